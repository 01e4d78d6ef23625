// Many level changes: nothing of old levels stays on the card.
#include <gtest/gtest.h>

#include <iostream>

#include "render_gl/injected_gl.h"
#include "render_gl/model_scenes.h"
#include "support/effort.h"
#include "support/models/drawable_models.h"

namespace temblor::render_gl {
namespace {

struct Held {
  std::size_t objects = 0;
  std::uint64_t bytes = 0;
};

// Every level has its own models, sprite, and skybox, which are freed when the next one is drawn.
class LevelChanges : public testing::TestWithParam<render::PixelFormat> {
 protected:
  void SetUp() override {
    auto made = InjectedGl::make();
    if (!made.ok()) GTEST_SKIP() << "no OpenGL: " << made.error().what;
    card_ = std::move(made).value();
  }

  void draw_level(std::size_t number, GlRenderer& io_renderer) {
    const world::Level& level = *levels_[number % levels_.size()].level;
    test::Random random(number % 2);
    ModelScene scene = random_scene(make_small_models(), level, 3, random);
    scene.instances.front().alpha = 0.5f;
    render::Skybox skybox;
    const std::uint32_t side_texels = number % 2 == 0 ? 16 : 64;
    for (formats::Image& side : skybox.sides)
      side = {side_texels, side_texels,
              std::vector<std::uint32_t>(std::size_t{side_texels} * side_texels, 0xff123456)};
    const formats::Spr sprite{
        .frames = {
            {{{-4, 4, 8, 8, std::vector<std::uint8_t>(64, static_cast<std::uint8_t>(number % 200))}}, {}}}};
    const render::SpriteInstance instance{.sprite = &sprite,
                                          .picture = &sprite.frames[0].pictures[0],
                                          .origin_world = scene.instances[1].origin_world};
    render::Scene drawn = scene.scene(level);
    drawn.skybox = &skybox;
    drawn.sprites = {&instance, 1};
    drawn.underwater = true;
    drawn.fog = {.density = 0.05f, .color = math::Vec3(0.5f)};
    render::FrameBuffer frame(64, 48, GetParam());
    for (int repeat = 0; repeat < 2; ++repeat) {
      const auto result = io_renderer.render(drawn, {}, frame);
      ASSERT_TRUE(result.ok()) << result.error().what;
    }
  }
  void keep_nothing(WorldMethod method, std::size_t changes) {
    constexpr std::size_t kFirst = 20;
    {
      GlRenderer renderer =
          GlRenderer::make(card_->finder(), levels_[0].palette, levels_[0].colormap, {.bytes = 8 << 20})
              .value();
      renderer.set_method(method);
      Held most;
      for (std::size_t number = 0; number < changes; ++number) {
        draw_level(number, renderer);
        const Held now = held();
        if (number < kFirst) {
          most = {std::max(most.objects, now.objects), std::max(most.bytes, now.bytes)};
          continue;
        }
        ASSERT_LE(now.objects, most.objects) << "after " << number << " changes";
        ASSERT_LE(now.bytes, most.bytes) << "after " << number << " changes";
      }
      std::cout << "[          ] " << most.objects << " objects, " << most.bytes << " bytes\n";
    }
    EXPECT_EQ(card_->live_objects(), 0u);
  }
  Held held() const { return {card_->live_objects(), card_->live_bytes()}; }

  const std::vector<test::DrawableLevel> levels_ = {test::small_level({.tiny = true}, "tiny"),
                                                    test::small_level({.tiny = true, .seed = 2}, "other")};
  std::unique_ptr<InjectedGl> card_;
};

TEST_P(LevelChanges, KeepNothingOfOldLevels) {
  keep_nothing(WorldMethod::kBlocks, test::effort(500, 30));
  if (GetParam() == render::PixelFormat::kIndexed) return;
  using enum WorldMethod;
  for (const WorldMethod method :
       {kLitTextures, kCardBlocks, kExpandedBlocks, kLightPass, kLightPolygons, kGouraud, kStyleLayers})
    keep_nothing(method, test::effort(80, 30));
}

INSTANTIATE_TEST_SUITE_P(BothFormats, LevelChanges,
                         testing::Values(render::PixelFormat::kRgb, render::PixelFormat::kIndexed));

}  // namespace
}  // namespace temblor::render_gl
