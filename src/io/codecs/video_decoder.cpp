// SPDX-License-Identifier: BSD-3-Clause
#include "io/codecs/video_decoder.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "core/base/error.h"

namespace hogelscope {

namespace {

bool isMpeg(const AVCodecParameters& params) {
  return params.codec_id == AV_CODEC_ID_H264 || params.codec_id == AV_CODEC_ID_HEVC;
}

/// Whether no frame after a packet needs others before it: one of H.264 or H.265 has an IDR
/// picture, others are not asked. In files like MP4 each NAL unit begins with its length, of as
/// many bytes as the extra data say, in others with 0, 0, 1.
bool isAlone(const AVCodecParameters& params, const AVPacket& packet) {
  if (!isMpeg(params)) return true;
  const bool isHevc = params.codec_id == AV_CODEC_ID_HEVC;
  const int lengthAt = isHevc ? 21 : 4;
  const bool hasLengths = params.extradata_size > lengthAt && params.extradata[0] == 1;
  const int lengthBytes = hasLengths ? (params.extradata[lengthAt] & 3) + 1 : 3;
  for (std::int64_t at = 0; at + lengthBytes < packet.size;) {
    std::int64_t length = 0;
    for (int k = 0; k < lengthBytes; ++k) length = length << 8 | packet.data[at + k];
    const bool isUnit = hasLengths || length == 1;
    const int header = packet.data[at + lengthBytes];
    const int kind = isHevc ? header >> 1 & 63 : header & 31;
    if (isUnit && (isHevc ? kind == 19 || kind == 20 : kind == 5)) return true;
    at += hasLengths ? lengthBytes + length : 1;
  }
  return false;
}

}  // namespace

VideoDecoder::VideoDecoder(std::filesystem::path file, std::string format)
    : m_file(std::move(file)),
      m_format(std::move(format)),
      m_packet(av_packet_alloc()),
      m_frame(av_frame_alloc()) {
  if (!m_packet || !m_frame) throw std::bad_alloc();
  restart();
}

/// Opens the file anew, since seeking to the first packet is not exact in all containers.
void VideoDecoder::restart() {
  m_decoder.reset();
  m_stream.reset();
  m_stream = std::make_unique<VideoStream>(m_file, m_format);
  const AVStream& stream = m_stream->stream();
  const AVCodec* const codec = avcodec_find_decoder(stream.codecpar->codec_id);
  if (codec == nullptr)
    throw InputError(m_file.string(), "",
                     std::string("is a video in ") + avcodec_get_name(stream.codecpar->codec_id) +
                         ", which this FFmpeg does not decode; convert it");
  m_decoder.reset(avcodec_alloc_context3(codec));
  if (!m_decoder) throw std::bad_alloc();
  int error = avcodec_parameters_to_context(m_decoder.get(), stream.codecpar);
  m_decoder->pkt_timebase = stream.time_base;
  m_decoder->thread_count = 1;
  // Even a frame of one colour takes some bytes; a damaged header may claim any size.
  constexpr std::int64_t mostPixelsPerByte = 40000;
  m_decoder->max_pixels = std::min<std::int64_t>(mostPixelsPerByte * m_stream->bytes(),
                                                 std::numeric_limits<int>::max());
  if (error >= 0) error = avcodec_open2(m_decoder.get(), codec, nullptr);
  if (error < 0)
    throw InputError(m_file.string(), "",
                     std::string("is a video in ") + avcodec_get_name(stream.codecpar->codec_id) +
                         " of a kind that this FFmpeg does not decode; convert it");
  m_current = none;
  m_next = 0;
  m_isHeld = m_isPending = m_hasKey = false;
}

bool VideoDecoder::advance(std::size_t frame) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::milliseconds(500);
  do {
    if (m_phase == Phase::list)
      listPacket();
    else if (m_phase == Phase::first)
      decodeFirst();
    else if (m_phase == Phase::count)
      countFrame();
    else if (reach(frame))
      return true;
  } while (Clock::now() < end);
  return false;
}

