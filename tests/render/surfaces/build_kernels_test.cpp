// Rows of surface blocks: SIMD against scalar kernels, bit for bit and on every instruction set; scalar
// kernels against the formulas in render/surfaces/build_surface.h.
#include "render/surfaces/build_kernels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/simd_targets.h"
#include "render/surfaces/surface_block.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::IndexedRow;
using render::RgbRow;

constexpr std::int32_t kBrightest = 65280;  // a light sum
constexpr int kMaxTexels = 256;
constexpr std::uint32_t kOpaque = 0xff000000u;

// Dark, bright, or in between; often equal to the neighbor.
std::int32_t random_light_sum(Random& random) {
  switch (random.below(4)) {
    case 0:
      return 0;
    case 1:
      return kBrightest;
    default:
      return static_cast<std::int32_t>(random.below(kBrightest + 1));
  }
}
// The number of samples around `count` texels.
std::size_t sample_columns(int count, int texels_per_sample) {
  return static_cast<std::size_t>((count + texels_per_sample - 1) / texels_per_sample) + 1;
}

// Random bytes. All cases share them, because making them takes much longer than drawing a row.
const std::vector<std::uint8_t>& random_colormap() {
  static const std::vector<std::uint8_t> colormap = [] {
    Random random(64 * 256);
    std::vector<std::uint8_t> bytes(64 * 256);
    for (std::uint8_t& entry : bytes) entry = static_cast<std::uint8_t>(random.bits());
    return bytes;
  }();
  return colormap;
}

// A row of a block: its texels are followed by the padding that kernels may read, and its other arrays have
// exactly their size.
struct IndexedCase {
  int count, texels_per_sample;
  std::vector<std::uint8_t> texels, out;
  std::vector<std::int16_t> light;

  IndexedCase(Random& random, int texels_in_row, int texels_between_samples)
      : count(texels_in_row),
        texels_per_sample(texels_between_samples),
        texels(static_cast<std::size_t>(count) + render::kBlockPadding),
        out(static_cast<std::size_t>(count)) {
    for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random.bits());
    for (std::size_t i = 0; i < sample_columns(count, texels_per_sample); ++i)
      light.push_back(static_cast<std::int16_t>(std::max((kBrightest - random_light_sum(random)) >> 2, 64)));
  }
  std::vector<std::uint8_t> drawn(void (*draw)(const IndexedRow&)) {
    std::fill(out.begin(), out.end(), std::uint8_t{0});
    draw({texels.data(), light.data(), random_colormap().data(), out.data(), count, texels_per_sample});
    return out;
  }
};

struct RgbCase {
  int count, texels_per_sample;
  std::vector<std::uint32_t> texels, out;
  std::vector<std::int16_t> light;  // blue, green, red, 0

  RgbCase(Random& random, int texels_in_row, int texels_between_samples)
      : count(texels_in_row),
        texels_per_sample(texels_between_samples),
        texels(static_cast<std::size_t>(count) + render::kBlockPadding / sizeof(std::uint32_t)),
        out(static_cast<std::size_t>(count)) {
    for (std::uint32_t& texel : texels) {
      const std::uint32_t color = static_cast<std::uint32_t>(random.bits()) & 0xffffffu;
      texel = random.chance(0.2) ? color : color | kOpaque;
    }
    for (std::size_t i = 0; i < sample_columns(count, texels_per_sample); ++i) {
      for (int channel = 0; channel < 3; ++channel)
        light.push_back(static_cast<std::int16_t>(random_light_sum(random) >> 1));
      light.push_back(0);
    }
  }
  std::vector<std::uint32_t> drawn(void (*draw)(const RgbRow&)) {
    std::fill(out.begin(), out.end(), 0u);
    draw({texels.data(), light.data(), out.data(), count, texels_per_sample});
    return out;
  }
};

// Rounds down, whatever the sign.
std::int64_t shifted_right(std::int64_t value, int bits) {
  const std::int64_t unit = std::int64_t{1} << bits;
  return (value - (value % unit + unit) % unit) / unit;
}
// "a + (((b - a) * i * (2048 * 16 / n) + 16384) >> 15)"
std::int64_t between(std::int64_t a, std::int64_t b, int i, int n) {
  return a + shifted_right((b - a) * i * (2048 * 16 / n) + 16384, 15);
}
// "min(255, (2 * color * h + 16384) >> 15)"
std::uint32_t lit_channel(std::uint32_t color, std::int64_t h) {
  return static_cast<std::uint32_t>(std::min<std::int64_t>(255, shifted_right(2 * color * h + 16384, 15)));
}

class BuildRows : public testing::TestWithParam<int> {
 protected:
  const int texels_per_sample_ = GetParam();
};

TEST_P(BuildRows, SimdMatchesTheScalarReference) {
  for (int seed = 0; seed < effort(20, 1); ++seed)
    for (int count = 1; count <= kMaxTexels; ++count) {
      Random random(static_cast<std::uint64_t>(seed * 1000 + count));
      IndexedCase indexed(random, count, texels_per_sample_);
      const std::vector<std::uint8_t> indices = indexed.drawn(render::build_indexed_row_scalar);
      RgbCase rgb(random, count, texels_per_sample_);
      const std::vector<std::uint32_t> colors = rgb.drawn(render::build_rgb_row_scalar);
      for_each_simd_target([&] {
        ASSERT_EQ(indices, indexed.drawn(render::build_indexed_row_simd))
            << count << " indices, seed " << seed;
        ASSERT_EQ(colors, rgb.drawn(render::build_rgb_row_simd)) << count << " colors, seed " << seed;
      });
      if (::testing::Test::HasFatalFailure()) return;
    }
}

