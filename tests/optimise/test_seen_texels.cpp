// SPDX-License-Identifier: BSD-3-Clause
// What views ask of texels, collected in bands of hogel rows and at once, and on several threads.
#include <QTest>
#include <map>
#include <set>

#include "core/base/parallel.h"
#include "io/documents/session_file.h"
#include "optimise/seen_texels.h"

using namespace hogelscope;

namespace {

constexpr const char* document = R"({"hogelscope": 1,
  "display": {"size": [0.2, 0.15], "hogels": [12, 9], "directions": [7, 6], "fov": [40, 36]},
  "lightField": {"layout": "live", "source": "scene"},
  "sampling": {"samplesPerPixel": 2},
  "cameras": [
    {"name": "a", "eye": [0, 0, 0.6], "fov": 20, "res": [40, 30]},
    {"name": "b", "eye": [0.1, 0.03, 0.5], "fov": 24, "res": [50, 30],
     "distortion": {"k1": -0.1}},
    {"name": "c", "intrinsics": {"fx": 90, "fy": 91, "cx": 21, "cy": 16}, "eye": [-0.05, 0, 0.55],
     "res": [44, 34]}]})";

/// The wishes of all hogels: sums of light by key, so that equal keys have no order.
std::map<std::uint64_t, std::array<std::uint64_t, 4>> all(SeenTexels& texels, int nx, int ny) {
  std::map<std::uint64_t, std::array<std::uint64_t, 4>> sums;
  for (int j = 0; j < ny; ++j) {
    texels.load(j, {});
    for (int i = 0; i < nx; ++i)
      for (const SeenTexels::Wish& wish : texels.of(i, j)) {
        auto& sum = sums[wish.key];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += wish.light[c];
        ++sum[3];
      }
  }
  return sums;
}

}  // namespace

class TestSeenTexels : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bandsAndThreadsDoNotMatter() {
    const Session session = parseSession(document, ".");
    const ViewSource source = loadViewSource(session, {});
    std::vector<TargetView> views;
    for (const CameraState& state : session.cameras) views.push_back({state, views.size() % 2, {}});
    const auto made = [&](std::size_t memory) {
      return SeenTexels(source, views, 2, LightModel::linear, memory, {});
    };
    SeenTexels whole = made(1000000000);
    const auto expected = all(whole, 12, 9);
    QVERIFY(expected.size() > 250);
    std::uint64_t rays = 0;
    std::set<std::uint64_t> seen;
    for (const auto& [key, sum] : expected) {
      rays += sum[3];
      seen.insert(key / 2);
    }
    QVERIFY(rays > 4000 && rays <= 4 * (40 * 30 + 50 * 30 + 44 * 34));
    QCOMPARE(whole.meanWeight(), double(rays) / double(seen.size()));
    for (const std::size_t memory : {std::size_t{0}, std::size_t{10000}})  // rows, and some rows
      for (const int threads : {1, 2, 7}) {
        setThreads(threads);
        SeenTexels inBands = made(memory);
        QCOMPARE(inBands.meanWeight(), whole.meanWeight());
        QVERIFY(all(inBands, 12, 9) == expected);
      }
    setThreads(0);
  }

  void progressStops() {
    const Session session = parseSession(document, ".");
    const ViewSource source = loadViewSource(session, {});
    const std::vector<TargetView> views{{session.cameras[0], 0, {}}};
    const Progress stop = [](double) { return false; };
    QVERIFY_EXCEPTION_THROWN(SeenTexels(source, views, 1, LightModel::encoded, 0, stop), Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestSeenTexels)
#include "test_seen_texels.moc"