void VideoDecoder::listPacket() {
  if (!m_stream->read(*m_packet)) return finishList();
  if (m_packets.empty()) m_beginsAlone = isAlone(*m_stream->stream().codecpar, *m_packet);
  const auto has = [this](int flag) { return (m_packet->flags & flag) != 0; };
  m_packets.push_back({m_packet->pts, m_packet->dts, m_packets.size(), has(AV_PKT_FLAG_KEY)});
  if (!has(AV_PKT_FLAG_DISCARD)) m_times.push_back(m_packet->pts);
}

void VideoDecoder::finishList() {
  if (const std::size_t missing = m_stream->missing(); m_packets.empty() || missing > 0)
    throw InputError(m_file.string(), "is damaged",
                     "it is cut off: of its frames " + std::to_string(m_packets.size()) +
                         " are there, " + std::to_string(missing) + " are missing");
  std::ranges::sort(m_times);
  std::ranges::sort(m_packets, {}, &Packet::time);
  if (!isOneFrameAPacket()) m_times.clear();
  m_frames = m_listed = m_times.size();
  if (!m_beginsAlone) m_times.clear();
  restart();
  m_phase = Phase::first;
}

/// Whether the packets' times number the frames. The codecs that are not named may have packets
/// without a frame, or with two, as has interlaced H.264.
bool VideoDecoder::isOneFrameAPacket() {
  const AVCodecParameters& params = *m_stream->stream().codecpar;
  const AVCodecDescriptor* const codec = avcodec_descriptor_get(params.codec_id);
  const bool isKnown = params.codec_id == AV_CODEC_ID_VP9 || params.codec_id == AV_CODEC_ID_AV1 ||
                       (isMpeg(params) && params.field_order <= AV_FIELD_PROGRESSIVE);
  const bool isIntra = codec != nullptr && (codec->props & AV_CODEC_PROP_INTRA_ONLY) != 0;
  const bool areTimes = m_packets.front().time != AV_NOPTS_VALUE;  // the smallest number
  const bool areDistinct =
      std::ranges::adjacent_find(m_packets, {}, &Packet::time) == m_packets.end();
  return (isKnown || isIntra) && areTimes && areDistinct && !m_times.empty();
}

/// Sees whether the first frame is the one that the list says. Where a stream was cut without
/// decoding it, the first frames may need others that are not there; FFmpeg leaves them out.
void VideoDecoder::decodeFirst() {
  const Step done = step();
  if (done == Step::more) return;
  if (done == Step::end)
    throw InputError(m_file.string(), "is damaged", "no picture of it can be decoded");
  m_current = 0;
  const bool isListed = !m_times.empty() && m_frame->pts == m_times.front();
  m_phase = isListed ? Phase::read : Phase::count;
  if (isListed) return;
  m_times.clear();
  m_frames = 1;
}

void VideoDecoder::countFrame() {
  const Step done = step();
  if (done == Step::frame) ++m_frames;
  if (done != Step::end) return;
  restart();
  m_phase = Phase::read;
}

/// Takes one step towards a frame; returns whether it is the current one.
bool VideoDecoder::reach(std::size_t frame) {
  if (frame >= m_frames) throw std::logic_error("VideoDecoder: a frame beyond the last one");
  if (m_isHeld && m_current == frame) return true;
  if (m_target != frame) goTowards(frame);
  const Step done = step();
  if (done == Step::end) fail(frame, "cannot be decoded");
  if (done == Step::frame) take(frame);
  return m_isHeld && m_current == frame;
}

/// Seeks or begins again if the frame does not follow, or if a key frame after the packets that
/// have been read saves decoding those between.
void VideoDecoder::goTowards(std::size_t frame) {
  m_target = frame;
  const bool isBefore = m_current != none && m_current >= frame;
  const Packet* const key = keyOf(frame);
  if (!isBefore && (key == nullptr || key->place <= m_next)) return;
  if (key != nullptr && (beginAt(key->time, *key) || beginAt(key->decoding, *key))) return;
  restart();
}

