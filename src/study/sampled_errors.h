// SPDX-License-Identifier: BSD-3-Clause
// Errors of methods, measured on part of the pixels: on blocks that are drawn at random all over
// the pictures, the same for all methods, with an interval that the error of all pixels is in.
#pragma once

#include <cstdint>
#include <vector>

#include "core/engine/renderer.h"
#include "core/metrics/statistics.h"
#include "study/tradeoff.h"

namespace hogelscope {

/// Returns the number of pixels of a view's image.
double pixelsOf(const RenderJob& job);

/// Pixels [x0, x1) of rows [y0, y1).
struct PixelBlock {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] int pixels() const { return (x1 - x0) * (y1 - y0); }
};

/// An image's blocks of 32×4 pixels, smaller at its right and bottom, in rounds of about 1/256 of
/// them. Of each area of 64×128 pixels a block comes in every fourth round (stratified sampling);
/// the first round has one block at least, all together have every pixel once.
constexpr int drawRounds = 256;
std::vector<std::vector<PixelBlock>> drawnBlocks(const std::array<int, 2>& res, std::uint64_t seed);

/// A method's error over the drawn blocks, in squared code values of 8-bit images over pixels and
/// channels.
struct MethodError {
  double square = 0;  ///< the mean
  double low = 0;     ///< its 95 % interval; both are the mean where all pixels were drawn
  double high = 0;
  int largest = 0;        ///< of the drawn pixels, code values
  double mismatches = 0;  ///< share of the drawn pixels that one of both images sees
};

class SampledErrors {
 public:
  /// `pixels` is the number of those of all views, also of the views that add() will not get.
  SampledErrors(std::vector<NamedMethod> methods, std::vector<Question> questions, double pixels,
                std::uint64_t seed, const ParallelRows& parallelRows, Progress progress);

  /// Draws the first round of another view, and further ones if those of all views have too few
  /// blocks for an interval. Throws as Renderer::render() and Simulation.
  void add(const RenderJob& view);
  /// Draws this many rounds more of all views, fewer if no more are left. Throws the same.
  void draw(int rounds);

  /// Whether too few blocks were drawn for an interval that can be relied on.
  [[nodiscard]] bool areFew() const;
  /// Returns how many rounds were drawn.
  [[nodiscard]] int rounds() const { return m_drawn; }
  /// Returns the number of pixels that were compared.
  [[nodiscard]] double pixels() const;
  /// Returns the errors of all methods. An interval is the percentile bootstrap's over blocks
  /// (Efron 1979), narrowed by √(1 − f) where a share f of the pixels was drawn, or a wider one
  /// that knows of errors in few blocks (Fay and Feuer 1997). It is 0 to 255² below eight blocks.
  [[nodiscard]] std::vector<MethodError> errors(Question question) const;
  /// Whether every method has errors, and a PSNR with a narrower interval than this.
  [[nodiscard]] bool areKnown(double decibels) const;

 private:
  /// Sums of one method and question over a view's blocks.
  struct Sums {
    std::vector<double> squares;  ///< of each group of blocks
    int largest = 0;
    double mismatches = 0;
  };
  struct View {
    RenderJob job;
    std::vector<std::vector<PixelBlock>> rounds;
    std::vector<double> pixels;           ///< of each group of blocks
    std::vector<std::vector<Sums>> sums;  ///< of each question and method
    int merged = 1;                       ///< blocks of a group
  };

  void measure(View& view, int first, int last);
  /// Returns the number of all pixels of the views that were added.
  [[nodiscard]] double pixelsOfViews() const;
  [[nodiscard]] std::vector<std::vector<double>> groupsOf(std::size_t question) const;
  void setIntervals(std::vector<MethodError>& errors,
                    const std::vector<std::vector<double>>& groups,
                    const FiguresOfSums& meansOf) const;
  [[nodiscard]] Image reference(Question question, const RenderJob& job,
                                const std::vector<PixelBlock>& blocks);
  [[nodiscard]] Image picture(const RenderJob& job, const std::vector<PixelBlock>& blocks);

  std::vector<NamedMethod> m_methods;
  std::vector<Question> m_questions;
  double m_allPixels;
  std::uint64_t m_seed;
  ParallelRows m_rows;
  Progress m_progress;
  LensTables m_tables;
  std::vector<View> m_views;
  int m_drawn;
};

}  // namespace hogelscope
