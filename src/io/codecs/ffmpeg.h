// SPDX-License-Identifier: BSD-3-Clause
// The headers of FFmpeg's libraries, which are C, and owners of what they allocate.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <memory>

namespace hogelscope {

struct FfmpegDeleter {
  void operator()(AVFormatContext* container) const { avformat_close_input(&container); }
  void operator()(AVIOContext* bytes) const {
    av_freep(static_cast<void*>(&bytes->buffer));
    avio_context_free(&bytes);
  }
  void operator()(AVCodecContext* decoder) const { avcodec_free_context(&decoder); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

template <class T>
using FfmpegPtr = std::unique_ptr<T, FfmpegDeleter>;

}  // namespace hogelscope
