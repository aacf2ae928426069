// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <set>

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/text.h"
#include "core/metrics/flicker.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "io/opening/session_around.h"
#include "report/page/test_names.h"
#include "report/panel_projection.h"
#include "report/report_facts.h"
#include "report/report_files.h"
#include "report/report_frames.h"
#include "report/report_moves.h"
#include "report/view_pairs.h"
#include "runs/journal.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Sum of time over all threads.
class TimeSum {
 public:
  template <class Work>
  auto of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    m_nanoseconds += (std::chrono::steady_clock::now() - start).count();
    return result;
  }
  [[nodiscard]] double seconds() const { return 1e-9 * double(m_nanoseconds); }

 private:
  std::atomic<std::int64_t> m_nanoseconds = 0;
};

bool seesAnything(const Image& image) {
  return std::ranges::any_of(image.seen, [](std::uint8_t seen) { return seen != 0; });
}

class ReportRun {
 public:
  ReportRun(const ReportRequest& request, const ReportListener& listener);
  Report run();

 private:
  void takeUp();
  void readLightFields(std::size_t test, std::size_t frame);
  [[nodiscard]] bool isOpen(std::size_t test, std::size_t state) const;
  [[nodiscard]] std::vector<std::size_t> statesToRender(std::size_t test,
                                                        const FrameViews& frame) const;
  [[nodiscard]] std::vector<FrameViews> framesToRead() const;
  void runTest(std::size_t test, std::size_t frame);
  void finishTest(std::size_t test);
  void finishFrames();
  void readAgain(std::size_t test, std::size_t state);
  void setFlicker(std::size_t test, std::size_t state, const ViewPair& pair,
                  std::vector<double>& values);
  void runState(std::size_t test, std::size_t state, std::size_t worker);
  void compareState(std::size_t test, std::size_t state, std::size_t worker, const ViewPair& pair);
  void showViews(std::size_t test);
  void setKilobits();
  void writeAll();

  [[nodiscard]] std::size_t states() const { return m_request.session.cameras.size(); }
  [[nodiscard]] fs::path panelFile(std::size_t test, const std::optional<Shard>& shard) const {
    return m_folder / ("report.panel" + std::to_string(test + 1) + endingOf(shard));
  }
  /// The estimated cost of reading a light field, in states, for the progress bar.
  [[nodiscard]] double readingSteps() const {
    return 1 + 0.1 * double(states()) / double(m_frames.size());
  }
  [[nodiscard]] bool isInTime() const { return !m_request.frames.empty(); }
  [[nodiscard]] std::size_t rowOf(std::size_t test, std::size_t state) const {
    return ReportOrder{m_request.tests.size()}.row(state, test);
  }

  const ReportRequest& m_request;
  const ReportListener& m_listener;
  fs::path m_folder;
  StepProgress m_progress;
  FileHashes m_hashes;
  ReportFacts m_facts;
  RunRows m_rows;
  std::vector<std::unique_ptr<PanelProjection>> m_projections;  ///< of each test
  ShardOfViews m_shard;
  std::vector<FrameViews> m_frames;                  ///< those that are read
  std::vector<std::optional<std::size_t>> m_before;  ///< viewsBefore()
  std::vector<std::optional<std::size_t>> m_after;   ///< the same the other way round
  /// Of each test the differences of the last two frames' views, by their number.
  std::vector<std::map<std::size_t, FrameDifference>> m_differences;
  std::mutex m_differencesMutex;
  std::size_t m_workers;
  ViewPairs m_pairs;
  std::vector<ReportView> m_views;
  std::vector<std::string> m_names;               ///< of the tests, for figures
  std::vector<std::vector<double>> m_viewErrors;  ///< of each test; empty if not in memory
  Report m_report;
  TimeSum m_rendering;
  TimeSum m_comparing;
  TimeSum m_writing;
};

/// Returns the number of states in parallel; for few states it is 1, and an image's rows run in
/// parallel.
std::size_t workersFor(const ReportRequest& request) {
  const auto threads = std::size_t(threadCount());
  std::size_t most = 0;
  for (const FrameViews& frame : framesOf(request)) most = std::max(most, frame.end - frame.begin);
  return most < 2 * threads ? 1 : threads;
}

