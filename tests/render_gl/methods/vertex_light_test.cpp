// Light at vertices (WorldMethod::kGouraud): against light maps that the test reads itself, and next to the
// CPU's pictures of levels whose light is the same everywhere.
#include "render_gl/vertex_light/vertex_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_gl/methods/method_views.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::render_gl {
namespace {

// A copy whose light maps have one value.
test::DrawableLevel with_even_light(const test::DrawableLevel& drawable, std::uint8_t value) {
  auto level = std::make_shared<world::Level>(*drawable.level);
  level->identity = std::make_shared<const world::LevelIdentity>();
  std::ranges::fill(level->light, value);
  std::ranges::fill(level->light_rgb, value);
  test::DrawableLevel even = drawable;
  even.name += "_even";
  even.level = level;
  return even;
}

// A request for the light of a whole face, with these style values.
render::BlockRequest request_light(world::FaceIndex face, const std::array<std::uint16_t, 4>& style_values) {
  render::BlockRequest request{.face = face,
                               .tile_s = 0,
                               .tile_t = 0,
                               .mip = 0,
                               .contents = {},
                               .lights = {},
                               .marks = {},
                               .block = {}};
  request.contents.style_values = style_values;
  return request;
}

// The stored samples of a face with a stock light map, whose sum is in 65280ths.
double find_stored_light(const world::Level& level, const world::Face& face, std::int32_t column,
                         std::int32_t row, const std::array<std::uint16_t, 4>& style_values) {
  const std::int32_t width = face.texture_extents[0] / 16 + 1, height = face.texture_extents[1] / 16 + 1;
  double sum = 0;
  for (std::int32_t style = 0; style < face.style_count; ++style) {
    const std::size_t sample = face.light + static_cast<std::size_t>((style * height + row) * width + column);
    sum += level.light[sample] * style_values[static_cast<std::size_t>(style)];
  }
  return std::min(sum, 65280.0);
}

bool has_stock_light(const world::Face& face) {
  return face.kind == world::FaceKind::kLit && face.style_count > 0 &&
         face.light_map_grid == world::kStockGrid;
}

TEST(GlVertexLight, IsThatOfTheLightMap) {
  const test::DrawableLevel drawable = test::small_level({.four_styles = true}, "four_styles");
  const world::Level& level = *drawable.level;
  base::Arena scratch;
  test::Random random(1);
  std::size_t checked = 0;
  for (std::uint32_t number = 0; number < level.faces.size(); ++number) {
    const world::Face& face = level.faces[number];
    if (!has_stock_light(face)) continue;
    const std::array<std::uint16_t, 4> styles = {256, 100, static_cast<std::uint16_t>(random.below(500)), 30};
    const double s = random.uniform(0, face.texture_extents[0]),
                 t = random.uniform(0, face.texture_extents[1]);
    const auto column = static_cast<std::int32_t>(s / 16), row = static_cast<std::int32_t>(t / 16);
    const double share_s = s / 16 - column, share_t = t / 16 - row;
    const auto sample = [&](int x, int y) {
      return find_stored_light(level, face, column + x, row + y, styles);
    };
    const double wanted =
        std::lerp(std::lerp(sample(0, 0), share_s > 0 ? sample(1, 0) : 0, share_s),
                  std::lerp(sample(0, 1), share_s > 0 ? sample(1, 1) : 0, share_s), share_t);
    const auto light = find_light_at(level, request_light(world::FaceIndex{number}, styles), s, t, scratch);
    for (const std::int16_t channel : light) EXPECT_NEAR(channel, wanted / 2, 1) << "face " << number;
    ++checked;
  }
  EXPECT_GT(checked, 50u);
}

// At a multiple of 16 texels, and beyond the last sample: there is nothing to interpolate.
TEST(GlVertexLight, AddsDynamicLights) {
  const test::DrawableLevel drawable = test::small_level();
  const world::Level& level = *drawable.level;
  base::Arena scratch;
  const auto found = std::ranges::find_if(level.faces, has_stock_light);
  ASSERT_NE(found, level.faces.end());
  render::BlockRequest request =
      request_light(world::FaceIndex{static_cast<std::uint32_t>(found - level.faces.begin())}, {0, 0, 0, 0});
  const std::array<render::FaceLight, 1> lights = {render::FaceLight{.s = 10,
                                                                     .t = 6,
                                                                     .units_per_s = 1,
                                                                     .units_per_t = 0.5f,
                                                                     .at_nearest = 90,
                                                                     .reach = 80,
                                                                     .color = {1, 0.5f, 0}}};
  request.lights = lights;
  // 10 units along s, and 3 along t: 90 - (10 + 1.5) is left.
  const auto light = find_light_at(level, request, -20, -1, scratch);
  EXPECT_NEAR(light[2], 78.5 * 256 / 2, 1);
  EXPECT_NEAR(light[1], 78.5 * 256 / 4, 1);
  EXPECT_EQ(light[0], 0);
}

TEST(GlGouraud, ShowsEvenLightAsTheCpuDoes) {
  for (const int value : {40, 128, 250}) {
    const test::DrawableLevel even = with_even_light(test::small_level(), static_cast<std::uint8_t>(value));
    RENDERER_PAIR_OR_SKIP(pair, even);
    const EqualShares shares =
        compare_views(pair, even, WorldMethod::kGouraud, test::effort(10, 2),
                      {.lights = 0, .with_marks = true, .with_fog = true, .with_opacity = true});
    EXPECT_GE(shares.mean, 0.998);
    EXPECT_GE(shares.worst, 0.99);
  }
}

// The difference is the method's own, so only its size is checked. Measured: 0.26 to 0.51 within 2 of 255,
// and 0.94 to 0.99 within 40.
void check_gouraud(const test::DrawableLevel& drawable) {
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const int views = test::effort(20, 3);
  EXPECT_LT(compare_views(pair, drawable, WorldMethod::kGouraud, views, {}).mean, 0.8);
  EXPECT_GT(compare_views(pair, drawable, WorldMethod::kGouraud, views, {}, 40).mean,
            test::kQuick ? 0.7 : 0.85);
}

TEST(GlGouraud, LosesLightBetweenVertices) {
  check_gouraud(test::small_level());
}

TEST(GlGouraud, LosesLightBetweenVerticesOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"start", "lq_e1m2"}) check_gouraud(test::stock_level(data, name));
}

// Corners are lit again only when their light changes.
TEST(GlGouraud, UploadsWhatChanges) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  pair.gl().set_method(WorldMethod::kGouraud);
  NumberedView view(*drawable.level, 1, {.lights = 0});
  const auto count_bytes = [&] {
    pair.compare(view.scene, {});
    return pair.gl().cache_counts().bytes_uploaded;
  };
  EXPECT_GT(count_bytes(), 0u);
  EXPECT_EQ(count_bytes(), 0u);
  view.scene.light_styles.fill(100);
  EXPECT_GT(count_bytes(), 0u);
  EXPECT_EQ(count_bytes(), 0u);
}

}  // namespace
}  // namespace temblor::render_gl
