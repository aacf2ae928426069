// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/optimised_content.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>

#include "core/base/parallel.h"
#include "core/optics/image.h"

namespace hogelscope {

namespace {

using Plane = HogelLeakage::Plane;

/// Returns the slope of the encoding between two parts of white in linear light. Below `least`, a
/// tenth of a code value, it is the same for all.
double slopeBetween(double a, double b) {
  constexpr double least = 1e-4;
  a = std::max(a, least);
  b = std::max(b, least);
  constexpr double most = 12.92;  // of the sRGB encoding's straight part
  if (std::abs(a - b) < least) {
    constexpr double gamma = 2.4, scale = 1.055;
    return std::min(most, scale / gamma * std::pow(a, 1 / gamma - 1));
  }
  return std::min(most, (encodedFromLinear(a) - encodedFromLinear(b)) / (255 * (a - b)));
}

/// Appends the bytes of a value, or of a list's values, to a text; takes them off its front.
template <class Value>
void append(std::string& text, const Value* values, std::size_t count) {
  text.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}
template <class Value>
void take(std::string_view& text, Value* values, std::size_t count) {
  std::memcpy(values, text.data(), count * sizeof(Value));
  text.remove_prefix(count * sizeof(Value));
}

}  // namespace

/// A row of hogels: texels as stored, dv rows of nx·du, and the figures of its hogels.
template <class T>
struct OptimisedContent::Row {
  struct Hogel {
    double before = 0, after = 0, bound = 0, weight = 0;
    std::uint64_t iterations = 0;
    int mostIterations = 0;
    std::uint32_t black = 0, white = 0;
  };

  explicit Row(const LightFieldSize& size)
      : width(size.width()),
        texels(std::size_t(size.dv) * 3 * width),
        hogels(std::size_t(size.nx)),
        directions(std::size_t(size.du) * std::size_t(size.dv)) {}

  [[nodiscard]] T* at(int v, std::size_t column) {
    return &texels[3 * (std::size_t(v) * width + column)];
  }
  [[nodiscard]] std::size_t bytes() const {
    return texels.size() * sizeof(T) + hogels.size() * sizeof(Hogel) +
           directions.size() * sizeof(std::uint32_t);
  }
  [[nodiscard]] std::string text() const {
    std::string result;
    append(result, texels.data(), texels.size());
    append(result, hogels.data(), hogels.size());
    append(result, directions.data(), directions.size());
    return result;
  }
  void take(std::string_view text) {
    hogelscope::take(text, texels.data(), texels.size());
    hogelscope::take(text, hogels.data(), hogels.size());
    hogelscope::take(text, directions.data(), directions.size());
  }

  std::size_t width;
  int j = 0;
  int taken = 0;  ///< rows of directions that have arrived
  std::vector<T> texels;
  std::vector<Hogel> hogels;
  std::vector<std::uint32_t> directions;  ///< clipped values
};

/// One thread's memory.
struct OptimisedContent::Work {
  Work(int du, int dv, int margin, const std::vector<StatesLeakage>& leakages)
      : solver(du, dv, margin),
        own(du, dv, margin),
        most(own),
        x(own),
        seen(own),
        scratch(own),
        clipped(std::size_t(du) * std::size_t(dv)) {
    for (const StatesLeakage& one : leakages) terms.push_back({&one.leakage, own, own});
  }

