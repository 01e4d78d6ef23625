// Colored dynamic light in indexed frames: the tables against their definition, and blocks against blocks in
// white light.
#include "render/color/tint_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "render/color/color_tables.h"
#include "render/edges/edge_table.h"
#include "render/surfaces/build_surface.h"
#include "support/levels/drawable_level.h"

namespace temblor::test {
namespace {

using Color = std::array<float, 3>;
constexpr std::size_t kLastRow = render::kTintRows - 1;

// The nearest entry that is not full-bright, by trying all.
std::uint8_t find_nearest(const render::ColorTables& tables, const std::array<double, 3>& color) {
  double least = std::numeric_limits<double>::max();
  std::uint8_t nearest = 0;
  for (int index = 0; index < std::min(tables.first_fullbright, 255); ++index) {
    const formats::Rgb& entry = tables.palette[static_cast<std::size_t>(index)];
    const double r = entry.r - color[0], g = entry.g - color[1], b = entry.b - color[2];
    const double distance = r * r + g * g + b * b;
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<std::uint8_t>(index);
  }
  return nearest;
}

double find_distance(const formats::Rgb& a, const std::array<double, 3>& b) {
  return std::hypot(a.r - b[0], a.g - b[1], a.b - b[2]);
}

// The table rounds channels before it searches, which moves the color by at most half the diagonal of a cube.
// So it may find an entry that is farther by the whole diagonal.
TEST(TintTables, MultiplyByTheColorOfTheLight) {
  const DrawableLevel drawable = small_level();
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  const Color orange{1, 0.75f, 0.25f};
  const std::uint8_t* const rows = tables.tints.rows_for(orange);
  for (std::size_t row = 0; row <= kLastRow; ++row)
    for (std::size_t index = 0; index < 256; ++index) {
      const std::uint8_t found = rows[row * 256 + index];
      if (row == 0 || index == 255 || tables.match.is_fullbright(index)) {
        ASSERT_EQ(found, index);
        continue;
      }
      ASSERT_FALSE(tables.match.is_fullbright(found));
      const formats::Rgb& entry = tables.palette[index];
      const double share = static_cast<double>(row) / kLastRow;
      const std::array<double, 3> tinted = {entry.r * 1.0, entry.g * (1 - share * 0.25),
                                            entry.b * (1 - share * 0.75)};
      const std::uint8_t nearest = find_nearest(tables, tinted);
      ASSERT_LE(find_distance(tables.palette[found], tinted),
                find_distance(tables.palette[nearest], tinted) + std::numbers::sqrt3)
          << row << ", " << index;
    }
}

TEST(TintTables, DependOnTheRatioOfTheChannelsOnly) {
  const DrawableLevel drawable = small_level();
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  EXPECT_EQ(tables.tints.rows_for({1, 0.5f, 0.25f}), tables.tints.rows_for({4, 2, 1}));
  EXPECT_NE(tables.tints.rows_for({1, 0.5f, 0.25f}), tables.tints.rows_for({0.25f, 0.5f, 1}));
  EXPECT_EQ(tables.tints.rows_for({0, 0, 0}), tables.tints.rows_for({1, 1, 1}));
  const std::uint8_t* const white = tables.tints.rows_for({1, 1, 1});
  for (std::size_t index = 0; index < 256; ++index) {
    const formats::Rgb& shown = tables.palette[white[kLastRow * 256 + index]];
    EXPECT_TRUE(shown == tables.palette[index]) << index;
  }
}

// One block of the small level, in the light of `lights` and of its light map times `style_value` / 256.
std::vector<std::uint8_t> build(const DrawableLevel& drawable, const render::ColorTables& tables,
                                world::FaceIndex index, std::uint16_t style_value,
                                const std::vector<render::FaceLight>& lights, bool simd_kernels) {
  const world::Face& face = drawable.level->face(index);
  render::BlockRequest request{};
  request.face = index;
  request.contents.texture = face.texture;
  request.contents.style_values.fill(style_value);
  request.contents.lights = render::hash_lights(lights);
  request.lights = lights;
  const render::SurfaceShape shape = render::surface_shape(face, 0, 0, 0);
  std::vector<std::byte> bytes(shape.texels() + render::kBlockPadding);
  request.block = {bytes.data(), shape};
  base::Arena scratch;
  render::build_surface(*drawable.level, tables, nullptr, request, render::PixelFormat::kIndexed,
                        simd_kernels, scratch);
  const auto* texels = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return {texels, texels + shape.texels()};
}

// A light above the middle of the face's first tile, which fades toward its corners.
render::FaceLight make_light(const world::Face& face, const Color& color) {
  const auto middle = [](std::int32_t extent) { return static_cast<float>(std::min(extent, 256)) / 2; };
  const float reach = std::min(middle(face.texture_extents[0]), middle(face.texture_extents[1]));
  return {.s = middle(face.texture_extents[0]),
          .t = middle(face.texture_extents[1]),
          .units_per_s = 1,
          .units_per_t = 1,
          .at_nearest = reach,
          .reach = reach,
          .color = color};
}

class TintedBlocks : public testing::Test {
 protected:
  // Calls `visit(face index)` for lit faces of at least 4 x 4 samples.
  template <typename Visit>
  void visit_faces(Visit visit) {
    std::size_t visited = 0;
    for (std::size_t number = 0; number < drawable_.level->faces.size() && visited < 40; ++number) {
      const auto index = base::to_index<world::FaceIndex>(number);
      const world::Face& face = drawable_.level->face(index);
      if (face.kind != world::FaceKind::kLit || face.light == world::kNoLight) continue;
      if (std::min(face.texture_extents[0], face.texture_extents[1]) < 64) continue;
      ++visited;
      visit(index);
    }
    EXPECT_GT(visited, 10u);
  }

