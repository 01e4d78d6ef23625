// Light maps of other resolutions against the definitions of their lumps.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formats/levels/decoupled_light.h"
#include "formats/levels/scaled_light.h"
#include "support/effort.h"
#include "support/random.h"
#include "world/animation.h"
#include "world/sample_light.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

using test::effort;
using test::Random;

std::vector<formats::ScaledLightMap> copy_stock_maps(const formats::Bsp& bsp) {
  std::vector<formats::ScaledLightMap> maps;
  for (const formats::BspFace& face : bsp.faces) maps.push_back({4, face.light_offset, face.styles});
  return maps;
}

// The vectors that describe a face's stock light map.
formats::DecoupledLightMap describe_stock_map(const TestLevel& test, std::size_t number) {
  const Face& face = test.level->faces[number];
  const TextureAxes& axes = test.level->texture_axes[face.axes];
  return {static_cast<std::uint16_t>(face.light_width()),
          static_cast<std::uint16_t>(face.light_height()),
          test.bsp.faces[number].light_offset,
          axes.s_axis / 16.0f,
          (axes.s_offset - static_cast<float>(face.texture_mins[0])) / 16,
          axes.t_axis / 16.0f,
          (axes.t_offset - static_cast<float>(face.texture_mins[1])) / 16};
}

void expect_equal_light(const Level& level, const Level& expected) {
  ASSERT_EQ(level.faces.size(), expected.faces.size());
  EXPECT_TRUE(level.notes.empty());
  for (std::size_t i = 0; i < level.faces.size(); ++i) {
    EXPECT_EQ(level.faces[i].light, expected.faces[i].light) << i;
    EXPECT_EQ(level.faces[i].styles, expected.faces[i].styles) << i;
    EXPECT_EQ(level.faces[i].style_count, expected.faces[i].style_count) << i;
    EXPECT_EQ(level.faces[i].light_map_grid, kStockGrid) << i;
  }
}

TEST(LightMaps, ShiftFourIsTheStockMap) {
  const TestLevel stock = small_test_level();
  formats::Bsp bsp = stock.bsp;
  formats::set_scaled_light(copy_stock_maps(bsp), bsp);
  for (formats::BspFace& face : bsp.faces) face.light_offset = -1;
  expect_equal_light(*test_level("shift 4", bsp).level, *stock.level);
}

// Finds positions in the grid of each lit face, and compares them with dot(position, axis) + offset.
TEST(LightMaps, DecoupledGridsFollowTheirVectors) {
  const TestLevel stock = small_test_level();
  for (int seed = 0; seed < effort(50, 10); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    formats::Bsp bsp = stock.bsp;
    std::vector<formats::DecoupledLightMap> maps;
    for (const formats::BspFace& face : bsp.faces) {
      const int offset = face.light_offset < 0 ? -1 : 0;
      const float scale = static_cast<float>(random.log_uniform(0.01, 1));
      maps.push_back({3, 2, offset, random.in_cube(1) * scale, random.in_cube(100).x,
                      random.in_cube(1) * scale, random.in_cube(100).y});
    }
    formats::set_decoupled_light(maps, bsp);
    const auto level = test_level("decoupled", bsp).level;
    ASSERT_TRUE(level->notes.empty()) << level->notes[0];
    int compared = 0;
    for (std::size_t i = 0; i < level->faces.size(); ++i) {
      const Face& face = level->faces[i];
      if (face.light == kNoLight) continue;
      ASSERT_NE(face.light_map_grid, kStockGrid);
      const LightMapGrid& grid = level->light_map_grids[face.light_map_grid];
      EXPECT_EQ(level->light_size(face), (std::array<std::int32_t, 2>{3, 2}));
      EXPECT_TRUE(grid.texels == 1 || grid.texels == 2 || grid.texels == 4 || grid.texels == 8 ||
                  grid.texels == 16);
      const TextureAxes& axes = level->texture_axes[face.axes];
      for (std::uint32_t k = 0; k < face.surfedge_count; ++k) {
        const math::Vec3d corner(level->vertices[level->surfedge_start(face.first_surfedge + k)]);
        const math::Vec2d position = grid.position(
            glm::dot(corner, math::Vec3d(axes.s_axis)) + double{axes.s_offset} - face.texture_mins[0],
            glm::dot(corner, math::Vec3d(axes.t_axis)) + double{axes.t_offset} - face.texture_mins[1]);
        // Corners may be off their plane by a rounding error of the file.
        EXPECT_NEAR(position.x, glm::dot(corner, math::Vec3d(maps[i].x_axis)) + double{maps[i].x_offset},
                    0.02);
        EXPECT_NEAR(position.y, glm::dot(corner, math::Vec3d(maps[i].y_axis)) + double{maps[i].y_offset},
                    0.02);
        ++compared;
      }
    }
    EXPECT_GT(compared, 20);
  }
}

