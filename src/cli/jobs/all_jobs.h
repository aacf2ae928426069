// SPDX-License-Identifier: BSD-3-Clause
// The functions of all jobs, each named after its option and defined in a file of its own.
#pragma once

#include "cli/command_line.h"
#include "core/optics/session.h"

namespace hogelscope {

// Each returns the exit status and throws InputError; those with a progress bar throw Cancelled.

/// Writes one image for each camera state.
int runRender(const CommandLine& line);
/// Compares every state's image from the session's light field with that from each test. Returns 1
/// for a failed gate.
int runReport(const CommandLine& line);
/// Writes the session and a set of camera states to --output, which may be the session itself.
int runMakeCameras(const CommandLine& line);
/// Writes a test light field of any size; two of its rows of hogels are in memory.
int runGenerate(const CommandLine& line);
/// Writes a light field as a store. Continues where an earlier run stopped.
int runPack(const CommandLine& line);
/// Does the work of runPack() with the session's light field; `isDisplayGiven`: the store keeps its
/// display.
int packContent(const Session& session, bool isDisplayGiven, const CommandLine& line);
/// Writes the session's light field in another layout.
int runExport(const CommandLine& line);
/// Measures speed against accuracy of every method on the session's own states: tradeoff.csv, .png
/// and .svg.
int runTradeoff(const CommandLine& line);
/// Measures where methods fail: stability.csv and .png.
int runStability(const CommandLine& line);
/// Prints what a session, an image, a folder of views or a store is, read as --set says.
int runInfo(const CommandLine& line);
/// Prints which plugins are found, and why any is refused.
int runPlugins(const CommandLine& line);
/// Prints how far the report in a folder is; 1 if it is not finished.
int runStatus(const CommandLine& line);
int runHelp(const CommandLine& line);
int runVersion(const CommandLine& line);

}  // namespace hogelscope
