// SPDX-License-Identifier: BSD-3-Clause
// The Properties dock: a column of sections in processing order, from the light field to the
// sampling.
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;
class QScrollArea;
class QVBoxLayout;

namespace hogelscope {

class DesignNumbersWidget;
class DisplayDock;
class DistortionDock;
class LightFieldDock;
class Section;
class SessionModel;

class Properties : public QWidget {
  Q_OBJECT

 public:
  /// Creates the sections and their docks, which `window` owns.
  Properties(SessionModel* model, QAction* importAction, QMainWindow* window);

  [[nodiscard]] LightFieldDock* lightField() const { return m_lightField; }
  [[nodiscard]] DesignNumbersWidget* designNumbers() const { return m_numbers; }
  [[nodiscard]] DisplayDock* display() const { return m_display; }
  [[nodiscard]] DistortionDock* distortion() const { return m_distortion; }
  /// Returns the section whose content may stand in `dock`; null: none.
  [[nodiscard]] Section* sectionOf(const QDockWidget* dock) const;
  /// Opens a section of the column and scrolls to it.
  void reveal(Section* section);
  /// Enables all sections but the light field's, which may have to be mended first.
  void setOpen(bool isOpen);

 Q_SIGNALS:
  /// An edit has been rejected; the session is unchanged.
  void failed(const QString& line);

 private:
  Section* add(const char* name, const QString& title, QWidget* content, QMainWindow* window);
  void showSummaries();

  SessionModel* m_model;
  QScrollArea* m_area;
  QVBoxLayout* m_column;
  std::vector<Section*> m_sections;
  LightFieldDock* m_lightField;
  DesignNumbersWidget* m_numbers;
  DisplayDock* m_display;
  DistortionDock* m_distortion;
};

}  // namespace hogelscope
