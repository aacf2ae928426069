// SPDX-License-Identifier: BSD-3-Clause
// A campaign: several scenes with the same tests, each scene a report of its own. The document's
// paths are relative to it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/summary.h"

namespace hogelscope {

struct CampaignScene {
  std::string name;         ///< of the scene's folder, too
  std::string session;      ///< the document's file
  std::string states = "";  ///< a pattern of states; "": all
};

struct CampaignTest {
  std::string name;   ///< "GROUP NAME", or without a group "NAME"; unique
  std::string group;  ///< of a rate-distortion curve; "": none
  std::string file;   ///< with {scene} in it
};

/// Bits per directional pixel and frame.
struct CampaignRate {
  std::string scene;
  std::string test;
  double bits = 0;
};

struct Campaign {
  std::string file;
  std::vector<CampaignScene> scenes;
  std::vector<CampaignTest> tests;
  std::vector<std::string> metrics;  ///< in place of the sessions' own, if there are any
  /// Columns of the table of means, by their names in summary.csv, and "scenes"; empty: the number
  /// of scenes and the headlines.
  std::vector<std::string> columns;
  std::string rateFile;  ///< "": none
  std::vector<CampaignRate> rates;
};

/// Reads a campaign. Throws InputError that names the file and the entry.
Campaign loadCampaign(const std::string& file);
/// Reads the text of a campaign's document; `file` is its name, beside which its paths are.
Campaign parseCampaign(const std::string& text, const std::string& file);

/// A test of a scene, and the light field that is compared.
struct SceneTest {
  const CampaignTest* test = nullptr;
  std::string file;
};

/// The work for a scene: what its report compares. The campaign must live as long.
struct SceneWork {
  std::string session;
  std::string states;
  std::string folder;              ///< of its report
  std::vector<SceneTest> tests;    ///< whose files are there
  std::vector<SceneTest> missing;  ///< the others
  std::vector<RateGroup> groups;   ///< of four tests or more that are there; rates 0: of files
  std::vector<std::string> lines;  ///< sentences on what is left out

  /// Returns the arguments of `hogelscope` for the scene's report alone.
  [[nodiscard]] std::vector<std::string> arguments(const Campaign& campaign) const;
};

/// Looks for a scene's tests; its report goes to a folder in `output`.
SceneWork workOf(const Campaign& campaign, const CampaignScene& scene,
                 const std::filesystem::path& output);

}  // namespace hogelscope