/// Throws InputError if the differences of two frames do not fit in memory.
void checkDifferences(const ReportRequest& request) {
  if (request.frames.empty()) return;
  double most = 0;
  for (const FrameViews& frame : framesOf(request)) {
    double bytes = 0;
    for (std::size_t view = frame.begin; view < frame.end; ++view) {
      const auto [width, height] = request.session.cameras[view].camera.res;
      bytes += 2.0 * double(request.tests.size()) * (3 * sizeof(float) + 1) * width * height;
    }
    most = std::max(most, bytes);
  }
  if (most > double(machineMemory()) / 2)
    throw InputError("cameras", "the differences of their pictures at two frames need " +
                                    bytesText(std::size_t(most)) + " of memory, this machine has " +
                                    bytesText(machineMemory()) + ": take fewer states");
}

fs::path makeOutputFolder(const fs::path& folder) {
  makeFolder(folder);
  return folder;
}

ReportRun::ReportRun(const ReportRequest& request, const ReportListener& listener)
    : m_request(request),
      m_listener(listener),
      m_folder(makeOutputFolder(request.output)),
      m_progress(listener.progress),
      m_hashes(m_folder),
      m_facts(factsOf(request, m_hashes, m_progress.within())),
      m_rows(m_folder, {m_facts.key, states(), request.tests.size()}, request.shard,
             request.metrics.columns().size()),
      m_shard(request),
      m_frames(framesOf(request)),
      m_before(viewsBefore(request)),
      m_after(m_before.size()),
      m_differences(request.tests.size()),
      m_workers(workersFor(request)),
      m_pairs(request, m_workers, m_workers == 1 ? parallelRows : serialRows) {
  checkDifferences(request);
  for (std::size_t view = 0; view < states(); ++view)
    if (m_before[view]) m_after[*m_before[view]] = view;
  m_report.rows.resize(states() * request.tests.size());
  std::vector<std::string> files;
  for (const ReportTest& test : request.tests) files.push_back(test.name);
  m_names = figureNames(files);
  m_report.replacedAnother = m_rows.replacedAnother();
  takeUp();
}

/// Takes the results of an earlier run.
void ReportRun::takeUp() {
  const std::vector<ReportTest>& tests = m_request.tests;
  for (std::size_t state = 0; state < states(); ++state) {
    const CameraParams& camera = m_request.session.cameras[state].camera;
    for (std::size_t test = 0; test < tests.size(); ++test) {
      ReportRow& row = m_report.rows[rowOf(test, state)];
      row = {camera.name, tests[test].name, {}, camera.eye, camera.weight};
      if (isInTime()) row.frame = m_request.frames[state];
    }
  }
  for (const auto& [index, entry] : m_rows.taken()) {
    m_report.rows[index].values = entry.values;
    m_report.rows[index].problem = entry.problem;
    if (m_listener.finished) m_listener.finished(index, m_report.rows[index]);
  }
  m_report.taken = m_rows.taken().size();
  for (std::size_t test = 0; test < tests.size(); ++test) {
    m_projections.push_back(std::make_unique<PanelProjection>(
        panelFile(test, m_request.shard), m_facts.key, m_request.file->size(),
        std::max(m_request.file->bits(), tests[test].file->bits()) > 8));
    for (const Shard& shard : m_rows.shards()) m_projections[test]->join(panelFile(test, shard));
  }
  if (m_request.shard) return;
  // Removes the table of an earlier report, which must not be mistaken for this one's.
  std::error_code none;
  fs::remove(m_folder / "report.csv", none);
}

void ReportRun::compareState(std::size_t test, std::size_t state, std::size_t worker,
                             const ViewPair& pair) {
  ReportRow row = m_report.rows[rowOf(test, state)];
  row.problem = pair.problem;
  row.values = m_request.metrics.noValues();
  if (pair.problem.empty()) {
    if (m_request.images)
      m_writing.of([&] {
        writeImages(m_folder, test, pictureName(m_report.rows, rowOf(test, state)), pair,
                    m_progress.within());
        return 0;
      });
    if (!seesAnything(pair.reference) && !seesAnything(pair.test))
      row.problem = seesNothing;
    else
      try {
        row.values = m_comparing.of([&] {
          return m_request.metrics.compare(pair.reference, pair.test,
                                           m_pairs.renderer(worker).rows(), m_progress.within(),
                                           m_pairs.viewing(state));
        });
      } catch (const std::bad_alloc&) {
        row.problem = "not enough memory to compare its pictures";
      }
    if (isInTime()) setFlicker(test, state, pair, row.values);
    if (m_request.isAgainstDesign && row.problem.empty())
      std::ranges::copy(moveValues(m_pairs.moves(state, worker, m_progress.within())),
                        row.values.end() - 2);
  }
  const std::size_t index = rowOf(test, state);
  m_rows.add(index, {row.values, row.problem}, [&] {
    m_report.rows[index] = row;
    if (m_listener.finished) m_listener.finished(index, row);
  });
}

