// SPDX-License-Identifier: BSD-3-Clause
// Campaigns for Python, which makes the scenes' reports itself.
#include <pybind11/stl.h>

#include "campaign/campaign.h"
#include "campaign/campaign_tables.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "python/bindings.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

/// Returns the campaign of a text, or of a file if there is no text.
Campaign campaignOf(const std::string& text, const std::string& file) {
  return text.empty() ? loadCampaign(file) : parseCampaign(text, file);
}

/// Returns the metrics that replace the sessions' own, and a dict for each scene.
py::tuple scenesOf(const std::string& text, const std::string& file, const std::string& output) {
  const Campaign campaign = campaignOf(text, file);
  py::list scenes;
  for (const CampaignScene& scene : campaign.scenes) {
    const SceneWork work = workOf(campaign, scene, output);
    py::dict one;
    py::list tests;
    for (const SceneTest& test : work.tests) tests.append(test.file);
    py::dict groups;
    for (const RateGroup& group : work.groups) {
      py::dict rates;
      for (const TestRate& test : group.tests)
        rates[py::str(test.test)] = test.rate > 0 ? py::object(py::float_(test.rate)) : py::none();
      groups[py::str(group.name)] = rates;
    }
    one["scene"] = scene.name;
    one["session"] = work.session;
    one["states"] = work.states;
    one["folder"] = work.folder;
    one["tests"] = tests;
    one["groups"] = groups;
    one["lines"] = work.lines;
    scenes.append(one);
  }
  return py::make_tuple(campaign.metrics, scenes);
}

/// Writes the campaign's files from the scenes' reports. Returns the texts of campaign.csv,
/// summary.csv and bd.csv, and the sentences on what is missing.
py::tuple tablesOf(const std::string& text, const std::string& file, const std::string& output) {
  const Campaign campaign = campaignOf(text, file);
  CampaignResult result;
  runStoppable(py::none(), [&](const Progress&, const InPython&) {
    checkOutputs(campaignFiles(output));
    result = writeCampaign(campaign, output);
  });
  const std::filesystem::path folder = output;
  const auto textOfMember = [&](const char* name) {
    const std::filesystem::path table = folder / name;
    return std::filesystem::is_regular_file(table) ? readTextFile(table) : std::string();
  };
  return py::make_tuple(textOfMember("campaign.csv"), textOfMember("summary.csv"),
                        textOfMember("bd.csv"), result.missing);
}

}  // namespace

void addCampaigns(py::module_& module) {
  module.def("campaign_scenes", &scenesOf, py::arg("text"), py::arg("file"), py::arg("output"),
             "The metrics of a campaign, and what each scene's report compares.");
  module.def("campaign_tables", &tablesOf, py::arg("text"), py::arg("file"), py::arg("output"),
             "Writes a campaign's files from the reports of its scenes, and returns its tables.");
}

}  // namespace hogelscope
