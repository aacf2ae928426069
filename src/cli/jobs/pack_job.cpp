// SPDX-License-Identifier: BSD-3-Clause
// --pack: a light field becomes a store.
#include "cli/jobs/pack_job.h"

#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/progress_bar.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/files/output_folder.h"
#include "io/files/random_access_file.h"
#include "io/files/system_limits.h"
#include "io/scene/scene.h"
#include "io/store/store_writer.h"

namespace hogelscope {

namespace {

/// A display that nobody gave is not kept in the store.
struct Content {
  Session session;
  bool isDisplayGiven = false;
};

Content contentOf(const Options& options) {
  if (options.session.empty() && !isSessionFile(options.subject))
    return {aroundLightField(options.subject, options), false};
  if (options.session.empty()) return {loadSession(options.subject, options.overrides), true};
  return {withLightField(loadSession(options.session, options.overrides), options.subject), true};
}

std::string shapeText(const StoreHeader& header) {
  const auto by = [](int a, int b) { return std::to_string(a) + "×" + std::to_string(b); };
  const auto& [size, type, block, overview, source, display] = header;
  return by(size.nx, size.ny) + " hogels of " + by(size.du, size.dv) + " directions in blocks of " +
         by(block.i, block.j) + " × " + by(block.u, block.v);
}

}  // namespace

int packJob(const Options& options) {
  const auto [session, isDisplayGiven] = contentOf(options);
  const auto file = openLightField(session.lightField, session.display);
  checkOutputs({options.output}, inputsOf(options, file.get()));
  const std::size_t memory = allowedMemory() / (file->isStream() ? 1 : 2);  // the reader's half
  const PackPlan plan =
      planPack(session.lightField, *file,
               isDisplayGiven ? std::optional(session.display) : std::nullopt, memory);
  makeFolderOf(options.output);
  if (!options.quiet)
    std::cout << shapeText(plan.header) << "; rows in memory " << bytesText(plan.memory)
              << ", on the disk about " << bytesText(plan.storeBytes) << readingTime(*file)
              << std::endl;
  ProgressBar bar("packing", options.quiet);
  pack(*file, plan, options.output, options.threads, bar.progress());
  bar.done();
  if (!options.quiet)
    std::cout << options.output << ": " << bytesText(RandomAccessFile(options.output).size())
              << "\n";
  return 0;
}

}  // namespace hogelscope
