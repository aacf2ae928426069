// SPDX-License-Identifier: BSD-3-Clause
// The first minute: a line in the status bar says the next useful thing to do, each once.
#pragma once

#include <QLabel>
#include <array>

#include "core/base/geometry.h"

namespace hogelscope {

class SessionModel;

class Guide : public QLabel {
  Q_OBJECT

 public:
  /// Creates a hidden line. The steps that were done are in the settings.
  explicit Guide(SessionModel* model);

  /// Shows the next step, if there is one.
  void offer();
  /// A pixel of the simulated view was picked.
  void pixelPicked() { finish("pixel"); }

 private:
  void finish(const QString& step);
  void follow();

  SessionModel* m_model;
  Vec3 m_eye;
  std::array<int, 2> m_directions{};
};

}  // namespace hogelscope
