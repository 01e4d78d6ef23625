#include "formats/images/png.h"

#include <spng.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "base/check.h"

namespace temblor::formats {
namespace {

// Compared with zlib's default level 6 on a dithered 1280 x 800 picture: 14 % larger, in a third of the time.
constexpr int kCompressionLevel = 4;

struct ContextDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
struct Free {
  void operator()(void* memory) const { std::free(memory); }
};

// Writes a PNG row by row. Keeps the first error: later calls do nothing, and take() returns it, so callers
// need not check each call.
class Encoder {
 public:
  Encoder(int width, int height, spng_color_type color_type) : context_(spng_ctx_new(SPNG_CTX_ENCODER)) {
    check(context_ ? 0 : static_cast<int>(SPNG_EMEM));
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(width);
    header.height = static_cast<std::uint32_t>(height);
    header.bit_depth = 8;
    header.color_type = static_cast<std::uint8_t>(color_type);
    call([&](spng_ctx* context) { return spng_set_option(context, SPNG_ENCODE_TO_BUFFER, 1); });
    call([&](spng_ctx* context) {
      return spng_set_option(context, SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel);
    });
    call([&](spng_ctx* context) { return spng_set_ihdr(context, &header); });
  }

  void set_palette(const Palette& palette) {
    spng_plte entries{};
    entries.n_entries = static_cast<std::uint32_t>(palette.size());
    for (std::size_t i = 0; i < palette.size(); ++i)
      entries.entries[i] = {palette[i].r, palette[i].g, palette[i].b, 255};
    call([&](spng_ctx* context) { return spng_set_plte(context, &entries); });
  }

  void begin_rows() {
    call([](spng_ctx* context) {
      return spng_encode_image(context, nullptr, 0, SPNG_FMT_PNG,
                               SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);
    });
  }

  void write_row(std::span<const std::uint8_t> row) {
    call([&](spng_ctx* context) {
      const int status = spng_encode_row(context, row.data(), row.size());
      return status == static_cast<int>(SPNG_EOI) ? 0 : status;  // "end of image": success of the last row
    });
  }

  base::Result<base::ByteVector> take() {
    std::size_t size = 0;
    std::unique_ptr<void, Free> png;
    call([&](spng_ctx* context) {
      int status = 0;
      png.reset(spng_get_png_buffer(context, &size, &status));
      return status;
    });
    if (status_ != 0) return base::error(base::ErrorCode::kIo, "PNG: {}", spng_strerror(status_));
    const auto* bytes = static_cast<const std::byte*>(png.get());
    return base::ByteVector(bytes, bytes + size);
  }

 private:
  template <typename Call>
  void call(Call function) {
    if (status_ == 0) check(function(context_.get()));
  }
  void check(int status) {
    if (status_ == 0) status_ = status;
  }

  std::unique_ptr<spng_ctx, ContextDeleter> context_;
  int status_ = 0;
};

void check_size(std::size_t pixels, int width, int height) {
  CHECK(width > 0 && height > 0, "{} x {}", width, height);
  CHECK(pixels == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "{} pixels, {} x {}",
        pixels, width, height);
}

}  // namespace

base::Result<base::ByteVector> write_png(std::span<const std::uint8_t> indices, int width, int height,
                                         const Palette& palette) {
  check_size(indices.size(), width, height);
  Encoder encoder(width, height, SPNG_COLOR_TYPE_INDEXED);
  encoder.set_palette(palette);
  encoder.begin_rows();
  const auto row_bytes = static_cast<std::size_t>(width);
  for (std::size_t begin = 0; begin < indices.size(); begin += row_bytes)
    encoder.write_row(indices.subspan(begin, row_bytes));
  return encoder.take();
}

base::Result<base::ByteVector> write_png(std::span<const std::uint32_t> rgb, int width, int height) {
  check_size(rgb.size(), width, height);
  Encoder encoder(width, height, SPNG_COLOR_TYPE_TRUECOLOR);
  encoder.begin_rows();
  const auto row_pixels = static_cast<std::size_t>(width);
  std::vector<std::uint8_t> row(row_pixels * 3);
  for (std::size_t begin = 0; begin < rgb.size(); begin += row_pixels) {
    for (std::size_t x = 0; x < row_pixels; ++x) {
      const std::uint32_t pixel = rgb[begin + x];
      row[3 * x] = static_cast<std::uint8_t>(pixel >> 16);
      row[3 * x + 1] = static_cast<std::uint8_t>(pixel >> 8);
      row[3 * x + 2] = static_cast<std::uint8_t>(pixel);
    }
    encoder.write_row(row);
  }
  return encoder.take();
}

base::Result<base::ByteVector> write_png(const Image& image) {
  const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  check_size(image.pixels.size(), width, height);
  Encoder encoder(width, height, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA);
  encoder.begin_rows();
  std::vector<std::uint8_t> row(std::size_t{image.width} * 4);
  for (std::size_t begin = 0; begin < image.pixels.size(); begin += image.width) {
    for (std::size_t x = 0; x < image.width; ++x) {
      const std::uint32_t pixel = image.pixels[begin + x];
      row[4 * x] = static_cast<std::uint8_t>(pixel >> 16);
      row[4 * x + 1] = static_cast<std::uint8_t>(pixel >> 8);
      row[4 * x + 2] = static_cast<std::uint8_t>(pixel);
      row[4 * x + 3] = static_cast<std::uint8_t>(pixel >> 24);
    }
    encoder.write_row(row);
  }
  return encoder.take();
}

}  // namespace temblor::formats
