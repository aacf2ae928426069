// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/icons.h"

#include <QApplication>
#include <QIcon>

#include "ui_main_window.h"

namespace hogelscope {

void addIcons(const Ui::MainWindow& ui) {
  QApplication::setWindowIcon(QIcon(":/icons/io.github.hogelscope.Hogelscope.svg"));
  for (const auto& [action, name] :
       {std::pair(ui.newAction, "new"), std::pair(ui.openAction, "open"),
        std::pair(ui.saveAction, "save"), std::pair(ui.fitAction, "fit"),
        std::pair(ui.savePictureAction, "save_picture"), std::pair(ui.copyPictureAction, "copy")})
    action->setIcon(QIcon(QString(":/icons/%1.svg").arg(name)));
}

}  // namespace hogelscope
