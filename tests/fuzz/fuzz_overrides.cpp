// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes --set: each line of the input is one, of a session and of a camera set.
#include <sstream>

#include "io/documents/camera_set_file.h"
#include "io/documents/session_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

constexpr std::string_view document = R"({"hogelscope": 1,
  "display": {"hogels": [4, 3], "directions": [5, 6]}, "lightField": {"file": "x.png"},
  "cameras": [{"name": "a", "psf": {"sigma": 1.5, "windowSize": 9}}, {"name": "b"}]})";

std::vector<std::string> linesOf(std::string_view input) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(input)};
  for (std::string line; lines.size() < 20 && std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

void fuzz(std::string_view input) {
  const std::vector<std::string> lines = linesOf(input);
  mayRefuse([&] {
    const Session session = loadSession(fileOf("s.json", document), lines);
    require(loadSession(fileOf("t.json", textOf(session))) == session);
  });
  mayRefuse([&] { (void)loadCameraSet("random", lines); });
}
