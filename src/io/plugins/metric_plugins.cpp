// SPDX-License-Identifier: BSD-3-Clause
#include "io/plugins/metric_plugins.h"

#include <algorithm>
#include <array>
#include <memory>

#include "io/plugins/plugin_guard.h"
#include "io/plugins/plugin_library.h"

namespace hogelscope {

namespace {

/// Returns rounded values for an image without unrounded ones.
std::vector<float> roundedValues(const Image& image) {
  if (!image.unrounded.empty()) return {};
  std::vector<double> values(image.rgb.size());
  readCodeValues(image, 0, values);
  return {values.begin(), values.end()};
}

double compared(const plugin::Metric& metric, const Image& reference, const Image& test,
                const Viewing& viewing) {
  const std::array values{roundedValues(reference), roundedValues(test)};
  const auto viewOf = [](const Image& image, const std::vector<float>& otherwise) {
    const std::vector<float>& shown = image.unrounded.empty() ? otherwise : image.unrounded;
    return plugin::View{image.width, image.height, image.rgb, shown, image.seen};
  };
  return metric.compare(viewOf(reference, values[0]), viewOf(test, values[1]),
                        {viewing.pixelsPerDegree, viewing.distance});
}

Metric metricOf(const std::string& name) {
  const std::shared_ptr<plugin::Metric> metric = loadPlugin(name, PluginKind::metric).makeMetric();
  std::string column = name;
  std::ranges::replace(column, '-', '_');
  const int decimals = metric->decimals();
  return {
      .columns = {{.name = column,
                   .title = metric->title(),
                   .unit = metric->unit(),
                   .help = "Of the plugin " + name,
                   .decimals = decimals,
                   .where = MetricColumn::Where::window}},
      .means = {{.name = "mean_" + column,
                 .title = std::string("mean ") + metric->title(),
                 .decimals = decimals,
                 .isQuality = true,
                 .unit = metric->unit()}},
      .compare = [metric](const Image& reference, const Image& test, const ParallelRows&,
                          const Progress& progress, const Viewing& viewing) -> std::vector<double> {
        throwIfCancelled(progress);
        return {compared(*metric, reference, test, viewing)};
      },
      .readsUnrounded = true};
}

/// Throws if a plugin's column has the name of a standard one.
void refuseStandard(const std::string& column, const std::string& plugin) {
  constexpr std::array<std::string_view, 4> others{"state", "test", "weight", "problem"};
  const MetricSet standard;
  if (std::ranges::find(others, column) != others.end() ||
      std::ranges::find(standard.columns(), column, &MetricColumn::name) !=
          standard.columns().end())
    throw pluginError(plugin, "has the name of another column of a report: build it with another");
}

}  // namespace

MetricSet metricsOf(const std::vector<std::string>& names) {
  std::vector<Metric> others;
  for (const std::string& name : names) {
    others.push_back(metricOf(name));
    refuseStandard(others.back().columns.front().name, name);
  }
  return MetricSet(std::move(others));
}

}  // namespace hogelscope
