// SPDX-License-Identifier: BSD-3-Clause
// Facts about the tested light fields.
#include "report/report_facts.h"

#include <array>
#include <ctime>
#include <filesystem>

#include "core/base/text.h"
#include "core/content/capture_content.h"
#include "core/optics/sampling.h"
#include "io/documents/session_file.h"
#include "io/files/content_hash.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "report/versions.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::string contentOf(const LightFieldFile& file, FileHashes& hashes, const Progress& progress) {
  const std::string own = file.contentHash();
  if (!own.empty()) return "XXH3-128 of the pages " + own;
  return file.files().empty() ? "" : "XXH3-128 " + hashes.of(file.files(), progress);
}

/// Returns the session's document with its twin in it.
std::string contentOf(Session session) {
  session.twinFile.clear();
  return textOf(session);
}

/// Returns a text such as "scene.png, 64×64 hogels of 32×32 directions, XXH3-128 …".
std::string described(const std::string& name, const LightFieldSize& size,
                      const std::string& hash) {
  const std::string content = hash.empty() ? "" : ", " + hash;
  return name + ", " + pairText(size.nx, size.ny) + " hogels of " + pairText(size.du, size.dv) +
         " directions" + content;
}

std::string described(const SamplingParams& sampling) {
  const int n = sampling.samplesPerPixel;
  return std::string(nameOf(sampling.reconstruction)) + ", " + pairText(n, n) +
         (n == 1 ? " ray" : " rays") + " a pixel, " +
         (sampling.mapping == LensMapping::exact ? "exact" : "direct") + " lens mapping";
}

/// Returns a time such as "2026-11-22 09:30 UTC".
std::string timeNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 40> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts)};
}

}  // namespace

std::string nameIn(const ReportRequest& request, const std::string& file) {
  if (!request.hasRelativeNames || file.empty()) return file;
  std::error_code error;
  fs::path path = fs::absolute(file, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // "views/" is "views"
  // The last name stays as it is chosen, that of a link or of a folder around the report, too.
  const fs::path folder = relativeTo(request.output + "/report.html", path.parent_path().string());
  return (folder / path.filename()).lexically_normal().string();
}

ReportFacts factsOf(const ReportRequest& request, FileHashes& hashes, const Progress& progress) {
  const Session& session = request.session;
  ReportFacts facts;
  std::string all = versionsLine() + contentOf(session) + (request.images ? "images" : "") +
                    (request.isAgainstIdeal ? "ideal" : "") +
                    (request.isAgainstDesign ? "design" : "");
  const auto line = [&](const std::string& name, const std::string& value) {
    facts.lines.push_back({name, value});
  };
  const auto lightField = [&](const std::string& name, const Session& of,
                              const LightFieldFile& file) {
    const std::string hash = contentOf(file, hashes, progress);
    const LightFieldParams& params = of.lightField;
    line(name, described(params.isLive() ? "live " + params.source : nameIn(request, params.file),
                         file.size(), hash));
    all += hash;
    const auto files = sessionFiles(of);
    if (!files.empty()) all += hashes.of(files, progress);
  };
  if (!request.sessionFile.empty())
    line("Session", nameIn(request, request.sessionFile) + ", XXH3-128 " +
                        hashes.of({request.sessionFile}, progress));
  lightField("Light field", session, *request.file);
  if (request.isAgainstIdeal)
    line("Reference", session.lightField.source == CaptureContent::sourceName
                          ? "ideal view: the capture itself, interpolated, without the display"
                          : "ideal view: the scene itself, without the display");
  if (request.isAgainstDesign)
    line("Reference", "the display as designed; the tests are units as they were built");
  for (const ReportTest& test : request.tests) {
    lightField(request.tests.size() == 1 ? "Test light field" : "Test " + test.name, test.session,
               *test.file);
    Session other = test.session;
    other.cameras.clear();
    all += contentOf(other);
  }
  for (std::size_t k = MetricSet().columns().size(); k < request.metrics.columns().size(); ++k)
    all += request.metrics.columns()[k].name + "\n";
  if (request.frames.empty()) {
    line("Camera states", std::to_string(session.cameras.size()));
  } else {
    for (const int frame : request.frames) all += std::to_string(frame) + "\n";
    line("Views", std::to_string(session.cameras.size()) + " camera states at frames " +
                      std::to_string(request.frames.front()) + " … " +
                      std::to_string(request.frames.back()));
  }
  line("Sampling", described(session.sampling));
  line("Program", versionsLine());
  line("Command", request.command);
  line("Made", timeNow());
  facts.key = contentHash(all);
  return facts;
}

std::vector<std::string> warningsOf(const ReportRequest& request) {
  std::vector<std::string> warnings;
  for (const ReportTest& test : request.tests)
    if (!test.order.empty()) warnings.push_back(test.name + ": " + test.order);
  const std::vector<std::filesystem::path> files = request.file->files();
  // A scene's textures are no pictures of its views; the views of a folder are of one format.
  if (request.session.lightField.isLive() || files.empty()) return warnings;
  const std::string format = lossyFormatOf(files.front());
  if (!format.empty())
    warnings.push_back("the reference is itself a lossy file (" + format + ", " +
                       nameIn(request, files.front().string()) +
                       "): every figure also has its errors; use the lossless original");
  return warnings;
}

}  // namespace hogelscope
