// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/light_field_output.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/session/session_model.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "io/scene/view_source.h"
#include "web/view_page.h"

namespace hogelscope {

namespace {

/// What the window says of a layout.
struct LayoutWords {
  QString title;
  QString help;
  QString name;  ///< proposed for the file; "": a folder
};

LayoutWords wordsOf(ExportLayout layout) {
  const auto tr = [](const char* text) { return LightFieldOutput::tr(text); };
  switch (layout) {
    case ExportLayout::hogels:
      return {tr("Hogels"), tr("One picture of all hogels: each is a tile of its directions."),
              "hogels.png"};
    case ExportLayout::views:
      return {tr("Views"),
              tr("A folder of one picture for each direction, 000_000.png from the top left."),
              {}};
    case ExportLayout::quilt:
      return {tr("Quilt"),
              tr("One picture of all views of a display with one row of directions: the first "
                 "view, from the left, is its bottom left tile. A name such as room_qs8x6a0.75.png "
                 "gives the tiles."),
              "quilt.png"};
    case ExportLayout::mosaic:
      return {tr("Mosaic"),
              tr("One picture of all views: the top left tile is seen from the top left."),
              "mosaic.png"};
    case ExportLayout::woven:
      return {tr("Panel's picture"), tr("The pixels that the panel under the lens sheet shows."),
              "panel.png"};
    case ExportLayout::pack:
      break;
  }
  return {tr("Store"),
          tr("A tiled TIFF of which a view reads only what it sees, so that it need not fit into "
             "memory."),
          "store.tif"};
}

/// Asks for the layout.
class ExportDialog : public QDialog {
 public:
  ExportDialog(const Session& session, const std::optional<LightFieldSize>& size, QWidget* parent)
      : QDialog(parent), m_layouts(exportLayoutsOf(session.display)), m_size(size) {
    setWindowTitle(LightFieldOutput::tr("Export light field"));
    auto* rows = new QVBoxLayout(this);
    m_layout->setObjectName("exportLayoutBox");
    for (const ExportLayout layout : m_layouts) m_layout->addItem(wordsOf(layout).title);
    m_help->setObjectName("exportHelp");
    m_help->setWordWrap(true);
    m_help->setMinimumWidth(fontMetrics().averageCharWidth() * 48);
    m_isForTwin->setObjectName("forTwinBox");
    m_isForTwin->setText(LightFieldOutput::tr("&Correct it for the unit as built"));
    m_isForTwin->setToolTip(LightFieldOutput::tr(
        "The unit then shows what the display as designed shows of the session's light field"));
    m_isForTwin->setVisible(!session.twin.isZero() && !session.display.sheet);
    for (QWidget* row : std::initializer_list<QWidget*>{m_layout, m_help, m_isForTwin, m_buttons})
      rows->addWidget(row);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_layout, &QComboBox::currentIndexChanged, this, [this] { showLayout(); });
    showLayout();
  }

  [[nodiscard]] ExportLayout layout() const {
    return m_layouts[std::size_t(m_layout->currentIndex())];
  }
  [[nodiscard]] bool isForTwin() const { return m_isForTwin->isChecked(); }

