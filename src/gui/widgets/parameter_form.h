// SPDX-License-Identifier: BSD-3-Clause
// A form generated from a parameter description: a heading, and a row for each field with unit,
// help and slider.
#pragma once

#include <QHash>
#include <QSet>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "core/base/parameters.h"

class QFormLayout;
class QLabel;
class QMenu;

namespace hogelscope {

template <class Box>
class BoxRow;

/// Creates a field's row when the field is first visited, and hides it while the field is not
/// visited or does not count. Editors are named after their fields: "sigma", "sigma.slider",
/// "eye.0". A right click on a row offers the default.
class ParameterForm : public QWidget, private ParameterVisitor {
  Q_OBJECT

 public:
  /// Visits the current parameters and applies what the visitor changed.
  using Visit = std::function<void(ParameterVisitor&)>;

  /// `defaults` visits the default parameters; without it, no default is offered.
  explicit ParameterForm(Visit visit, Visit defaults = {}, QWidget* parent = nullptr);

  /// Hides or shows a field's row.
  void hideField(const QString& name, bool isHidden);
  /// Sets the upper end of a field's slider, limited to the field's maximum; the default is the
  /// field's declaration. It extends to a larger value.
  void slideTo(const QString& name, double most);
  /// Shows the current parameters.
  void refresh();

  /// A row that is shown, for those who search one.
  struct Row {
    QString group;  ///< the form's heading
    QString label;
    QWidget* editor;  ///< the first one
    QString text;     ///< the value or values
  };
  [[nodiscard]] std::vector<Row> rows() const;

 Q_SIGNALS:
  /// Return was pressed in an editor, which has applied its value, or Escape, and it has not.
  void entered();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  /// Shows the menu of a row.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Pass { show, apply, sayDefault, showDefault };

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
  void addRow(const Field& field, const QString& key, QWidget* editor);
  [[nodiscard]] QString keyOf(const Field& field, const char* kind) const;
  void applyEdit(QObject* editor);
  void walkDefaults(Pass pass, const QString& key);
  [[nodiscard]] bool skipsRow(const QWidget* row) const;
  [[nodiscard]] bool shows() const { return m_pass == Pass::show || m_pass == Pass::showDefault; }
  void showMenu(QWidget* on, const QString& key, const QPoint& at);
  void offerDefault(QMenu* menu, const QString& key);

  Visit m_visit;
  Visit m_defaults;
  QFormLayout* m_layout;
  QLabel* m_heading;
  QString m_group;
  Pass m_pass = Pass::show;
  QObject* m_edited = nullptr;  ///< the editor changed by the user
  QString m_wanted;             ///< the row whose default is read or shown
  QStringList m_default;        ///< the default values of that row
  QHash<QString, QWidget*> m_rows;
  QSet<QWidget*> m_visited;  ///< of m_rows, during this visit
  QSet<QString> m_hidden;    ///< names of hidden fields
  QHash<QString, double> m_slideMost;
};

}  // namespace hogelscope
