#include "formats/images/image.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spng.h>

#include <cstdlib>
#include <memory>

#include "formats/images/png.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::uint8_t kTopLeft = 0x20, kTopRight = 0x30, kBottomRight = 0x10, kBottomLeft = 0;

struct TgaFile {
  std::uint8_t type = 2, pixel_bits = 24, descriptor = kTopLeft;
  std::uint16_t width = 2, height = 2;
  std::vector<int> pixel_bytes = {};
  std::uint16_t map_first = 0, map_entries = 0;
  std::uint8_t map_bits = 0;
  std::vector<int> map_bytes = {};
  std::string id = {};
};

base::ByteVector pack_bytes(const TgaFile& file) {
  base::ByteWriter writer;
  writer.u8(static_cast<std::uint8_t>(file.id.size()));
  writer.u8(file.map_bits > 0 ? 1 : 0);
  writer.u8(file.type);
  writer.u16(file.map_first);
  writer.u16(file.map_entries);
  writer.u8(file.map_bits);
  writer.u32(0x12345678);  // position on a screen, ignored
  writer.u16(file.width);
  writer.u16(file.height);
  writer.u8(file.pixel_bits);
  writer.u8(file.descriptor);
  writer.bytes(base::as_bytes(file.id));
  for (const int byte : file.map_bytes) writer.u8(static_cast<std::uint8_t>(byte));
  for (const int byte : file.pixel_bytes) writer.u8(static_cast<std::uint8_t>(byte));
  return std::move(writer).take();
}

std::vector<std::uint32_t> list_pixels(const TgaFile& file) {
  const auto image = read_tga(pack_bytes(file));
  EXPECT_TRUE(image.ok()) << image.error().message();
  if (!image.ok()) return {};
  EXPECT_EQ(image->width, file.width);
  EXPECT_EQ(image->height, file.height);
  return image->pixels;
}

std::string error_of_tga(const TgaFile& file) {
  const auto image = read_tga(pack_bytes(file));
  return image.ok() ? "no error" : image.error().what;
}

Image random_image(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
  test::Random random(seed);
  Image image{width, height, std::vector<std::uint32_t>(std::size_t{width} * height)};
  for (std::uint32_t& pixel : image.pixels) pixel = static_cast<std::uint32_t>(random.bits());
  return image;
}

TEST(Tga, RoundTrips) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 3u}, {64u, 64u}, {1u, kMaxImageSide}}) {
    const Image image = random_image(width, height, width);
    const auto back = read_tga(write_tga(image));
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(*back, image);
  }
}

TEST(Tga, ReadsAllPixelFormats) {
  EXPECT_THAT(list_pixels({.width = 2, .height = 1, .pixel_bytes = {1, 2, 3, 4, 5, 6}}),
              ElementsAre(0xff030201u, 0xff060504u));
  EXPECT_THAT(
      list_pixels({.pixel_bits = 32, .width = 1, .height = 1, .pixel_bytes = {1, 2, 3, 4}, .id = "me"}),
      ElementsAre(0x04030201u));
  // 5 bits for each channel: red, green, blue, half gray. The top bit only counts if the file has alpha.
  const std::vector<int> sixteen = {0x00, 0x7c, 0xe0, 0x03, 0x1f, 0x80, 0x10, 0x42};
  EXPECT_THAT(list_pixels({.pixel_bits = 15, .pixel_bytes = sixteen}),
              ElementsAre(0xffff0000u, 0xff00ff00u, 0xff0000ffu, 0xff848484u));
  EXPECT_THAT(list_pixels({.pixel_bits = 16, .descriptor = kTopLeft | 1, .pixel_bytes = sixteen}),
              ElementsAre(0x00ff0000u, 0x0000ff00u, 0xff0000ffu, 0x00848484u));
  EXPECT_THAT(list_pixels({.type = 3, .pixel_bits = 8, .width = 2, .height = 1, .pixel_bytes = {0, 200}}),
              ElementsAre(0xff000000u, 0xffc8c8c8u));
  EXPECT_THAT(list_pixels({.type = 3, .pixel_bits = 16, .width = 1, .height = 1, .pixel_bytes = {200, 9}}),
              ElementsAre(0x09c8c8c8u));
}

