// SPDX-License-Identifier: BSD-3-Clause
// A light field that makes up for a display's leakage: of each hogel the content whose light comes
// closest to what its texels should look like (docs/formulas.md, Optimised content).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/panel/twin.h"
#include "io/layouts/light_field_file.h"
#include "optimise/hogel_solver.h"
#include "optimise/seen_texels.h"
#include "optimise/solved_rows.h"

namespace hogelscope {

/// One of the different leakages of a session's states.
struct StatesLeakage {
  PsfParams psf;
  HogelLeakage leakage;
  int states = 0;  ///< that have it
};

/// The problem that is solved for each hogel.
struct Optimisation {
  OptimiseParams params;
  LightModel light = LightModel::encoded;  ///< what leaks, and what `params.lift` scales
  std::vector<StatesLeakage> leakages;     ///< at least one
  std::shared_ptr<const Twin> twin;        ///< its dead pixels stay black; may be null
  std::shared_ptr<SeenTexels> wishes;  ///< what views should look like; null: OptimiseTarget::light

  /// Whether content is its own optimum, to the byte.
  [[nodiscard]] bool isIdentity() const;
};

/// Figures of solved hogels.
struct OptimiseFigures {
  explicit OptimiseFigures(const LightFieldSize& size)
      : clippedOfHogels(std::size_t(size.nx) * std::size_t(size.ny)),
        clippedOfDirections(std::size_t(size.du) * std::size_t(size.dv)) {}

  double before = 0;             ///< Σ f of the content as it was, over hogels and colours
  double after = 0;              ///< Σ f of the optimised one
  double bound = 0;              ///< Σ f of no content is less
  double weight = 0;             ///< Σ W: f/W is the square of a mean error, in parts of white
  std::uint64_t iterations = 0;  ///< of all hogels and colours
  int mostIterations = 0;
  std::uint64_t black = 0;                         ///< values of 0
  std::uint64_t white = 0;                         ///< values of full scale
  std::vector<std::uint32_t> clippedOfHogels;      ///< values of both, ny rows of nx
  std::vector<std::uint32_t> clippedOfDirections;  ///< dv rows of du
};

class OptimisedContent : public WrappedFile {
 public:
  /// `content` is what the display shows before: each texel's own light, and the start.
  OptimisedContent(std::shared_ptr<LightFieldFile> content, Optimisation what);

  /// Solves row after row of hogels, on all threads; bytes depend neither on these nor on memory.
  void stream(const HogelRow& row, const Progress& progress) override;

  /// Solves the rows of `rows` that are this process's, and keeps them there alone.
  void solveShard(const Progress& progress) { solveAll({}, progress); }
  /// Takes the rows that are there from now on, and keeps those that are solved.
  void keepRows(std::shared_ptr<const SolvedRows> rows) { m_rows = std::move(rows); }

  /// Returns the figures of what was streamed last.
  [[nodiscard]] const OptimiseFigures& figures() const { return m_figures; }
  [[nodiscard]] const Optimisation& what() const { return m_what; }

 private:
  template <class T>
  struct Row;
  struct Work;

  void solveAll(const HogelRow& use, const Progress& progress);
  template <class T>
  void finishRow(Row<T>& row, const HogelRow& use, const Progress& progress);
  template <class T>
  void solveRow(Row<T>& row, const Progress& progress);
  template <class T>
  void solveHogel(Row<T>& row, int i, Work& work);
  [[nodiscard]] double lifted(double light) const;
  void addWishes(int i, int j, std::size_t channel, Work& work) const;
  void setTerms(int i, int j, std::size_t channel, Work& work) const;
  void weighBySlopes(Work& work) const;

  Optimisation m_what;
  int m_margin = 0;
  std::shared_ptr<const SolvedRows> m_rows;
  OptimiseFigures m_figures;
};

}  // namespace hogelscope
