// SPDX-License-Identifier: BSD-3-Clause
// A form generated from a parameter description: a heading, and a row for each field with its
// label, editors, units and help.
#pragma once

#include <QHash>
#include <QSet>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "core/base/linked_pair.h"
#include "core/base/parameters.h"

class QFormLayout;
class QLabel;
class QToolButton;

namespace hogelscope {

template <class Box>
class BoxRow;
class FieldLabel;

/// Creates a field's row when the field is first visited, and hides it while the field is not
/// visited or does not count. Editors are named after their fields: "sigma", "eye.0". A value that
/// is not the default has a dot before its label; a click on it, or the menu of a right click,
/// brings the default back.
class ParameterForm : public QWidget, private ParameterVisitor {
  Q_OBJECT

 public:
  /// Visits the current parameters and applies what the visitor changed.
  using Visit = std::function<void(ParameterVisitor&)>;

  /// `defaults` visits the default parameters; without it, no default is offered.
  explicit ParameterForm(Visit visit, Visit defaults = {}, QWidget* parent = nullptr);
  ~ParameterForm() override;

  /// Hides or shows a field's row.
  void hideField(const QString& name, bool isHidden);
  /// Hides the heading, where the surroundings have it.
  void hideHeading();
  /// Gives a pair of numbers the letters h and v, and the button "link": while it is on, an edit of
  /// one changes the other in proportion.
  void linkPair(const QString& name, bool isOn);
  /// Adds a switch, named "PAIR.NAME", to the row of a pair of numbers. Its icon is NAME, or unNAME
  /// while it is off.
  QToolButton* addButton(const QString& pair, const QString& name, bool isOn, const QString& help);
  /// Sets what stands in an editor while its number is left out; "": "not given".
  void showLeftOut(const QString& editor, const QString& text);
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
  /// Escape was pressed in an editor, whose text is that of the value again.
  void escaped();
  /// The drag of a number has begun, or ended.
  void dragged(bool isHeld);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  /// Shows the menu of a row.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Pass { show, apply, compare, showDefault };  ///< the last two visit the defaults
  struct Link {
    QToolButton* button;
    LinkedPair pair = {};
  };

  void group(std::string_view name, std::string_view help) override;
  void numbers(const Field& field, std::span<double> values, bool isList) override;
  void integers(const Field& field, std::span<int> values, bool isList) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void choice(const Field& field, int& index) override;

  template <class Box, class Number>
  void boxes(const Field& field, std::span<Number> values, bool isList);
  template <class Box, class Number>
  void compareBoxes(const Field& field, BoxRow<Box>* row, std::span<const Number> defaults);
  template <class Box>
  BoxRow<Box>* newBoxes(const Field& field, std::size_t count, bool isList);
  template <class Make>
  auto editor(const Field& field, Make make) -> decltype(make());
  void addRow(const Field& field, const QString& key, QWidget* editor);
  void explain(const Field& field, QWidget* row);
  [[nodiscard]] QString keyOf(const Field& field, const char* kind) const;
  void applyEdit(QObject* editor);
  void walkDefaults(Pass pass);
  void reset(const QString& key);
  void takeDefault(const Field& field, QWidget* row, const QString& words, bool isShown);
  [[nodiscard]] FieldLabel* labelOf(QWidget* row) const;
  [[nodiscard]] bool skipsRow(const QWidget* row) const;
  [[nodiscard]] bool shows() const { return m_pass == Pass::show || m_pass == Pass::showDefault; }
  void showMenu(QWidget* on, const QString& key, const QPoint& at);

  Visit m_visit;
  Visit m_defaults;
  QFormLayout* m_layout;
  QLabel* m_heading;
  QString m_group;
  Pass m_pass = Pass::show;
  QObject* m_edited = nullptr;  ///< the editor changed by the user
  QString m_wanted;             ///< the row whose default is to be shown
  QHash<QString, QWidget*> m_rows;
  QSet<QWidget*> m_visited;  ///< of m_rows, during this visit
  QSet<QString> m_hidden;    ///< names of hidden fields
  QHash<QString, Link> m_links;
};

}  // namespace hogelscope