TEST(Tga, ColorMaps) {
  EXPECT_THAT(list_pixels({.type = 1,
                           .pixel_bits = 8,
                           .width = 2,
                           .height = 1,
                           .pixel_bytes = {4, 3},
                           .map_first = 3,
                           .map_entries = 2,
                           .map_bits = 24,
                           .map_bytes = {1, 2, 3, 4, 5, 6}}),
              ElementsAre(0xff060504u, 0xff030201u));
  EXPECT_THAT(list_pixels({.type = 1,
                           .pixel_bits = 16,
                           .width = 1,
                           .height = 1,
                           .pixel_bytes = {0, 1},
                           .map_first = 256,
                           .map_entries = 1,
                           .map_bits = 32,
                           .map_bytes = {1, 2, 3, 4}}),
              ElementsAre(0x04030201u));
  // A true-color picture may have a map that it does not use.
  EXPECT_THAT(list_pixels({.width = 1,
                           .height = 1,
                           .pixel_bytes = {7, 8, 9},
                           .map_entries = 1,
                           .map_bits = 15,
                           .map_bytes = {1, 2}}),
              ElementsAre(0xff090807u));
}

TEST(Tga, EveryCorner) {
  const std::vector<int> gray = {1, 2, 3, 4, 5, 6};
  const auto levels = [&](std::uint8_t corner) {
    std::vector<int> found;
    for (const std::uint32_t pixel : list_pixels({.type = 3,
                                     .pixel_bits = 8,
                                     .descriptor = corner,
                                     .width = 3,
                                     .height = 2,
                                     .pixel_bytes = gray}))
      found.push_back(static_cast<int>(pixel & 0xff));
    return found;
  };
  EXPECT_THAT(levels(kTopLeft), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(levels(kTopRight), ElementsAre(3, 2, 1, 6, 5, 4));
  EXPECT_THAT(levels(kBottomLeft), ElementsAre(4, 5, 6, 1, 2, 3));
  EXPECT_THAT(levels(kBottomRight), ElementsAre(6, 5, 4, 3, 2, 1));
}

// Runs and single pixels; one run crosses the end of a row.
TgaFile run_length_coded() {
  return {.type = 10,
          .width = 3,
          .height = 2,
          .pixel_bytes = {0x00, 1, 2, 3, 0x82, 4, 5, 6, 0x01, 7, 8, 9, 10, 11, 12}};
}

TEST(Tga, RunLengthCoded) {
  EXPECT_THAT(list_pixels(run_length_coded()),
              ElementsAre(0xff030201u, 0xff060504u, 0xff060504u, 0xff060504u, 0xff090807u, 0xff0c0b0au));
}

// At most half of the picture may be missing.
TEST(Tga, TruncatedPicturesAreTransparentAtTheEnd) {
  constexpr std::size_t kHeader = 18, kPixels = 6;
  const base::ByteVector whole = write_tga(random_image(3, 2, 1));
  const std::vector<std::uint32_t> pixels = random_image(3, 2, 1).pixels;
  test::for_each_truncation(whole, [&](const base::ByteVector& bytes) {
    const auto image = read_tga(bytes);
    ASSERT_EQ(image.ok(), bytes.size() >= kHeader + kPixels * 4 / 2) << bytes.size() << " bytes";
    if (!image.ok()) return;
    ASSERT_EQ(image->pixels.size(), kPixels);
    for (std::size_t i = 0; i < kPixels; ++i)
      EXPECT_EQ(image->pixels[i], kHeader + 4 * (i + 1) <= bytes.size() ? pixels[i] : 0u) << bytes.size();
  });
  TgaFile coded = run_length_coded();
  coded.pixel_bytes.resize(8);  // within the last packet
  EXPECT_THAT(list_pixels(coded), ElementsAre(0xff030201u, 0xff060504u, 0xff060504u, 0xff060504u, 0u, 0u));
  coded.pixel_bytes.resize(6);  // within the run
  EXPECT_THAT(list_pixels(coded), ElementsAre(0xff030201u, 0u, 0u, 0u, 0u, 0u));
}

TEST(Tga, OddFilesThatOtherEnginesRead) {
  const std::vector<int> pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const auto expected = ElementsAre(0xff030201u, 0xff060504u, 0xff090807u, 0xff0c0b0au);
  for (const int bits : {0x40, 0x80, 0xc0})  // bits of interleaving
    EXPECT_THAT(
        list_pixels({.descriptor = static_cast<std::uint8_t>(kTopLeft | bits), .pixel_bytes = pixels}),
        expected);
  EXPECT_THAT(list_pixels({.pixel_bytes = pixels, .id = std::string(255, 'i')}), expected);
  // A map of a true-color picture is skipped, whatever its entries are.
  EXPECT_THAT(
      list_pixels({.pixel_bytes = pixels, .map_entries = 3, .map_bits = 9, .map_bytes = {9, 9, 9, 9, 9, 9}}),
      expected);
  std::vector<int> with_footer = pixels;
  for (const char c : std::string("\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0", 26)) with_footer.push_back(c);
  EXPECT_THAT(list_pixels({.pixel_bytes = with_footer}), expected);
  // The run is longer than the picture.
  EXPECT_THAT(list_pixels({.type = 10, .width = 1, .pixel_bytes = {0xff, 1, 2, 3}}),
              ElementsAre(0xff030201u, 0xff030201u));
  EXPECT_THAT(list_pixels({.type = 10, .width = 1, .height = 1, .pixel_bytes = {0x01, 1, 2, 3, 4, 5, 6}}),
              ElementsAre(0xff030201u));
  for (const int index : {0, 2})  // colors before and after the map
    EXPECT_THAT(list_pixels({.type = 1,
                             .pixel_bits = 8,
                             .width = 2,
                             .height = 1,
                             .pixel_bytes = {index, 1},
                             .map_first = 1,
                             .map_entries = 1,
                             .map_bits = 24,
                             .map_bytes = {1, 2, 3}}),
                ElementsAre(0xff000000u, 0xff030201u));
}

TEST(Tga, RejectsFaultsWithReason) {
  EXPECT_THAT(error_of_tga({.type = 4}), HasSubstr("type 4"));
  EXPECT_THAT(error_of_tga({.type = 0}), HasSubstr("type 0"));
  EXPECT_THAT(error_of_tga({.pixel_bits = 12}), HasSubstr("12 bits per pixel"));
  EXPECT_THAT(error_of_tga({.width = 0}), HasSubstr("0 x 2"));
  EXPECT_THAT(error_of_tga({.height = kMaxImageSide + 1}), HasSubstr("2 x 8193"));
  EXPECT_THAT(error_of_tga({.width = kMaxImageSide, .height = kMaxImageSide}),
              HasSubstr("only 0 bytes remain"));
  // The longest run stores 128 pixels in two bytes or a few more.
  EXPECT_THAT(
      error_of_tga({.type = 10, .width = 256, .height = 2, .pixel_bytes = {0xff, 1, 2, 3, 0xff, 1, 2}}),
      HasSubstr("only 7 bytes remain"));
  EXPECT_THAT(error_of_tga({.type = 10, .pixel_bytes = {0x83, 1, 2, 3, 0}}), HasSubstr("no error"));
  EXPECT_THAT(error_of_tga({.type = 1, .pixel_bits = 8}), HasSubstr("without a color map"));
  EXPECT_THAT(error_of_tga({.map_entries = 9, .map_bits = 24}),
              HasSubstr("color map at offset 0x12 needs 27"));
  EXPECT_THAT(error_of_tga({.type = 1, .pixel_bits = 8, .map_entries = 9, .map_bits = 9}),
              HasSubstr("9 bits per entry"));
}

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

// Encodes with libspng, for kinds of PNG that write_png() does not write.
base::ByteVector encode(std::uint32_t width, std::uint32_t height, int color_type, int bits,
                        const std::vector<std::uint8_t>& raw, bool interlaced = false) {
  const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_ihdr header{};
  header.width = width;
  header.height = height;
  header.color_type = static_cast<std::uint8_t>(color_type);
  header.bit_depth = static_cast<std::uint8_t>(bits);
  header.interlace_method = interlaced ? 1 : 0;
  EXPECT_EQ(spng_set_ihdr(context.get(), &header), 0);
  if (color_type == SPNG_COLOR_TYPE_INDEXED) {
    spng_plte palette{};
    palette.n_entries = 2;
    palette.entries[0] = {1, 2, 3, 255};
    palette.entries[1] = {4, 5, 6, 255};
    EXPECT_EQ(spng_set_plte(context.get(), &palette), 0);
    spng_trns transparent{};
    transparent.n_type3_entries = 1;
    transparent.type3_alpha[0] = 9;
    EXPECT_EQ(spng_set_trns(context.get(), &transparent), 0);
  }
  EXPECT_EQ(spng_encode_image(context.get(), raw.data(), raw.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE), 0);
  std::size_t size = 0;
  int status = 0;
  const std::unique_ptr<void, FreeMemory> png(spng_get_png_buffer(context.get(), &size, &status));
  EXPECT_EQ(status, 0);
  const auto* bytes = static_cast<const std::byte*>(png.get());
  return {bytes, bytes + size};
}

std::vector<std::uint32_t> png_pixels(const base::ByteVector& png) {
  const auto image = read_png(png);
  EXPECT_TRUE(image.ok()) << image.error().message();
  return image.ok() ? image->pixels : std::vector<std::uint32_t>{};
}

TEST(PngReading, ReadsAllPixelFormats) {
  EXPECT_THAT(png_pixels(encode(2, 1, SPNG_COLOR_TYPE_TRUECOLOR, 8, {1, 2, 3, 4, 5, 6})),
              ElementsAre(0xff010203u, 0xff040506u));
  EXPECT_THAT(png_pixels(encode(1, 1, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 8, {1, 2, 3, 4})),
              ElementsAre(0x04010203u));
  EXPECT_THAT(png_pixels(encode(2, 1, SPNG_COLOR_TYPE_GRAYSCALE, 8, {0, 200})),
              ElementsAre(0xff000000u, 0xffc8c8c8u));
  EXPECT_THAT(png_pixels(encode(4, 1, SPNG_COLOR_TYPE_GRAYSCALE, 1, {0b0101'0000})),
              ElementsAre(0xff000000u, 0xffffffffu, 0xff000000u, 0xffffffffu));
  EXPECT_THAT(png_pixels(encode(2, 1, SPNG_COLOR_TYPE_INDEXED, 8, {1, 0})),
              ElementsAre(0xff040506u, 0x09010203u));
  EXPECT_THAT(png_pixels(encode(1, 2, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, 8, {7, 8, 9, 10})),
              ElementsAre(0x08070707u, 0x0a090909u));
}

TEST(PngReading, RoundTrips) {
  Image image = random_image(37, 21, 5);
  for (std::uint32_t& pixel : image.pixels) pixel |= 0xff000000u;
  const auto png = write_png(image.pixels, 37, 21);
  ASSERT_TRUE(png.ok());
  const auto back = read_png(*png);
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(*back, image);
}

TEST(PngReading, RejectsTruncatedPixels) {
  constexpr std::size_t kTailBytes = 4 + 12;  // checksum of the pixels, and the end chunk
  const base::ByteVector png = write_png(random_image(5, 4, 6).pixels, 5, 4).value();
  test::for_each_truncation(base::Bytes(png).first(png.size() - kTailBytes),
                            [](const base::ByteVector& bytes) {
                              const auto image = read_png(bytes);
                              ASSERT_FALSE(image.ok()) << bytes.size() << " bytes";
                              EXPECT_THAT(image.error().what, HasSubstr("PNG"));
                            });
}

// A chunk with a wrong checksum.
base::ByteVector make_chunk(std::string_view type, std::string_view data) {
  constexpr std::uint32_t kWrongChecksum = 0x12345678;
  base::ByteWriter writer;
  for (int shift = 24; shift >= 0; shift -= 8) writer.u8(static_cast<std::uint8_t>(data.size() >> shift));
  writer.bytes(base::as_bytes(type));
  writer.bytes(base::as_bytes(data));
  writer.u32(kWrongChecksum);
  return std::move(writer).take();
}

// libpng and libspng read all of these.
TEST(PngReading, OddFilesThatOtherProgramsRead) {
  constexpr std::size_t kHeaderEnd = 8 + 25, kEndChunk = 12, kChecksum = 4;
  Image image = random_image(5, 4, 6);
  for (std::uint32_t& pixel : image.pixels) pixel |= 0xff000000u;
  const base::ByteVector png = write_png(image.pixels, 5, 4).value();
  const auto with = [&](std::size_t at, const base::ByteVector& more) {
    base::ByteVector bytes = png;
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), more.begin(), more.end());
    return bytes;
  };
  const auto cut = [&](std::size_t bytes) {
    return base::ByteVector(png.begin(), png.end() - static_cast<std::ptrdiff_t>(bytes));
  };
  const std::pair<const char*, base::ByteVector> files[] = {
      {"bytes after the end", with(png.size(), base::ByteVector(1000, std::byte{7}))},
      {"no end chunk", cut(kEndChunk)},
      {"no checksum of the pixels", cut(kEndChunk + kChecksum)},
      {"text with a wrong checksum", with(kHeaderEnd, make_chunk("tEXt", "Title"))},
      {"gamma of a wrong size with a wrong checksum", with(kHeaderEnd, make_chunk("gAMA", "x"))},
      {"unknown chunk with a wrong checksum", with(kHeaderEnd, make_chunk("abCd", "x"))},
      {"chunk after the pixels", with(png.size() - kEndChunk, make_chunk("tEXt", "Title"))},
  };
  for (const auto& [name, bytes] : files) {
    const auto back = read_png(bytes);
    ASSERT_TRUE(back.ok()) << name << ": " << back.error().message();
    EXPECT_EQ(*back, image) << name;
  }
}

TEST(PngReading, SurvivesDamagedFiles) {
  const base::ByteVector png = write_png(random_image(5, 4, 6).pixels, 5, 4).value();
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const auto image = read_png(test::with_flipped_bits(png, random));
    refused += image.ok() ? 0 : 1;
    if (!image.ok()) continue;
    EXPECT_EQ(image->pixels.size(), std::size_t{image->width} * image->height) << "seed " << seed;
  }
  EXPECT_GT(refused, 400);  // checksums detect most damage
}

}  // namespace
}  // namespace temblor::formats
