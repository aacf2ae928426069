// SPDX-License-Identifier: BSD-3-Clause
// Shows what the display can show to the current eye: a card of six numbers, those of hogels or of
// a lens sheet, and the depths that are sharp, beside those of the content. It follows the
// session's edits and needs no picture.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/panel/design_numbers.h"
#include "core/panel/sheet_numbers.h"
#include "gui/session/session_model.h"

namespace Ui {
class DesignNumbers;
}

namespace hogelscope {

class DepthBar;
struct ViewSource;

class DesignNumbersWidget : public QWidget {
 public:
  /// A card of two columns over the depths, or a row of numbers alone with their changes since the
  /// session was opened.
  enum class Form { card, strip };

  explicit DesignNumbersWidget(const SessionModel* model, Form form = Form::card);
  ~DesignNumbersWidget() override;

  /// Sets the current light field: its depths, and the hogels and directions of a display that
  /// leaves them out.
  void setSource(const std::optional<ViewSource>& source);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void arrangeStrip();
  void showNumbers();
  void showHogels(const DesignNumbers& numbers);
  void showSheet(const SheetNumbers& numbers);
  [[nodiscard]] DesignNumbers numbersOf(const DisplayParams& display) const;
  [[nodiscard]] std::optional<SheetNumbers> numbersOfSheet() const;

  std::unique_ptr<Ui::DesignNumbers> m_ui;
  const SessionModel* m_model;
  DisplayParams m_known;   ///< the display of the light field
  DisplayParams m_opened;  ///< A: as it was opened
  DepthBar* m_bar;
};

}  // namespace hogelscope
