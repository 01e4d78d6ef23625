// _lmscale: light maps of another scale besides those that every engine reads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/bytes.h"
#include "compiler/light/lighting.h"
#include "world/face_at.h"
#include "world/level.h"

namespace temblor::test {
namespace {

const std::string kLamps =
    "{ 'classname' 'light' 'origin' '10 -20 8' 'light' '150' }"
    "{ 'classname' 'light' 'origin' '-30 0 0' 'light' '60' 'style' '3' 'wait' '0.5' }";

LitResult lit_room(const char* scale, const compiler::LightOptions& options = {}) {
  return light(room_with({kLamps, std::string("'_lmscale' '") + scale + "'"}), options);
}

base::ByteReader lump(const formats::Bsp& bsp, const char* name) {
  const formats::BspxLump* found = bsp.find_bspx(name);
  CHECK(found != nullptr, "{}", name);
  return base::ByteReader(found->data);
}

TEST(LightScale, OldEnginesSeeTheUsualLight) {
  const LitResult usual = lit_room("1"), scaled = lit_room("0.25");
  EXPECT_EQ(usual.bsp.find_bspx("LMSHIFT"), nullptr);
  EXPECT_EQ(scaled.bsp.faces, usual.bsp.faces);
  ASSERT_GT(scaled.bsp.lighting.size(), usual.bsp.lighting.size());
  EXPECT_TRUE(std::equal(usual.bsp.lighting.begin(), usual.bsp.lighting.end(), scaled.bsp.lighting.begin()));
}

// The game draws the scaled map: its grid has a luxel for every 4 texels.
TEST(LightScale, TheGameUsesTheScaledMap) {
  const LitResult scaled = lit_room("0.25");
  const auto level = world::make_level(scaled.bsp, "scaled").value();
  EXPECT_TRUE(level->notes.empty());
  ASSERT_EQ(level->light_map_grids.size(), level->faces.size());
  for (std::size_t i = 0; i < level->faces.size(); ++i) {
    EXPECT_GT(level->faces[i].light, static_cast<std::uint32_t>(scaled.bsp.faces[i].light_offset));
    const world::LightMapGrid& grid = level->light_map_grids[level->faces[i].light_map_grid];
    EXPECT_EQ(grid.per_s, math::Vec2d(0.25, 0));
    EXPECT_EQ(grid.per_t, math::Vec2d(0, 0.25));
    EXPECT_EQ(grid.texels, 4);
  }
}

TEST(LightScale, TheOptionOverridesTheKey) {
  const LitResult by_key = lit_room("0.5"), by_option = lit_room("4", {.luxel_texels = 8});
  EXPECT_EQ(by_option.bsp.bspx, by_key.bsp.bspx);
  EXPECT_EQ(by_option.bsp.lighting, by_key.bsp.lighting);
  EXPECT_EQ(lit_room("0.5", {.luxel_texels = 16}).bsp.find_bspx("LMSHIFT"), nullptr);
  EXPECT_EQ(light(room_with(RoomSetup{kLamps, "'_lightmap_scale' '0.5'"})).bsp.bspx, by_key.bsp.bspx);
}

TEST(LightScale, IsRoundedToAPowerOfTwo) {
  for (const auto& [scale, shift] :
       {std::pair{"0.5", 3}, {"0.3", 2}, {"0.25", 2}, {"2", 5}, {"0.001", 0}, {"1000", 7}, {"1.3", 4}}) {
    const LitResult lit = lit_room(scale);
    if (shift == 4) {
      EXPECT_EQ(lit.bsp.find_bspx("LMSHIFT"), nullptr) << scale;
      continue;
    }
    base::ByteReader shifts = lump(lit.bsp, "LMSHIFT");
    ASSERT_EQ(shifts.remaining(), lit.bsp.faces.size());
    EXPECT_EQ(shifts.u8(), shift) << scale;
  }
}

// Every luxel of every scaled map, found as an engine finds it, has the light that the formula gives.
TEST(LightScale, ScaledLuxelsHaveTheRightLight) {
  for (const auto& [scale, texels] : {std::pair{"0.25", 4}, {"0.5", 8}, {"2", 32}}) {
    const LitResult lit = lit_room(scale);
    const auto level = world::make_level(lit.bsp, "scaled").value();
    base::ByteReader offsets = lump(lit.bsp, "LMOFFSET"), styles = lump(lit.bsp, "LMSTYLE");
    int compared = 0;
    for (const world::Face& face : level->faces) {
      const std::int32_t offset = offsets.i32();
      ASSERT_EQ(styles.u8(), 0);
      ASSERT_EQ(styles.u8(), 3);
      ASSERT_EQ(styles.u8(), 255);
      ASSERT_EQ(styles.u8(), 255);
      const world::TextureAxes& axes = level->texture_axes[face.axes];
      const world::FacePlane plane = world::compute_face_plane(*level, face);
      // The room is a cube of 128 units whose texture axes are along the world's axes, so texels are units.
      const double low_s = std::floor((-64.0 + double{axes.s_offset}) / texels) * texels;
      const double low_t = std::floor((-64.0 + double{axes.t_offset}) / texels) * texels;
      const int width =
          static_cast<int>(std::ceil((64.0 + double{axes.s_offset}) / texels) - low_s / texels) + 1;
      const int height =
          static_cast<int>(std::ceil((64.0 + double{axes.t_offset}) / texels) - low_t / texels) + 1;
      for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
          const double s = low_s + column * texels - double{axes.s_offset};
          const double t = low_t + row * texels - double{axes.t_offset};
          if (std::abs(s) > 60 || std::abs(t) > 60) continue;
          const math::Vec3d place = math::Vec3d(axes.s_axis) * s + math::Vec3d(axes.t_axis) * t +
                                    plane.normal * (plane.distance + 1);
          const auto light_from = [&](const math::Vec3d& lamp, double value, double wait) {
            const double distance = glm::length(lamp - place);
            const double cosine = glm::dot(lamp - place, plane.normal) / distance;
            return std::max(0.0, value - wait * distance) * (0.5 + 0.5 * cosine) * 0.5;
          };
          const auto luxel = static_cast<std::size_t>(offset + row * width + column);
          const auto size = static_cast<std::size_t>(width * height);
          EXPECT_NEAR(lit.bsp.lighting.at(luxel), light_from({10, -20, 8}, 150, 1), 1);
          EXPECT_NEAR(lit.bsp.lighting.at(luxel + size), light_from({-30, 0, 0}, 60, 0.5), 1);
          ++compared;
        }
    }
    EXPECT_GT(compared, 50) << scale;
  }
}

TEST(LightScale, DoesNotDependOnHowItIsMade) {
  const LitResult lit = light_in_all_ways("\"_lmscale\" \"0.5\"");
  ASSERT_NE(lit.bsp.find_bspx("LMSHIFT"), nullptr);
  ASSERT_TRUE(lit.summary.colored);
  EXPECT_EQ(lit.summary.lit.samples.size(), lit.bsp.lighting.size() * 3);
}

// Where both maps measure the same place, bounced light is the same.
TEST(LightScale, BouncedLightEqualsThatOfTheUsualMap) {
  formats::Bsp bsp = room_with({"{ 'classname' 'light' 'origin' '50 50 50' 'light' '90' }",
                                "'_lmscale' '0.5' '_bounce' '3' '_bouncescale' '4'"});
  const LitResult lit = light(bsp);
  const auto level = world::make_level(lit.bsp, "scaled").value();
  base::ByteReader offsets = lump(lit.bsp, "LMOFFSET");
  int compared = 0;
  for (std::size_t number = 0; number < level->faces.size(); ++number) {
    const world::Face& face = level->faces[number];
    const std::int32_t offset = offsets.i32();
    const world::TextureAxes& axes = level->texture_axes[face.axes];
    const int low_s = static_cast<int>(std::floor((-64.0 + double{axes.s_offset}) / 8)) * 8;
    const int low_t = static_cast<int>(std::floor((-64.0 + double{axes.t_offset}) / 8)) * 8;
    const int width = static_cast<int>(std::ceil((64.0 + double{axes.s_offset}) / 8)) - low_s / 8 + 1;
    for (int row = 1; row + 1 < face.light_height(); ++row)
      for (int column = 1; column + 1 < face.light_width(); ++column) {
        const int fine_column = (face.texture_mins[0] + column * 16 - low_s) / 8;
        const int fine_row = (face.texture_mins[1] + row * 16 - low_t) / 8;
        const int usual = lit.bsp.faces[number].light_offset + row * face.light_width() + column;
        EXPECT_NEAR(level->light[static_cast<std::size_t>(usual)],
                    level->light[static_cast<std::size_t>(offset + fine_row * width + fine_column)], 1);
        ++compared;
      }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace temblor::test
