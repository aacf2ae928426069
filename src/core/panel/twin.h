// SPDX-License-Identifier: BSD-3-Clause
// A twin: one unit of a display as it was built. It says which directional pixel a ray meets, and
// how much light that sends (docs/formulas.md, Twin).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/panel/display.h"
#include "core/panel/move_table.h"
#include "core/panel/twin_params.h"
#include "core/panel/twin_plane.h"

namespace hogelscope {

/// The maps of TwinMapFiles. Lengths are metres; x is to the viewer's right, y upwards.
struct TwinMaps {
  TwinPlane shiftX, shiftY;  ///< of each hogel's lens
  TwinPlane tiltX, tiltY;    ///< slopes
  TwinPlane gap;             ///< gap error
  std::array<TwinPlane, 3> gain;
  TwinPlane moveU, moveV;  ///< over the directions: how many pixels of the design a pixel is off
  TwinPlane sigma;         ///< over the directions: standard deviation of the leakage, px
  std::array<TwinPlane, 3> directionGain;
  TwinPlane height;                  ///< of the panel's surface, over the panel
  std::array<TwinPlane, 3> kernels;  ///< of leakage, kernelTiles × kernelTiles squares
};

/// Tells how a hogel's lens differs from the array's. The shifts are metres, the tilts slopes.
struct HogelErrors {
  float shiftX = 0;
  float shiftY = 0;
  float tiltX = 0;
  float tiltY = 0;
  float gap = 0;
};

/// The lens array, as numbers of an affine map: of two numbers, the first is across, the second
/// down (of hogels) or up (of metres).
struct LensArrayMap {
  std::array<double, 2> cell{};     ///< hogel (i, j) of the panel's middle
  std::array<double, 2> cellX{};    ///< by which (i, j) grow for each metre to the right
  std::array<double, 2> cellY{};    ///< and up
  std::array<double, 2> middle{};   ///< middle of the lens of hogel (0, 0), metres
  std::array<double, 2> middleI{};  ///< by which it moves for each hogel to the right
  std::array<double, 2> middleJ{};  ///< and down
  std::array<double, 2> design{};   ///< middle of hogel (0, 0) as designed
  std::array<double, 2> pitch{};    ///< as designed; the second is down
  std::array<double, 2> wedge{};    ///< gap error for each metre to the right, and up
  std::array<double, 2> field{};    ///< slopes of the whole field, 2 tan(F/2); of linear lenses
  double gap = 0;                   ///< gap error in the middle
  double focal = 0;                 ///< focal error
  double convergence = 0;           ///< 1/viewingDistance
};

/// Taps of a kernel along an axis, counted from its middle.
struct TapRange {
  int first;
  int last;
};

class Twin final : public DisplayKind {
 public:
  /// `design` has its hogels and directions. Throws InputError (twin.…) if a map folds, Cancelled.
  Twin(TwinParams params, TwinMaps maps, const PanelParams& design, const Progress& progress = {});
  /// Returns the bytes that a unit of this design takes while it is made, without its maps.
  [[nodiscard]] static double bytesFor(const TwinParams& params, const PanelParams& design);
  [[nodiscard]] const TwinParams& params() const { return m_params; }
  [[nodiscard]] const DisplayTraits& traits() const override { return m_traits; }
  [[nodiscard]] const Twin* twin() const override { return m_traits.movesRays ? this : nullptr; }
  void complete(PanelMap& map) const override;
  void checkContent(const LightFieldSize& size) const override;

  /// Whether the surface is the plane z = 0 and the hogels' lenses are linear, so that lensArray()
  /// and hogels() are all of meet() but for moved().
  [[nodiscard]] bool isSimple() const { return m_maps.height.isEmpty() && m_array.field[0] > 0; }
  /// Whether moved() changes hits.
  [[nodiscard]] bool movesHits() const {
    return movesDirections() || m_params.lensArray.outside != OutsideField::dark;
  }
  /// Whether texels are other light than their code values are in sRGB.
  [[nodiscard]] bool drivesTexels() const {
    return m_params.light.bits != 0 || m_params.light.eotf != Eotf::srgb;
  }
  /// Whether some texels send no light.
  [[nodiscard]] bool hasDead() const { return m_params.dead != DeadParts{}; }
  [[nodiscard]] bool isDead(const TexelIndex& at) const {
    return isDeadHogel(at.i, at.j) || isDeadColumn(at.i, at.u) || isDeadRow(at.j, at.v);
  }
  [[nodiscard]] bool isDeadHogel(int i, int j) const { return m_deadHogels[hogelAt(i, j)] != 0; }
  [[nodiscard]] bool isDeadColumn(int i, int u) const {
    return m_deadColumns[std::size_t(i) * std::size_t(m_design.directions[0]) + std::size_t(u)] !=
           0;
  }
  [[nodiscard]] bool isDeadRow(int j, int v) const {
    return m_deadRows[std::size_t(j) * std::size_t(m_design.directions[1]) + std::size_t(v)] != 0;
  }

  /// Returns the factor of a colour's index: 1 + χ.
  [[nodiscard]] double scaleOf(std::size_t channel) const {
    return 1 + m_params.colour.scale[channel];
  }
  [[nodiscard]] const LensArrayMap& lensArray() const { return m_array; }
  /// Returns how far a hogel's lens is from where its tile is, metres, to the right and up.
  [[nodiscard]] Vec2 shiftOf(int i, int j) const;
  /// Returns the errors of each hogel, row by row; empty if all are 0.
  [[nodiscard]] const std::vector<HogelErrors>& hogels() const { return m_hogels; }

