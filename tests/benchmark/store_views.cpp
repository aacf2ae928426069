// SPDX-License-Identifier: BSD-3-Clause
// How long a view of a store takes, first and again: the table "At the paper's size" in
// docs/measurements.md.
//   hogelscope-store-views SESSION.json: the first state of a session whose light field is a store
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/base/parallel.h"
#include "core/engine/fast_simulation.h"
#include "core/engine/renderer.h"
#include "core/engine/scaled_view.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"

namespace {

using namespace hogelscope;

template <class Work>
double milliseconds(Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

/// Of some views, one after the other, each another one.
template <class ViewAt>
void print(const char* what, ViewAt viewAt, Renderer& renderer) {
  constexpr int views = 15;
  std::vector<double> times;
  for (int k = 0; k < views; ++k) {
    const RenderJob job = viewAt(k);
    times.push_back(milliseconds([&] { (void)renderer.render(job); }));
  }
  std::sort(times.begin(), times.end());
  std::printf("%-46s %8.1f ms (%.1f … %.1f)\n", what, times[views / 2], times.front(),
              times.back());
}

void measure(const char* file) {
  const Session session = loadSession(file);
  std::optional<ViewSource> scene;
  std::printf("%-46s %8.1f ms\n", "open",
              milliseconds([&] { scene = loadViewSource(session, {}, {.memory = 1000000000}); }));
  Renderer renderer;
  const RenderJob job = scene->job(session.cameras.front());
  const auto moved = [&job](double x) {
    RenderJob other = job;
    other.state.camera.eye.x += x;
    return other;
  };
  std::printf("%-46s %8.1f ms\n", "overview, read and rendered",
              milliseconds([&] { (void)renderer.render(overview(job)); }));
  std::printf("%-46s %8.1f ms\n", "the first view",
              milliseconds([&] { (void)renderer.render(job); }));
  print(
      "the same again", [&](int) { return job; }, renderer);
  print(
      "the eye moved by 1 mm each", [&](int k) { return moved(0.001 * k); }, renderer);
  print(
      "the eye moved by 20 mm each", [&](int k) { return moved(0.02 * (k - 7) + 0.01); }, renderer);
  print(
      "overview, the eye moved by 20 mm each",
      [&](int k) { return overview(moved(0.02 * (k - 7))); }, renderer);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "hogelscope-store-views SESSION.json\n");
    return 2;
  }
  try {
    measure(arguments[1]);
  } catch (const InputError& error) {
    std::fprintf(stderr, "hogelscope-store-views: %s\n", error.what());
    return 2;
  }
  return 0;
}
