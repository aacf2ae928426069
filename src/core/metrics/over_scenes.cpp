// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/over_scenes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/metrics/rate_curves.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

namespace {

/// A mean without values that are not finite.
class FiniteMean {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    m_sum += value;
    ++m_count;
  }
  [[nodiscard]] double value() const { return m_count == 0 ? unknownFigure : m_sum / m_count; }

 private:
  double m_sum = 0;
  int m_count = 0;
};

void append(std::vector<double>& list, const std::vector<double>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// A scene whose means may be drawn: those of its curves' tests (RateCurves::means()), then, in the
/// same way, those of all its tests.
class DrawnScene {
 public:
  DrawnScene(const SceneFigures& scene, const MetricSet& metrics)
      : m_scene(scene), m_curves(scene.tests, metrics, scene.groups) {}

  [[nodiscard]] const RateCurves& curves() const { return m_curves; }
  [[nodiscard]] std::vector<double> means() const {
    std::vector<double> all = m_curves.means();
    for (const TestSummary& test : m_scene.tests)
      for (const bool isWeighted : {false, true}) append(all, test.means(isWeighted).values);
    return all;
  }
  /// Returns the sums of each view, from which means() follow.
  [[nodiscard]] std::vector<std::vector<double>> units(const MetricSet& metrics) const {
    std::vector<std::vector<double>> units = m_curves.units();
    if (m_scene.tests.empty()) return units;
    units.resize(m_scene.tests.front().rows.size());
    for (std::size_t view = 0; view < units.size(); ++view)
      for (const TestSummary& test : m_scene.tests)
        append(units[view], sumsOf(test.rows[view], metrics));
    return units;
  }
  [[nodiscard]] std::optional<std::size_t> testAt(const std::string& name) const {
    return placeOf(m_scene.tests, &TestSummary::test, name);
  }
  [[nodiscard]] std::optional<std::size_t> groupAt(const std::string& name) const {
    return placeOf(m_scene.groups, &RateGroup::name, name);
  }
  [[nodiscard]] std::size_t testCount() const { return m_scene.tests.size(); }

 private:
  template <class List, class Member>
  static std::optional<std::size_t> placeOf(const List& list, Member member,
                                            const std::string& name) {
    const auto found = std::ranges::find(list, name, member);
    if (found == list.end()) return std::nullopt;
    return std::size_t(found - list.begin());
  }

  const SceneFigures& m_scene;
  RateCurves m_curves;
};

/// A scene, and means of it.
struct SceneMeans {
  std::size_t scene = 0;
  std::vector<double> means;
};

class ScenesTogether {
 public:
  ScenesTogether(const std::vector<SceneFigures>& scenes, const MetricSet& metrics)
      : m_metrics(metrics) {
    const auto add = [](std::vector<std::string>& names, const std::string& name) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    bool haveWeights = false;
    for (const SceneFigures& scene : scenes) {
      m_scenes.emplace_back(scene, metrics);
      for (const TestSummary& test : scene.tests) add(m_tests, test.test);
      for (const RateGroup& group : scene.groups) add(m_groups, group.name);
      haveWeights = haveWeights || m_scenes.back().curves().haveWeights();
    }
    m_pairs = bdPairs(metrics, m_groups.size(), haveWeights);
  }

  [[nodiscard]] OverScenes figures() const {
    std::vector<SceneMeans> scenes;
    std::vector<std::vector<std::vector<double>>> units;
    for (std::size_t k = 0; k < m_scenes.size(); ++k) {
      scenes.push_back({k, m_scenes[k].means()});
      units.push_back(m_scenes[k].units(m_metrics));
    }
    constexpr BootstrapParams draws{.resamples = 1000};
    const std::vector<Interval> intervals = nestedBootstrap(
        units,
        [this](const std::vector<DrawnGroup>& drawn) {
          std::vector<SceneMeans> means;
          for (const DrawnGroup& one : drawn)
            means.push_back({one.group, meansOfSums(one.sums, m_metrics)});
          return meansOver(means);
        },
        draws);
    return described(scenes, meansOver(scenes), intervals);
  }

 private:
  /// Returns the means over scenes: of each test twice as many as there are means, then of each
  /// pair BD-rate and gain.
  [[nodiscard]] std::vector<double> meansOver(const std::vector<SceneMeans>& scenes) const {
    const std::size_t count = 2 * m_metrics.means().size();
    std::vector<double> all;
    for (const std::string& test : m_tests) {
      std::vector<FiniteMean> means(count);
      for (const auto& [scene, own] : scenes)
        if (const auto at = m_scenes[scene].testAt(test)) {
          const std::size_t first = own.size() - (m_scenes[scene].testCount() - *at) * count;
          for (std::size_t k = 0; k < count; ++k) means[k].add(own[first + k]);
        }
      std::ranges::transform(means, std::back_inserter(all), &FiniteMean::value);
    }
    for (const BdPair& pair : m_pairs) {
      FiniteMean rate, gain;
      for (const SceneMeans& scene : scenes)
        if (const std::optional<BdDelta> delta = deltaOf(pair, scene)) {
          rate.add(delta->rate);
          gain.add(delta->quality);
        }
      all.insert(all.end(), {rate.value(), gain.value()});
    }
    return all;
  }

  /// Returns the delta of a scene; none if it has not both groups, or cannot compare them.
  [[nodiscard]] std::optional<BdDelta> deltaOf(const BdPair& pair, const SceneMeans& scene) const {
    const DrawnScene& own = m_scenes[scene.scene];
    const auto anchor = own.groupAt(m_groups[pair.anchor]);
    const auto group = own.groupAt(m_groups[pair.group]);
    if (!anchor || !group) return std::nullopt;
    BdDelta delta = own.curves().deltaOf({*anchor, *group, pair.mean}, scene.means);
    if (!delta.problem.empty()) return std::nullopt;
    return delta;
  }

  [[nodiscard]] OverScenes described(const std::vector<SceneMeans>& scenes,
                                     const std::vector<double>& means,
                                     const std::vector<Interval>& intervals) const {
    const std::size_t count = m_metrics.means().size();
    OverScenes over;
    std::size_t at = 0;
    const auto part = [&](const auto& list, std::size_t length) {
      const auto first = list.begin() + std::ptrdiff_t(at);
      return std::vector(first, first + std::ptrdiff_t(length));
    };
    for (const std::string& test : m_tests) {
      TestOverScenes& one = over.tests.emplace_back();
      one.test = test;
      one.scenes = std::size_t(std::ranges::count_if(
          m_scenes, [&](const DrawnScene& scene) { return scene.testAt(test).has_value(); }));
      one.intervals = part(intervals, 2 * count);
      one.means = part(means, count);
      at += count;
      one.weighted = part(means, count);
      at += count;
    }
    for (const BdPair& pair : m_pairs) {
      BdOverScenes& one = over.comparisons.emplace_back();
      one.anchor = m_groups[pair.anchor];
      one.group = m_groups[pair.group];
      one.quality = m_metrics.means()[pair.mean % count];
      one.isWeighted = pair.mean >= count;
      one.rate = means[at];
      one.rateInterval = intervals[at];
      one.gain = means[at + 1];
      one.gainInterval = intervals[at + 1];
      at += 2;
      for (const SceneMeans& scene : scenes) {
        const std::optional<BdDelta> delta = deltaOf(pair, scene);
        one.ofScenes.push_back(delta ? delta->rate : unknownFigure);
        one.scenes += delta ? 1 : 0;
        one.better += delta && delta->rate < 0 ? 1 : 0;
      }
      one.signTest = signTest(one.ofScenes);
      one.signedRankTest = signedRankTest(one.ofScenes);
    }
    return over;
  }

  const MetricSet& m_metrics;
  std::vector<DrawnScene> m_scenes;
  std::vector<std::string> m_tests;
  std::vector<std::string> m_groups;
  std::vector<BdPair> m_pairs;
};

}  // namespace

OverScenes overScenes(const std::vector<SceneFigures>& scenes, const MetricSet& metrics) {
  return ScenesTogether(scenes, metrics).figures();
}

}  // namespace hogelscope
