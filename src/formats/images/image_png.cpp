// Reads PNG images with libspng, with limits against files that unpack to far more than they contain.
#include <spng.h>

#include <algorithm>
#include <memory>

#include "formats/images/image.h"

namespace temblor::formats {
namespace {

using base::ErrorCode;

// Upper bound of deflate: 258 bytes in two bits.
constexpr std::uint64_t kMaxUnpackedPerByte = 258 * 4;
// Limit for color profiles, comments, and the like, which are skipped.
constexpr std::size_t kMaxChunkBytes = std::size_t{64} << 20;

struct ImageContextDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, ImageContextDeleter>;

// Converts a status of libspng.
base::Status check_spng(int status) {
  if (status != 0) return base::malformed("PNG: {}", spng_strerror(status));
  return base::Ok{};
}

// Converts between 0xAABBGGRR (bytes R, G, B, A) and 0xAARRGGBB; its own inverse.
std::uint32_t swap_red_and_blue(std::uint32_t pixel) {
  return (pixel & 0xff00ff00u) | (pixel & 0xffu) << 16 | (pixel >> 16 & 0xffu);
}

// A wrong checksum is an error in the chunks that matter, and drops any other chunk.
base::Status set_source(spng_ctx* context, base::Bytes bytes) {
  TRY_STATUS(check_spng(spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_DISCARD)));
  TRY_STATUS(check_spng(spng_set_chunk_limits(context, kMaxChunkBytes, kMaxChunkBytes)));
  TRY_STATUS(check_spng(spng_set_png_buffer(context, bytes.data(), bytes.size())));
  return base::Ok{};
}

// Checks the size, and that the file is large enough to contain so many pixels.
base::Result<spng_ihdr> read_header(spng_ctx* context, std::size_t file_bytes) {
  spng_ihdr header{};
  TRY_STATUS(check_spng(spng_get_ihdr(context, &header)));
  if (header.width > kMaxImageSide || header.height > kMaxImageSide)
    return base::error(ErrorCode::kTooLarge, "PNG of {} x {} pixels, sides are 1 to {}", header.width,
                       header.height, kMaxImageSide);
  std::size_t stored_bytes = 0;
  TRY_STATUS(check_spng(spng_decoded_image_size(context, SPNG_FMT_RAW, &stored_bytes)));
  if (stored_bytes > file_bytes * kMaxUnpackedPerByte)
    return base::malformed("PNG of {} x {} pixels: {} bytes cannot hold them", header.width, header.height,
                           file_bytes);
  return header;
}

}  // namespace

base::Result<Image> read_png(base::Bytes bytes) {
  const Context context(spng_ctx_new(0));
  if (!context) return base::error(ErrorCode::kIo, "PNG: out of memory");
  TRY_STATUS(set_source(context.get(), bytes));
  TRY(const spng_ihdr header, read_header(context.get(), bytes.size()));
  Image image{header.width, header.height,
              std::vector<std::uint32_t>(std::size_t{header.width} * header.height)};
  TRY_STATUS(check_spng(spng_decode_image(context.get(), image.pixels.data(),
                                          image.pixels.size() * sizeof(std::uint32_t), SPNG_FMT_RGBA8,
                                          SPNG_DECODE_TRNS)));
  std::ranges::transform(image.pixels, image.pixels.begin(), swap_red_and_blue);
  return image;
}

}  // namespace temblor::formats