  HogelSolver solver;
  Plane own, most, x, seen, scratch;
  std::vector<HogelTerm> terms;
  std::vector<std::uint32_t> clipped;
};

bool Optimisation::isIdentity() const {
  return wishes == nullptr && params.lift == std::array{0.0, 0.0} && twin == nullptr &&
         std::ranges::all_of(leakages,
                             [](const StatesLeakage& one) { return one.psf.windowSize == 1; });
}

OptimisedContent::OptimisedContent(std::shared_ptr<LightFieldFile> content, Optimisation what)
    : WrappedFile(std::move(content)), m_what(std::move(what)), m_figures(size()) {
  for (const StatesLeakage& one : m_what.leakages)
    m_margin = std::max(m_margin, one.psf.windowSize / 2);
}

double OptimisedContent::lifted(double light) const {
  const auto [black, white] = m_what.params.lift;
  return black + (1 - black - white) * light;
}

void OptimisedContent::stream(const HogelRow& row, const Progress& progress) {
  solveAll(row, progress);
}

void OptimisedContent::solveAll(const HogelRow& use, const Progress& progress) {
  m_figures = OptimiseFigures(size());
  withStoredType(type(), [&](auto zero) {
    using T = decltype(zero);
    Row<T> row(size());
    const Progress polled = forThreads(progress);
    content().stream(
        [&](int j, int v, const StoredRows& rgb) {
          std::copy_n(std::get<const T*>(rgb), 3 * row.width, row.at(v, 0));
          row.j = j;
          if (++row.taken < size().dv) return;
          finishRow(row, use, polled);
          row.taken = 0;
        },
        polled);
  });
}

/// Solves a row of hogels that has all its texels, or takes it from the disk; hands it out.
template <class T>
void OptimisedContent::finishRow(Row<T>& row, const HogelRow& use, const Progress& progress) {
  const std::optional<std::string> kept = m_rows ? m_rows->read(row.j) : std::nullopt;
  if (kept && kept->size() == row.bytes()) {
    row.take(*kept);
  } else {
    if (m_rows && !m_rows->isOwn(row.j)) return;
    if (m_what.wishes) m_what.wishes->load(row.j, progress);
    solveRow(row, progress);
    if (m_rows) m_rows->write(row.j, row.text());
  }
  for (std::size_t i = 0; i < row.hogels.size(); ++i) {
    const auto& one = row.hogels[i];
    m_figures.before += one.before;
    m_figures.after += one.after;
    m_figures.bound += one.bound;
    m_figures.weight += one.weight;
    m_figures.iterations += one.iterations;
    m_figures.mostIterations = std::max(m_figures.mostIterations, one.mostIterations);
    m_figures.black += one.black;
    m_figures.white += one.white;
    m_figures.clippedOfHogels[std::size_t(row.j) * row.hogels.size() + i] = one.black + one.white;
  }
  std::ranges::transform(row.directions, m_figures.clippedOfDirections,
                         m_figures.clippedOfDirections.begin(), std::plus());
  if (!use) return;
  for (int v = 0; v < size().dv; ++v)
    use(row.j, v, StoredRows(std::as_const(row).texels.data() + 3 * std::size_t(v) * row.width));
}

template <class T>
void OptimisedContent::solveRow(Row<T>& row, const Progress& progress) {
  const auto [nx, ny, du, dv] = size();
  std::ranges::fill(row.directions, 0U);
  std::mutex mutex;
  parallelRows(nx, [&, du = du, dv = dv](int begin, int end) {
    Work work(du, dv, m_margin, m_what.leakages);
    for (int i = begin; i < end; ++i) {
      throwIfCancelled(progress);
      solveHogel(row, i, work);
    }
    const std::lock_guard lock(mutex);
    std::ranges::transform(work.clipped, row.directions, row.directions.begin(), std::plus());
  });
}

/// Writes what the hogel's texels should look like, and the weights, of one colour.
void OptimisedContent::setTerms(int i, int j, std::size_t channel, Work& work) const {
  double states = 0;
  for (const StatesLeakage& one : m_what.leakages) states += one.states;
  const SeenTexels* const wishes = m_what.wishes.get();
  const double ofOwn = wishes != nullptr ? m_what.params.keep * wishes->meanWeight() / states : 1;
  for (std::size_t k = 0; k < work.terms.size(); ++k) {
    auto& [leakage, weights, targets] = work.terms[k];
    const double weight = ofOwn * m_what.leakages[k].states;
    for (int v = 0; v < weights.dv; ++v)
      for (int u = 0; u < weights.du; ++u) {
        weights.row(v)[u] = weight;
        targets.row(v)[u] = lifted(work.own.row(v)[u]);
      }
  }
  if (wishes != nullptr) addWishes(i, j, channel, work);
  if (m_what.light == LightModel::linear) weighBySlopes(work);
}

/// Adds to the own light what rays of the views wish: a target is the mean of both by weight.
void OptimisedContent::addWishes(int i, int j, std::size_t channel, Work& work) const {
  // As TwinContent does with the own light: the dimmest hogel is white.
  const Twin* const twin = m_what.twin.get();
  const double gain = twin != nullptr && twin->hasGains() ? double(twin->gainOf(i, j)[channel]) : 0;
  const double dimmed = gain > 0 ? twin->leastGain() / gain : 1;
  const std::span<const SeenTexels::Wish> all = m_what.wishes->of(i, j);
  for (std::size_t k = 0, next = 0; k < all.size(); k = next) {
    std::uint64_t sum = 0;  // whole numbers, whose order does not matter
    for (next = k; next < all.size() && all[next].key == all[k].key; ++next)
      sum += all[next].light[channel];
    HogelTerm& term = work.terms[m_what.wishes->leakageOf(all[k])];
    const auto texel = int(m_what.wishes->texelOf(all[k]));
    double& weight = term.weights.row(texel / term.weights.du)[texel % term.weights.du];
    double& target = term.targets.row(texel / term.weights.du)[texel % term.weights.du];
    const auto rays = double(next - k);
    const double wish = lifted(dimmed * double(sum) / (rays * SeenTexels::white));
    target = (weight * target + rays * wish) / (weight + rays);
    weight += rays;
  }
}

/// Light is summed linear but judged encoded: an error counts by the slope of the encoding between
/// what should be seen and what is seen of the content as it is.
void OptimisedContent::weighBySlopes(Work& work) const {
  for (auto& [leakage, weights, targets] : work.terms) {
    leakage->apply(work.x, work.seen, work.scratch);
    for (int v = 0; v < weights.dv; ++v)
      for (int u = 0; u < weights.du; ++u) {
        const double slope = slopeBetween(targets.row(v)[u], work.seen.row(v)[u]);
        weights.row(v)[u] *= slope * slope;
      }
  }
}

template <class T>
void OptimisedContent::solveHogel(Row<T>& row, int i, Work& work) {
  const bool isLinear = m_what.light == LightModel::linear;
  const auto [nx, ny, du, dv] = size();
  const SolverLimits limits{m_what.params.iterations, m_what.params.tolerance};
  auto& hogel = row.hogels[std::size_t(i)] = {};
  const std::size_t first = std::size_t(i) * std::size_t(du);
  const Twin* const dead = m_what.twin && m_what.twin->hasDead() ? m_what.twin.get() : nullptr;
  for (int v = 0; v < dv; ++v)
    for (int u = 0; u < du; ++u)
      work.most.row(v)[u] = dead != nullptr && dead->isDead({i, row.j, u, v}) ? 0 : 1;
  for (std::size_t c = 0; c < 3; ++c) {
    for (int v = 0; v < dv; ++v)
      for (int u = 0; u < du; ++u) {
        const double code = codeValue(row.at(v, first + std::size_t(u))[c]);
        const double light = isLinear ? linearFromEncoded(code) : code / 255;
        work.own.row(v)[u] = light;
        work.x.row(v)[u] = std::clamp(light, 0.0, work.most.row(v)[u]);
      }
    setTerms(i, row.j, c, work);
    const HogelSolution solution = work.solver.solve(work.terms, work.most, limits, work.x);
    hogel.before += solution.before;
    hogel.after += solution.after;
    hogel.bound += solution.bound;
    hogel.weight += solution.weight;
    hogel.iterations += std::uint64_t(solution.iterations);
    hogel.mostIterations = std::max(hogel.mostIterations, solution.iterations);
    for (int v = 0; v < dv; ++v)
      for (int u = 0; u < du; ++u) {
        const double light = work.x.row(v)[u];
        T& stored = row.at(v, first + std::size_t(u))[c];
        stored = storedValue<T>(isLinear ? encodedFromLinear(light) : 255 * light);
        const bool isBlack = codeValue(stored) <= 0, isWhite = codeValue(stored) >= 255;
        hogel.black += std::uint32_t(isBlack);
        hogel.white += std::uint32_t(isWhite);
        work.clipped[std::size_t(v) * std::size_t(du) + std::size_t(u)] +=
            std::uint32_t(isBlack || isWhite);
      }
  }
}

}  // namespace hogelscope
