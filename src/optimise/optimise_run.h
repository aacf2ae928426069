// SPDX-License-Identifier: BSD-3-Clause
// --optimise: checks what is asked, writes the content that makes up for a display's leakage,
// judges it, and writes F.csv and F.html beside it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/scene/light_field_export.h"
#include "optimise/judged_eyes.h"
#include "optimise/optimised_content.h"

namespace hogelscope {

/// Returns the picture of each state in `optimise.views`, empty for the other targets. Throws
/// InputError for one that is missing.
std::vector<std::filesystem::path> picturesOf(const Session& session);

/// Returns the layout of a name, "hogels", "views", "quilt" or "pack". Throws InputError for
/// another one, or if the output's name is not one of that layout.
ExportLayout optimiseLayout(const std::string& name, const std::filesystem::path& output);

/// Returns the content for a session, whose heads are replaced by their eyes; nothing is solved
/// yet. Throws InputError: a lens sheet; sampling.reconstruction not "nearest"; states whose
/// psf.light differ; a pupil, where states say what should be seen; an error of the twin that is no
/// gain, shift or dead pixel; no ideal views or pictures; nothing to do. Throws Cancelled.
std::shared_ptr<OptimisedContent> optimisedContent(const Session& session,
                                                   const Progress& progress);

struct OptimiseRequest {
  std::string name;  ///< of the session, in texts
  Session session;
  ExportLayout layout = ExportLayout::hogels;
  std::filesystem::path output;  ///< a file, for views a folder
  std::optional<Shard> shard;    ///< of a pack's rows of hogels
};

struct Optimised {
  OptimiseFigures figures;
  Judgement judgement;
  std::vector<std::string> warnings;  ///< what the study of such content has found, where it holds
};

/// Returns the names of the table and of the page of an output.
std::filesystem::path tableOf(const OptimiseRequest& request);
std::filesystem::path pageOf(const OptimiseRequest& request);

/// Solves, writes and judges. Of a pack, solved rows outlive a stop, in OUTPUT.rows; a shard solves
/// its own alone, and returns nothing. Throws InputError, Cancelled.
std::optional<Optimised> optimise(const OptimiseRequest& request, OptimisedContent& content,
                                  const Progress& progress);

/// Returns the smallest transfer of the leakage over directions, at any frequency: where it is
/// nearly 0, no content makes up for it.
double leastTransfer(const PsfParams& psf);

}  // namespace hogelscope
