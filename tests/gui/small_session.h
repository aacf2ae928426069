// SPDX-License-Identifier: BSD-3-Clause
// A small session in the current folder, quick to read and render, for tests of the window.
#pragma once

#include "tests/io/documents.h"
#include "tests/io/pictures.h"

/// s.json: three states, a (with lens and leakage), b and c, over a.png.
inline void writeSmallSession() {
  writePicture("a.png", 64, 64, [](int x, int y, int channel) {
    return float((x * 5 + y * 3 + channel * 40) % 200 + 20) / 255;
  });
  const auto state = [](const QByteArray& name, const QByteArray& more) {
    return "{\"name\": \"" + name + "\", \"eye\": [0, 0, 0.7], \"res\": [40, 30]" + more + "}";
  };
  writeFile("s.json", text({.display = R"({"hogels": [16, 16], "directions": [4, 4]})",
                            .lightField = R"({"file": "a.png"})",
                            .cameras = "[" +
                                       state("a",
                                             R"(, "distortion": {"k1": 0.1, "p2": 0.01},
                                                "psf": {"sigma": 0.5, "windowSize": 3})") +
                                       ", " + state("b", "") + ", " + state("c", "") + "]"}));
}
