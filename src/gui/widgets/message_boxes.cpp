// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/message_boxes.h"

#include <vtkVersion.h>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "report/report_facts.h"

namespace hogelscope {

Unsaved askUnsaved(QWidget* window, const QString& name) {
  QMessageBox box(QMessageBox::Question, QObject::tr("Unsaved changes"),
                  QObject::tr("%1 has been changed. Save the changes?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window);
  box.setObjectName("unsavedBox");
  box.setInformativeText(QObject::tr("What is not saved is lost."));
  box.button(QMessageBox::Save)->setText(QObject::tr("&Save"));
  box.button(QMessageBox::Discard)->setText(QObject::tr("&Discard"));
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  switch (box.exec()) {
    case QMessageBox::Save:
      return Unsaved::save;
    case QMessageBox::Discard:
      return Unsaved::discard;
    default:
      return Unsaved::cancel;
  }
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

}  // namespace hogelscope
