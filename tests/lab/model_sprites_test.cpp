// Cached pictures of models.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "lab/model_pictures.h"
#include "lab/models/sprite_kernels.h"
#include "render/simd_targets.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

// A model that is moved by whole pixels has other rounding errors, and surfaces at equal depth may swap
// places.
void expect_nearly_the_same(FrameCopy a, FrameCopy b, int seed) {
  for (std::size_t i = 0; i < a.depth_bits.size(); ++i) {
    const float ours = std::bit_cast<float>(a.depth_bits[i]), right = std::bit_cast<float>(b.depth_bits[i]);
    if (std::abs(ours - right) <= 1e-4f * std::abs(right)) b.depth_bits[i] = a.depth_bits[i];
  }
  EXPECT_LT(differing_pixels(a, b), a.depth_bits.size() / 500) << seed;
}

TEST(ModelSprites, OfOneFrameAreTheEnginesModels) {
  const DrawableLevel drawable = small_level();
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (int seed = 0; seed < effort(20, 3); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      ModelScene models(drawable, random, {.least = 2});
      models.scene.view_weapon = &models.weapon;
      ModelPictures engine(drawable, nullptr, format), sprites(drawable, "model-sprites:frames=1", format);
      for (int frame = 0; frame < 2; ++frame)
        expect_nearly_the_same(engine.copy(models.scene, {}), sprites.copy(models.scene, {}), seed);
    }
}

TEST(ModelSprites, KeepTheirPictureWhileNothingMoves) {
  const DrawableLevel drawable = small_level();
  Random random(1);
  const ModelScene models(drawable, random, {.least = 100});
  ModelPictures sprites(drawable, "model-sprites:frames=3", PixelFormat::kRgb);
  const FrameCopy first = sprites.copy(models.scene, kModelsAlone);
  for (int frame = 0; frame < 4; ++frame) EXPECT_EQ(first, sprites.copy(models.scene, kModelsAlone));
}

// The columns and rows between which a frame has models.
struct DrawnBox {
  int left = 10000, top = 10000, right = -1, bottom = -1;
};
DrawnBox find_box(const render::FrameBuffer& frame) {
  DrawnBox box;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) {
      if (!(frame.depth()[static_cast<std::size_t>(y * frame.width() + x)] > 0)) continue;
      box.left = std::min(box.left, x);
      box.top = std::min(box.top, y);
      box.right = std::max(box.right, x);
      box.bottom = std::max(box.bottom, y);
    }
  return box;
}

// One model walks to the side. Its old picture is drawn where the model is, whichever frame makes a new one.
TEST(ModelSprites, MoveWithTheirModels) {
  const DrawableLevel drawable = small_level();
  Random random(2);
  ModelScene models(drawable, random, {.least = 200, .most = 201, .spread = 0, .count = 1});
  ModelPictures sprites(drawable, "model-sprites:frames=4", PixelFormat::kIndexed);
  ModelPictures engine(drawable, nullptr, PixelFormat::kIndexed);
  int different = 0;
  for (int frame = 0; frame < 12; ++frame) {
    const DrawnBox drawn = find_box(sprites.draw(models.scene, kModelsAlone));
    const DrawnBox right = find_box(engine.draw(models.scene, kModelsAlone));
    EXPECT_LE(std::abs(drawn.left - right.left), 1) << frame;
    EXPECT_LE(std::abs(drawn.right - right.right), 1) << frame;
    EXPECT_LE(std::abs(drawn.top - right.top), 1) << frame;
    EXPECT_LE(std::abs(drawn.bottom - right.bottom), 1) << frame;
    different +=
        sprites.copy(models.scene, kModelsAlone).indexed != engine.copy(models.scene, kModelsAlone).indexed;
    render::AliasInstance& instance = models.instances.front();
    instance.origin_world += math::Vec3(models.axes().right * 3.0);
    instance.angles_deg.z += 20;
  }
  EXPECT_GT(different, 3);
}

// Another model under the same number is not shown with the old picture.
TEST(ModelSprites, BelongToTheirModel) {
  const DrawableLevel drawable = small_level();
  Random random(3);
  ModelScene models(drawable, random, {.least = 200, .most = 300, .spread = 0.2, .count = 2});
  ModelPictures sprites(drawable, "model-sprites:frames=60", PixelFormat::kRgb);
  sprites.draw(models.scene, kModelsAlone);
  std::swap(models.instances[0], models.instances[1]);
  ModelPictures engine(drawable, nullptr, PixelFormat::kRgb);
  expect_nearly_the_same(engine.copy(models.scene, kModelsAlone), sprites.copy(models.scene, kModelsAlone),
                         0);
}

struct Blended {
  std::vector<std::uint8_t> indexed;
  std::vector<std::uint32_t> rgb;
  std::vector<float> depth;
  bool operator==(const Blended&) const = default;
};

TEST(SpriteKernels, AgreeWithTheScalarOnes) {
  int changed = 0;
  for (int seed = 0; seed < effort(300, 30); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto width = static_cast<std::int32_t>(1 + random.below(70));
    const auto height = static_cast<std::int32_t>(1 + random.below(5));
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 64;
    Blended sprite, frame;
    for (std::size_t i = 0; i < pixels; ++i) {
      sprite.indexed.push_back(static_cast<std::uint8_t>(random.below(256)));
      sprite.rgb.push_back(static_cast<std::uint32_t>(random.bits()));
      const bool is_empty = random.chance(0.4);
      const double depth = random.uniform(0, 1);
      sprite.depth.push_back(is_empty ? -std::numeric_limits<float>::infinity() : static_cast<float>(depth));
      frame.indexed.push_back(0);
      frame.rgb.push_back(0);
      const double before = random.uniform(-1, 1);
      frame.depth.push_back(static_cast<float>(before));
    }
    const auto draw = [&](auto kernel_u8, auto kernel_u32) {
      Blended out = frame, other = frame;
      lab::SpriteRows rows{sprite.indexed.data(),
                           sprite.depth.data(),
                           0.9f,
                           out.indexed.data(),
                           out.depth.data(),
                           width,
                           width,
                           width,
                           height};
      kernel_u8(rows);
      rows.pixels = sprite.rgb.data();
      rows.out_pixels = other.rgb.data();
      rows.out_depth = other.depth.data();
      kernel_u32(rows);
      EXPECT_EQ(out.depth, other.depth);
      out.rgb = other.rgb;
      return out;
    };
    const Blended expected = draw(lab::draw_sprite_u8_scalar, lab::draw_sprite_u32_scalar);
    changed += expected != frame;
    for_each_simd_target(
        [&] { EXPECT_EQ(expected, draw(lab::draw_sprite_u8_simd, lab::draw_sprite_u32_simd)) << seed; });
  }
  EXPECT_GT(changed, effort(200, 20));
}

}  // namespace
}  // namespace temblor::test