  [[nodiscard]] std::optional<Hit> meet(const Vec3& eye, const Vec3& direction,
                                        std::size_t channel) const override;
  [[nodiscard]] std::optional<PanelRay> rayOf(const TexelIndex& at) const override;
  /// Returns the ray that leaves the middle of a hogel's lens with a real-valued direction, as one
  /// colour: the inverse of meet(). Its position is where it passes z = 0.
  [[nodiscard]] PanelRay rayOf(int i, int j, double u, double v, std::size_t channel) const;

  /// Whether hits of one colour of scale 1 are affine in slopes and hogels, but for hogelMoves()
  /// and moved().
  [[nodiscard]] bool isAffine() const { return isSimple() && m_isAffine; }
  [[nodiscard]] AffineHits affineHits(const Vec3& eye) const;
  /// Returns the largest of what is added to u and v in any hogel.
  [[nodiscard]] const std::array<double, 2>& largestMoves() const { return m_largestMoves; }
  /// Returns what is added to u and v in each hogel, row by row; empty if nothing is.
  [[nodiscard]] const std::vector<std::array<float, 2>>& hogelMoves() const { return m_hogelMoves; }
  /// Returns all of moved(), if that is a map of directions alone; empty if it is not.
  [[nodiscard]] const MoveTable& directionTable() const { return m_directions; }
  /// Whether kernels know the twin: all of meet() but for the hogels' tables is affine, or there is
  /// no moved().
  [[nodiscard]] bool hasKernel() const {
    return isSimple() && (!movesHits() || (isAffine() && !m_directions.isEmpty()));
  }
  /// Returns a hit on the array after the directions' map, and at the neighbour that is seen in
  /// place of what lies outside the field. A hit beside the array stays.
  [[nodiscard]] Hit moved(Hit hit) const;

  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  /// Whether hogels have gains; theirs, and the least of all colours that is above 0, else 1.
  [[nodiscard]] bool hasGains() const { return !m_gains.empty(); }
  [[nodiscard]] const std::array<float, 3>& gainOf(int i, int j) const {
    return m_gains[hogelAt(i, j)];
  }
  [[nodiscard]] double leastGain() const;
  /// Returns the maps with what was drawn in them, of the size of the hogels.
  [[nodiscard]] TwinMaps drawn() const;
  /// Whether the leakage's width differs over the field.
  [[nodiscard]] bool leaksOverField() const {
    return m_params.leakage.sigmaGrowth > 0 || !m_maps.sigma.isEmpty();
  }
  [[nodiscard]] bool hasDiffraction() const {
    return m_params.colour.wavelengths != ColourErrors{}.wavelengths;
  }
  [[nodiscard]] bool hasKernels() const { return !m_maps.kernels[0].isEmpty(); }
  /// Whether red, green and blue leak differently.
  [[nodiscard]] bool leaksByColour() const { return hasDiffraction() || hasKernels(); }
  /// Returns the standard deviation of the leakage at a direction, px, where psf.sigma is `sigma`.
  [[nodiscard]] double sigmaAt(int u, int v, double sigma) const;
  /// Returns a direction's width in units of the diffraction pattern, λ/p of slope; 0 without one.
  [[nodiscard]] double diffractionStep(std::size_t axis, std::size_t channel) const;
  /// Returns n of kernels of 2n + 1 pixels, and those taps of a direction's kernel, row by row.
  [[nodiscard]] int kernelReach() const {
    return (m_maps.kernels[0].width / m_params.maps.kernelTiles - 1) / 2;
  }
  [[nodiscard]] std::vector<double> kernelAt(int u, int v, std::size_t channel,
                                             const TapRange& across, const TapRange& down) const;

  /// Returns the light of a ray, linear 0 … 1, whose pixels send `content`. `hits` are those of its
  /// colours.
  [[nodiscard]] Rgb lit(const std::array<Hit, 3>& hits, const Rgb& content) const;

 private:
  [[nodiscard]] std::size_t hogelAt(int i, int j) const {
    return std::size_t(j) * std::size_t(m_design.hogels[0]) + std::size_t(i);
  }
  void prepareDead();
  void prepareArray();
  void prepareHogels(const Progress& progress);
  void prepareKernels();
  [[nodiscard]] HogelErrors errorsOf(int i, int j) const;
  struct Move;
  [[nodiscard]] bool movesDirections() const {
    return !m_maps.moveU.isEmpty() || !m_maps.moveV.isEmpty();
  }
  [[nodiscard]] Vec2 solved(const Vec2& designed) const;
  [[nodiscard]] Move moveAt(double u, double v) const;
  void checkDirections() const;
  void checkKernels() const;

  TwinParams m_params;
  TwinMaps m_maps;
  PanelParams m_design;
  LightFieldSize m_size;
  std::array<std::shared_ptr<const HogelLens>, 2> m_lenses;
  LensArrayMap m_array;
  std::vector<HogelErrors> m_hogels;
  std::vector<std::array<float, 2>> m_hogelMoves;
  std::array<double, 2> m_largestMoves{};
  std::vector<std::array<float, 3>> m_gains;
  MoveTable m_directions;
  bool m_isAffine = false;
  /// 1 where dead: hogels row by row, columns and rows of the hogel image; empty if none is.
  std::vector<std::uint8_t> m_deadHogels, m_deadColumns, m_deadRows;
  DisplayTraits m_traits;
};

}  // namespace hogelscope
