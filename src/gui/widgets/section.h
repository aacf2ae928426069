// SPDX-License-Identifier: BSD-3-Clause
// A part of a column: a header that opens and closes it, and its content, which can stand in a dock
// of its own instead.
#pragma once

#include <QWidget>

class QAbstractButton;
class QDockWidget;
class QScrollArea;
class QVBoxLayout;

namespace hogelscope {

/// The content is in the column while its dock is hidden, and in the dock while it is shown. The
/// dock has the section's title.
class Section : public QWidget {
  Q_OBJECT

 public:
  /// `content` and the header are named after the dock: "cameraArea" and "cameraHeader" of
  /// "cameraDock".
  Section(QWidget* content, QDockWidget* dock, QWidget* parent = nullptr);

  void setSummary(const QString& summary);
  /// Opens or closes the section in the column.
  void setOpen(bool isOpen);
  [[nodiscard]] bool isOpen() const;
  /// Whether the content stands in the dock.
  [[nodiscard]] bool isOut() const;
  [[nodiscard]] QDockWidget* dock() const { return m_dock; }
  [[nodiscard]] QWidget* content() const { return m_content; }

 Q_SIGNALS:
  void toggled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move(bool isOut);

  QWidget* m_content;
  QDockWidget* m_dock;
  QAbstractButton* m_header;
  QVBoxLayout* m_layout;
  QScrollArea* m_area;  ///< in the dock
};

}  // namespace hogelscope
