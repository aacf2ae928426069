// SPDX-License-Identifier: BSD-3-Clause
// Collects what pictures of a display's views ask of its texels. With the nearest texel and leakage
// inside the hogel, the pixel p of a view says only "the texel that my ray meets should look like
// p".
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/engine/renderer.h"
#include "io/scene/view_source.h"

namespace hogelscope {

/// A view whose picture is what should be seen.
struct TargetView {
  CameraState state;
  std::size_t leakage = 0;        ///< the index of the state's leakage, see StatesLeakage
  std::filesystem::path picture;  ///< "": the ideal view
};

/// The wishes of all rays of all views, collected for some rows of hogels at a time.
class SeenTexels {
 public:
  static constexpr double white = 65535;

  /// One ray's wish, in the light that is summed, 0 … `white`.
  struct Wish {
    std::uint64_t key;  ///< hogel, texel v·du + u and leakage, see texelOf() and leakageOf()
    std::array<std::uint16_t, 3> light;
  };

  /// `source` is the scene whose views they are; of an ideal view, each of its samples is a ray.
  /// Uses about `memory` bytes, but at least a row of hogels' rays. Throws InputError (a picture
  /// that is missing, damaged or of another size; as ViewRays does), Cancelled.
  SeenTexels(ViewSource source, std::vector<TargetView> views, std::size_t leakages,
             LightModel light, std::size_t memory, const Progress& progress);

  /// Returns the rays per texel that any ray meets.
  [[nodiscard]] double meanWeight() const { return m_meanWeight; }
  /// Collects the wishes of a row of hogels, if they are not there.
  void load(int j, const Progress& progress);
  /// Returns those of a hogel of that row, sorted by texel, then by leakage.
  [[nodiscard]] std::span<const Wish> of(int i, int j) const;
  [[nodiscard]] std::size_t texelOf(const Wish& wish) const {
    return std::size_t(wish.key / m_leakages % m_texels);
  }
  [[nodiscard]] std::size_t leakageOf(const Wish& wish) const {
    return std::size_t(wish.key % m_leakages);
  }

 private:
  /// Rows of hogels [first, last).
  struct Band {
    int first = 0;
    int last = 0;
  };

  [[nodiscard]] CameraState refined(const CameraState& state) const;
  [[nodiscard]] std::vector<std::uint16_t> lightOf(const TargetView& view,
                                                   const CameraState& refined, int& each,
                                                   const Progress& progress);
  template <class Use>
  void eachRay(const CameraState& refined, const Use& use, const Progress& progress);
  void chooseBands(std::size_t memory, const Progress& progress);
  void collect(const Band& band, const Progress& progress);

  ViewSource m_source;
  std::vector<TargetView> m_views;
  std::uint64_t m_leakages;
  LightModel m_light;
  LightFieldSize m_size;
  std::uint64_t m_texels;
  Renderer m_renderer;
  std::vector<Band> m_bands;
  Band m_loaded;
  std::vector<Wish> m_wishes;
  double m_meanWeight = 0;
};

}  // namespace hogelscope