/// Sets the error of the change since the frame before.
void ReportRun::setFlicker(std::size_t test, std::size_t state, const ViewPair& pair,
                           std::vector<double>& values) {
  const FrameDifference* before = nullptr;
  {
    const std::lock_guard lock(m_differencesMutex);
    auto& known = m_differences[test];
    const auto at = m_before[state] ? known.find(*m_before[state]) : known.end();
    if (at != known.end()) before = &at->second;
  }
  if (before == nullptr) return;
  const FlickerError error = flickerError(*before, frameDifference(pair.reference, pair.test));
  const auto& columns = m_request.metrics.columns();
  const auto column =
      std::ranges::find(columns, flickerMetric().columns[0].name, &MetricColumn::name);
  std::ranges::copy(flickerValues(error), values.begin() + (column - columns.begin()));
}

void ReportRun::runState(std::size_t test, std::size_t state, std::size_t worker) {
  const ViewPair pair =
      m_rendering.of([&] { return m_pairs.render(state, worker, m_progress.within()); });
  if (m_after.at(state) && pair.problem.empty()) {
    FrameDifference difference = frameDifference(pair.reference, pair.test);
    const std::lock_guard lock(m_differencesMutex);
    m_differences[test][state] = std::move(difference);
  }
  if (!isOpen(test, state)) return;  // only the next frame needs it
  // The row may be on disk already if the projection was saved before it.
  if (!m_rows.has(rowOf(test, state))) compareState(test, state, worker, pair);
  m_projections[test]->add(state, worker, pair, m_pairs, m_progress.within());
  m_progress.finish();
}

/// Reads the frame of a state for pictures of it.
void ReportRun::readAgain(std::size_t test, std::size_t state) {
  for (const FrameViews& frame : framesOf(m_request)) {
    if (state < frame.begin || state >= frame.end) continue;
    m_pairs.expect({frame});
    m_pairs.read(test, 0, m_progress.within());
  }
}

/// Writes the worst, the median and the best of a test's views.
void ReportRun::showViews(std::size_t test) {
  const std::vector<std::size_t> order =
      worstFirst(m_report.rows, ReportOrder{m_request.tests.size()}, test);
  const auto show = [&](const char* which, std::size_t state) {
    if (isInTime()) readAgain(test, state);
    const ViewPair pair = m_pairs.render(state, 0, m_progress.within());
    const ReportRow& row = m_report.rows[rowOf(test, state)];
    const SheetLabels labels{viewName(row), m_names[test], row.values[psnrSeenColumn]};
    m_views.push_back(m_writing.of([&] {
      return writeView(m_folder, {rowOf(test, state), test, which},
                       roomForView(m_views, m_request.tests.size()), pair, labels,
                       m_progress.within());
    }));
  };
  if (!order.empty()) show("worst", order.front());
  if (order.size() > 2) show("median", order[order.size() / 2]);
  if (order.size() > 1) show("best", order.back());
}

/// Saves and ignores errors, so that the earlier exception is the one reported.
void saveQuietly(PanelProjection& projection) {
  try {
    projection.save();
  } catch (const InputError&) {
  }
}

/// Whether a state of this run is not finished yet.
bool ReportRun::isOpen(std::size_t test, std::size_t state) const {
  return m_shard.has(state) &&
         (!m_rows.has(rowOf(test, state)) || !m_projections[test]->has(state));
}

/// Returns a frame's states that are open, or whose next frame is.
std::vector<std::size_t> ReportRun::statesToRender(std::size_t test,
                                                   const FrameViews& frame) const {
  std::vector<std::size_t> states;
  for (std::size_t state = frame.begin; state < frame.end; ++state)
    if (isOpen(test, state) || (m_after[state] && isOpen(test, *m_after[state])))
      states.push_back(state);
  return states;
}

/// Returns the frames of which something is to be rendered; a still always.
std::vector<FrameViews> ReportRun::framesToRead() const {
  std::vector<FrameViews> frames;
  for (const FrameViews& frame : framesOf(m_request)) {
    bool isNeeded = !isInTime();
    for (std::size_t test = 0; test < m_request.tests.size(); ++test)
      isNeeded = isNeeded || !statesToRender(test, frame).empty();
    if (isNeeded) frames.push_back(frame);
  }
  return frames;
}

