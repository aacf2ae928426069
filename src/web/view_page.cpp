// SPDX-License-Identifier: BSD-3-Clause
#include "web/view_page.h"

#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/engine/renderer.h"
#include "io/documents/session_file.h"
#include "io/files/system_limits.h"
#include "io/images/image_writer.h"
#include "io/json/json_parameters.h"
#include "page/html.h"
#include "web/page_files.h"

namespace hogelscope {

namespace {

constexpr double mostTexels = 64e6;  // 256 MB in the page
constexpr int leastDirections = 16;  // that thinning leaves
constexpr std::size_t mostExact = 8'000'000;
constexpr std::array<std::string_view, 2> qualityWords{
    "exact: the pictures are those of the program, byte by byte",
    "compressed (WebP): its figures are not for measuring"};

/// Which hogels and directions of the content are in the page: every step-th one, from half a step.
struct Thinning {
  LightFieldSize size;
  int hogelStep = 1;
  int directionStep = 1;
};

Thinning thinningOf(const LightFieldSize& of, double most) {
  Thinning thinning{of};
  const auto count = [](int all, int step) { return std::max(1, all / step); };
  while (double(thinning.size.width()) * double(thinning.size.height()) > most) {
    const bool hasMany = std::max(thinning.size.du, thinning.size.dv) > 2 * leastDirections;
    (hasMany ? thinning.directionStep : thinning.hogelStep) *= 2;
    thinning.size = {count(of.nx, thinning.hogelStep), count(of.ny, thinning.hogelStep),
                     count(of.du, thinning.directionStep), count(of.dv, thinning.directionStep)};
  }
  return thinning;
}

std::string everyWords(int step) {
  return step == 2 ? "second" : std::to_string(step) + "th";
}

using Values = std::vector<std::uint8_t>;

/// Reads the content as an image of hogels, in 8 bits.
Values valuesOf(LightFieldFile& file, const Thinning& thinning, const Progress& progress) {
  const auto& [size, hogelStep, directionStep] = thinning;
  const LightFieldSize all = file.size();
  const std::size_t width = size.width();
  Values values(3 * width * size.height());
  const auto source = file.source({.memory = allowedMemory() / 2}, part(progress, 0, 0.5));
  const auto of = [](int k, int step, int count) {
    return std::min(k * step + step / 2, count - 1);
  };
  for (int v = 0; v < size.dv; ++v) {
    const int from = of(v, directionStep, all.dv);
    const auto texels =
        source->slice(readsOfRows(all, {0, all.ny - 1}, {0, all.du - 1}, {from, from}),
                      part(progress, 0.5 + 0.5 * v / size.dv, 0.5 + 0.5 * (v + 1) / size.dv));
    for (int j = 0; j < size.ny; ++j) {
      std::uint8_t* to =
          &values[3 * (std::size_t(j) * std::size_t(size.dv) + std::size_t(v)) * width];
      for (int i = 0; i < size.nx; ++i)
        for (int u = 0; u < size.du; ++u) {
          const Rgb c = texels->texel({of(i, hogelStep, all.nx), of(j, hogelStep, all.ny),
                                       of(u, directionStep, all.du), from});
          for (const double value : {c.r, c.g, c.b}) *to++ = quantised(value);
        }
    }
  }
  return values;
}

/// FNV-1a of 32 bits, as eight hexadecimal digits.
template <class Bytes>
std::string hashOf(const Bytes& bytes) {
  std::uint32_t hash = 2166136261U;
  for (const auto byte : bytes) hash = (hash ^ std::uint8_t(byte)) * 16777619U;
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4)
    text += "0123456789abcdef"[hash >> unsigned(shift) & 15U];
  return text;
}

std::string encodedWebp(int width, int height, const std::uint8_t* rgb, float quality) {
  std::uint8_t* bytes = nullptr;
  const std::size_t count = WebPEncodeRGB(rgb, width, height, 3 * width, quality, &bytes);
  const std::unique_ptr<std::uint8_t, void (*)(void*)> owned(bytes, WebPFree);
  if (count == 0) throw std::bad_alloc();
  return {reinterpret_cast<const char*>(bytes), count};
}

/// Some views of a row, from (u, v) on, side by side.
struct Picture {
  int u = 0;
  int v = 0;
  std::string bytes;
};

/// WebP has at most 16 383 px, and some browsers' canvases 16.7 million in all.
int viewsOfPicture(const LightFieldSize& size) {
  const double most = std::min(16383.0, 16.7e6 / size.ny);
  return int(std::clamp(most / size.nx, 1.0, double(size.du)));
}

std::vector<Picture> picturesOf(const Values& values, const LightFieldSize& size,
                                PageQuality quality, const Progress& progress) {
  const int most = viewsOfPicture(size);
  std::vector<Picture> pictures;
  for (int v = 0; v < size.dv; ++v)
    for (int u = 0; u < size.du; u += most) pictures.push_back({u, v, {}});
  const Progress polled = forThreads(progress);
  std::atomic<int> done = 0;
  sideBySide(pictures.size(), threadCount(), [&](std::size_t k, std::size_t /*worker*/) {
    throwIfCancelled(polled);
    auto& [u0, v, bytes] = pictures[k];
    const int views = std::min(most, size.du - u0), width = views * size.nx;
    Values rgb(3 * std::size_t(width) * std::size_t(size.ny));
    std::uint8_t* to = rgb.data();
    for (int j = 0; j < size.ny; ++j) {
      const std::size_t row = std::size_t(j) * std::size_t(size.dv) + std::size_t(v);
      for (int u = u0; u < u0 + views; ++u)
        for (int i = 0; i < size.nx; ++i, to += 3)
          std::copy_n(&values[3 * (row * size.width() + std::size_t(i) * std::size_t(size.du) +
                                   std::size_t(u))],
                      3, to);
    }
    bytes = quality == PageQuality::exact ? encodedPng(width, size.ny, rgb)
                                          : encodedWebp(width, size.ny, rgb.data(), 90);
    reportProgress(polled, double(++done) / double(pictures.size()));
  });
  return pictures;
}

std::size_t bytesOf(const std::vector<Picture>& pictures) {
  std::size_t bytes = 0;
  for (const Picture& picture : pictures) bytes += picture.bytes.size();
  return bytes;
}

/// A JSON text that stands in a script.
std::string forScript(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6)
    json.replace(at, 1, "\\u003c");
  return json;
}

