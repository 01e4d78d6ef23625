#include "formats/images/png.h"

#include <gtest/gtest.h>
#include <spng.h>

#include <memory>

#include "support/mutations.h"

namespace temblor::formats {
namespace {

struct ContextDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

struct DecodedPng {
  spng_ihdr header{};
  spng_plte palette{};  // n_entries 0: none
  std::vector<std::uint8_t> image;
};

// Decodes with libspng. `format`: SPNG_FMT_PNG returns the pixels as stored.
DecodedPng decode(const base::ByteVector& png, int format) {
  DecodedPng decoded;
  const std::unique_ptr<spng_ctx, ContextDeleter> context(spng_ctx_new(0));
  EXPECT_EQ(spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR), 0);
  EXPECT_EQ(spng_set_png_buffer(context.get(), png.data(), png.size()), 0);
  EXPECT_EQ(spng_get_ihdr(context.get(), &decoded.header), 0);
  std::size_t size = 0;
  EXPECT_EQ(spng_decoded_image_size(context.get(), format, &size), 0);
  decoded.image.resize(size);
  EXPECT_EQ(spng_decode_image(context.get(), decoded.image.data(), size, format, 0), 0);
  if (spng_get_plte(context.get(), &decoded.palette) != 0) decoded.palette.n_entries = 0;
  return decoded;
}

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{1, 1}, {1, 7}, {7, 1}, {3, 2}, {64, 64}, {257, 131}, {1024, 3}};

std::size_t pixel_count(Size size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

TEST(Png, KeepsIndicesAndPalette) {
  for (const Size size : kSizes) {
    test::Random random(static_cast<std::uint64_t>(size.width));
    Palette palette;
    for (Rgb& color : palette)
      color = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)),
               static_cast<std::uint8_t>(random.below(256))};
    std::vector<std::uint8_t> indices(pixel_count(size));
    for (std::uint8_t& index : indices) index = static_cast<std::uint8_t>(random.below(256));

    const auto png = write_png(indices, size.width, size.height, palette);
    ASSERT_TRUE(png.ok()) << png.error().message();
    const DecodedPng decoded = decode(*png, SPNG_FMT_PNG);
    EXPECT_EQ(decoded.header.width, static_cast<std::uint32_t>(size.width));
    EXPECT_EQ(decoded.header.height, static_cast<std::uint32_t>(size.height));
    EXPECT_EQ(decoded.header.bit_depth, 8);
    EXPECT_EQ(decoded.header.color_type, SPNG_COLOR_TYPE_INDEXED);
    EXPECT_EQ(decoded.image, indices);
    ASSERT_EQ(decoded.palette.n_entries, 256u);
    for (std::size_t i = 0; i < 256; ++i) {
      const spng_plte_entry& entry = decoded.palette.entries[i];
      ASSERT_EQ((Rgb{entry.red, entry.green, entry.blue}), palette[i]) << i;
    }
  }
}

TEST(Png, KeepsRgbColors) {
  for (const Size size : kSizes) {
    test::Random random(static_cast<std::uint64_t>(size.height));
    std::vector<std::uint32_t> pixels(pixel_count(size));
    for (std::uint32_t& pixel : pixels) pixel = static_cast<std::uint32_t>(random.bits());

    const auto png = write_png(pixels, size.width, size.height);
    ASSERT_TRUE(png.ok()) << png.error().message();
    const DecodedPng decoded = decode(*png, SPNG_FMT_RGB8);
    EXPECT_EQ(decoded.header.width, static_cast<std::uint32_t>(size.width));
    EXPECT_EQ(decoded.header.height, static_cast<std::uint32_t>(size.height));
    EXPECT_EQ(decoded.header.color_type, SPNG_COLOR_TYPE_TRUECOLOR);
    ASSERT_EQ(decoded.image.size(), pixels.size() * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const std::uint32_t color = static_cast<std::uint32_t>(decoded.image[3 * i] << 16) |
                                  static_cast<std::uint32_t>(decoded.image[3 * i + 1] << 8) |
                                  decoded.image[3 * i + 2];
      ASSERT_EQ(color, pixels[i] & 0xffffff) << i;
    }
  }
}

TEST(Png, IsReproducible) {
  const std::vector<std::uint32_t> pixels(300 * 200, 0xff336699u);
  EXPECT_EQ(*write_png(pixels, 300, 200), *write_png(pixels, 300, 200));
}

}  // namespace
}  // namespace temblor::formats
