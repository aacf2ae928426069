// SPDX-License-Identifier: BSD-3-Clause
// The functions of all jobs, each named after its option and defined in its own file; those of
// --help and --version in help.cpp.
#pragma once

#include "cli/command_line.h"
#include "core/optics/session.h"

namespace hogelscope {

// Each returns the exit status and throws InputError; those with a progress bar throw Cancelled.

/// Writes one image for each camera state.
int runRender(const CommandLine& line);
/// Compares every state's image from the session's light field with the image from each test.
/// Returns 1 for a failed gate.
int runReport(const CommandLine& line);
/// Writes the session and a set of camera states to --output, which may be the session itself.
int runMakeCameras(const CommandLine& line);
int runMakeTwin(const CommandLine& line);
/// Writes a test light field of any size, with two of its hogel rows in memory.
int runGenerate(const CommandLine& line);
/// Writes a light field as a store. Continues where an earlier run stopped.
int runPack(const CommandLine& line);
/// Packs the session's light field as runPack() does. With `isDisplayGiven` the store contains the
/// session's display.
int packContent(const Session& session, bool isDisplayGiven, const CommandLine& line);
/// Writes the session's light field in another layout.
int runExport(const CommandLine& line);
/// Measures speed against accuracy of every method on the session's own states: tradeoff.csv, .png
/// and .svg.
int runTradeoff(const CommandLine& line);
/// Measures the failures of methods: stability.csv and .png.
int runStability(const CommandLine& line);
/// Measures the figures of the session's display: measure.csv, measure.html and plots.
int runMeasure(const CommandLine& line);
/// Measures figures of many designs of the session: sweep.csv, sweep.html and plots.
int runSweep(const CommandLine& line);
/// Measures whether the session's content fits its display in depth: depth.csv, .json, .svg and
/// .png.
int runDepth(const CommandLine& line);
/// Prints the properties of a session, an image, a folder of views or a store, read as --set
/// specifies.
int runInfo(const CommandLine& line);
/// Prints the plugins that are found, and the reasons for rejected ones.
int runPlugins(const CommandLine& line);
/// Prints the progress of the report in a folder. Returns 1 if it is not finished.
int runStatus(const CommandLine& line);
int runHelp(const CommandLine& line);
int runVersion(const CommandLine& line);

}  // namespace hogelscope
