// SPDX-License-Identifier: BSD-3-Clause
// One HTML file with a session's light field, its states and the program's own engine, which shows
// the display to anyone who opens it (resources/web).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/optics/session.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// exact: PNG, decoded to the same bytes everywhere; small: WebP of quality 90.
enum class PageQuality { exact, small };

struct ViewPage {
  std::string html;
  PageQuality quality = PageQuality::exact;
  LightFieldSize size;             ///< of the light field in it
  std::vector<std::string> notes;  ///< what it shows otherwise than the program, in sentences
};

/// A light field of a page, and what the page calls it.
struct PageContent {
  std::string name;
  std::shared_ptr<LightFieldFile> file;
};

struct PageOptions {
  std::string title;
  /// exact if the pictures take at most 8 MB, or for an experiment; else small
  std::optional<PageQuality> quality{};
  /// "pairs" or "dsis" (double stimulus, impairment scale, ITU-R BT.500): viewers vote on the
  /// contents. "": they look around.
  std::string experiment{};
};

/// Returns how many questions an experiment asks each viewer.
std::size_t questionsOf(const std::string& experiment, std::size_t contents, std::size_t states);

/// Throws InputError if this program has no engine for pages, or it does not show such a display.
void requirePage(const Session& session);

/// Returns the page of a session. The first content is its own, others of the same size are
/// compared with it. Content of more than 8 bits is rounded to 8. Beyond 64 million directional
/// pixels every second direction is taken, then every second hogel. No names of folders and files
/// are in it beside those that are given. Throws InputError, Cancelled.
ViewPage viewPage(const Session& session, const std::vector<PageContent>& contents,
                  const PageOptions& options, const Progress& progress);

}  // namespace hogelscope
