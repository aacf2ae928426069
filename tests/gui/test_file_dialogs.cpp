// SPDX-License-Identifier: BSD-3-Clause
// Qt's own file dialogs, for desktops without one: whatever is pressed there, the files stay as
// they are. All happens in a folder of the test's own.
#include <QAbstractButton>
#include <QAction>
#include <QDirIterator>
#include <QListView>

#include "gui/widgets/dialogs.h"
#include "tests/gui/habits_test.h"
#include "tests/io/documents.h"

using namespace hogelscope;

using Dialog = QString (*)();
Q_DECLARE_METATYPE(Dialog)

namespace {

QString openFile() {
  return chooseFile(nullptr, "Open", "Texts (*.txt)");
}
QString openFiles() {
  return chooseFiles(nullptr, "Open", "Texts (*.txt)").value(0);
}
QString openFolder() {
  return chooseFolder(nullptr, "Open");
}
QString outputFolder() {
  return chooseOutputFolder(nullptr, "Write into");
}
QString newFile() {
  return chooseNewFile(nullptr, "Save", "b.txt", "Texts (*.txt *.text)");
}

QModelIndex find(const QListView& list, const QString& name) {
  for (int row = 0; row < list.model()->rowCount(list.rootIndex()); ++row) {
    const QModelIndex index = list.model()->index(row, 0, list.rootIndex());
    if (index.data() == name) return index;
  }
  return {};
}

void press(QAbstractItemView& view, const QModelIndex& victim) {
  view.setCurrentIndex(victim);
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_Delete);
  QTest::qWait(50);
  QTest::keyClick(&view, Qt::Key_F2);
  if (auto* editor = view.findChild<QLineEdit*>()) {
    editor->setText("renamed");
    QTest::keyClick(editor, Qt::Key_Return);
  }
  QTest::qWait(50);
}

}  // namespace

class TestFileDialogs : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void filesStay_data();
  void filesStay();
  void aNewFolderIsTyped();

 private:
  QStringList all() const;
  void attack(QFileDialog* dialog);

  std::unique_ptr<QTemporaryDir> m_folder;
  bool m_isAttacked = false;
  bool m_canDrag = false;  ///< which moves files
};

void TestFileDialogs::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->filePath("settings"));
  QVERIFY(QDir(m_folder->path()).mkpath("here/victim"));
  writeFile(m_folder->filePath("here/victim/a.txt"), "a");
  rememberFolderOf(m_folder->filePath("here/b.txt"));
  m_isAttacked = m_canDrag = false;
}

QStringList TestFileDialogs::all() const {
  QStringList names;
  QDirIterator found(m_folder->path(), {"*.txt", "victim", "renamed"}, QDir::AllEntries,
                     QDirIterator::Subdirectories);
  while (found.hasNext()) names << QDir(m_folder->path()).relativeFilePath(found.next());
  names.sort();
  return names;
}

/// Answers questions with yes.
void TestFileDialogs::attack(QFileDialog* dialog) {
  QTimer yes;
  connect(&yes, &QTimer::timeout, this, [] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
      box->button(QMessageBox::Yes)->click();
  });
  yes.start(10);
  const auto* list = dialog->findChild<QListView*>("listView");
  for (auto* view : dialog->findChildren<QAbstractItemView*>()) {
    if (view->model() != list->model()) continue;
    press(*view, find(*list, "victim"));
    m_canDrag = m_canDrag || view->dragDropMode() != QAbstractItemView::NoDragDrop;
  }
  dialog->findChild<QAction*>("qt_new_folder_action")->trigger();
  QTest::qWait(50);
  m_isAttacked = true;
  dialog->reject();
}

void TestFileDialogs::filesStay_data() {
  QTest::addColumn<Dialog>("dialog");
  QTest::addColumn<bool>("makesFolders");
  QTest::newRow("file") << &openFile << false;
  QTest::newRow("files") << &openFiles << false;
  QTest::newRow("folder") << &openFolder << false;
  QTest::newRow("new file") << &newFile << true;
  QTest::newRow("folder to write into") << &outputFolder << true;
}

void TestFileDialogs::filesStay() {
  QFETCH(Dialog, dialog);
  QFETCH(bool, makesFolders);
  const QStringList before = all();
  QCOMPARE(before.size(), 2);
  QTimer timer;
  connect(&timer, &QTimer::timeout, this, [&] {
    auto* open = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (open == nullptr || !find(*open->findChild<QListView*>("listView"), "victim").isValid())
      return;
    timer.stop();
    attack(open);
  });
  timer.start(20);
  dialog();
  QVERIFY(m_isAttacked && !m_canDrag);
  QCOMPARE(all(), before);
  const QDir here(m_folder->filePath("here"));
  QCOMPARE(here.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), makesFolders ? 2 : 1);
}

void TestFileDialogs::aNewFolderIsTyped() {
  const QString folder = m_folder->filePath("here/new/one");
  const DialogAnswer answer(folder);
  QCOMPARE(outputFolder(), folder);
  QVERIFY(QFileInfo(folder).isDir());
}

int main(int argc, char** argv) {
  return runHabitsTest<TestFileDialogs>(argc, argv);
}
#include "test_file_dialogs.moc"