 private:
  /// A store says what its session's display is: a unit's corrected content is of another one.
  void showLayout() {
    const bool isStore = layout() == ExportLayout::pack;
    m_isForTwin->setEnabled(!isStore);
    if (isStore) m_isForTwin->setChecked(false);
    QString problem;
    try {
      if (layout() == ExportLayout::quilt && m_size) (void)quiltTilesFor(*m_size, {});
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    m_help->setText(problem.isEmpty() ? wordsOf(layout()).help : problem);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
  }

  std::vector<ExportLayout> m_layouts;
  std::optional<LightFieldSize> m_size;
  QComboBox* m_layout = new QComboBox;
  QLabel* m_help = new QLabel;
  QCheckBox* m_isForTwin = new QCheckBox;
  QDialogButtonBox* m_buttons =
      new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
};

}  // namespace

LightFieldOutput::LightFieldOutput(QMenu* menu, QStatusBar* statusBar, SessionModel* model,
                                   QWidget* window)
    : FileOutput("exportBar", tr("Exporting"), tr("How much of the light field has been written"),
                 statusBar, window),
      m_model(model),
      m_window(window),
      m_export(addCommand(menu,
                          {"exportLightFieldAction", tr("&Export light field…"),
                           tr("Writes the light field, also that of a live scene, as hogels, "
                              "views, a quilt, a mosaic or a store"),
                           Qt::CTRL | Qt::ALT | Qt::Key_L},
                          this, &LightFieldOutput::ask)),
      m_share(addCommand(menu,
                         {"sharePageAction", tr("S&hare as a page…"),
                          tr("Writes one file with the display, its states and the engine, in "
                             "which anyone moves around the display in a browser; all of the "
                             "light field is in it"),
                          Qt::CTRL | Qt::ALT | Qt::Key_P},
                         this, &LightFieldOutput::share)) {
  connect(m_task, &Task::runningChanged, this, &LightFieldOutput::showState);
  showState();
}

void LightFieldOutput::setSize(const std::optional<LightFieldSize>& size) {
  m_size = size;
  showState();
}

void LightFieldOutput::showState() {
  for (QAction* action : {m_export, m_share}) action->setEnabled(m_size && !m_task->isRunning());
}

void LightFieldOutput::save(ExportLayout layout, const QString& output, bool isForTwin) {
  m_task->start([=, this, session = m_model->session(), frame = m_frame](const Progress& progress) {
    const auto content = contentToExport(session, layout, isForTwin, part(progress, 0, 0.1));
    const bool isInTime = !content->frames().isStill();
    const FrameNumbers frames = content->frames();
    const int written = frame && frames.has(*frame) ? *frame : frames.first;
    if (isInTime) content->select(written);
    const FilesInUse inUse(filesOf(session, *content));
    checkOutputs({output.toStdString()});
    exportAs(layout, session, *content, output.toStdString(), part(progress, 0.1, 1));
    const QString what = isInTime ? tr("Saved frame %1 as %2").arg(written) : tr("Saved %1");
    return [this, line = what.arg(output)] { Q_EMIT done(line); };
  });
}

/// The page is made first, so that its size is known before a file is written.
void LightFieldOutput::share() {
  const QString file = m_model->file();
  const std::string title =
      (file.isEmpty() ? tr("A display") : QFileInfo(file).baseName()).toStdString();
  m_task->start([=, this, session = m_model->session()](const Progress& progress) -> Task::Answer {
    requirePage(session);
    const std::shared_ptr<LightFieldFile> content =
        openLightField(session.lightField, session.display, part(progress, 0, 0.1));
    // Marked as in use until the page has been written, too.
    const auto inUse = std::make_shared<const FilesInUse>(filesOf(session, *content));
    const ViewPage page = viewPage(session, {{title, content}}, {title}, part(progress, 0.1, 1));
    return [this, page, inUse] {
      const QString size = QLocale().formattedDataSize(qint64(page.html.size()));
      const QString output = chooseNewFile(m_window, tr("Share a page of %1").arg(size),
                                           "page.html", tr("Pages (*.html)"));
      if (output.isEmpty()) return;
      guarded(this, [&] {
        checkOutputs({output.toStdString()});
        writeTextFile(output.toStdString(), page.html);
        Q_EMIT done(tr("Saved %1").arg(output) + " · " +
                    QString::fromStdString(page.notes.front()));
      });
    };
  });
}

void LightFieldOutput::ask() {
  ExportDialog dialog(m_model->session(), m_size, m_window);
  if (dialog.exec() != QDialog::Accepted) return;
  const LayoutWords words = wordsOf(dialog.layout());
  const QString title = tr("Export light field as %1").arg(words.title.toLower());
  const bool isStore = dialog.layout() == ExportLayout::pack;
  const QString output =
      words.name.isEmpty()
          ? chooseOutputFolder(m_window, title)
          : chooseNewFile(m_window, title, words.name,
                          isStore ? tr("Stores (*.tif)") : tr("Pictures (*.png *.tif *.exr)"));
  if (!output.isEmpty()) save(dialog.layout(), output, dialog.isForTwin());
}

}  // namespace hogelscope
