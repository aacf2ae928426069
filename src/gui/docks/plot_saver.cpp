// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/plot_saver.h"

#include <QWidget>
#include <filesystem>
#include <utility>

#include "core/base/error.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

PlotSaver::PlotSaver(QWidget* plot, const QString& title, const QSize& size, Paint paint)
    : QObject(plot),
      m_plot(plot),
      m_title(title),
      m_size(size),
      m_paint(std::move(paint)),
      m_action(new QAction(tr("&Save plot…"), this)) {
  m_action->setToolTip(tr("As SVG or PNG, black on white"));
  connect(m_action, &QAction::triggered, this, &PlotSaver::ask);
  plot->addAction(m_action);
  plot->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void PlotSaver::save(const QString& file) {
  const std::filesystem::path path = file.toStdString();
  guarded(this, [&] {
    const std::string extension = path.extension().string();
    if (extension != ".svg" && extension != ".png")
      throw InputError(path.string(), "cannot be written",
                       "a plot's extension is .svg or .png, not \"" + extension + "\"");
    writeTextFile(path, extension == ".svg" ? svgOf(m_paint, m_size, m_title.toStdString())
                                            : pngOf(m_paint, m_size));
    Q_EMIT done(tr("Saved %1").arg(file));
  });
}

void PlotSaver::ask() {
  const QString file =
      chooseNewFile(m_plot, tr("Save plot"), m_title.toLower() + ".svg", tr("Plots (*.svg *.png)"));
  if (!file.isEmpty()) save(file);
}

}  // namespace hogelscope
