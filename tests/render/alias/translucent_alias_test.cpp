// Translucent models: each pixel of the opaque model is blended once.
#include <gtest/gtest.h>

#include "render/alias/draw_alias_models.h"
#include "render/alias/draw_translucent_alias.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/pictures/stage_parts.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::test {
namespace {

constexpr int kGlassWidth = 150, kGlassHeight = 110;

class TranslucentAlias : public testing::TestWithParam<render::PixelFormat> {
 protected:
  // A level, and a model in front of it that hides its own far side.
  void set_up(std::uint64_t seed) {
    Random random(seed);
    scene_.alias_models = {};
    scene_.level = drawable_.level.get();
    scene_.camera = random_camera(*drawable_.level, random);
    scene_.camera.projection = render::Projection::kPerspective;
    instance_.model = model_.get();
    const math::Basis axes = math::basis_from_angles(scene_.camera.angles_deg);
    const double distance = random.uniform(20, 150);
    instance_.origin_world =
        scene_.camera.origin_world + math::Vec3(axes.forward * distance) + random.in_cube(40);
    instance_.angles_deg = random.in_cube(180);
    instance_.full_bright = true;
    instance_.alpha = 1;
    view_ = render::make_view_frame(scene_, kGlassWidth, kGlassHeight);
    renderer_.render(scene_, {}, background_);
    scene_.alias_models = {&instance_, 1};
    renderer_.render(scene_, {}, opaque_);
    instance_.alpha = 0.25f;
    renderer_.render(scene_, {}, translucent_);
  }

  const DrawableLevel drawable_ = small_level();
  const render::ColorTables tables_ = render::make_color_tables(drawable_.palette, drawable_.colormap);
  const std::shared_ptr<const render::AliasModel> model_ = small_model(sphere_mdl(), 60);
  render::Renderer renderer_{drawable_.palette, drawable_.colormap};
  render::Scene scene_;
  render::AliasInstance instance_;
  render::ViewFrame view_;
  render::FrameBuffer background_{kGlassWidth, kGlassHeight, GetParam()},
      translucent_{kGlassWidth, kGlassHeight, GetParam()}, opaque_{kGlassWidth, kGlassHeight, GetParam()};
};

TEST_P(TranslucentAlias, BlendsWhatTheOpaquePictureShows) {
  const std::uint8_t* const table = tables_.blends.table_for(0.25f);
  std::size_t blended = 0;
  for (int seed = 0; seed < effort(30, 6); ++seed) {
    set_up(static_cast<std::uint64_t>(seed));
    for (std::size_t i = 0; i < background_.pixel_count(); ++i) {
      const bool shows = opaque_.depth()[i] != background_.depth()[i];
      blended += shows;
      ASSERT_EQ(translucent_.depth()[i], background_.depth()[i]);
      if (GetParam() == render::PixelFormat::kIndexed) {
        const std::uint8_t over = opaque_.indexed()[i], under = background_.indexed()[i];
        ASSERT_EQ(translucent_.indexed()[i], shows ? table[over * 256 + under] : under) << "seed " << seed;
        continue;
      }
      for (int shift = 0; shift < 24; shift += 8) {
        const auto channel = [&](std::uint32_t color) { return static_cast<int>(color >> shift & 255); };
        const int over = channel(opaque_.rgb()[i]), under = channel(background_.rgb()[i]);
        ASSERT_NEAR(channel(translucent_.rgb()[i]), shows ? over * 0.25 + under * 0.75 : under, 0.51)
            << "seed " << seed;
      }
    }
  }
  EXPECT_GT(blended, 1000u);
}

TEST_P(TranslucentAlias, IsLeftOutByTheOpaqueStage) {
  set_up(3);
  render::FrameBuffer frame(kGlassWidth, kGlassHeight, GetParam());
  StageParts parts;
  render::draw_alias_models(render::prepare_alias_models(parts.context(scene_, GetParam(), tables_), view_),
                            true, {0, kGlassHeight}, background_);
  for (std::size_t i = 0; i < frame.pixel_count(); ++i)
    ASSERT_EQ(background_.depth()[i], translucent_.depth()[i]);
}

INSTANTIATE_TEST_SUITE_P(Formats, TranslucentAlias,
                         testing::Values(render::PixelFormat::kIndexed, render::PixelFormat::kRgb),
                         [](const auto& test) {
                           return test.param == render::PixelFormat::kIndexed ? "indexed" : "rgb";
                         });

}  // namespace
}  // namespace temblor::test
