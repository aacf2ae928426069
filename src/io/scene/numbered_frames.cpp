// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/numbered_frames.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "capture/names/name_pattern.h"
#include "capture/names/name_series.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "io/layouts/layouts.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using FrameDigits = std::map<int, std::string>;

/// Whether a name of a folder has the number of a frame and no other number of a pattern.
bool isFolderOfFrame(const std::string& name) {
  if (name.find(frameMark) == std::string::npos) return false;
  try {
    return namePattern(name + "/RR_CC").meaning() == "RC";
  } catch (const InputError&) {
    return false;
  }
}

/// Returns the parameters with the folders of frames at the beginning of the pattern as a part of
/// the file's name, so that only the folder of one frame is searched for its views.
LightFieldParams withFolders(LightFieldParams params) {
  for (;;) {
    const std::size_t slash = params.pattern.find('/');
    if (slash == std::string::npos) return params;
    const std::string folder = params.pattern.substr(0, slash);
    if (!isFolderOfFrame(folder)) return params;
    params.file = (fs::path(params.file) / folder).string();
    params.pattern.erase(0, slash + 1);
  }
}

void add(FrameDigits& digits, const std::string& found, const std::string& where) {
  constexpr std::size_t longest = 9;  // of an int
  if (found.size() > longest)
    throw InputError(where, "lightField.file", "has a frame " + found + ", a number too large");
  const int number = std::stoi(found);
  const auto [at, isNew] = digits.emplace(number, found);
  if (!isNew && at->second != found)
    throw InputError(
        where, "lightField.file",
        "has two frames " + std::to_string(number) + ": " + at->second + " and " + found);
}

/// Finds the entries of a folder that have a name such as "scene.{T}.png".
FrameDigits framesNamed(const fs::path& folder, const std::string& name) {
  const std::size_t mark = name.find(frameMark);
  const std::string before = name.substr(0, mark);
  FrameDigits digits;
  for (const fs::path& entry : entriesOf(folder)) {
    const std::string own = entry.filename().string();
    if (!own.starts_with(before)) continue;
    const std::size_t end = std::min(own.find_first_not_of("0123456789", mark), own.size());
    const std::string found = own.substr(mark, end - mark);
    if (!found.empty() && withFrame(name, found) == own) add(digits, found, folder.string());
  }
  return digits;
}

FrameDigits framesOfFile(const fs::path& file) {
  fs::path folder;
  for (const fs::path& part : file) {
    if (part.string().find(frameMark) != std::string::npos)
      return framesNamed(folder.empty() ? fs::path(".") : folder, part.string());
    folder /= part;
  }
  return {};
}

/// Finds the frames of views of which each has the number of its frame in its own name.
FrameDigits framesOfPattern(const LightFieldParams& params) {
  const NamePattern pattern = namePattern(params.pattern);
  std::vector<fs::path> folders{params.file};
  for (auto depth = std::ranges::count(params.pattern, '/'); depth > 0; --depth) {
    std::vector<fs::path> inside;
    for (const fs::path& folder : folders)
      for (const fs::path& entry : entriesOf(folder))
        if (isFolder(entry)) inside.push_back(entry);
    folders = std::move(inside);
  }
  FrameDigits digits;
  for (const fs::path& folder : folders)
    for (const fs::path& file : filesIn(folder))
      if (const auto numbers = numbersIn(nameBelow(params.file, file), pattern))
        add(digits, numbers->at('T'), params.file);
  return digits;
}

FrameDigits framesOf(const LightFieldParams& params) {
  const bool isInFile = params.file.find(frameMark) != std::string::npos;
  FrameDigits digits = isInFile ? framesOfFile(params.file) : framesOfPattern(params);
  if (digits.empty())
    throw InputError(params.file, isInFile ? "lightField.file" : "lightField.pattern",
                     "no file has a number in place of {T}");
  return digits;
}

