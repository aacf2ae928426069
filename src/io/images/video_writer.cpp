// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/video_writer.h"

#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "core/base/text.h"

namespace hogelscope {

namespace {

constexpr int patience = 20;  // milliseconds from one look at the progress to the next

/// Starts a program that reads `input`. It is in a process group of its own, since Ctrl-C is for
/// the job, which ends it.
pid_t started(const std::string& program, const std::string& arguments, int input, int messages) {
  std::istringstream text(arguments);
  std::vector<std::string> words{program};
  for (std::string word; text >> word;) words.push_back(word);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, messages, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = -1;
  const int error =
      ::posix_spawnp(&process, pointers[0], &files, &attributes, pointers.data(), ::environ);
  ::posix_spawn_file_actions_destroy(&files);
  ::posix_spawnattr_destroy(&attributes);
  if (error != 0)
    throw InputError(program, "cannot be started",
                     std::strerror(error) + std::string("; it makes the video: install it"));
  return process;
}

/// A part of a file, from and to a byte.
struct Part {
  std::uint64_t first = 0;
  std::uint64_t end = 0;
};

/// Reads `bytes` bytes of big-endian at a place of a file; none if they are not there.
std::optional<std::uint64_t> numberAt(int file, std::uint64_t at, std::size_t bytes) {
  std::array<std::uint8_t, 8> read{};
  if (::pread(file, read.data(), bytes, off_t(at)) != ssize_t(bytes)) return std::nullopt;
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < bytes; ++k) number = number << 8U | read[k];
  return number;
}

/// Returns the content of a part's first box of a type (ISO 14496-12, 4.2); none if there is none,
/// or a box before it is not whole.
std::optional<Part> boxIn(int file, const Part& part, std::uint32_t type) {
  for (std::uint64_t at = part.first; at < part.end;) {
    auto size = numberAt(file, at, 4);
    const auto found = numberAt(file, at + 4, 4);
    const std::uint64_t head = size == 1U ? 16 : 8;
    if (size == 1U) size = numberAt(file, at + 8, 8);
    if (!size || !found || *size < head || *size > part.end - at) return std::nullopt;
    if (*found == type) return Part{at + head, at + *size};
    at += *size;
  }
  return std::nullopt;
}

constexpr std::uint32_t typeOf(const char (&name)[5]) {
  std::uint32_t type = 0;
  for (std::size_t k = 0; k < 4; ++k) type = type << 8U | std::uint8_t(name[k]);
  return type;
}

/// Returns the number of pictures of an MP4's first track; 0 if the file is not a whole MP4.
std::uint64_t picturesIn(int file) {
  const off_t size = ::lseek(file, 0, SEEK_END);
  const Part whole{0, std::uint64_t(std::max<off_t>(0, size))};
  if (!boxIn(file, whole, typeOf("ftyp"))) return 0;
  std::optional<Part> part = whole;
  for (const std::uint32_t type : {typeOf("moov"), typeOf("trak"), typeOf("mdia"), typeOf("minf"),
                                   typeOf("stbl"), typeOf("stsz")})
    if (part) part = boxIn(file, *part, type);
  return part ? numberAt(file, part->first + 8, 4).value_or(0) : 0;
}

}  // namespace

bool isVideoName(const std::filesystem::path& file) {
  return file.extension() == ".mp4";
}

VideoWriter::VideoWriter(const std::filesystem::path& file, const std::array<int, 2>& size,
                         double picturesPerSecond, const std::string& ffmpeg)
    : m_path(file),
      m_file(file),
      m_messages(::memfd_create("ffmpeg", MFD_CLOEXEC)),
      m_pictures(-1) {
  if (!isVideoName(file))
    throw InputError(file.string(), "cannot be written", "the name of a video ends in .mp4");
  std::array<int, 2> ends{};  // a socket: writing to a closed pipe would be a signal
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw InputError(file.string(), "cannot be written", std::strerror(errno));
  m_pictures = Descriptor(ends[0]);
  const Descriptor theirs(ends[1]);
  // It writes into the file, which has no name, through the name that /proc gives it.
  m_process = started(ffmpeg,
                      "-nostdin -loglevel error -y -f rawvideo -pix_fmt rgb24 -video_size " +
                          std::to_string(size[0]) + "x" + std::to_string(size[1]) + " -framerate " +
                          numberText(picturesPerSecond) +
                          " -i pipe:0 -vf pad=ceil(iw/2)*2:ceil(ih/2)*2 -pix_fmt yuv420p -crf 17"
                          " -f mp4 /proc/" +
                          std::to_string(::getpid()) + "/fd/" + std::to_string(m_file.descriptor()),
                      theirs.get(), m_messages.get());
}

VideoWriter::~VideoWriter() {
  if (m_process <= 0) return;
  ::kill(-m_process, SIGKILL);
  while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void VideoWriter::add(std::span<const std::uint8_t> rgb, const Progress& progress) {
  ++m_count;
  pollfd place{m_pictures.get(), POLLOUT, 0};
  while (!rgb.empty()) {
    const ssize_t sent =
        ::send(m_pictures.get(), rgb.data(), rgb.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      rgb = rgb.subspan(std::size_t(sent));
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) fail();
    ::poll(&place, 1, patience);
    reportProgress(progress, 1);
  }
}

void VideoWriter::finish(const Progress& progress) {
  ::shutdown(m_pictures.get(), SHUT_WR);
  int status = 0;
  pid_t ended = 0;
  for (; (ended = ::waitpid(m_process, &status, WNOHANG)) == 0; ::poll(nullptr, 0, patience))
    reportProgress(progress, 1);
  // Where SIGCHLD is ignored nobody says how it ended: its video may be cut off.
  if (std::exchange(m_process, -1) != ended || status != 0) fail();
  // It also ends with 0 when the disk is full, and then only says so.
  if (::lseek(m_messages.get(), 0, SEEK_END) > 0) fail();
  if (const std::uint64_t found = picturesIn(m_file.descriptor()); found != m_count)
    throw InputError(m_path.string(), "cannot be written",
                     "ffmpeg made a file with " + std::to_string(found) + " of " +
                         std::to_string(m_count) + " pictures");
  m_file.commit();
}

/// Throws what ffmpeg printed last.
void VideoWriter::fail() const {
  std::string text(4096, '\0');
  const off_t written = ::lseek(m_messages.get(), 0, SEEK_END);
  const ssize_t count = ::pread(m_messages.get(), text.data(), text.size(),
                                std::max<off_t>(0, written - off_t(text.size())));
  text.resize(std::size_t(std::max<ssize_t>(0, count)));
  text.erase(text.find_last_not_of('\n') + 1);
  if (text.empty()) text = "ended too early";
  throw InputError(m_path.string(), "cannot be written",
                   "ffmpeg: " + text.substr(text.find_last_of('\n') + 1));
}

}  // namespace hogelscope
