// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/dialogs.h"

#include <vtkVersion.h>
#include <QAbstractItemView>
#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QShortcut>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>

#include "report/versions.h"
#include "ui_size_dialog.h"

namespace hogelscope {

QMessageBox::StandardButton askUnsaved(QWidget* window, const QString& name) {
  QMessageBox box(QMessageBox::Question, QObject::tr("Unsaved changes"),
                  QObject::tr("%1 has been changed. Save the changes?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window);
  box.setObjectName("unsavedBox");
  box.setInformativeText(QObject::tr("What is not saved is lost."));
  box.button(QMessageBox::Save)->setText(QObject::tr("&Save"));
  box.button(QMessageBox::Discard)->setText(QObject::tr("&Discard"));
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  return QMessageBox::StandardButton(box.exec());
}

std::optional<bool> askEither(QWidget* window, const QString& title, const QString& text,
                              const std::array<QString, 2>& ways) {
  QMessageBox box(QMessageBox::Question, title, text, QMessageBox::Cancel, window);
  box.setObjectName("eitherBox");
  QPushButton* first = box.addButton(ways[0], QMessageBox::AcceptRole);
  const QPushButton* second = box.addButton(ways[1], QMessageBox::AcceptRole);
  box.setDefaultButton(first);
  box.exec();
  if (box.clickedButton() == first) return true;
  return box.clickedButton() == second ? std::optional(false) : std::nullopt;
}

Recovery askRecovery(QWidget* window, const QString& document, const QDateTime& time) {
  const QString name =
      document.isEmpty() ? QObject::tr("a session without a file") : QFileInfo(document).fileName();
  QMessageBox box(QMessageBox::Question, QObject::tr("Recovery"),
                  QObject::tr("Hogelscope ended before changes of %1 were saved.").arg(name),
                  QMessageBox::NoButton, window);
  box.setObjectName("recoveryBox");
  box.setInformativeText(QObject::tr("%1\nAs it was at %2.")
                             .arg(document, QLocale().toString(time, QLocale::ShortFormat)));
  const auto* recover = box.addButton(QObject::tr("&Recover"), QMessageBox::AcceptRole);
  const auto* discard = box.addButton(QObject::tr("&Discard"), QMessageBox::DestructiveRole);
  QPushButton* later = box.addButton(QObject::tr("&Later"), QMessageBox::RejectRole);
  later->setToolTip(QObject::tr("Asks again at the next start"));
  box.setEscapeButton(later);
  box.exec();
  if (box.clickedButton() == recover) return Recovery::recover;
  return box.clickedButton() == discard ? Recovery::discard : Recovery::later;
}

void showAbout(QWidget* window) {
  QString list;
  std::vector<Version> all = versions();
  all.insert(all.begin() + 1, {{"Qt", qVersion()}, {"VTK", vtkVersion::GetVTKVersion()}});
  for (const Version& each : all)
    list += QString("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(QString::fromStdString(each.name), QString::fromStdString(each.version));
  QMessageBox box(QMessageBox::NoIcon, QObject::tr("About Hogelscope"),
                  QObject::tr("<h3>Hogelscope</h3><p>Simulated viewing of light field displays: "
                              "implements and extends the method of <i>Improved Simulated Viewing "
                              "of Holographic Imagery</i>.</p>"),
                  QMessageBox::Close, window);
  box.setObjectName("aboutBox");
  box.setInformativeText("<table>" + list + "</table>");
  box.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  box.exec();
}

namespace {

constexpr const char* folderKey = "lastFolder";
constexpr const char* sheetKey = "lastSheet";

QString lastFolder() {
  return QSettings().value(folderKey, QDir::homePath()).toString();
}

/// Returns the folder that was used last, or one of the user's own where that cannot be written.
QString folderForOutput() {
  const QString last = lastFolder();
  if (QFileInfo(last).isWritable()) return last;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isWritable() ? documents : QDir::homePath();
}

/// Returns the first ending that a filter like "Sessions (*.hogelscope *.json)" has; "" for none.
QString firstSuffix(const QString& filter) {
  static const QRegularExpression first(R"(\*\.(\w+))");
  return first.match(filter).captured(1);
}

/// Disables Qt's deletion, renaming and moving of files. New folders can still be created for
/// output.
void keepFiles(QFileDialog& dialog) {
  QStringList hidden{"qt_rename_action", "qt_delete_action"};
  if (dialog.testOption(QFileDialog::ReadOnly)) hidden << "qt_new_folder_action";
  for (const QString& name : hidden)
    if (auto* action = dialog.findChild<QAction*>(name)) {
      action->setVisible(false);
      action->setEnabled(false);  // Qt 6.4 keeps the one for new folders enabled
    }
  for (auto* view : dialog.findChildren<QAbstractItemView*>()) {
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setDragDropMode(QAbstractItemView::NoDragDrop);
    for (auto* shortcut : view->findChildren<QShortcut*>()) shortcut->setEnabled(false);
  }
}

/// A dialog that also accepts the typed name of a new folder for output.
class FolderMaker : public QFileDialog {
 public:
  using QFileDialog::QFileDialog;

 protected:
  void accept() override {
    const QString folder = selectedFiles().value(0);
    if (fileMode() == Directory && !testOption(ReadOnly) && !folder.isEmpty())
      QDir().mkpath(folder);
    QFileDialog::accept();
  }
};

struct Asked {
  QFileDialog::FileMode mode = QFileDialog::ExistingFile;
  QFileDialog::Options options;
  QString filter;
};

QStringList chosen(QWidget* parent, const QString& title, const Asked& asked,
                   const QString& name = {}) {
  const bool isOutput = !asked.options.testFlag(QFileDialog::ReadOnly);
  FolderMaker dialog(parent, title, isOutput ? folderForOutput() : lastFolder(), asked.filter);
  dialog.setOptions(asked.options);
  dialog.setFileMode(asked.mode);
  if (asked.mode == QFileDialog::AnyFile) {
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(firstSuffix(asked.filter));  // or the dialogs that open hide the file
  }
  dialog.selectFile(name);
  keepFiles(dialog);
  QStringList files;
  if (dialog.exec() == QDialog::Accepted) files = dialog.selectedFiles();
  rememberFolderOf(files.value(0));
  return files;
}

}  // namespace

void rememberFolderOf(const QString& file) {
  if (!file.isEmpty()) QSettings().setValue(folderKey, QFileInfo(file).absolutePath());
}

QString sessionFilter() {
  return QCoreApplication::translate("FileDialogs", "Sessions (*.hogelscope *.json)");
}

QString lightFieldFilter(const QString& more) {
  return QCoreApplication::translate(
             "FileDialogs",
             "Light fields (*.png *.tif *.tiff *.jpg *.jpeg *.ppm *.pgx *.yuv *.exr *.avi *.mov "
             "*.mp4 *.m4v *.qt *.mj2 *.mkv *.webm *.y4m *.h5 *.mat *.glb *.gltf *.obj "
             "*.ply%1);;All "
             "files (*)")
      .arg(more);
}

QString chooseFile(QWidget* parent, const QString& title, const QString& filter) {
  return chosen(parent, title, {QFileDialog::ExistingFile, QFileDialog::ReadOnly, filter}).value(0);
}

QStringList chooseFiles(QWidget* parent, const QString& title, const QString& filter) {
  return chosen(parent, title, {QFileDialog::ExistingFiles, QFileDialog::ReadOnly, filter});
}

/// Remembers the parent of the chosen folder, because the next one is likely to lie there too.
QString chooseFolder(QWidget* parent, const QString& title) {
  const auto options = QFileDialog::ShowDirsOnly | QFileDialog::ReadOnly;
  return chosen(parent, title, {QFileDialog::Directory, options, {}}).value(0);
}

QString chooseOutputFolder(QWidget* parent, const QString& title) {
  return chosen(parent, title, {QFileDialog::Directory, QFileDialog::ShowDirsOnly, {}}).value(0);
}

QString chooseNewFile(QWidget* parent, const QString& title, const QString& name,
                      const QString& filter) {
  return chosen(parent, title, {QFileDialog::AnyFile, {}, filter}, name).value(0);
}

QString chooseSheet(QWidget* parent) {
  return chooseFile(
      parent, QCoreApplication::translate("FileDialogs", "Choose a lens sheet's calibration"),
      QCoreApplication::translate("FileDialogs", "Calibrations (*.json);;All files (*)"));
}

QString lastSheet() {
  const QString file = QSettings().value(sheetKey).toString();
  return QFileInfo::exists(file) ? file : QString();
}

void rememberSheet(const QString& calibration) {
  QSettings().setValue(sheetKey, QFileInfo(calibration).absoluteFilePath());
}

SizeDialog::SizeDialog(const QString& title, const QSize& proposed, QWidget* parent)
    : QDialog(parent),
      m_proposed(proposed.expandedTo({1, 1})),
      m_ui(std::make_unique<Ui::SizeDialog>()) {
  m_ui->setupUi(this);
  setWindowTitle(title);
  constexpr double longest = 16384;  // px, the limit of a state's resolution
  const double aspect = double(m_proposed.height()) / m_proposed.width();
  connect(m_ui->widthBox, &QSpinBox::valueChanged, this,
          [this] { m_ui->heightLabel->setText(tr("%1 px").arg(size().height())); });
  m_ui->widthBox->setRange(1, int(longest / std::max(1.0, aspect)));
  m_ui->widthBox->setValue(m_proposed.width());
  m_ui->widthBox->selectAll();
}

SizeDialog::~SizeDialog() = default;

QFormLayout* SizeDialog::form() const {
  return m_ui->form;
}

QSize SizeDialog::size() const {
  const double height = double(m_ui->widthBox->value()) * m_proposed.height() / m_proposed.width();
  return {m_ui->widthBox->value(), std::max(1, int(std::lround(height)))};
}

}  // namespace hogelscope