/// Numbers the frame that was decoded.
void VideoDecoder::take(std::size_t frame) {
  std::size_t number = m_current == none ? 0 : m_current + 1;
  if (!m_times.empty()) {
    const auto at = std::ranges::lower_bound(m_times, m_frame->pts);
    const auto listed = std::size_t(at - m_times.begin());
    const bool isListed = at != m_times.end() && *at == m_frame->pts;
    if (!isListed || listed > frame || (m_current != none && listed < number)) {
      // After a key frame that does not stand for itself, frames may be missing.
      if (!m_isSeekable) fail(frame, "is not where its time stamp says");
      m_isSeekable = false;
      return restart();
    }
    number = listed;
  }
  m_current = number;
}

/// Returns the last key frame that is presented at a frame's time or before it, whose decoding
/// needs no packet before it; null if frames are decoded in order.
const VideoDecoder::Packet* VideoDecoder::keyOf(std::size_t frame) const {
  if (m_times.empty() || !m_isSeekable) return nullptr;
  auto packet = std::ranges::upper_bound(m_packets, m_times[frame], {}, &Packet::time);
  while (packet != m_packets.begin())
    if ((--packet)->isKey) return &*packet;
  return nullptr;
}

/// Seeks to a time. Returns whether the packet there is known, and not after the key frame.
bool VideoDecoder::beginAt(std::int64_t time, const Packet& key) {
  if (time == AV_NOPTS_VALUE || !m_stream->seek(time) || !m_stream->read(*m_packet)) return false;
  const auto found = std::ranges::lower_bound(m_packets, m_packet->pts, {}, &Packet::time);
  if (found == m_packets.end() || found->time != m_packet->pts || found->place > key.place)
    return false;
  avcodec_flush_buffers(m_decoder.get());
  m_next = found->place;
  m_isPending = true;
  m_hasKey = false;
  m_current = none;
  return true;
}

std::vector<std::string> VideoDecoder::notes() const {
  std::vector<std::string> lines = m_stream->notes();
  if (m_frames < m_listed)
    lines.push_back("has " + std::to_string(m_listed) + " frames, of which " +
                    std::to_string(m_listed - m_frames) +
                    " are left out: they need frames that were cut off");
  return lines;
}

VideoDecoder::Step VideoDecoder::step() {
  m_isHeld = false;
  const int error = avcodec_receive_frame(m_decoder.get(), m_frame.get());
  if (error == AVERROR_EOF) return Step::end;
  if (error == AVERROR(EAGAIN)) send();
  if (error < 0) {
    if (error != AVERROR(EAGAIN)) check(error);
    return Step::more;
  }
  if ((m_frame->flags & AV_FRAME_FLAG_CORRUPT) != 0 || m_frame->decode_error_flags != 0)
    check(AVERROR_INVALIDDATA);
  m_isHeld = true;
  return Step::frame;
}

/// Gives the next packet to the decoder, or none after the last one.
void VideoDecoder::send() {
  const bool isThere = std::exchange(m_isPending, false) || m_stream->read(*m_packet);
  if (isThere) ++m_next;
  m_hasKey = m_hasKey || (isThere && (m_packet->flags & AV_PKT_FLAG_KEY) != 0);
  check(avcodec_send_packet(m_decoder.get(), isThere ? m_packet.get() : nullptr));
}

/// Throws for an error of the decoder, but for those before the first key frame, where a stream
/// that was cut may begin.
void VideoDecoder::check(int error) const {
  if (error >= 0 || (error == AVERROR_INVALIDDATA && !m_hasKey)) return;
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  fail(m_current == none ? 0 : m_current + 1, std::string("cannot be decoded: ") + text.data());
}

void VideoDecoder::fail(std::size_t frame, const std::string& why) const {
  throw InputError(m_file.string(), "is damaged", "frame " + std::to_string(frame) + " " + why);
}

}  // namespace hogelscope