// Models are lit by the same map: with vectors that describe the stock map, the light below any point is the
// same.
TEST(LightMaps, SampleLightFollowsDecoupledGrids) {
  const TestLevel stock = small_test_level();
  formats::Bsp bsp = stock.bsp;
  std::vector<formats::DecoupledLightMap> maps;
  for (std::size_t i = 0; i < bsp.faces.size(); ++i) maps.push_back(describe_stock_map(stock, i));
  formats::set_decoupled_light(maps, bsp);
  for (formats::BspFace& face : bsp.faces) face.light_offset = -1;
  const auto level = test_level("decoupled", bsp).level;
  ASSERT_TRUE(level->notes.empty()) << level->notes[0];
  LightStyleValues styles{};
  styles.fill(256);
  Random random(5);
  int lit = 0;
  for (int i = 0; i < 500; ++i) {
    const math::Vec3& low = stock.level->world().bounds.mins;
    const math::Vec3 size = stock.level->world().bounds.maxs - low;
    const math::Vec3 point = low + size * (math::Vec3(0.5f) + random.in_cube(0.5));
    const PointLight expected = sample_light(*stock.level, styles, point),
                     found = sample_light(*level, styles, point);
    EXPECT_NEAR(found.gray, expected.gray, 0.01);
    if (expected.gray > 0) ++lit;
  }
  EXPECT_GT(lit, 50);
}

// Returns the notes of a level whose lumps were damaged; its light must be the stock light.
std::vector<std::string> find_notes(const TestLevel& stock, const formats::Bsp& bsp) {
  const auto level = test_level("damaged", bsp).level;
  std::vector<std::string> notes = level->notes;
  Level without_notes = *level;
  without_notes.notes.clear();
  expect_equal_light(without_notes, *stock.level);
  return notes;
}

TEST(LightMaps, DamagedLumpsAreIgnoredWithANote) {
  const TestLevel stock = small_test_level();
  std::size_t lit = 0;
  while (stock.level->faces[lit].light == kNoLight) ++lit;
  const std::string face = "face " + std::to_string(lit);
  const auto samples = static_cast<std::int32_t>(stock.bsp.lighting.size());

  std::vector<formats::ScaledLightMap> scaled = copy_stock_maps(stock.bsp);
  const auto with_scaled = [&](const formats::ScaledLightMap& map) {
    formats::Bsp bsp = stock.bsp;
    std::vector<formats::ScaledLightMap> maps = scaled;
    maps[lit] = map;
    formats::set_scaled_light(maps, bsp);
    return find_notes(stock, bsp);
  };
  for (const auto& notes :
       {with_scaled({4, samples, {0, 255, 255, 255}}), with_scaled({0, 0, {0, 1, 2, 3}})}) {
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_TRUE(notes[0].starts_with("lump LMSHIFT: " + face + ": ")) << notes[0];
    EXPECT_TRUE(notes[0].ends_with("; it is ignored")) << notes[0];
  }

  const auto with_decoupled = [&](const formats::DecoupledLightMap& map) {
    formats::Bsp bsp = stock.bsp;
    std::vector<formats::DecoupledLightMap> maps(bsp.faces.size());
    maps[lit] = map;
    formats::set_decoupled_light(maps, bsp);
    return find_notes(stock, bsp);
  };
  for (const auto& notes :
       {with_decoupled({65535, 65535, 0, {1, 0, 0}, 0, {0, 1, 0}, 0}),
        with_decoupled({1, 1, samples, {1, 0, 0}, 0, {0, 1, 0}, 0}),
        with_decoupled({1, 1, 0, {std::numeric_limits<float>::infinity(), 0, 0}, 0, {0, 1, 0}, 0})}) {
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_TRUE(notes[0].starts_with("lump DECOUPLED_LM: " + face)) << notes[0];
  }
}

TEST(LightMaps, DecoupledMapsPrecedeScaledOnes) {
  const TestLevel stock = small_test_level();
  formats::Bsp bsp = stock.bsp;
  std::vector<formats::ScaledLightMap> scaled(bsp.faces.size(), {5, 0, {0, 255, 255, 255}});
  formats::set_scaled_light(scaled, bsp);
  std::vector<formats::DecoupledLightMap> maps(bsp.faces.size(), {2, 2, 1, {1, 0, 0}, 0, {0, 1, 0}, 0});
  formats::set_decoupled_light(maps, bsp);
  const auto level = test_level("both", bsp).level;
  for (const Face& face : level->faces)
    if (face.kind == FaceKind::kLit) {
      EXPECT_EQ(face.light, 1u);
    }
}

}  // namespace
}  // namespace temblor::world
