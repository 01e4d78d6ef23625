// Palette expansion: the SIMD kernel against the scalar reference on every instruction set, and whole frames
// against the definition: a pixel's color is that of its index.
#include "render/present.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "render/screen/present_kernels.h"
#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

constexpr std::uint32_t kUntouchedPixel = 0x12345678u;

std::vector<std::uint32_t> random_colors(Random& random) {
  std::vector<std::uint32_t> colors(256);
  for (std::uint32_t& color : colors) color = static_cast<std::uint32_t>(random.bits());
  return colors;
}

// The indices end at the end of their memory and begin at any alignment; pixels before and after stay
// unchanged.
void expect_expanded(std::size_t count, std::size_t indices_before, std::size_t pixels_before,
                     Random& random) {
  const std::vector<std::uint32_t> colors = random_colors(random);
  std::vector<std::uint8_t> indices(indices_before + count);
  for (std::uint8_t& index : indices) index = static_cast<std::uint8_t>(random.bits());
  std::vector<std::uint32_t> expected(pixels_before + count + 20, kUntouchedPixel);
  std::vector<std::uint32_t> plain = expected, vector = expected;
  for (std::size_t i = 0; i < count; ++i) expected[pixels_before + i] = colors[indices[indices_before + i]];
  render::expand_palette_scalar(indices.data() + indices_before, count, colors.data(),
                                plain.data() + pixels_before);
  render::expand_palette_simd(indices.data() + indices_before, count, colors.data(),
                              vector.data() + pixels_before);
  ASSERT_EQ(plain, expected);
  ASSERT_EQ(vector, expected);
}

TEST(ExpandPalette, GivesEveryIndexItsColor) {
  for_each_simd_target([] {
    for (std::size_t count = 0; count < 150; ++count)
      for (std::size_t start = 0; start < 17; start += effort(1, 5)) {
        SCOPED_TRACE(testing::Message() << count << " from " << start);
        Random random(count * 17 + start);
        expect_expanded(count, start, random.below(17), random);
      }
    Random random(1);
    expect_expanded(100003, 1, 3, random);
  });
}

formats::Palette random_palette(Random& random) {
  formats::Palette palette;
  for (formats::Rgb& color : palette)
    color = {static_cast<std::uint8_t>(random.bits()), static_cast<std::uint8_t>(random.bits()),
             static_cast<std::uint8_t>(random.bits())};
  return palette;
}

// Frames of few rows with many threads, or vice versa: slices may be empty or uneven.
struct PresentCase {
  int width, height, threads;
  bool simd_kernels;
};
std::vector<PresentCase> present_cases() {
  std::vector<PresentCase> cases;
  for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {317, 3}, {64, 33}, {320, 200}})
    for (const int threads : {1, 2, 3})
      for (const bool simd_kernels : {true, false}) cases.push_back({width, height, threads, simd_kernels});
  return cases;
}

TEST(Present, ExpandsIndexedFrames) {
  Random random(1);
  for (const PresentCase& present : present_cases()) {
    const formats::Palette palette = random_palette(random);
    render::FrameBuffer frame(present.width, present.height, render::PixelFormat::kIndexed);
    for (std::uint8_t& index : frame.indexed()) index = static_cast<std::uint8_t>(random.bits());
    base::Jobs jobs(present.threads, base::JobBackend::kStdThread);
    std::vector<std::uint32_t> out(frame.pixel_count(), kUntouchedPixel);
    render::present(frame, palette, present.simd_kernels, jobs, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const formats::Rgb color = palette[frame.indexed()[i]];
      ASSERT_EQ(out[i], 0xff000000u + color.r * 0x10000u + color.g * 0x100u + color.b) << "pixel " << i;
    }
  }
}

TEST(Present, CopiesRgbFrames) {
  Random random(1);
  for (const PresentCase& present : present_cases()) {
    render::FrameBuffer frame(present.width, present.height, render::PixelFormat::kRgb);
    for (std::uint32_t& color : frame.rgb()) color = static_cast<std::uint32_t>(random.bits());
    base::Jobs jobs(present.threads, base::JobBackend::kStdThread);
    std::vector<std::uint32_t> out(frame.pixel_count(), kUntouchedPixel);
    render::present(frame, {}, present.simd_kernels, jobs, out);
    ASSERT_TRUE(std::equal(out.begin(), out.end(), frame.rgb().begin()));
  }
}

}  // namespace
}  // namespace temblor::test