  DrawableLevel drawable_ = small_level();
  render::ColorTables tables_ = render::make_color_tables(drawable_.palette, drawable_.colormap);
};

// In the dark, only the colored light is left: each texel is that of white light, seen through the last row.
TEST_F(TintedBlocks, TakeTheColorOfTheOnlyLight) {
  const Color blue{0.5f, 0.75f, 1};
  const std::uint8_t* const rows = tables_.tints.rows_for(blue);
  visit_faces([&](world::FaceIndex index) {
    const world::Face& face = drawable_.level->face(index);
    const auto white = build(drawable_, tables_, index, 0, {make_light(face, {1, 1, 1})}, true);
    const auto tinted = build(drawable_, tables_, index, 0, {make_light(face, blue)}, true);
    const int width = render::surface_shape(face, 0, 0, 0).width;
    const render::FaceLight light = make_light(face, blue);
    for (std::size_t i = 0; i < white.size(); ++i) {
      const auto x = static_cast<float>(static_cast<int>(i) % width);
      const auto y = static_cast<float>(static_cast<int>(i) / width);
      // Samples without any light are white, and their neighbors' texels are in between.
      if (render::distance_on_face(light, x, y) > light.reach - 40) continue;
      ASSERT_EQ(tinted[i], rows[kLastRow * 256 + white[i]]) << i;
    }
  });
}

TEST_F(TintedBlocks, AreTheSameWithBothKernelsAndPlainWhereNoLightReaches) {
  const Color orange{1, 0.7f, 0.3f};
  std::size_t tinted_texels = 0;
  visit_faces([&](world::FaceIndex index) {
    const world::Face& face = drawable_.level->face(index);
    const render::FaceLight light = make_light(face, orange);
    const auto without = build(drawable_, tables_, index, 256, {}, true);
    const auto tinted = build(drawable_, tables_, index, 256, {light}, true);
    ASSERT_EQ(tinted, build(drawable_, tables_, index, 256, {light}, false));
    const int width = render::surface_shape(face, 0, 0, 0).width;
    for (std::size_t i = 0; i < without.size(); ++i) {
      const auto x = static_cast<float>(static_cast<int>(i) % width);
      const auto y = static_cast<float>(static_cast<int>(i) / width);
      tinted_texels += tinted[i] != without[i];
      // Two samples beyond the light's reach.
      if (render::distance_on_face(light, x, y) > light.reach + 48) {
        ASSERT_EQ(tinted[i], without[i]) << i;
      }
    }
  });
  EXPECT_GT(tinted_texels, 10000u);
}

}  // namespace
}  // namespace temblor::test
