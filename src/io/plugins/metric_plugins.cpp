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

plugin::Figures compared(const plugin::Metric& metric, const Image& reference, const Image& test,
                         const Viewing& viewing) {
  const std::array values{roundedValues(reference), roundedValues(test)};
  const auto viewOf = [](const Image& image, const std::vector<float>& otherwise) {
    const std::vector<float>& shown = image.unrounded.empty() ? otherwise : image.unrounded;
    return plugin::View{image.width, image.height, image.rgb, shown, image.seen};
  };
  return metric.compareBoth(viewOf(reference, values[0]), viewOf(test, values[1]),
                            {viewing.pixelsPerDegree, viewing.distance});
}

/// Adds the column and the mean of a region to `metric`.
void addRegion(Metric& metric, const std::string& name, const plugin::Metric& plugin, bool isSeen,
               const std::string& region) {
  std::string column = name + (isSeen ? "_seen" : "");
  std::ranges::replace(column, '-', '_');
  const int decimals = plugin.decimals();
  metric.means.push_back({.name = "mean_" + column,
                          .title = std::string("mean ") + plugin.title(),
                          .column = metric.columns.size(),
                          .decimals = decimals,
                          .isQuality = true,
                          .unit = plugin.unit(),
                          .isSeen = isSeen,
                          .mayFall = true});
  metric.columns.push_back({.name = column,
                            .title = plugin.title() + region,
                            .unit = plugin.unit(),
                            .help = "Of the plugin " + name,
                            .decimals = decimals,
                            .where = MetricColumn::Where::window});
}

Metric metricOf(const std::string& name) {
  const std::shared_ptr<plugin::Metric> plugin = loadPlugin(name, PluginKind::metric).makeMetric();
  const bool hasSeen = plugin->hasSeen();
  Metric metric;
  metric.readsUnrounded = true;
  addRegion(metric, name, *plugin, false, hasSeen ? " frame" : "");
  if (hasSeen) addRegion(metric, name, *plugin, true, " seen");
  metric.compare = [plugin, hasSeen](const Image& reference, const Image& test, const ParallelRows&,
                                     const Progress& progress,
                                     const Viewing& viewing) -> std::vector<double> {
    throwIfCancelled(progress);
    const plugin::Figures figures = compared(*plugin, reference, test, viewing);
    return hasSeen ? std::vector{figures.frame, figures.seen} : std::vector{figures.frame};
  };
  return metric;
}

/// Throws if a column of the plugin has the name of one that is there.
void refuseOthers(const Metric& metric, const std::string& plugin, const MetricSet& known) {
  constexpr std::array<std::string_view, 4> others{"state", "test", "weight", "problem"};
  for (const MetricColumn& column : metric.columns)
    if (std::ranges::find(others, column.name) != others.end() ||
        std::ranges::find(known.columns(), column.name, &MetricColumn::name) !=
            known.columns().end())
      throw plugin.empty()
          ? InputError("metrics", column.name, "is the name of another column: take another name")
          : pluginError(plugin,
                        "has the name of another column of a report: build it with another");
}

}  // namespace

MetricSet metricsOf(const std::vector<std::string>& names, std::vector<Metric> more) {
  std::vector<Metric> others;
  for (const std::string& name : names) {
    Metric metric = metricOf(name);
    refuseOthers(metric, name, MetricSet(others));
    others.push_back(std::move(metric));
  }
  for (Metric& metric : more) {
    refuseOthers(metric, "", MetricSet(others));
    others.push_back(std::move(metric));
  }
  return MetricSet(std::move(others));
}

}  // namespace hogelscope
