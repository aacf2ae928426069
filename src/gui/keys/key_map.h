// SPDX-License-Identifier: BSD-3-Clause
// All commands of a window with their default and user-defined keys.
// A command is a QAction with an object name. A test compares them with the manual's keys.md, and
// requires a key and a tooltip for each.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMainWindow>
#include <QPointer>
#include <vector>

namespace hogelscope {

/// The keys of a window's actions. A command is an object name among the actions; several actions
/// of one name, such as those of several images, are one command. Keys that differ from the
/// defaults are saved at once and read by load().
class KeyMap : public QObject {
  Q_OBJECT

 public:
  struct Command {
    QString name;     ///< as in the file
    QString section;  ///< menu
    QString title;
    QString help;
    QList<QPointer<QAction>> actions;
    QList<QKeySequence> defaults;
    QList<QKeySequence> keys;
  };

  /// Collects the window's actions, which must all exist by then.
  explicit KeyMap(QMainWindow* window);

  [[nodiscard]] const std::vector<Command>& commands() const { return m_commands; }
  /// Returns the commands that share a key with `command`; none of them is triggered by that key.
  [[nodiscard]] std::vector<std::size_t> conflictsOf(std::size_t command) const;
  /// Assigns a key; an empty one removes the key.
  void setKey(std::size_t command, const QKeySequence& key);
  void reset(std::size_t command);
  void resetAll();
  /// Reads the saved keys. Without a file the defaults stay; errors are reported through failed().
  void load();

 Q_SIGNALS:
  void changed();
  void failed(const QString& line);

 private:
  static bool areApart(const Command& a, const Command& b);
  void addAction(QAction* action);
  void assign(Command& command, const QList<QKeySequence>& keys);
  void finish();

  std::vector<Command> m_commands;
};

}  // namespace hogelscope
