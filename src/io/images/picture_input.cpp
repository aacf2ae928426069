// SPDX-License-Identifier: BSD-3-Clause
// Reads images and videos through codecs(), in this process or in a copy of it.
#include "io/images/image_file.h"
#include "io/images/image_inputs.h"

#include <algorithm>
#include <cstring>
#include <shared_mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/isolated.h"
#include "io/files/random_access_file.h"
#include "io/images/exr_header.h"
#include "io/images/video_format.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns the first bytes of a file; fewer if it is shorter.
std::string firstBytesOf(const fs::path& path) {
  constexpr std::size_t longest = 16;
  std::string begin(longest, '\0');
  const RandomAccessFile file(path);
  begin.resize(file.readSome(0, std::as_writable_bytes(std::span(begin))));
  return begin;
}

/// Returns OpenImageIO's name of a format that this process reads; empty for all others. Cameras'
/// raw formats are not TIFFs, although they begin like them.
std::string_view trustedFormatOf(const fs::path& file) {
  using namespace std::string_view_literals;
  using Signatures = std::vector<std::string_view>;
  static const std::vector<std::pair<std::string_view, Signatures>> formats{
      {"jpeg", {"\xff\xd8\xff"sv}},
      {"openexr", {"\x76\x2f\x31\x01"sv}},
      {"bmp", {"BM"sv}},
      {"tiff", {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}},
      {"pnm", {"P1"sv, "P2"sv, "P3"sv, "P4"sv, "P5"sv, "P6"sv, "PF"sv, "Pf"sv}}};
  const std::string begin = firstBytesOf(file);
  const auto isBegin = [&begin](std::string_view signature) {
    return begin.starts_with(signature);
  };
  for (const auto& [format, signatures] : formats) {
    if (std::ranges::none_of(signatures, isBegin)) continue;
    const bool isRaw =
        format == "tiff" && !lowerCase(file.extension().string()).starts_with(".tif");
    return isRaw ? ""sv : format;
  }
  return {};
}

/// Holds Isolated::librariesInUse() while the library works.
class OwnInput : public ImageInput {
 public:
  OwnInput(const fs::path& file, const std::string& format) {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_input = codecs().open(file, format);
    m_facts = m_input->facts();
  }
  ~OwnInput() override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_input.reset();
  }
  OwnInput(const OwnInput&) = delete;
  OwnInput& operator=(const OwnInput&) = delete;

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_input->read(frame, first, rows, to);
  }
  void choose(std::size_t picture, const std::optional<std::array<int, 3>>& colours) override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_input->choose(picture, colours);
    m_facts = m_input->facts();
  }
  void readChannel(std::size_t channel, std::size_t first, std::size_t rows, float* to) override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_input->readChannel(channel, first, rows, to);
  }

 private:
  std::unique_ptr<ImageInput> m_input;
};

/// A request to the copy: for rows, or, without any, for ImageNumbers and texts (textsOf()). The
/// answer is empty while a video is not prepared for it.
struct PictureRequest {
  std::size_t frame = 0;
  std::size_t first = 0;
  std::size_t rows = 0;
  StoredType type = StoredType::uint8;
  bool isOneChannel = false;  ///< as floats, in place of the colours
  std::size_t channel = 0;
};

/// Returns the format, the names of channels and the notes, each ended by a zero, and each list by
/// a zero more.
std::string textsOf(const ImageFacts& facts) {
  std::string texts = facts.format + '\0';
  for (const auto* const list : {&facts.channelNames, &facts.notes}) {
    for (const std::string& text : *list) texts += text + '\0';
    texts += '\0';
  }
  return texts;
}

