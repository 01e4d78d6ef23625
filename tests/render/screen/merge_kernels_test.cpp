// Rows of deferred faces merged into the picture, against the definition, pixel by pixel.
#include "render/translucent/merge_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render/simd_targets.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::MergeRow;

template <typename Pixel>
struct MergeCase {
  std::vector<Pixel> texels, pixels;
  std::vector<float> depth, z;
  std::vector<std::uint8_t> table;
  MergeRow row{};

  explicit MergeCase(Random& random) : table(65536 + 3) {
    const std::size_t count = random.below(70);
    for (std::size_t i = 0; i < count; ++i) {
      const bool clear = random.chance(0.3);
      texels.push_back(clear ? static_cast<Pixel>(sizeof(Pixel) == 1 ? 255 : random.bits() & 0xffffffu)
                             : static_cast<Pixel>(random.bits() | 0xff000000u));
      pixels.push_back(static_cast<Pixel>(random.bits() | 0xff000000u));
      depth.push_back(static_cast<float>(random.uniform(0, 1)));
      z.push_back(random.chance(0.2) ? depth.back() : static_cast<float>(random.uniform(0, 1)));
    }
    for (std::uint8_t& entry : table) entry = static_cast<std::uint8_t>(random.bits());
    row.count = static_cast<std::int32_t>(count);
    row.nearer = random.chance(0.5) ? 1.0f : 1.00001f;
    row.has_holes = random.chance(0.5);
    row.opacity_256 = static_cast<std::int32_t>(random.below(257));
  }
  MergeRow ready() {
    row.texels = texels.data();
    row.depth = depth.data();
    row.pixels = pixels.data();
    row.z = z.data();
    row.table = table.data();
    return row;
  }
  bool shows(std::size_t i) const {
    const bool is_clear = sizeof(Pixel) == 1 ? texels[i] == 255 : texels[i] < 0x1000000u;
    return depth[i] * row.nearer >= z[i] && !(row.has_holes && is_clear);
  }
};

template <typename Pixel, typename Merge, typename Expect>
void expect_as_defined(Merge merge, bool writes_depth, Expect expect) {
  for (int seed = 0; seed < 200; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    MergeCase<Pixel> before(random);
    MergeCase<Pixel> after = before;
    merge(after.ready());
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
      const bool shows = before.shows(i);
      ASSERT_EQ(after.pixels[i], shows ? expect(before, i) : before.pixels[i])
          << "seed " << seed << ", " << i;
      ASSERT_EQ(after.z[i], shows && writes_depth ? before.depth[i] : before.z[i]) << "seed " << seed;
    }
  }
}

std::uint8_t blended_byte(const MergeCase<std::uint8_t>& before, std::size_t i) {
  return before.table[before.texels[i] * 256u + before.pixels[i]];
}
std::uint32_t blended_color(const MergeCase<std::uint32_t>& before, std::size_t i) {
  std::uint32_t out = 0xff000000u;
  const double share = before.row.opacity_256 / 256.0;
  for (int shift = 0; shift < 24; shift += 8) {
    const double over = before.texels[i] >> shift & 255, under = before.pixels[i] >> shift & 255;
    out |= static_cast<std::uint32_t>(std::floor(over * share + under * (1 - share) + 0.5)) << shift;
  }
  return out;
}

TEST(MergeOpaque, WritesPixelsAndDepthOfWhatIsInFront) {
  const auto texel = [](const auto& before, std::size_t i) { return before.texels[i]; };
  expect_as_defined<std::uint8_t>([](const MergeRow& row) { render::merge_opaque_u8_scalar(row); }, true,
                                  texel);
  expect_as_defined<std::uint32_t>([](const MergeRow& row) { render::merge_opaque_u32_scalar(row); }, true,
                                   texel);
  for_each_simd_target([&] {
    expect_as_defined<std::uint8_t>(render::merge_opaque_u8_simd, true, texel);
    expect_as_defined<std::uint32_t>(render::merge_opaque_u32_simd, true, texel);
  });
}

TEST(MergeBlend, BlendsAndLeavesDepthAlone) {
  expect_as_defined<std::uint8_t>([](const MergeRow& row) { render::merge_blend_u8_scalar(row); }, false,
                                  blended_byte);
  expect_as_defined<std::uint32_t>([](const MergeRow& row) { render::merge_blend_u32_scalar(row); }, false,
                                   blended_color);
  for_each_simd_target([&] {
    expect_as_defined<std::uint8_t>(render::merge_blend_u8_simd, false, blended_byte);
    expect_as_defined<std::uint32_t>(render::merge_blend_u32_simd, false, blended_color);
  });
}

}  // namespace
}  // namespace temblor::test
