#include "golden/golden_picture.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>

#include "base/check.h"
#include "formats/images/png.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

constexpr std::uint32_t kOpaque = 0xff000000u;

int channel(std::uint32_t pixel, int shift) {
  return static_cast<int>(pixel >> shift & 255);
}

// The difference of the channel that differs most.
int distance(std::uint32_t a, std::uint32_t b) {
  int most = 0;
  for (const int shift : {0, 8, 16}) most = std::max(most, std::abs(channel(a, shift) - channel(b, shift)));
  return most;
}

std::uint32_t amplified_difference(std::uint32_t a, std::uint32_t b) {
  constexpr int kAmplify = 8;
  std::uint32_t difference = kOpaque;
  for (const int shift : {0, 8, 16}) {
    const int apart = std::abs(channel(a, shift) - channel(b, shift));
    difference |= static_cast<std::uint32_t>(std::min(255, kAmplify * apart)) << shift;
  }
  return difference;
}

bool same_size(const formats::Image& a, const formats::Image& b) {
  return a.width == b.width && a.height == b.height;
}

// From left to right, top edges aligned, with a stripe between.
formats::Image in_a_row(std::span<const formats::Image> images) {
  constexpr std::uint32_t kStripe = 4, kStripeColor = kOpaque | 0x808080;
  formats::Image row;
  for (const formats::Image& image : images) {
    row.width += image.width + kStripe;
    row.height = std::max(row.height, image.height);
  }
  row.pixels.assign(std::size_t{row.width} * row.height, kStripeColor);
  std::uint32_t left = 0;
  for (const formats::Image& image : images) {
    for (std::uint32_t y = 0; y < image.height; ++y)
      std::copy_n(image.pixels.begin() + std::ptrdiff_t{y} * image.width, image.width,
                  row.pixels.begin() + std::ptrdiff_t{y} * row.width + left);
    left += image.width + kStripe;
  }
  return row;
}

void write_file(const std::filesystem::path& path, base::Bytes bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  CHECK(file.good(), "cannot write {}", path.string());
}

}  // namespace

::testing::AssertionResult is_like(const formats::Image& expected, const formats::Image& got,
                                   const Tolerance& tolerance) {
  if (!same_size(expected, got))
    return ::testing::AssertionFailure() << "expected " << expected.width << " x " << expected.height
                                         << " pixels, got " << got.width << " x " << got.height;
  std::size_t differing = 0, far_off = 0;
  int furthest = 0;
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    const int apart = distance(expected.pixels[i], got.pixels[i]);
    differing += apart > tolerance.step ? 1 : 0;
    far_off += apart > kFarOff ? 1 : 0;
    furthest = std::max(furthest, apart);
  }
  const double percent = 100.0 * static_cast<double>(differing) / static_cast<double>(expected.pixels.size());
  if (percent <= tolerance.differing_percent && far_off <= tolerance.far_off)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << differing << " pixels (" << percent << " %) differ, " << far_off
                                       << " by more than " << kFarOff << ", at most by " << furthest;
}

formats::Image side_by_side(const formats::Image& expected, const formats::Image& got) {
  std::vector<formats::Image> images = {expected, got};
  if (same_size(expected, got)) {
    formats::Image difference = expected;
    std::transform(expected.pixels.begin(), expected.pixels.end(), got.pixels.begin(),
                   difference.pixels.begin(), amplified_difference);
    images.push_back(std::move(difference));
  }
  return in_a_row(images);
}

void expect_golden(const std::string& name, base::Bytes png, const Tolerance& tolerance) {
  const std::string file_name = name + ".png";
  const std::filesystem::path golden = std::filesystem::path(TEMBLOR_GOLDEN_PICTURES) / file_name;
  if (std::getenv("TEMBLOR_REWRITE_GOLDENS") != nullptr) {
    write_file(golden, png);
    GTEST_SKIP() << golden << " was written; look at it before you commit it";
  }
  ASSERT_TRUE(std::filesystem::exists(golden)) << "no picture " << golden;
  const formats::Image expected = formats::read_png(read_file(golden)).value();
  const formats::Image got = formats::read_png(png).value();
  const ::testing::AssertionResult alike = is_like(expected, got, tolerance);
  if (alike) return;
  const std::filesystem::path failure = std::filesystem::path(TEMBLOR_GOLDEN_FAILURES) / file_name;
  const formats::Image row = side_by_side(expected, got);
  write_file(
      failure,
      formats::write_png(row.pixels, static_cast<int>(row.width), static_cast<int>(row.height)).value());
  ADD_FAILURE() << name << ": " << alike.message() << "\nexpected, got, difference: " << failure;
}

}  // namespace temblor::test
