// SPDX-License-Identifier: BSD-3-Clause
// The rows of a plain PNG through libspng.
#include "io/png_rows.h"

#include <spng.h>

#include "core/error.h"

namespace hogelscope {

PngRows::PngRows(std::filesystem::path file, File input, Context context)
    : m_file(std::move(file)), m_input(std::move(input)), m_context(std::move(context)) {}

std::unique_ptr<PngRows> PngRows::open(const std::filesystem::path& file) {
  File input(std::fopen(file.c_str(), "rb"), &std::fclose);
  Context context(spng_ctx_new(0), &spng_ctx_free);
  if (!input || !context) return nullptr;
  constexpr std::size_t chunkBytes = std::size_t{16} << 20U;  // of texts and the like
  spng_set_image_limits(context.get(), INT32_MAX, INT32_MAX);
  spng_set_chunk_limits(context.get(), chunkBytes, chunkBytes);
  spng_set_png_file(context.get(), input.get());
  spng_ihdr header{};
  if (spng_get_ihdr(context.get(), &header) != 0) return nullptr;
  spng_trns transparency{};
  if (header.color_type != SPNG_COLOR_TYPE_TRUECOLOR || header.bit_depth != 8 ||
      header.interlace_method != SPNG_INTERLACE_NONE ||
      spng_get_trns(context.get(), &transparency) == 0)
    return nullptr;
  if (spng_decode_image(context.get(), nullptr, 0, SPNG_FMT_PNG, SPNG_DECODE_PROGRESSIVE) != 0)
    return nullptr;
  return std::unique_ptr<PngRows>(
      new PngRows(file, std::move(input), std::move(context)));  // its constructor is private
}

void PngRows::next(std::span<std::uint8_t> rgb) {
  const int status = spng_decode_row(m_context.get(), rgb.data(), rgb.size());
  if (status != 0 && status != SPNG_EOI)
    throw InputError(m_file.string(), "row " + std::to_string(m_row),
                     std::string("is damaged: ") + spng_strerror(status));
  ++m_row;
}

}  // namespace hogelscope
