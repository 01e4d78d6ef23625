// JPEG files that ImageMagick made of a picture with four colors, each 16 x 16 pixels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "formats/images/image.h"
#include "support/game_data.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

base::ByteVector read_jpeg_file(std::string_view name) {
  return test::read_file(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "fuzz/corpus/jpeg" / name);
}

// Upper left, upper right, lower left, lower right.
constexpr std::array<std::uint32_t, 4> kQuarters = {0xffc02010, 0xff20a040, 0xff3040d0, 0xffe0e0a0};

int find_largest_error(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (int shift = 0; shift < 32; shift += 8)
    largest =
        std::max(largest, std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
  return largest;
}

void expect_quarters(const Image& image, const std::array<std::uint32_t, 4>& quarters, int tolerance) {
  ASSERT_EQ(image.width, 32u);
  ASSERT_EQ(image.height, 32u);
  ASSERT_EQ(image.pixels.size(), 32u * 32u);
  for (std::uint32_t y = 0; y < 32; ++y)
    for (std::uint32_t x = 0; x < 32; ++x)
      ASSERT_LE(find_largest_error(image.pixels[y * 32 + x], quarters[y / 16 * 2 + x / 16]), tolerance)
          << x << "," << y;
}

TEST(Jpeg, ReadsBaselineAndProgressiveFiles) {
  for (const char* const name : {"baseline.jpg", "progressive.jpg"}) {
    const auto image = read_jpeg(read_jpeg_file(name));
    ASSERT_TRUE(image.ok()) << name << ": " << image.error().message();
    expect_quarters(*image, kQuarters, 4);
  }
}

TEST(Jpeg, ReadsGrayFiles) {
  const auto image = read_jpeg(read_jpeg_file("gray.jpg"));
  ASSERT_TRUE(image.ok()) << image.error().message();
  std::array<std::uint32_t, 4> grays{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t color = kQuarters[i];
    const double gray = 0.2126 * (color >> 16 & 255) + 0.7152 * (color >> 8 & 255) + 0.0722 * (color & 255);
    grays[i] = 0xff000000u | static_cast<std::uint32_t>(gray) * 0x010101u;
  }
  expect_quarters(*image, grays, 6);
}

TEST(Jpeg, ReadsColorsOfHalfTheResolution) {
  const auto image = read_jpeg(read_jpeg_file("subsampled.jpg"));
  ASSERT_TRUE(image.ok()) << image.error().message();
  // Colors mix at the borders of the quarters only.
  EXPECT_LE(find_largest_error(image->pixels[8 * 32 + 8], kQuarters[0]), 8);
  EXPECT_LE(find_largest_error(image->pixels[24 * 32 + 24], kQuarters[3]), 8);
}

TEST(Jpeg, EveryTruncationIsAnError) {
  for (const char* const name : {"baseline.jpg", "progressive.jpg", "gray.jpg"}) {
    const base::ByteVector whole = read_jpeg_file(name);
    // The last two bytes only mark the end.
    for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
      const auto image = read_jpeg(base::Bytes(whole).first(size));
      if (!image.ok()) {
        EXPECT_THAT(image.error().message(), HasSubstr("JPEG"));
        continue;
      }
      // Only padding of the last byte of data may be missing.
      EXPECT_GE(size + 4, whole.size()) << name;
    }
  }
}

TEST(Jpeg, RefusesOtherFilesAndSizes) {
  EXPECT_FALSE(read_jpeg({}).ok());
  EXPECT_FALSE(read_jpeg(base::as_bytes(std::string_view("no picture at all"))).ok());
  EXPECT_FALSE(read_jpeg(read_jpeg_file("cmyk.jpg")).ok());
  // The frame header: FF C0, length u16, precision u8, height u16, width u16.
  base::ByteVector bytes = read_jpeg_file("baseline.jpg");
  std::size_t frame = 0;
  while (!(bytes[frame] == std::byte{0xff} && bytes[frame + 1] == std::byte{0xc0})) ++frame;
  const auto with_size = [&](int height, int width) {
    bytes[frame + 5] = static_cast<std::byte>(height >> 8);
    bytes[frame + 6] = static_cast<std::byte>(height & 255);
    bytes[frame + 7] = static_cast<std::byte>(width >> 8);
    bytes[frame + 8] = static_cast<std::byte>(width & 255);
    return read_jpeg(bytes);
  };
  EXPECT_EQ(with_size(16, 9000).error().code, base::ErrorCode::kTooLarge);
  EXPECT_EQ(with_size(8000, 8000).error().code, base::ErrorCode::kTooLarge);
  EXPECT_THAT(with_size(4000, 4000).error().message(), HasSubstr("cannot hold them"));
  EXPECT_TRUE(with_size(200, 200).ok()) << "rows without data are gray, as in other programs";
}

}  // namespace
}  // namespace temblor::formats
