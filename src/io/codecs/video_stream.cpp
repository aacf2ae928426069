// SPDX-License-Identifier: BSD-3-Clause
#include "io/codecs/video_stream.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "core/base/error.h"

namespace hogelscope {

namespace {

/// Refuses every other file that a container names.
int refuseToOpen(AVFormatContext* /*container*/, AVIOContext** /*bytes*/, const char* /*address*/,
                 int /*flags*/, AVDictionary** /*options*/) {
  return AVERROR(EPERM);
}

bool isOfPictures(const AVStream& stream) {
  return stream.codecpar->codec_type == AVMEDIA_TYPE_VIDEO &&
         (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) == 0;
}

}  // namespace

VideoStream::VideoStream(std::filesystem::path file, const std::string& format)
    : m_file(std::move(file)), m_bytes(m_file, std::ios::binary) {
  m_bytes.seekg(0, std::ios::end);
  m_size = m_bytes.tellg();
  m_bytes.seekg(0);
  if (!m_bytes) throw InputError(m_file.string(), "cannot be read");
  constexpr int bufferBytes = 1 << 16;
  auto* buffer = static_cast<unsigned char*>(av_malloc(bufferBytes));
  m_input.reset(avio_alloc_context(buffer, bufferBytes, 0, this, &readBytes, nullptr, &seekBytes));
  AVFormatContext* container = avformat_alloc_context();
  if (!m_input || container == nullptr) throw std::bad_alloc();
  container->pb = m_input.get();
  container->io_open = &refuseToOpen;
  const AVInputFormat* const reader = av_find_input_format(format.c_str());
  if (reader == nullptr)
    throw InputError(m_file.string(), "", "is " + format + ", which this FFmpeg does not read");
  int error = avformat_open_input(&container, nullptr, reader, nullptr);
  if (error < 0)
    throw InputError(m_file.string(), "is damaged or cut off",
                     "a " + format + " file without a whole header or index");
  m_container.reset(container);
  error = avformat_find_stream_info(container, nullptr);
  if (error < 0) fail(error);
  m_index = av_find_best_stream(container, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
  if (m_index < 0)
    throw InputError(m_file.string(), "", "is a " + format + " file without pictures");
  for (unsigned k = 0; k < container->nb_streams; ++k)
    if (int(k) != m_index) container->streams[k]->discard = AVDISCARD_ALL;
}

int VideoStream::readBytes(void* self, std::uint8_t* to, int bytes) {
  std::ifstream& in = static_cast<VideoStream*>(self)->m_bytes;
  in.read(reinterpret_cast<char*>(to), bytes);
  return in.gcount() > 0 ? int(in.gcount()) : AVERROR_EOF;
}

std::int64_t VideoStream::seekBytes(void* self, std::int64_t offset, int whence) {
  auto& video = *static_cast<VideoStream*>(self);
  whence &= ~AVSEEK_FORCE;
  if (whence == AVSEEK_SIZE) return video.m_size;
  video.m_bytes.clear();  // the end of the file may have been reached
  const std::int64_t from = whence == SEEK_CUR   ? std::int64_t(video.m_bytes.tellg())
                            : whence == SEEK_END ? video.m_size
                                                 : 0;
  if (offset + from < 0) return AVERROR(EINVAL);
  video.m_bytes.seekg(offset + from);
  return offset + from;
}

bool VideoStream::read(AVPacket& packet) {
  for (;;) {
    av_packet_unref(&packet);
    const int error = av_read_frame(m_container.get(), &packet);
    if (error == AVERROR_EOF) return false;
    if (error < 0) fail(error);
    // Headers may claim any number of empty packets, but each of the others takes some bytes.
    if (++m_read > m_size) fail(AVERROR_INVALIDDATA);
    if (packet.stream_index != m_index) continue;
    ++m_packets;
    if (packet.size == 0) continue;
    if ((packet.flags & AV_PKT_FLAG_CORRUPT) != 0)
      throw InputError(m_file.string(), "", "is damaged or cut off within a picture");
    return true;
  }
}

bool VideoStream::seek(std::int64_t time) {
  m_read = 0;
  return av_seek_frame(m_container.get(), m_index, time, AVSEEK_FLAG_BACKWARD) >= 0;
}

std::size_t VideoStream::missing() const {
  const auto indexed = std::size_t(std::max(0, avformat_index_get_entries_count(&stream())));
  return indexed - std::min(indexed, m_packets);
}

const std::int32_t* VideoStream::displayMatrix() const {
  constexpr std::size_t bytes = 9 * sizeof(std::int32_t);
#if LIBAVFORMAT_VERSION_MAJOR >= 61  // FFmpeg 7.0
  const AVCodecParameters& params = *stream().codecpar;
  const AVPacketSideData* const side = av_packet_side_data_get(
      params.coded_side_data, params.nb_coded_side_data, AV_PKT_DATA_DISPLAYMATRIX);
  if (side == nullptr || side->size < bytes) return nullptr;
  return reinterpret_cast<const std::int32_t*>(side->data);
#else
  std::size_t size = 0;
  const std::uint8_t* const data =
      av_stream_get_side_data(&stream(), AV_PKT_DATA_DISPLAYMATRIX, &size);
  return size < bytes ? nullptr : reinterpret_cast<const std::int32_t*>(data);
#endif
}

std::vector<std::string> VideoStream::notes() const {
  int streams = 0;
  for (unsigned k = 0; k < m_container->nb_streams; ++k)
    streams += isOfPictures(*m_container->streams[k]) ? 1 : 0;
  if (streams < 2) return {};
  return {"has " + std::to_string(streams) + " streams of pictures; only number " +
          std::to_string(m_index) + " is read"};
}

void VideoStream::fail(int error) const {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  throw InputError(m_file.string(), "is damaged", text.data());
}

}  // namespace hogelscope
