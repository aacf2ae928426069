// SPDX-License-Identifier: BSD-3-Clause
// Reads PGX files.
#include <array>
#include <regex>
#include <string>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/images/image_inputs.h"
#include "io/images/raw_plane.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::string kind(const RawPlane& plane) {
  return pairText(plane.width, plane.height) + " px of " + std::to_string(plane.bits) + " bits";
}

/// Reads the header, one line: PG, the order of bytes, sign and bits, width, height.
RawPlane headerOf(const RandomAccessFile& file) {
  static const std::regex line(
      R"(PG[ \t]+(ML|LM)[ \t]*([+-]?)[ \t]*(\d{1,2})[ \t]+(\d{1,9})[ \t]+(\d{1,9})[ \t]*\r?\n)");
  std::array<char, 128> text{};
  const std::size_t count = file.readSome(0, std::as_writable_bytes(std::span(text)));
  const char* const header = text.data();
  std::cmatch found;
  if (!std::regex_search(header, header + count, found, line,
                         std::regex_constants::match_continuous))
    throw InputError(file.path().string(), "is damaged",
                     "a PGX begins with a line such as PG ML +10 WIDTH HEIGHT");
  RawPlane plane{std::uint64_t(found.length()), std::stoull(found[4]), std::stoull(found[5]),
                 std::stoi(found[3]),           found[2] == "-",       found[1] == "ML"};
  if (plane.bits < 1 || plane.bits > 16)
    throw InputError(file.path().string(), "has " + std::to_string(plane.bits) + " bits a sample",
                     "1 to 16 can be read");
  if (plane.width < 1 || plane.height < 1)
    throw InputError(file.path().string(), "", "is not a picture with pixels");
  if (plane.end() > file.size())
    throw InputError(file.path().string(), "is damaged",
                     "its " + std::to_string(file.size()) + " bytes cannot be " + kind(plane));
  return plane;
}

bool isPgx(const fs::path& path) {
  if (path.extension() == ".pgx") return true;
  const RandomAccessFile file(path);
  std::array<char, 3> found{};
  file.readSome(0, std::as_writable_bytes(std::span(found)));
  return found == std::array{'P', 'G', ' '} || found == std::array{'P', 'G', '\t'};
}

class PgxInput : public RowInput {
 public:
  explicit PgxInput(const fs::path& file) {
    add(file);
    addColours(file);
    const RawPlane& plane = m_components[0].plane;
    m_facts = {{plane.width, plane.height, int(m_components.size()),
                plane.bits > 8 ? StoredType::uint16 : StoredType::uint8, std::max(plane.bits, 8)},
               "pgx"};
  }

 private:
  struct Component {
    RandomAccessFile file;
    RawPlane plane;
  };

  void add(const fs::path& file) {
    RandomAccessFile input(file);
    const RawPlane plane = headerOf(input);
    m_components.push_back({std::move(input), plane});
  }

  void addColours(const fs::path& file) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (folder.filename() != "0") return;
    const fs::path green = folder.parent_path() / "1" / file.filename();
    const fs::path blue = folder.parent_path() / "2" / file.filename();
    std::error_code ignored;
    if (!fs::exists(green, ignored) || !fs::exists(blue, ignored)) return;
    for (const fs::path& other : {green, blue}) {
      add(other);
      const std::string is = kind(m_components.back().plane);
      const std::string should = kind(m_components[0].plane);
      if (is != should)
        throw InputError(other.string(), "size",
                         std::string("is ")
                             .append(is)
                             .append(", but the component in folder 0 has ")
                             .append(should));
    }
  }

  void readRow(std::size_t y, std::uint8_t* rgb) override { spreadRow(y, rgb); }
  void readRow(std::size_t y, std::uint16_t* rgb) override { spreadRow(y, rgb); }

  template <class T>
  void spreadRow(std::size_t y, T* rgb) const {
    const std::size_t channels = m_components.size();
    for (std::size_t c = 0; c < channels; ++c) {
      const auto& [file, plane] = m_components[c];
      const std::vector<std::uint16_t> samples = hogelscope::readRow(file, plane, y);
      for (std::size_t x = 0; x < samples.size(); ++x) {
        rgb[3 * x + c] = spread<T>(samples[x], plane.bits);
        if (channels == 1) rgb[3 * x + 1] = rgb[3 * x + 2] = rgb[3 * x];
      }
    }
  }

  std::vector<Component> m_components;  // one, or three
};

}  // namespace

std::unique_ptr<ImageInput> openPgx(const fs::path& file) {
  return isPgx(file) ? std::make_unique<PgxInput>(file) : nullptr;
}

}  // namespace hogelscope
