// SPDX-License-Identifier: BSD-3-Clause
// A form created from a parameter description: a heading, and a row for each field with unit, help
// and slider.
#pragma once

#include <QHash>
#include <QSet>
#include <QWidget>
#include <functional>
#include <string>

#include "core/base/parameters.h"

class QFormLayout;
class QLabel;

namespace hogelscope {

template <class Box>
class BoxRow;

/// A field gets its row when it is visited first; the row hides while the field is not visited. The
/// editors are named after their fields: "sigma", "sigma.slider", "eye.0".
class ParameterForm : public QWidget, private ParameterVisitor {
  Q_OBJECT

 public:
  /// Visits the parameters as they are now, and takes over what the visitor changed.
  using Visit = std::function<void(ParameterVisitor&)>;

  explicit ParameterForm(Visit visit, QWidget* parent = nullptr);

  /// Shows the parameters as they are now.
  void refresh();

 Q_SIGNALS:
  /// Return was pressed in an editor, which has taken its value.
  void entered();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Pass { show, apply };

  void group(std::string_view name, std::string_view help) override;
  void numbers(const Field& field, std::span<double> values, bool isList) override;
  void integers(const Field& field, std::span<int> values, bool isList) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void choice(const Field& field, int& index) override;

  template <class Box, class Number>
  void boxes(const Field& field, std::span<Number> values, bool isList);
  template <class Box>
  BoxRow<Box>* newBoxes(const Field& field, std::size_t count, bool isList);
  template <class Box>
  void addSlider(const Field& field, Box* box, QWidget* row);
  template <class Make>
  auto editor(const Field& field, Make make) -> decltype(make());
  void addRow(const Field& field, QWidget* editor);
  void applyEdit(QObject* editor);

  Visit m_visit;
  QFormLayout* m_layout;
  QLabel* m_heading;
  Pass m_pass = Pass::show;
  QObject* m_edited = nullptr;  ///< the editor that a user changed
  QHash<QString, QWidget*> m_rows;
  QSet<QWidget*> m_visited;  ///< of m_rows, in this walk
};

}  // namespace hogelscope
