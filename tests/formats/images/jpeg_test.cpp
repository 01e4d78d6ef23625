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

// The place of the marker FF `code`.
std::size_t find_marker(base::Bytes bytes, int code) {
  std::size_t from = 0;
  while (bytes[from] != std::byte{0xff} || bytes[from + 1] != static_cast<std::byte>(code)) ++from;
  return from;
}

// Changes the size in the frame header: FF `code`, length u16, precision u8, height u16, width u16.
void set_size(int code, int height, int width, base::ByteVector& io_bytes) {
  const std::size_t frame = find_marker(io_bytes, code);
  io_bytes[frame + 5] = static_cast<std::byte>(height >> 8);
  io_bytes[frame + 6] = static_cast<std::byte>(height & 255);
  io_bytes[frame + 7] = static_cast<std::byte>(width >> 8);
  io_bytes[frame + 8] = static_cast<std::byte>(width & 255);
}

// The progressive file with its last scan, of a few bytes, repeated so that there are `scans` of them.
base::ByteVector with_scans(int scans, int height, int width) {
  const base::ByteVector whole = read_jpeg_file("progressive.jpg");
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i + 1 < whole.size(); ++i)
    if (whole[i] == std::byte{0xff} && whole[i + 1] == std::byte{0xda}) starts.push_back(i);
  const std::size_t end = whole.size() - 2;
  base::ByteVector bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(end));
  for (int i = static_cast<int>(starts.size()); i < scans; ++i)
    bytes.insert(bytes.end(), whole.begin() + static_cast<std::ptrdiff_t>(starts.back()),
                 whole.begin() + static_cast<std::ptrdiff_t>(end));
  bytes.insert(bytes.end(), {std::byte{0xff}, std::byte{0xd9}});
  bytes.resize(std::max<std::size_t>(bytes.size(), 8192));  // bytes after the end
  set_size(0xc2, height, width, bytes);
  return bytes;
}

TEST(Jpeg, LimitsTheScansOfProgressiveFiles) {
  EXPECT_TRUE(read_jpeg(with_scans(64, 32, 32)).ok());
  const auto many = read_jpeg(with_scans(65, 32, 32));
  EXPECT_EQ(many.error().code, base::ErrorCode::kTooLarge);
  EXPECT_THAT(many.error().message(), HasSubstr("64 scans"));
  // Large pictures may have fewer: 16 of 2^24 pixels.
  EXPECT_TRUE(read_jpeg(with_scans(16, 4096, 4096)).ok());
  EXPECT_EQ(read_jpeg(with_scans(17, 4096, 4096)).error().code, base::ErrorCode::kTooLarge);
}

TEST(Jpeg, RefusesOtherFilesAndSizes) {
  EXPECT_FALSE(read_jpeg({}).ok());
  EXPECT_FALSE(read_jpeg(base::as_bytes(std::string_view("no picture at all"))).ok());
  EXPECT_FALSE(read_jpeg(read_jpeg_file("cmyk.jpg")).ok());
  base::ByteVector bytes = read_jpeg_file("baseline.jpg");
  const auto with_size = [&](int height, int width) {
    set_size(0xc0, height, width, bytes);
    return read_jpeg(bytes);
  };
  EXPECT_EQ(with_size(16, 9000).error().code, base::ErrorCode::kTooLarge);
  EXPECT_EQ(with_size(8000, 8000).error().code, base::ErrorCode::kTooLarge);
  EXPECT_THAT(with_size(4000, 4000).error().message(), HasSubstr("cannot hold them"));
  EXPECT_TRUE(with_size(200, 200).ok()) << "rows without data are gray, as in other programs";
}

}  // namespace
}  // namespace temblor::formats
