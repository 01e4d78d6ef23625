#include <spng.h>

#include <algorithm>
#include <memory>

#include "formats/images/image.h"

namespace temblor::formats {
namespace {

using base::ErrorCode;

// Deflate codes at best 258 bytes in two bits.
constexpr std::uint64_t kMaxUnpackedPerByte = 258 * 4;
// Of color profiles, comments and the like, which are skipped.
constexpr std::size_t kMaxChunkBytes = std::size_t{64} << 20;

struct ContextDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, ContextDeleter>;

base::Status checked(int status) {
  if (status != 0) return base::malformed("PNG: {}", spng_strerror(status));
  return base::Ok{};
}

// Between bytes in the order R, G, B, A, read as a little-endian number, and 0xAARRGGBB.
std::uint32_t with_red_and_blue_exchanged(std::uint32_t pixel) {
  return (pixel & 0xff00ff00u) | (pixel & 0xffu) << 16 | (pixel >> 16 & 0xffu);
}

base::Status set_source(spng_ctx* context, base::Bytes bytes) {
  TRY_STATUS(checked(spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_DISCARD)));
  TRY_STATUS(checked(spng_set_chunk_limits(context, kMaxChunkBytes, kMaxChunkBytes)));
  TRY_STATUS(checked(spng_set_png_buffer(context, bytes.data(), bytes.size())));
  return base::Ok{};
}

// Sides in range, and no more pixels than the file's bytes can unpack to.
base::Result<spng_ihdr> read_header(spng_ctx* context, std::size_t file_bytes) {
  spng_ihdr header{};
  TRY_STATUS(checked(spng_get_ihdr(context, &header)));
  if (header.width > kMaxImageSide || header.height > kMaxImageSide)
    return base::error(ErrorCode::kTooLarge, "PNG of {} x {} pixels, sides are 1 to {}", header.width,
                       header.height, kMaxImageSide);
  std::size_t stored_bytes = 0;
  TRY_STATUS(checked(spng_decoded_image_size(context, SPNG_FMT_RAW, &stored_bytes)));
  if (stored_bytes > file_bytes * kMaxUnpackedPerByte)
    return base::malformed("PNG of {} x {} pixels: {} bytes cannot hold them", header.width, header.height,
                           file_bytes);
  return header;
}

}  // namespace

base::Result<Image> read_png(base::Bytes bytes) {
  const Context context(spng_ctx_new(0));
  if (!context) return base::error(ErrorCode::kIo, "PNG: no memory for its decoder");
  TRY_STATUS(set_source(context.get(), bytes));
  TRY(const spng_ihdr header, read_header(context.get(), bytes.size()));
  Image image{header.width, header.height,
              std::vector<std::uint32_t>(std::size_t{header.width} * header.height)};
  TRY_STATUS(checked(spng_decode_image(context.get(), image.pixels.data(),
                                       image.pixels.size() * sizeof(std::uint32_t), SPNG_FMT_RGBA8,
                                       SPNG_DECODE_TRNS)));
  std::ranges::transform(image.pixels, image.pixels.begin(), with_red_and_blue_exchanged);
  return image;
}

}  // namespace temblor::formats
