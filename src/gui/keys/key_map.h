// SPDX-License-Identifier: BSD-3-Clause
// All commands of a window and their keys: what they are by default, what a user made of them.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMainWindow>
#include <QPointer>
#include <vector>

namespace hogelscope {

/// A command is what has an object name among the window's actions; several actions of one name,
/// such as those of several images, are one command. Keys that differ from the defaults are saved
/// at once, and read when the map is made by load().
class KeyMap : public QObject {
  Q_OBJECT

 public:
  struct Command {
    QString name;     ///< in the file
    QString section;  ///< menu
    QString title;
    QString help;
    QList<QPointer<QAction>> actions;
    QList<QKeySequence> defaults;
    QList<QKeySequence> keys;
  };

  /// Make it when the window has all its actions.
  explicit KeyMap(QMainWindow* window);

  [[nodiscard]] const std::vector<Command>& commands() const { return m_commands; }
  /// Those that share a key with it: none of them works by that key.
  [[nodiscard]] std::vector<std::size_t> conflictsOf(std::size_t command) const;
  /// An empty one takes the key away.
  void setKey(std::size_t command, const QKeySequence& key);
  void reset(std::size_t command);
  void resetAll();
  /// Where there is no file the defaults stay; what is wrong with it is told by failed().
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
