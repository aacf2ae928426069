// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/twin_actors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gui/scene/scene_actor.h"

namespace hogelscope {

namespace {

constexpr int mostAcross = 24;  // arrows
constexpr int linesOfArrow = 3;

/// The hogels that are drawn: every `step`-th of each row and column.
struct Sample {
  explicit Sample(const PanelParams& display)
      : step(std::max(1, (std::max(display.hogels[0], display.hogels[1]) - 1) / mostAcross + 1)),
        spacing(step * std::min(display.size[0] / display.hogels[0],
                                display.size[1] / display.hogels[1])) {
    for (int j = step / 2; j < display.hogels[1]; j += step)
      for (int i = step / 2; i < display.hogels[0]; i += step) hogels.push_back({i, j});
  }
  int step;
  double spacing;  ///< metres
  std::vector<std::array<int, 2>> hogels;
};

/// Places on the panel in the world.
class OnPanel {
 public:
  explicit OnPanel(const PanelParams& display)
      : m_world(transformFromPose(display.position, display.orientation)) {}
  vtkIdType add(vtkPoints* points, const Vec2& at) const {
    const Vec3 p = m_world.point({at.x, at.y, 0});
    return points->InsertNextPoint(p.x, p.y, p.z);
  }

 private:
  RigidTransform m_world;
};

void addTwinLines(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) {
  const vtkNew<vtkTrivialProducer> source;
  source->SetOutput(data);
  addToScene(renderer, actor, source->GetOutputPort(), SceneLevel::onPanel);
}

/// Draws lines from the design's middles to the lenses, with heads.
void setArrows(vtkPolyData* data, const PanelParams& display, const Twin& twin) {
  const Sample sample(display);
  const Display design(display);
  const OnPanel onPanel(display);
  double longest = 0;
  for (const auto& [i, j] : sample.hogels) {
    const Vec2 shift = twin.shiftOf(i, j);
    longest = std::max(longest, std::hypot(shift.x, shift.y));
  }
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> lines;
  const double scale = longest > 0 ? sample.spacing / longest : 0;
  for (const auto& [i, j] : sample.hogels) {
    const Vec2 from = design.position(i + 0.5, j + 0.5);
    const Vec2 shift = twin.shiftOf(i, j);
    const Vec2 arrow{scale * shift.x, scale * shift.y};
    if (std::hypot(arrow.x, arrow.y) < 0.02 * sample.spacing) continue;
    const Vec2 to{from.x + arrow.x, from.y + arrow.y};
    const vtkIdType tip = onPanel.add(points, to);
    const auto line = [&](const Vec2& end) {
      lines->InsertNextCell({onPanel.add(points, end), tip});
    };
    line(from);
    for (const double side : {-1.0, 1.0})
      line({to.x - 0.25 * arrow.x - side * 0.15 * arrow.y,
            to.y - 0.25 * arrow.y + side * 0.15 * arrow.x});
  }
  data->SetPoints(points);
  data->SetLines(lines);
}

/// Returns blue for hogels that are too dim, orange for those too bright, as strong as `share`,
/// -1 … 1, says.
std::array<unsigned char, 4> colourOf(double share) {
  const double strength = std::min(std::abs(share), 1.0);
  const auto alpha = static_cast<unsigned char>(std::lround(200 * strength));
  return share < 0 ? std::array<unsigned char, 4>{60, 110, 255, alpha}
                   : std::array<unsigned char, 4>{255, 150, 30, alpha};
}

/// Colours the hogels by their gain's distance from 1, at most from the largest one.
void setSquares(vtkPolyData* data, const PanelParams& display, const Twin& twin) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> squares;
  const vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  const Sample sample(display);
  const auto errorOf = [&](int i, int j) {
    const auto& gain = twin.gainOf(i, j);
    return double(gain[0] + gain[1] + gain[2]) / 3 - 1;
  };
  double most = 0;
  for (const auto& [i, j] : sample.hogels)
    if (twin.hasGains()) most = std::max(most, std::abs(errorOf(i, j)));
  if (most > 0) {
    const Display design(display);
    const OnPanel onPanel(display);
    for (const auto& [i, j] : sample.hogels) {
      const double left = i - sample.step / 2;
      const double top = j - sample.step / 2;
      const auto corner = [&](double right, double down) {
        return onPanel.add(points, design.position(left + right, top + down));
      };
      const double side = sample.step;
      squares->InsertNextCell({corner(0, 0), corner(side, 0), corner(side, side), corner(0, side)});
      colours->InsertNextTypedTuple(colourOf(errorOf(i, j) / most).data());
    }
  }
  data->SetPoints(points);
  data->SetPolys(squares);
  data->GetCellData()->SetScalars(colours);
}

}  // namespace

TwinActors::TwinActors(vtkRenderer* renderer) {
  addTwinLines(renderer, m_squares, m_gains);
  addTwinLines(renderer, m_arrows, m_shifts);
  m_arrows->GetProperty()->SetLineWidth(1.5F);
}

void TwinActors::setColours(const Tokens& colours) {
  setColour(m_arrows->GetProperty(), colours.eye);
}

void TwinActors::show(const PanelParams& display, const Twin* twin) {
  if (twin == nullptr) {
    m_shifts->Initialize();
    m_gains->Initialize();
    return;
  }
  setArrows(m_shifts, display, *twin);
  setSquares(m_gains, display, *twin);
}

void TwinActors::setVisible(bool isVisible) {
  m_arrows->SetVisibility(isVisible);
  m_squares->SetVisibility(isVisible);
}

int TwinActors::arrows() const {
  return int(m_shifts->GetNumberOfLines()) / linesOfArrow;
}

}  // namespace hogelscope