/// The scripts that hold a light field: its name, and its pictures.
std::string scriptsOf(const std::string& name, const std::string& hash,
                      const std::vector<Picture>& pictures, std::size_t field, bool isExact) {
  const std::string number = std::to_string(field);
  std::string text = "<script type=\"application/json\" class=\"field\" data-hash=\"" + hash +
                     "\" data-exact=\"" + (isExact ? "yes" : "no") + "\">" +
                     forScript(Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)) +
                     "</script>\n";
  for (const auto& [u, v, bytes] : pictures)
    text += "<script type=\"application/octet-stream\" class=\"views\" data-field=\"" + number +
            "\" data-u=\"" + std::to_string(u) + "\" data-v=\"" + std::to_string(v) + "\">" +
            base64(bytes) + "</script>\n";
  return text;
}

/// What the page shows otherwise than the program.
std::vector<std::string> notesOf(const std::vector<PageContent>& contents, const Thinning& thinning,
                                 PageQuality quality) {
  std::vector<std::string> notes{"The content is " +
                                 std::string(qualityWords[std::size_t(quality)]) + "."};
  const bool isDeep = std::ranges::any_of(contents, [](const PageContent& content) {
    return content.file->bits() > 8 || content.file->type() != StoredType::uint8;
  });
  if (isDeep) notes.emplace_back("It is rounded to 8 bits.");
  const LightFieldSize all = contents.front().file->size();
  if (thinning.directionStep > 1)
    notes.push_back("It has every " + everyWords(thinning.directionStep) + " of " +
                    pairText(all.du, all.dv) + " directions.");
  if (thinning.hogelStep > 1)
    notes.push_back("It has every " + everyWords(thinning.hogelStep) + " of " +
                    pairText(all.nx, all.ny) + " hogels across and down.");
  return notes;
}

/// The document that the page reads: display, sampling and states.
std::string documentOf(const Session& session, const LightFieldSize& size) {
  Session shown;
  shown.display = session.display;
  shown.display.hogels = {size.nx, size.ny};
  shown.display.directions = {size.du, size.dv};
  shown.lightField.viewingDistance = session.lightField.viewingDistance;
  shown.sampling = session.sampling;
  shown.cameras = session.cameras;
  std::string text = textOf(shown);
  return forScript(std::move(text));
}

/// A still picture of the first state, for where no scripts run.
std::string stillOf(const Session& session, const Values& values, const LightFieldSize& size) {
  RenderJob job;
  job.lightField = std::make_shared<const LightField>(size, LightField::Values(values));
  Session shown = session;
  shown.display.hogels = {size.nx, size.ny};
  shown.display.directions = {size.du, size.dv};
  job.display = resolved(displayOf(shown), size);
  job.sampling = session.sampling;
  job.state = session.cameras.front();
  job.state.stereo = {};
  Renderer renderer;
  const Image image = renderer.render(job);
  const auto [width, height] = job.state.camera.res;
  return encodedWebp(width, height, image.rgb.data(), 80);
}

/// Returns the version and the commit, where the program was built from a repository.
std::string versionWords() {
  const std::string commit = HOGELSCOPE_COMMIT;
  return "Hogelscope " + std::string(programVersion()) +
         (commit.empty() ? "" : " (" + commit + ")");
}

/// Replaces each @name@ of the page by its part.
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string_view, std::string>>& parts) {
  std::string result;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t begin = std::min(page.find('@', at), page.size());
    result += page.substr(at, begin - at);
    at = begin;
    const auto part = std::ranges::find_if(parts, [&](const auto& each) {
      return page.substr(begin).starts_with("@" + std::string(each.first) + "@");
    });
    if (part != parts.end()) {
      result += part->second;
      at += part->first.size() + 2;
    } else if (begin < page.size()) {
      result += page[at++];
    }
  }
  return result;
}