void ReportRun::readLightFields(std::size_t test, std::size_t frame) {
  const bool isReferenceKnown = m_request.reference && !isInTime();
  const bool isFirst = test == 0 && (frame == 0 || isInTime());
  if (isFirst && isReferenceKnown) m_pairs.setReference(*m_request.reference);
  const double steps = (isFirst && !isReferenceKnown ? 2 : 1) * readingSteps();
  m_pairs.read(test, frame, m_progress.of(steps));
  m_progress.finish(steps);
  if (!m_listener.loaded || frame > 0) return;
  if (isFirst && !isReferenceKnown) m_listener.loaded(m_pairs.reference());
  m_listener.loaded(m_pairs.test());
}

void ReportRun::runTest(std::size_t test, std::size_t frame) {
  const std::vector<std::size_t> open = statesToRender(test, m_frames[frame]);
  if (m_request.shard && open.empty() && !isInTime()) return;
  readLightFields(test, frame);
  try {
    sideBySide(open.size(), m_workers,
               [&](std::size_t k, std::size_t worker) { runState(test, open[k], worker); });
  } catch (...) {
    for (const auto& projection : m_projections) saveQuietly(*projection);
    throw;
  }
  std::erase_if(m_differences[test],
                [&](const auto& each) { return each.first < m_frames[frame].begin; });
  if (!isInTime()) finishTest(test);
}

/// Shows views of a still's test while its light fields are in memory.
void ReportRun::finishTest(std::size_t test) {
  m_projections[test]->save();
  if (m_request.shard) return;
  showViews(test);
  m_viewErrors.push_back(m_comparing.of([&] { return m_pairs.viewErrors(m_progress.within()); }));
}

/// Shows views of all tests of a light field in time, whose frames are read again.
void ReportRun::finishFrames() {
  for (const auto& projection : m_projections) projection->save();
  if (m_request.shard) return;
  for (std::size_t test = 0; test < m_request.tests.size(); ++test) {
    showViews(test);
    m_viewErrors.emplace_back();  // light fields in time are not in memory as a whole
  }
}

/// Certifies the lenses of all states, equal ones once.
std::vector<ReportLens> certifyAll(const Session& session, const Progress& progress) {
  std::vector<std::pair<LensKey, LensCertificate>> known;
  std::vector<ReportLens> lenses;
  std::set<std::string> names;
  for (const CameraState& state : session.cameras) {
    if (!names.insert(state.camera.name).second) continue;  // at another frame
    const LensKey key = lensKeyOf(state, session.sampling);
    auto same = std::ranges::find(known, key, &std::pair<LensKey, LensCertificate>::first);
    if (same == known.end())
      same = known.insert(known.end(), {key, certify(key, parallelRows, progress)});
    lenses.push_back({state.camera.name, same->second});
  }
  return lenses;
}

/// Sets the rates in kbit/s of tests whose rate and frames a second are known.
void ReportRun::setKilobits() {
  if (!isInTime()) return;
  for (std::size_t test = 0; test < m_request.tests.size(); ++test) {
    const ReportTest& one = m_request.tests[test];
    const double perSecond = frameRateOf(one.session.lightField, *one.file);
    const LightFieldSize size = one.file->size();
    TestSummary& summary = m_report.summaries[test];
    if (summary.rate && perSecond > 0)
      summary.kilobits =
          *summary.rate * double(size.width()) * double(size.height()) * perSecond / 1000;
  }
}

