// Pictures of a level whose light maps lie turned on their faces, at many scales, against the oracle.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "formats/levels/decoupled_light.h"
#include "math/vec.h"
#include "oracle/judge_pictures.h"
#include "support/effort.h"
#include "support/random.h"
#include "world/face_at.h"

namespace temblor::oracle {
namespace {

// Waves of light through the level, about 150 units long, from 0 to 255.
std::uint8_t find_wave(const math::Vec3d& place, double phase) {
  const double wave =
      std::sin(place.x / 24 + phase) + std::sin(place.y / 29) + std::sin(place.z / 21 - phase);
  return static_cast<std::uint8_t>(std::lround(127.5 + 42 * wave));
}

// Lays a grid on a face, turned by any angle, and appends its light, with two styles.
formats::DecoupledLightMap add_map(const world::Level& level, const world::Face& face, test::Random& random,
                                   std::vector<std::uint8_t>& io_light) {
  const math::Vec3d normal = world::compute_face_plane(level, face).normal;
  const math::Vec3d start(level.vertices[level.surfedge_start(face.first_surfedge)]);
  const math::Vec3d side =
      glm::normalize(math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + 1)]) - start);
  const double angle = random.uniform(0, 7), units = random.log_uniform(3, 12);
  const math::Vec3d x = side * std::cos(angle) + glm::cross(normal, side) * std::sin(angle);
  formats::DecoupledLightMap map;
  map.offset = static_cast<std::int32_t>(io_light.size());
  map.x_axis = math::Vec3(x / units);
  map.y_axis = math::Vec3(glm::cross(normal, x) / units);
  math::Vec2d low(1e9), high(-1e9);
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3d corner(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    const math::Vec2d at(glm::dot(corner, math::Vec3d(map.x_axis)),
                         glm::dot(corner, math::Vec3d(map.y_axis)));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  // Textures are drawn in whole texels, so pixels at a face's edge may be up to a texel outside of it.
  low -= 1.0 / units;
  high += 1.0 / units;
  map.x_offset = static_cast<float>(-low.x);
  map.y_offset = static_cast<float>(-low.y);
  map.width = static_cast<std::uint16_t>(std::ceil(high.x - low.x) + 1);
  map.height = static_cast<std::uint16_t>(std::ceil(high.y - low.y) + 1);
  for (const double phase : {0.0, 2.0})
    for (int row = 0; row < map.height; ++row)
      for (int column = 0; column < map.width; ++column)
        io_light.push_back(find_wave(
            start + x * ((column + low.x) * units - glm::dot(start, x)) +
                glm::cross(normal, x) * ((row + low.y) * units - glm::dot(start, glm::cross(normal, x))),
            phase));
  return map;
}

test::DrawableLevel make_decoupled_level() {
  test::DrawableLevel drawable = test::small_level();
  formats::Bsp bsp = artgen::make_small_level();
  test::Random random(3);
  std::vector<formats::DecoupledLightMap> maps;
  for (std::size_t i = 0; i < bsp.faces.size(); ++i) {
    const world::Face& face = drawable.level->faces[i];
    bsp.faces[i].styles = {0, 1, world::kNoStyle, world::kNoStyle};
    maps.push_back(face.kind == world::FaceKind::kLit ? add_map(*drawable.level, face, random, bsp.lighting)
                                                      : formats::DecoupledLightMap{});
  }
  formats::set_decoupled_light(maps, bsp);
  drawable.name = "decoupled";
  drawable.level = world::make_level(std::move(bsp), drawable.name).value();
  CHECK(drawable.level->notes.empty(), "{}", drawable.level->notes[0]);
  return drawable;
}

class DecoupledLightPicture : public testing::TestWithParam<render::PixelFormat> {};

TEST_P(DecoupledLightPicture, IsWhatRaysSee) {
  const test::DrawableLevel drawable = make_decoupled_level();
  EXPECT_GT(drawable.level->light_map_grids.size(), 50u);
  // Single views may look at one bright face, whose steps of color are the finest.
  expect_right(judge_pictures(drawable, {.format = GetParam(), .views = test::effort(100, 20)}));
}

INSTANTIATE_TEST_SUITE_P(Formats, DecoupledLightPicture,
                         testing::Values(render::PixelFormat::kIndexed, render::PixelFormat::kRgb));

}  // namespace
}  // namespace temblor::oracle