/// Throws if votes on two contents could not be told apart.
void requireNames(const std::vector<PageContent>& contents) {
  for (std::size_t k = 0; k < contents.size(); ++k)
    if (std::ranges::count(contents, contents[k].name, &PageContent::name) > 1)
      throw InputError("--experiment",
                       "two light fields are called " + contents[k].name +
                           " in the votes, which have names without folder and ending: rename one");
}

/// Returns the whole page around its content; `still` is the picture of the first state.
std::string htmlOf(const Session& session, const ViewPage& page, const PageOptions& options,
                   const std::string& content, const std::string& still) {
  std::string facts = pairText(page.size.nx, page.size.ny) + " hogels of " +
                      pairText(page.size.du, page.size.dv) +
                      " directions. The pictures are computed here, by the engine of Hogelscope " +
                      programVersion() + ".";
  for (const std::string& note : page.notes) facts += " " + note;
  const std::string engine = base64(std::string(pageEngine()));
  const std::string document = documentOf(session, page.size);
  std::string experiment;
  if (!options.experiment.empty())
    experiment = filled(pageFile("experiment.html"),
                        {{"method", options.experiment},
                         {"experiment.js", std::string(pageFile("experiment.js"))}});
  return filled(pageFile("page.html"), {{"title", escaped(options.title)},
                                        {"version", versionWords()},
                                        {"facts", escaped(facts)},
                                        {"still", base64(still)},
                                        {"session", document},
                                        {"sessionHash", hashOf(document)},
                                        {"engine", engine},
                                        {"engineHash", hashOf(engine)},
                                        {"content", content},
                                        {"experiment", experiment},
                                        {"page.css", std::string(pageFile("page.css"))},
                                        {"engine.js", std::string(pageFile("engine.js"))},
                                        {"worker.js", std::string(pageFile("worker.js"))},
                                        {"eye.js", std::string(pageFile("eye.js"))},
                                        {"vr.js", std::string(pageFile("vr.js"))},
                                        {"page.js", std::string(pageFile("page.js"))}});
}

}  // namespace

std::size_t questionsOf(const std::string& experiment, std::size_t contents, std::size_t states) {
  return states * (experiment == "dsis" ? contents - 1 : contents * (contents - 1) / 2);
}

void requirePage(const Session& session) {
  if (pageEngine().empty())
    throw InputError("--export page", "this program was built without the engine for pages",
                     "install clang-19 lld-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 "
                     "libclang-rt-19-dev-wasm32 wasi-libc and build it again");
  requireHogels(session.display, "a page");
  if (!session.display.lensSource.empty())
    throw InputError("display.lensSource",
                     "is a plugin's lens, which is not in a page: give "
                     "display.lens");
  if (!session.twin.isZero())
    throw InputError("twin", "a page shows the display as designed: leave the unit out of it");
  if (session.cameras.empty()) throw InputError("cameras", "is empty: a page needs a camera state");
}

ViewPage viewPage(const Session& session, const std::vector<PageContent>& contents,
                  const PageOptions& options, const Progress& progress) {
  requirePage(session);
  if (!options.experiment.empty()) requireNames(contents);
  const LightFieldSize all = contents.front().file->size();
  for (const auto& [name, file] : contents)
    if (file->size() != all)
      throw InputError(file->files().empty() ? name : file->files().front().string(),
                       "has other hogels or directions than the session's light field",
                       "a page compares contents of one display");
  ViewPage page;
  const auto count = double(contents.size());
  const Thinning thinning = thinningOf(all, mostTexels / count);
  page.size = thinning.size;
  checkFits(double(page.size.width()) * double(page.size.height()) * (3 * count + 4),
            "the page's content");
  std::vector<Values> values;
  for (const PageContent& content : contents) {
    const double done = double(values.size()) / count / 2;
    values.push_back(valuesOf(*content.file, thinning, part(progress, done, done + 0.5 / count)));
  }
  const auto encode = [&](PageQuality as, double from, double to) {
    std::vector<std::vector<Picture>> pictures;
    for (const Values& each : values) {
      const double done = from + (to - from) * double(pictures.size()) / count;
      pictures.push_back(
          picturesOf(each, page.size, as, part(progress, done, done + (to - from) / count)));
    }
    return pictures;
  };
  page.quality = options.quality.value_or(PageQuality::exact);
  auto pictures = encode(page.quality, 0.5, options.quality ? 1 : 0.8);
  std::size_t bytes = 0;
  for (const auto& each : pictures) bytes += bytesOf(each);
  if (!options.quality && options.experiment.empty() && bytes > mostExact) {
    page.quality = PageQuality::small;
    pictures = encode(page.quality, 0.8, 1);
  }
  page.notes = notesOf(contents, thinning, page.quality);
  std::string content;
  for (std::size_t k = 0; k < contents.size(); ++k)
    content += scriptsOf(contents[k].name, hashOf(values[k]), pictures[k], k,
                         page.quality == PageQuality::exact);
  page.html = htmlOf(session, page, options, content, stillOf(session, values.front(), page.size));
  return page;
}

}  // namespace hogelscope