/// Returns the numbers of the frames. Throws InputError if one of them is missing.
FrameNumbers numbersOf(const LightFieldParams& params, const FrameDigits& digits) {
  FrameNumbers all{digits.begin()->first, digits.rbegin()->first, 1};
  if (params.frames)
    all = *params.frames;
  else if (digits.size() > 1)
    all.step = std::next(digits.begin())->first - all.first;
  std::vector<int> missing;
  for (std::size_t k = 0; k < all.count(); ++k)
    if (!digits.contains(all.number(k))) missing.push_back(all.number(k));
  if (missing.empty() && (params.frames || all.count() == digits.size())) return all;
  const std::string there = "there are " + std::to_string(digits.size()) + " frames, " +
                            std::to_string(digits.begin()->first) + " … " +
                            std::to_string(digits.rbegin()->first);
  if (missing.empty())
    throw InputError(params.file, "lightField.frames",
                     "is not given, and the numbers have no constant step: " + there);
  throw InputError(
      params.file, "lightField.frames",
      "frame " + std::to_string(missing.front()) +
          (missing.size() > 1 ? " and " + std::to_string(missing.size() - 1) + " more are missing"
                              : " is missing") +
          ": " + there + "; give those to read, [first, last, step]");
}

LightFieldParams stillOf(LightFieldParams params, const std::string& digits) {
  params.file = withFrame(params.file, digits);
  params.pattern = withFrame(params.pattern, digits);
  params.frames.reset();
  params.fps = notGiven;
  return params;
}

}  // namespace

std::string withFrame(std::string name, const std::string& digits) {
  for (std::size_t at = name.find(frameMark); at != std::string::npos;
       at = name.find(frameMark, at + digits.size()))
    name.replace(at, frameMark.size(), digits);
  return name;
}

LightFieldParams firstStillOf(const LightFieldParams& params) {
  if (!isNumbered(params)) return params;
  const LightFieldParams simple = withFolders(params);
  const FrameDigits digits = framesOf(simple);
  const auto first = params.frames ? digits.find(params.frames->first) : digits.begin();
  return stillOf(simple, (first == digits.end() ? digits.begin() : first)->second);
}

std::string firstFileOf(const std::string& file) {
  LightFieldParams params;
  params.file = file;
  return firstStillOf(params).file;
}

NumberedFrames::NumberedFrames(LightFieldParams params, const DisplayParams& display,
                               OpenStill open, const Progress& progress)
    : m_params(withFolders(std::move(params))),
      m_display(display),
      m_open(open),
      m_digits(framesOf(m_params)),
      m_frames(numbersOf(m_params, m_digits)),
      m_frame(m_frames.first),
      m_still(m_open(stillOf(m_params, m_digits.at(m_frame)), m_display, progress)) {}

std::vector<fs::path> NumberedFrames::files() const {
  std::call_once(m_areFound, [this] {
    for (std::size_t k = 0; k < m_frames.count(); ++k) {
      const LightFieldParams still = stillOf(m_params, m_digits.at(m_frames.number(k)));
      if (still.layout == Layout::views && isFolder(still.file))
        std::ranges::copy(findViews(still, m_display.directions).found(),
                          std::back_inserter(m_files));
      else
        m_files.emplace_back(still.file);
    }
  });
  return m_files;
}

void NumberedFrames::select(int frame) {
  if (frame == m_frame) return;
  const LightFieldParams params = stillOf(m_params, m_digits.at(frame));
  auto still = m_open(params, m_display, {});
  const LightFieldSize before = m_still->size(), size = still->size();
  if (size != before)
    throw InputError(params.file, "size",
                     "is " + pairText(size.nx, size.ny) + " hogels of " +
                         pairText(size.du, size.dv) + " directions, but the first frame has " +
                         pairText(before.nx, before.ny) + " of " + pairText(before.du, before.dv));
  if (still->type() != m_still->type() || still->bits() != m_still->bits())
    throw InputError(params.file, "bits", "are not those of the first frame");
  m_still = std::move(still);
  m_frame = frame;
}

}  // namespace hogelscope
