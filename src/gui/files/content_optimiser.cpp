// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/content_optimiser.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/optics/eyes.h"
#include "gui/session/session_forms.h"
#include "gui/session/session_model.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "optimise/optimise_page.h"
#include "optimise/optimise_run.h"

namespace hogelscope {

namespace {

/// Shows the session's `optimise`, whose edits are the session's, and asks for the layout.
class OptimiseDialog : public QDialog {
 public:
  OptimiseDialog(SessionModel* model, QWidget* parent) : QDialog(parent) {
    setWindowTitle(ContentOptimiser::tr("Optimise light field"));
    auto* what =
        new QLabel(ContentOptimiser::tr("Writes the light field whose light, as it leaks, comes "
                                        "closest to what should be seen. The "
                                        "PSF of the states says how much the display leaks."));
    what->setWordWrap(true);
    what->setMinimumWidth(fontMetrics().averageCharWidth() * 48);
    ParameterForm* const form = followingForm(
        model,
        [model](ParameterVisitor& visitor) {
          Session content = model->session();
          describe(visitor, content.optimise);
          model->setContent(content);
        },
        [](ParameterVisitor& visitor) {
          OptimiseParams defaults;
          describe(visitor, defaults);
        });
    form->hideHeading();
    m_layout->setObjectName("optimiseLayoutBox");
    m_layout->addItems({ContentOptimiser::tr("Write hogels"), ContentOptimiser::tr("Write views"),
                        ContentOptimiser::tr("Write a store")});
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(ContentOptimiser::tr("&Optimise…"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* rows = new QVBoxLayout(this);
    for (QWidget* row : std::initializer_list<QWidget*>{what, form, m_layout, buttons})
      rows->addWidget(row);
  }

  [[nodiscard]] ExportLayout layout() const {
    constexpr std::array layouts{ExportLayout::hogels, ExportLayout::views, ExportLayout::pack};
    return layouts[std::size_t(m_layout->currentIndex())];
  }

 private:
  QComboBox* m_layout = new QComboBox;
};

/// Returns "held-out eyes 29.08 → 42.04 dB": against the display without leakage.
QString gainText(const Optimised& result, bool isPrefiltered) {
  const auto psnr = [&](JudgedContent content) {
    return QString::number(meanOf(result.judgement.views, "display", true, content).psnr, 'f', 2);
  };
  return ContentOptimiser::tr("held-out eyes %1 → %2 dB")
      .arg(psnr(isPrefiltered ? prefilteredContent : beforeContent), psnr(afterContent));
}

}  // namespace

ContentOptimiser::ContentOptimiser(QMenu* menu, QStatusBar* statusBar, SessionModel* model,
                                   QWidget* window)
    : FileOutput("optimiseBar", tr("Optimising"), tr("How much of the light field has been solved"),
                 statusBar, window),
      m_model(model),
      m_window(window),
      m_action(addCommand(menu,
                          {"optimiseLightFieldAction", tr("&Optimise light field…"),
                           tr("Writes the light field that makes up for the display's leakage, and "
                              "compares it with the one before"),
                           Qt::CTRL | Qt::ALT | Qt::Key_U},
                          this, &ContentOptimiser::ask)) {
  connect(m_task, &Task::runningChanged, this, &ContentOptimiser::showState);
  showState();
}

void ContentOptimiser::setHasContent(bool hasContent) {
  m_hasContent = hasContent;
  showState();
}

void ContentOptimiser::showState() {
  m_action->setEnabled(m_hasContent && !m_task->isRunning() && !m_model->session().display.sheet);
}

void ContentOptimiser::ask() {
  OptimiseDialog dialog(m_model, m_window);
  if (dialog.exec() != QDialog::Accepted) return;
  const ExportLayout layout = dialog.layout();
  const QString title = tr("Optimised light field");
  const bool isStore = layout == ExportLayout::pack;
  const QString output =
      layout == ExportLayout::views
          ? chooseOutputFolder(m_window, title)
          : chooseNewFile(m_window, title, isStore ? "optimised.tif" : "optimised.png",
                          isStore ? tr("Stores (*.tif)") : tr("Pictures (*.png *.tif *.exr)"));
  if (!output.isEmpty()) save(layout, output);
}

void ContentOptimiser::save(ExportLayout layout, const QString& output) {
  const std::string name =
      m_model->file().isEmpty() ? "a session" : QFileInfo(m_model->file()).baseName().toStdString();
  m_task->start([=, this, session = m_model->session()](const Progress& progress) -> Task::Answer {
    const OptimiseRequest request{name, withEyes(session), layout, output.toStdString(), {}};
    const auto content = optimisedContent(request.session, part(progress, 0, 0.1));
    const FilesInUse inUse(filesOf(request.session, *content));
    const FilesInUse pictures(picturesOf(request.session));
    checkOutputs({request.output, tableOf(request), pageOf(request)});
    const Optimised result = *optimise(request, *content, part(progress, 0.1, 1));
    const QString line =
        tr("Saved %1").arg(output) + " · " + gainText(result, hasPrefilter(session)) + " · " +
        tr("page %1").arg(QFileInfo(QString::fromStdString(pageOf(request).string())).fileName());
    return [this, line, output] {
      Q_EMIT done(line);
      Q_EMIT written(output);
    };
  });
}

}  // namespace hogelscope
