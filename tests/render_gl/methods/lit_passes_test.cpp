// Methods that draw lit faces in several passes (lit_passes.h), next to the CPU's picture.
#include <gtest/gtest.h>

#include <algorithm>

#include "render_gl/methods/method_views.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::render_gl {
namespace {

// Within 2 of 255, measured 0.9996 or more: as many as with one pass. Within 1, 0.982 to 0.9999, as between
// passes the picture is rounded.
void check_light_pass(const test::DrawableLevel& drawable, int views, const ViewContents& contents) {
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const EqualShares shares = compare_views(pair, drawable, WorldMethod::kLightPass, views, contents);
  EXPECT_GE(shares.mean, test::kQuick ? 0.99 : 0.998);
  EXPECT_GE(shares.worst, 0.99);
  const EqualShares strict = compare_views(pair, drawable, WorldMethod::kLightPass, views, contents, 1);
  EXPECT_GE(strict.mean, test::kQuick ? 0.8 : 0.97);
}

TEST(GlLightPass, ShowsTheCpusPicture) {
  const ViewContents contents{
      .with_marks = true, .with_opacity = true, .with_turns = true, .with_styles = true};
  check_light_pass(test::small_level(), test::effort(20, 3), contents);
  check_light_pass(test::small_level({.colored_light = true}, "colored"), test::effort(10, 3), contents);
}

TEST(GlLightPass, ShowsFog) {
  check_light_pass(test::small_level(), test::effort(16, 8), {.with_fog = true});
}

TEST(GlLightPass, ShowsTheCpusPictureOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"start", "lq_e1m2"})
    check_light_pass(test::stock_level(data, name), test::effort(20, 2), {});
}

// Depth is equal in all passes, however coarse it is.
TEST(GlLightPass, ShowsTheCpusPictureWithoutClipControl) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable, ClipControl::kNo);
  EXPECT_GE(compare_views(pair, drawable, WorldMethod::kLightPass, test::effort(10, 2), {}).worst, 0.99);
}

// In the dark, only full-bright texels are left.
TEST(GlLightPass, KeepsFullBrightTexels) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  pair.gl().set_method(WorldMethod::kLightPass);
  std::ptrdiff_t bright = 0;
  for (int number = 0; number < test::effort(10, 3); ++number) {
    NumberedView view(*drawable.level, number, {.lights = 0});
    view.scene.light_styles.fill(0);
    EXPECT_GE(pair.compare(view.scene, {}), 0.998) << "view " << number;
    bright += std::ranges::count_if(pair.gl_frame().rgb(),
                                    [](std::uint32_t pixel) { return (pixel & 0xe0e0e0u) != 0; });
  }
  EXPECT_GT(bright, 1000);
}

// A frame of several portions, whose blocks are coarse, shows what it shows in one pass.
TEST(GlLightPass, DrawsPortions) {
  const test::DrawableLevel drawable = test::small_level({.wide_faces = true}, "wide");
  constexpr std::size_t kBytes = 40000;
  RENDERER_PAIR_OR_SKIP(pair, drawable, ClipControl::kIfSupported, CacheOptions{.bytes = kBytes});
  const auto compare = [&](WorldMethod method) {
    const double share =
        compare_views(pair, drawable, method, test::effort(10, 2), {.with_marks = true}).mean;
    EXPECT_GT(pair.gl().cache_counts().portions, 1u);
    return share;
  };
  EXPECT_NEAR(compare(WorldMethod::kLightPass), compare(WorldMethod::kLitTextures), 0.001);
}

}  // namespace
}  // namespace temblor::render_gl
