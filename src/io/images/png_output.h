// SPDX-License-Identifier: BSD-3-Clause
// PNG output row by row through libspng, which also reads PNGs.
#pragma once

#include <functional>
#include <memory>

#include "io/images/codecs.h"

struct spng_ctx;

namespace hogelscope {

class PngOutput : public ImageOutput {
 public:
  /// `small` makes small files; `quick`, for large ones, needs a quarter of the time without
  /// filters.
  enum class Effort { small, quick };
  /// Receives the bytes of the file in order.
  using Sink = std::function<void(const void* bytes, std::size_t size)>;

  /// Creates an image; `name` is for errors. Throws InputError for floats and for too large sizes.
  PngOutput(std::string name, const ImageSpec& spec, Effort effort, Sink sink);
  void write(const StoredRows& values, std::size_t rows) override;
  void finish() override;

 private:
  void check(int status) const;

  std::string m_name;
  Sink m_sink;
  std::size_t m_rowBytes = 0;
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> m_context;
};

}  // namespace hogelscope