std::string rowsOf(ImageInput& input, const PictureRequest& request) {
  std::string bytes;
  if (request.isOneChannel) {
    bytes.resize(input.facts().width * request.rows * sizeof(float));
    input.readChannel(request.channel, request.first, request.rows,
                      reinterpret_cast<float*>(bytes.data()));
    return bytes;
  }
  withStoredType(request.type, [&](auto value) {
    using T = decltype(value);
    bytes.resize(3 * input.facts().width * request.rows * sizeof(T));
    input.read(request.frame, request.first, request.rows, reinterpret_cast<T*>(bytes.data()));
  });
  return bytes;
}

class IsolatedInput : public ImageInput {
 public:
  IsolatedInput(const fs::path& file, std::function<std::unique_ptr<ImageInput>()> open)
      : m_process(file, [open = std::move(open)] { return serve(open()); }) {
    const std::string answer = ask({});
    m_facts = {valueOf<ImageNumbers>(answer), {}};
    std::istringstream texts(answer.substr(sizeof(ImageNumbers)));
    std::getline(texts, m_facts.format, '\0');
    for (auto* const list : {&m_facts.channelNames, &m_facts.notes})
      for (std::string text; std::getline(texts, text, '\0') && !text.empty();)
        list->push_back(text);
  }

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    std::visit(
        [&](auto* values) {
          using T = std::remove_pointer_t<decltype(values)>;
          constexpr StoredType type = std::is_same_v<T, std::uint8_t>    ? StoredType::uint8
                                      : std::is_same_v<T, std::uint16_t> ? StoredType::uint16
                                                                         : StoredType::real;
          receive({frame, first, rows, type}, values, 3 * m_facts.width * rows);
        },
        to);
  }

  void readChannel(std::size_t channel, std::size_t first, std::size_t rows, float* to) override {
    receive({0, first, rows, StoredType::real, true, channel}, to, m_facts.width * rows);
  }

 private:
  std::string ask(const PictureRequest& request) {
    std::string answer;
    while (answer.empty()) answer = m_process.ask(messageOf(request));
    return answer;
  }

  template <class T>
  void receive(const PictureRequest& request, T* to, std::size_t count) {
    const std::string bytes = ask(request);
    if (bytes.size() != count * sizeof(T))
      throw std::logic_error("openPicture: an answer of another size");
    std::memcpy(to, bytes.data(), count * sizeof(T));
  }

  static Isolated::Service serve(const std::shared_ptr<ImageInput>& input) {
    return [input](const std::string& bytes) {
      const auto request = valueOf<PictureRequest>(bytes);
      if (!input->prepare(request.frame)) return std::string();
      if (request.rows > 0) return rowsOf(*input, request);
      return messageOf<ImageNumbers>(input->facts()) + textsOf(input->facts());
    };
  }

  Isolated m_process;
};

}  // namespace

std::unique_ptr<ImageInput> openPicture(const fs::path& file) {
  const std::string_view format = trustedFormatOf(file);
  if (format.empty()) {
    (void)codecs();  // loaded once, here, and not by each copy
    return isolatedInput(file, [file, video = videoFormatOf(file)] {
      return video.empty() ? codecs().open(file, {}) : codecs().openVideo(file, video);
    });
  }
  if (format == "openexr") checkExrHeader(file);
  return std::make_unique<OwnInput>(file, std::string(format));
}

std::unique_ptr<ImageInput> isolatedInput(const fs::path& file,
                                          std::function<std::unique_ptr<ImageInput>()> open) {
  return std::make_unique<IsolatedInput>(file, std::move(open));
}

std::string lossyFormatOf(const fs::path& file) {
  if (const std::string video = videoFormatOf(file); !video.empty())
    return video == "yuv4mpegpipe" ? "" : "video";  // whose frames are not encoded
  std::string begin;
  try {
    begin = firstBytesOf(file);
  } catch (const InputError&) {
    return {};
  }
  if (begin.starts_with("\xff\xd8\xff")) return "JPEG";
  const bool isHeif = begin.find("ftyp") == 4 && begin.find("crx ") != 8;
  return isHeif ? "HEIF" : "";
}

}  // namespace hogelscope
