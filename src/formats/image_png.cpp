#include <spng.h>

#include <memory>

#include "formats/image.h"

namespace temblor::formats {
namespace {

using base::ErrorCode;

// Deflate codes at best 258 bytes in two bits.
constexpr std::uint64_t kMostUnpackedPerByte = 258 * 4;
// Of colour profiles, comments and the like, which are skipped.
constexpr std::size_t kMaxChunkBytes = std::size_t{64} << 20;

struct ContextDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, ContextDeleter>;

base::Error decoder_error(int status) {
  return base::malformed("PNG: {}", spng_strerror(status));
}

std::uint32_t argb(const std::uint8_t* rgba) {
  return std::uint32_t{rgba[3]} << 24 | std::uint32_t{rgba[0]} << 16 | std::uint32_t{rgba[1]} << 8 | rgba[2];
}

base::Status set_source(spng_ctx* context, base::Bytes bytes) {
  if (const int status = spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_DISCARD); status != 0)
    return decoder_error(status);
  if (const int status = spng_set_chunk_limits(context, kMaxChunkBytes, kMaxChunkBytes); status != 0)
    return decoder_error(status);
  if (const int status = spng_set_png_buffer(context, bytes.data(), bytes.size()); status != 0)
    return decoder_error(status);
  return base::Ok{};
}

// Sides in range, and no more pixels than the file's bytes can unpack to.
base::Result<spng_ihdr> read_header(spng_ctx* context, std::size_t file_bytes) {
  spng_ihdr header{};
  if (const int status = spng_get_ihdr(context, &header); status != 0) return decoder_error(status);
  if (header.width > kMaxImageSide || header.height > kMaxImageSide)
    return base::error(ErrorCode::kTooLarge, "PNG of {} x {} pixels, sides are 1 to {}", header.width,
                       header.height, kMaxImageSide);
  std::size_t stored_bytes = 0;
  if (const int status = spng_decoded_image_size(context, SPNG_FMT_RAW, &stored_bytes); status != 0)
    return decoder_error(status);
  if (stored_bytes > file_bytes * kMostUnpackedPerByte)
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
  std::size_t size = 0;
  if (const int status = spng_decoded_image_size(context.get(), SPNG_FMT_RGBA8, &size); status != 0)
    return decoder_error(status);
  std::vector<std::uint8_t> rgba(size);
  if (const int status =
          spng_decode_image(context.get(), rgba.data(), size, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS);
      status != 0)
    return decoder_error(status);
  Image image{header.width, header.height, {}};
  image.pixels.reserve(size / 4);
  for (std::size_t i = 0; i < size; i += 4) image.pixels.push_back(argb(&rgba[i]));
  return image;
}

}  // namespace temblor::formats
