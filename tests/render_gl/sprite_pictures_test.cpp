// Sprites on the graphics card, next to the CPU's picture.
#include <gtest/gtest.h>

#include "render_gl/gl_pictures.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"
#include "support/pictures/deferred_faces.h"

namespace temblor::render_gl {
namespace {

using formats::SprOrientation;

// The other pixels lie at edges of sprites, of their texels, and of the level's faces.
constexpr double kSpriteEqualShare = 0.9995;

constexpr SprOrientation kOrientations[] = {SprOrientation::kParallelUpright, SprOrientation::kFacingUpright,
                                            SprOrientation::kParallel, SprOrientation::kOriented,
                                            SprOrientation::kParallelOriented};

// One texel in five is clear.
formats::SprPicture make_picture(std::uint32_t width, std::uint32_t height, test::Random& io_random) {
  formats::SprPicture picture{-static_cast<int>(width / 2), static_cast<int>(height / 2), width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    picture.texels.push_back(io_random.chance(0.2) ? std::uint8_t{255}
                                                   : static_cast<std::uint8_t>(io_random.below(255)));
  return picture;
}

// One sprite of each orientation, with pictures of different sizes.
std::vector<formats::Spr> make_sprites(test::Random& io_random) {
  std::vector<formats::Spr> sprites;
  for (const SprOrientation orientation : kOrientations) {
    formats::Spr sprite{.orientation = orientation};
    for (int frame = 0; frame < 2; ++frame)
      sprite.frames.push_back({{make_picture(1 + static_cast<std::uint32_t>(io_random.below(70)),
                                             1 + static_cast<std::uint32_t>(io_random.below(70)), io_random)},
                               {}});
    sprites.push_back(std::move(sprite));
  }
  return sprites;
}

struct Range {
  double low, high;
};

std::vector<render::SpriteInstance> place_in_view(const std::vector<formats::Spr>& sprites, std::size_t count,
                                                  Range distance, const render::Scene& scene,
                                                  test::Random& io_random) {
  std::vector<render::SpriteInstance> placed;
  while (placed.size() < count) {
    const formats::Spr& sprite = sprites[io_random.below(sprites.size())];
    placed.push_back({.sprite = &sprite,
                      .picture = &sprite.frames[io_random.below(sprite.frames.size())].pictures[0],
                      .origin_world = point_in_view(scene, io_random.log_uniform(distance.low, distance.high),
                                                    0.8, io_random),
                      .angles_deg = io_random.in_cube(180),
                      .scale = static_cast<float>(io_random.log_uniform(0.3, 2))});
  }
  return placed;
}

// Compares pictures of `count` sprites; `change` may change a scene and its sprites.
template <typename Change>
void compare_sprites(std::size_t count, Range distance, Change change) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int number = 0; number < test::effort(20, 3); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const std::vector<formats::Spr> sprites = make_sprites(random);
    SceneView view = any_view(*level.level, random);
    std::vector<render::SpriteInstance> placed = place_in_view(sprites, count, distance, view.scene, random);
    change(number, view.scene, placed);
    view.scene.sprites = placed;
    EXPECT_GE(pair.compare(view.scene, {}), kSpriteEqualShare) << number;
  }
}

constexpr auto kUnchanged = [](int, render::Scene&, std::vector<render::SpriteInstance>&) {};

TEST(GlSprites, ShowEveryOrientation) {
  compare_sprites(40, {20, 400}, kUnchanged);
}

TEST(GlSprites, AreCutAtTheNearPlane) {
  compare_sprites(6, {0.02, 12}, kUnchanged);
}

TEST(GlSprites, ShowParallelProjection) {
  compare_sprites(40, {20, 400}, [](int number, render::Scene& io_scene, auto&) {
    io_scene.camera.projection = render::Projection::kOrthographic;
    io_scene.camera.units_per_pixel = number % 2 == 0 ? 0.5f : 1.5f;
  });
}

TEST(GlSprites, AreFogged) {
  compare_sprites(40, {20, 400}, [](int number, render::Scene& io_scene, auto& io_sprites) {
    io_scene.fog = {.density = number % 2 == 0 ? 0.1f : 0.5f, .color = {0.8f, 0.5f, 0.2f}};
    for (std::size_t i = 0; i < io_sprites.size(); i += 2) io_sprites[i].alpha = 0.6f;
  });
}

TEST(GlSprites, AreBlendedInOrderWithOtherLayers) {
  compare_sprites(40, {20, 400}, [](int number, render::Scene& io_scene, auto& io_sprites) {
    test::Random random(static_cast<std::uint64_t>(number));
    for (render::SpriteInstance& sprite : io_sprites)
      sprite.alpha = random.chance(0.3) ? 1.0f : static_cast<float>(random.uniform(-0.2, 1));
    io_scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
  });
}

// The later of two sprites at one place stays. Depth of sprites that are not parallel to the picture is
// rounded, also on the CPU.
TEST(GlSprites, CoverEarlierOnesOfTheSameDepth) {
  compare_sprites(40, {20, 400}, [](int, render::Scene&, auto& io_sprites) {
    std::erase_if(io_sprites, [](const render::SpriteInstance& sprite) {
      return sprite.sprite->orientation != SprOrientation::kParallel &&
             sprite.sprite->orientation != SprOrientation::kParallelOriented;
    });
    for (std::size_t i = 1; i < io_sprites.size(); i += 2)
      io_sprites[i].origin_world = io_sprites[i - 1].origin_world;
  });
}

TEST(GlSprites, WithoutDepthAreLeftOut) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  test::Random random(1);
  const std::vector<formats::Spr> sprites = make_sprites(random);
  SceneView view = any_view(*level.level, random);
  const auto placed = place_in_view(sprites, 40, {20, 200}, view.scene, random);
  view.scene.sprites = placed;
  for (const bool fill_depth : {false, true})
    EXPECT_GE(pair.compare(view.scene, {.fill_depth = fill_depth}), kSpriteEqualShare) << fill_depth;
}

// Another picture may have the memory of one that is gone.
TEST(GlSprites, ShowPicturesThatHaveChanged) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  test::Random random(1);
  std::vector<formats::Spr> sprites = make_sprites(random);
  SceneView view = any_view(*level.level, random);
  const auto placed = place_in_view(sprites, 40, {20, 200}, view.scene, random);
  view.scene.sprites = placed;
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_GE(pair.compare(view.scene, {}), kSpriteEqualShare) << frame;
    for (formats::Spr& sprite : sprites) {
      formats::SprPicture& picture = sprite.frames[0].pictures[0];
      for (std::uint8_t& texel : picture.texels) texel = static_cast<std::uint8_t>(random.bits());
      std::swap(picture.width, picture.height);
    }
  }
}

// So many texels that textures are dropped.
TEST(GlSprites, ShowManyLargePictures) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  for (int frame = 0; frame < 3; ++frame) {
    test::Random random(static_cast<std::uint64_t>(frame));
    std::vector<formats::Spr> sprites(5);
    for (formats::Spr& sprite : sprites) sprite.frames = {{{make_picture(1500, 1300, random)}, {}}};
    SceneView view = any_view(*level.level, random);
    auto placed = place_in_view(sprites, 10, {20, 200}, view.scene, random);
    for (render::SpriteInstance& sprite : placed) sprite.scale *= 0.05f;
    view.scene.sprites = placed;
    // Texels are smaller than pixels, so a rounding error more often meets another texel.
    EXPECT_GE(pair.compare(view.scene, {}), 0.999) << frame;
  }
}

}  // namespace
}  // namespace temblor::render_gl