// Every pair of neighboring samples, in steps that reach both ends.
TEST_P(BuildRows, SimdMatchesTheScalarReferenceForEveryLight) {
  std::vector<std::int32_t> sums = {0, 1, 2, 3, kBrightest - 1, kBrightest};
  for (std::int32_t sum = 0; sum <= kBrightest; sum += effort(251, 4093)) sums.push_back(sum);
  Random random(1);
  IndexedCase indexed(random, texels_per_sample_, texels_per_sample_);
  RgbCase rgb(random, texels_per_sample_, texels_per_sample_);
  for_each_simd_target([&] {
    for (const std::int32_t first : sums)
      for (const std::int32_t second : sums) {
        for (std::size_t side = 0; side < 2; ++side) {
          const std::int32_t sum = side == 0 ? first : second;
          indexed.light[side] = static_cast<std::int16_t>(std::max((kBrightest - sum) >> 2, 64));
          for (std::size_t channel = 0; channel < 3; ++channel)
            rgb.light[side * 4 + channel] =
                static_cast<std::int16_t>((channel == 1 ? kBrightest - sum : sum) >> 1);
        }
        ASSERT_EQ(indexed.drawn(render::build_indexed_row_scalar),
                  indexed.drawn(render::build_indexed_row_simd))
            << first << ", " << second;
        ASSERT_EQ(rgb.drawn(render::build_rgb_row_scalar), rgb.drawn(render::build_rgb_row_simd))
            << first << ", " << second;
      }
  });
}

TEST_P(BuildRows, IndexedIsTheColormapsRowForTheLight) {
  for (int seed = 0; seed < effort(1000, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    IndexedCase row(random, static_cast<int>(1 + random.below(kMaxTexels)), texels_per_sample_);
    const std::vector<std::uint8_t> drawn = row.drawn(render::build_indexed_row_scalar);
    for (std::size_t x = 0; x < drawn.size(); ++x) {
      const std::size_t sample = x / static_cast<std::size_t>(texels_per_sample_);
      const int i = static_cast<int>(x) % texels_per_sample_;
      const std::int64_t t = between(row.light[sample], row.light[sample + 1], i, texels_per_sample_);
      const std::size_t light_row = static_cast<std::size_t>(t >> 8);
      ASSERT_LT(light_row, 64u);
      ASSERT_EQ(drawn[x], random_colormap()[light_row * 256 + row.texels[x]])
          << "seed " << seed << " texel " << x;
    }
  }
}

TEST_P(BuildRows, RgbIsTheLineOfArithmetic) {
  for (int seed = 0; seed < effort(1000, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    RgbCase row(random, static_cast<int>(1 + random.below(kMaxTexels)), texels_per_sample_);
    const std::vector<std::uint32_t> drawn = row.drawn(render::build_rgb_row_scalar);
    for (std::size_t x = 0; x < drawn.size(); ++x) {
      const bool full_bright = row.texels[x] < kOpaque;
      const std::int16_t* samples = row.light.data() + x / static_cast<std::size_t>(texels_per_sample_) * 4;
      const int i = static_cast<int>(x) % texels_per_sample_;
      std::uint32_t expected = kOpaque;
      for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t color = row.texels[x] >> (8 * channel) & 255;
        const std::int64_t h = between(samples[channel], samples[4 + channel], i, texels_per_sample_);
        expected |= (full_bright ? color : lit_channel(color, h)) << (8 * channel);
      }
      ASSERT_EQ(drawn[x], expected) << "seed " << seed << " texel " << x;
    }
  }
}

// The intent of the arithmetic: bilinear light, rounded to the nearest whole number.
TEST_P(BuildRows, RgbIsWithinRoundingOfTheProduct) {
  for (int seed = 0; seed < effort(1000, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    RgbCase row(random, static_cast<int>(1 + random.below(kMaxTexels)), texels_per_sample_);
    const std::vector<std::uint32_t> drawn = row.drawn(render::build_rgb_row_scalar);
    for (std::size_t x = 0; x < drawn.size(); ++x) {
      if (row.texels[x] < kOpaque) continue;
      const std::int16_t* samples = row.light.data() + x / static_cast<std::size_t>(texels_per_sample_) * 4;
      const double along = static_cast<double>(static_cast<int>(x) % texels_per_sample_) / texels_per_sample_;
      for (int channel = 0; channel < 3; ++channel) {
        const double light = samples[channel] + (samples[4 + channel] - samples[channel]) * along;
        const double color = row.texels[x] >> (8 * channel) & 255;
        // Half of a step of light, then half of a step of color.
        const double expected = std::min(255.0, color * light / 16384), tolerance = 0.5 + color / 32768;
        ASSERT_NEAR(drawn[x] >> (8 * channel) & 255, expected, tolerance + 1e-9)
            << "seed " << seed << " texel " << x;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(TexelsASample, BuildRows, testing::Values(16, 8, 4, 2, 1),
                         [](const auto& test) { return fmt::format("{}", test.param); });

// The light as stored, half the sum of 128 x 256, leaves every color unchanged.
TEST(BuildRow, OfMiddlingLightShowsColorsAsTheyAre) {
  std::vector<std::uint32_t> texels(256 + render::kBlockPadding / sizeof(std::uint32_t)), out(256);
  for (std::uint32_t i = 0; i < 256; ++i) texels[i] = kOpaque | i << 16 | (255 - i) << 8 | (i ^ 85);
  std::vector<std::int16_t> light;
  for (int sample = 0; sample <= 256 / 16; ++sample) light.insert(light.end(), {16384, 16384, 16384, 0});
  render::build_rgb_row_scalar({texels.data(), light.data(), out.data(), 256, 16});
  EXPECT_TRUE(std::equal(out.begin(), out.end(), texels.begin()));
}

}  // namespace
}  // namespace temblor::test