void ReportRun::writeAll() {
  m_report.summaries = summariseTests(m_report.rows, m_request.metrics, m_request.groups);
  setKilobits();
  m_report.comparisons = bdRows(m_report.summaries, m_request.metrics, m_request.groups);
  const PanelParams& display = m_pairs.reference().display;
  ReportPage page{m_request.name,
                  m_facts.lines,
                  display,
                  m_request.metrics,
                  m_report.rows,
                  m_report.summaries,
                  m_report.comparisons,
                  m_request.groups,
                  certifyAll(m_request.session, m_progress.within()),
                  std::move(m_views),
                  {},
                  warningsOf(m_request),
                  harmlessMoves(m_report.summaries, m_request.metrics),
                  m_request.isAgainstDesign,
                  m_request.hasPage};
  for (std::size_t test = 0; test < m_projections.size(); ++test) {
    page.panels.push_back(writePanelError(m_folder, test, m_request, m_projections[test]->error(),
                                          m_viewErrors[test], display));
    m_report.panels.push_back(page.panels.back().figures);
  }
  writeFigures(m_folder, figuresOf(page));
  writeTextFile(m_folder / "report.html", html(page));
  writeTables(m_folder, m_report, m_request.metrics);
  m_rows.remove();
  m_hashes.remove();
  for (std::size_t test = 0; test < m_projections.size(); ++test) {
    m_projections[test]->remove();
    std::error_code none;
    for (const Shard& shard : m_rows.shards()) fs::remove(panelFile(test, shard), none);
  }
  std::set<fs::path> folders;
  for (const fs::path& file : filesOf(m_request)) folders.insert(file.parent_path());
  for (const fs::path& folder : folders) removeLeftovers(folder);
}

Report ReportRun::run() {
  const std::size_t tests = m_request.tests.size();
  m_frames = framesToRead();
  m_pairs.expect(m_frames);
  m_progress.expect(double(m_frames.size()) * double(tests + 1) * readingSteps());
  for (const FrameViews& frame : m_frames)
    for (std::size_t test = 0; test < tests; ++test)
      m_progress.expect(double(statesToRender(test, frame).size()));
  for (std::size_t frame = 0; frame < m_frames.size(); ++frame)
    for (std::size_t test = 0; test < tests; ++test) runTest(test, frame);
  if (isInTime()) finishFrames();
  if (!m_request.shard) writeAll();
  m_report.rendering = m_rendering.seconds();
  m_report.comparing = m_comparing.seconds();
  m_report.writing = m_writing.seconds();
  return std::move(m_report);
}

}  // namespace

std::vector<ReportTest> openTests(const Session& session, const std::vector<std::string>& files) {
  std::vector<ReportTest> tests;
  for (const std::string& file : files) {
    const Session other = withLightField(session, file);
    tests.push_back({file, other, openLightField(other.lightField, other.display)});
  }
  return tests;
}

std::optional<double> rateOfFiles(const ReportTest& test) {
  double bytes = 0;
  std::error_code error;
  if (!test.session.lightField.isLive())
    for (const fs::path& file : test.file->files()) {
      const std::uintmax_t size = fs::file_size(file, error);
      if (!error) bytes += double(size);
    }
  if (!(bytes > 0)) return std::nullopt;
  return 8 * bytes / (double(test.file->size().width()) * double(test.file->size().height())) /
         double(test.file->framesInFiles());
}

std::vector<fs::path> inputsOf(const ReportRequest& request) {
  std::vector<fs::path> inputs = filesOf(request.session, *request.file);
  for (const ReportTest& test : request.tests) {
    inputs.emplace_back(test.name);
    std::ranges::copy(filesOf(test.session, *test.file), std::back_inserter(inputs));
  }
  return inputs;
}

namespace {

/// Throws if a table could not have the name of a test: they are UTF-8.
void checkNames(const ReportRequest& request) {
  for (const ReportTest& test : request.tests)
    for (std::size_t at = 0; at < test.name.size();) {
      const Character next = characterAt(test.name, at);
      if (!next.point) throw InputError(printable(test.name), "its name is not UTF-8", "rename it");
      at += next.bytes;
    }
}

/// Removes tolerances, so that differences come from the light fields, not from methods.
ReportRequest withoutTolerance(ReportRequest request) {
  request.session.sampling.tolerance = 0;
  for (ReportTest& test : request.tests) {
    test.session.sampling.tolerance = 0;
    if (test.unloaded) test.unloaded->sampling.tolerance = 0;
  }
  if (request.reference) request.reference->sampling.tolerance = 0;
  return request;
}

}  // namespace

Report makeReport(const ReportRequest& request, const ReportListener& listener) {
  ReportRequest exact = withoutTolerance(request);
  if (!exact.file) exact.file = openLightField(exact.session.lightField, exact.session.display);
  checkNames(exact);
  const FilesInUse inUse(inputsOf(exact));
  for (ReportTest& test : exact.tests) test.name = nameIn(exact, test.name);
  {
    const FilesInUse document({exact.sessionFile});  // which may be saved while the report is made
    checkOutputs(filesOf(exact));
  }
  return ReportRun(exact, listener).run();
}

}  // namespace hogelscope
