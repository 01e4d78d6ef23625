// Rows of sprites: SIMD against scalar kernels on every instruction set, bit for bit. sprites_test.cpp
// compares whole sprites with rays.
#include "render/sprites/sprite_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

// Buffers of exactly the size drawn to, so that the address sanitizer sees reads and writes past their ends.
template <typename Pixel>
struct DrawnRow {
  std::vector<Pixel> pixels;
  std::vector<float> depth;
  bool operator==(const DrawnRow&) const = default;
};

struct Case {
  std::vector<std::uint8_t> texels;
  std::vector<std::uint32_t> colors = std::vector<std::uint32_t>(256);
  render::SpriteRow row{};
};

render::SpriteLine random_line(Random& random, double size, int pixels) {
  const double from = random.uniform(-0.2 * size, 1.2 * size), to = random.uniform(-0.2 * size, 1.2 * size);
  return {static_cast<float>(from), static_cast<float>(random.chance(0.2) ? 0 : (to - from) / pixels)};
}

// Some pictures are smaller than a gather; depths that reach zero occur by rounding.
Case random_case(Random& random) {
  Case c;
  c.row.width = 1 + static_cast<std::int32_t>(random.below(random.chance(0.2) ? 3 : 80));
  c.row.height = 1 + static_cast<std::int32_t>(random.below(random.chance(0.2) ? 3 : 80));
  c.texels.resize(static_cast<std::size_t>(c.row.width * c.row.height));
  for (std::uint8_t& texel : c.texels)
    texel = random.chance(0.3) ? render::kClearTexel : static_cast<std::uint8_t>(random.bits());
  for (std::uint32_t& color : c.colors) color = static_cast<std::uint32_t>(random.bits());
  c.row.count = static_cast<std::int32_t>(random.below(150));
  c.row.first = random.chance(0.5) ? 0 : static_cast<std::int32_t>(random.below(5000));
  c.row.affine = random.chance(0.5);
  const int pixels = c.row.first + c.row.count + 1;
  c.row.depth = random_line(random, random.chance(0.1) ? 1e-30 : 0.1, pixels);
  const double scale = c.row.affine ? 1 : 0.05;
  c.row.s = random_line(random, c.row.width * scale, pixels);
  c.row.t = random_line(random, c.row.height * scale, pixels);
  return c;
}

template <typename Pixel, typename Kernel>
DrawnRow<Pixel> draw(Kernel kernel, const Case& c, DrawnRow<Pixel> drawn) {
  render::SpriteRow row = c.row;
  row.texels = c.texels.data();
  row.colors = c.colors.data();
  row.pixels = drawn.pixels.data();
  row.frame_depth = drawn.depth.data();
  kernel(row);
  return drawn;
}

template <typename Pixel, typename Kernel>
void expect_same_sprites(Kernel vector, Kernel plain) {
  std::size_t changed = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(effort(3000, 300)); ++seed) {
    Random random(seed);
    const Case c = random_case(random);
    DrawnRow<Pixel> before;
    for (int i = 0; i < c.row.count; ++i) {
      before.pixels.push_back(static_cast<Pixel>(random.bits()));
      before.depth.push_back(static_cast<float>(random.chance(0.7) ? -1 : random.uniform(0, 0.1)));
    }
    const DrawnRow<Pixel> by_scalar = draw(plain, c, before);
    for_each_simd_target([&] { ASSERT_EQ(draw(vector, c, before), by_scalar) << "seed " << seed; });
    if (testing::Test::HasFatalFailure()) return;
    changed += by_scalar != before;
  }
  EXPECT_GT(changed, 100u);
}

TEST(SpriteKernels, DrawTheSameOnEveryInstructionSet) {
  expect_same_sprites<std::uint8_t>(render::draw_sprite_row_u8_simd, render::draw_sprite_row_u8_scalar);
  expect_same_sprites<std::uint32_t>(render::draw_sprite_row_u32_simd, render::draw_sprite_row_u32_scalar);
}

// A row that is drawn in segments equals the whole row.
TEST(SpriteKernels, DrawSegmentsLikeTheWholeRow) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    Case c = random_case(random);
    const auto pixels = static_cast<std::size_t>(c.row.count);
    const DrawnRow<std::uint8_t> before{std::vector<std::uint8_t>(pixels, 1),
                                        std::vector<float>(pixels, -1.0f)};
    const DrawnRow<std::uint8_t> whole = draw(render::draw_sprite_row_u8_simd, c, before);
    DrawnRow<std::uint8_t> in_pieces = before;
    const std::int32_t first = c.row.first, count = c.row.count;
    for (std::int32_t done = 0; done < count; done += c.row.count) {
      c.row.first = first + done;
      c.row.count = std::min(count - done, 1 + static_cast<std::int32_t>(random.below(40)));
      render::SpriteRow row = c.row;
      row.texels = c.texels.data();
      row.pixels = in_pieces.pixels.data() + done;
      row.frame_depth = in_pieces.depth.data() + done;
      render::draw_sprite_row_u8_simd(row);
    }
    ASSERT_EQ(in_pieces, whole) << i;
  }
}

}  // namespace
}  // namespace temblor::test
