// _world_units_per_luxel: light maps that lie on the plane of their face, not on its texture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "artgen/small_level.h"
#include "compiler/light/lighting.h"
#include "formats/levels/decoupled_light.h"
#include "formats/levels/scaled_light.h"
#include "support/random.h"
#include "world/animation.h"
#include "world/face_at.h"
#include "world/level.h"
#include "world/sample_light.h"

namespace temblor::test {
namespace {

const std::string kRoomLamp = "{ 'classname' 'light' 'origin' '10 -20 8' 'light' '150' }";
const std::string kSwitchedLamp =
    "{ 'classname' 'light' 'origin' '-30 0 0' 'light' '60' 'style' '3' 'wait' '0.5' }";

LitResult light_decoupled_room(const char* units, const compiler::LightOptions& options = {}) {
  return light(room_with(RoomSetup{kRoomLamp + kSwitchedLamp,
                                   std::string("'_world_units_per_luxel' '") + units + "'"}),
               options);
}

// The light of the first lamp by the documented formula: linear falloff, _anglescale 0.5, _range 0.5.
double find_true_light(const math::Vec3d& place, const math::Vec3d& normal) {
  const math::Vec3d way = math::Vec3d(10, -20, 8) - place;
  const double distance = glm::length(way), cosine = glm::dot(way, normal) / distance;
  return cosine > 0 ? std::max(0.0, 150 - distance) * (0.5 + 0.5 * cosine) * 0.5 : 0;
}

TEST(DecoupledLuxels, OldEnginesSeeTheUsualLight) {
  const LitResult usual = light_decoupled_room("0"), decoupled = light_decoupled_room("3");
  EXPECT_EQ(usual.bsp.find_bspx("DECOUPLED_LM"), nullptr);
  ASSERT_NE(decoupled.bsp.find_bspx("DECOUPLED_LM"), nullptr);
  EXPECT_EQ(decoupled.bsp.find_bspx("LMSHIFT"), nullptr);
  EXPECT_EQ(decoupled.bsp.faces, usual.bsp.faces);
  ASSERT_GT(decoupled.bsp.lighting.size(), usual.bsp.lighting.size());
  EXPECT_TRUE(
      std::equal(usual.bsp.lighting.begin(), usual.bsp.lighting.end(), decoupled.bsp.lighting.begin()));
  EXPECT_TRUE(world::make_level(decoupled.bsp, "decoupled").value()->notes.empty());
}

// Each luxel's place follows from the vectors of the lump by solving three equations.
TEST(DecoupledLuxels, HaveTheRightLight) {
  for (const char* units : {"3", "5.5", "24"}) {
    const LitResult lit = light_decoupled_room(units);
    const auto level = world::make_level(lit.bsp, "decoupled").value();
    const auto maps = formats::read_decoupled_light(lit.bsp).value();
    int compared = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
      const formats::DecoupledLightMap& map = maps[i];
      const world::FacePlane plane = world::compute_face_plane(*level, level->faces[i]);
      const glm::dmat3 places = glm::inverse(
          glm::transpose(glm::dmat3(math::Vec3d(map.x_axis), math::Vec3d(map.y_axis), plane.normal)));
      for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
          const math::Vec3d place =
              places * math::Vec3d(x - double{map.x_offset}, y - double{map.y_offset}, plane.distance);
          const math::Vec3d inside = glm::abs(place - plane.normal * glm::dot(place, plane.normal));
          if (std::max({inside.x, inside.y, inside.z}) > 60) continue;
          EXPECT_NEAR(lit.bsp.lighting.at(static_cast<std::size_t>(map.offset + y * map.width + x)),
                      find_true_light(place + plane.normal, plane.normal), 1)
              << units << ": " << place.x << " " << place.y << " " << place.z;
          ++compared;
        }
    }
    EXPECT_GT(compared, 100) << units;
  }
}

// The room has a texel for each unit, so luxels 4 units apart can be those that are 4 texels apart.
TEST(DecoupledLuxels, EqualScaledOnesOnTheSameLattice) {
  const LitResult decoupled = light_decoupled_room("4");
  const LitResult scaled = light(room_with(RoomSetup{kRoomLamp + kSwitchedLamp, "'_lmscale' '0.25'"}));
  const auto level = world::make_level(decoupled.bsp, "decoupled").value(),
             expected = world::make_level(scaled.bsp, "scaled").value();
  world::LightStyleValues styles{};
  styles.fill(256);
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const math::Vec3 point = random.in_cube(63);
    const float light = world::sample_light(*level, styles, point).gray;
    EXPECT_NEAR(light, world::sample_light(*expected, styles, point).gray, 0.01);
    EXPECT_GT(light, 0);
  }
}

TEST(DecoupledLuxels, FinerOnesAreNearerToTheTruth) {
  const auto find_mean_error = [](const char* units) {
    const LitResult lit =
        light(room_with(RoomSetup{kRoomLamp, std::string("'_world_units_per_luxel' '") + units + "'"}));
    const auto level = world::make_level(lit.bsp, "lit").value();
    world::LightStyleValues styles{};
    styles.fill(256);
    Random random(2);
    double error = 0;
    for (int i = 0; i < 1000; ++i) {
      const math::Vec3 point = random.in_cube(60);
      const math::Vec3d floor(point.x, point.y, -kHalfRoom + 1);
      error += std::abs(double{world::sample_light(*level, styles, point).gray} -
                        find_true_light(floor, math::Vec3d(0, 0, 1)));
    }
    return error / 1000;
  };
  const double usual = find_mean_error("0"), fine = find_mean_error("4");
  EXPECT_LT(fine, 0.5);
  EXPECT_LT(fine, usual);
}

// The light at a place on a face, interpolated between its luxels.
double find_light_on_face(const world::Level& level, const formats::DecoupledLightMap& map,
                          const math::Vec3d& place) {
  const auto along = [&](const math::Vec3& axis, float offset, int count) {
    return std::clamp(glm::dot(place, math::Vec3d(axis)) + double{offset}, 0.0, count - 1.0);
  };
  const double x = along(map.x_axis, map.x_offset, map.width),
               y = along(map.y_axis, map.y_offset, map.height);
  const auto luxel = [&](double column, double row) {
    const int u = std::min(static_cast<int>(column), map.width - 1),
              v = std::min(static_cast<int>(row), map.height - 1);
    return static_cast<double>(level.light.at(static_cast<std::size_t>(map.offset + v * map.width + u)));
  };
  const double left = std::floor(x), top = std::floor(y);
  return std::lerp(std::lerp(luxel(left, top), luxel(left + 1, top), x - left),
                   std::lerp(luxel(left, top + 1), luxel(left + 1, top + 1), x - left), y - top);
}

// Adjacent faces in one plane agree along their common side. (With the same number of rays for all luxels:
// otherwise a shadow that ends at the side may get more rays on one face than on the other.)
TEST(DecoupledLuxels, HaveNoSeamBetweenFacesInOnePlane) {
  formats::Bsp bsp = artgen::make_small_level({.light = false});
  bsp.entities.insert(bsp.entities.find('}'), "\"_world_units_per_luxel\" \"6\"");
  bsp.entities += "{ \"classname\" \"light\" \"origin\" \"0 0 64\" \"light\" \"600\" }";
  const LitResult lit = light(bsp, {.extra = 2});
  const auto level = world::make_level(lit.bsp, "decoupled").value();
  const auto maps = formats::read_decoupled_light(lit.bsp).value();
  int compared = 0;
  for (std::size_t a = 0; a < maps.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const world::Face &first = level->faces[a], &second = level->faces[b];
      if (first.light == world::kNoLight || second.light == world::kNoLight || first.plane != second.plane ||
          first.back_side != second.back_side)
        continue;
      for (std::uint32_t i = 0; i < first.surfedge_count; ++i)
        for (std::uint32_t k = 0; k < second.surfedge_count; ++k) {
          if (level->surfedges[first.first_surfedge + i] != -level->surfedges[second.first_surfedge + k])
            continue;
          const std::uint32_t next = (i + 1) % first.surfedge_count;
          const math::Vec3d start(level->vertices[level->surfedge_start(first.first_surfedge + i)]);
          const math::Vec3d end(level->vertices[level->surfedge_start(first.first_surfedge + next)]);
          // Luxels within walls take their light from the nearest place that the face can reach.
          if (glm::length(end - start) < 48) continue;
          for (const double share : {0.3, 0.5, 0.7}) {
            const math::Vec3d place = glm::mix(start, end, share);
            EXPECT_NEAR(find_light_on_face(*level, maps[a], place),
                        find_light_on_face(*level, maps[b], place), 2)
                << "faces " << a << " and " << b << " at " << place.x << " " << place.y << " " << place.z;
            ++compared;
          }
        }
    }
  EXPECT_GT(compared, 20);
}

TEST(DecoupledLuxels, DoNotDependOnHowTheyAreMade) {
  const LitResult lit = light_in_all_ways("\"_world_units_per_luxel\" \"10\"");
  ASSERT_NE(lit.bsp.find_bspx("DECOUPLED_LM"), nullptr);
  EXPECT_EQ(lit.summary.lit.samples.size(), lit.bsp.lighting.size() * 3);
}

TEST(DecoupledLuxels, TheOptionOverridesTheKey) {
  EXPECT_EQ(light_decoupled_room("9", {.units_per_luxel = 5.0f}).bsp.bspx,
            light_decoupled_room("5").bsp.bspx);
  EXPECT_EQ(light_decoupled_room("9", {.units_per_luxel = 0.0f}).bsp.find_bspx("DECOUPLED_LM"), nullptr);
}

// A style that only a fine map shows needs LMSTYLE.
TEST(DecoupledLuxels, HaveTheirOwnStyles) {
  const std::string spot = "{ 'classname' 'light' 'origin' '8 8 -62' 'light' '8' 'style' '5' }";
  const LitResult lit = light(room_with(RoomSetup{kRoomLamp + spot, "'_world_units_per_luxel' '2'"}));
  const auto styles = formats::read_face_styles(lit.bsp).value();
  const auto level = world::make_level(lit.bsp, "decoupled").value();
  int own = 0;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    EXPECT_EQ(level->faces[i].styles, styles[i]);
    if (styles[i] != lit.bsp.faces[i].styles) ++own;
  }
  EXPECT_EQ(lit.bsp.find_bspx("LMSTYLE") != nullptr, own > 0);
  EXPECT_EQ(own, 1);
}

TEST(DecoupledLuxels, TooManyAreLeftOutWithAWarning) {
  const LitResult lit = light_decoupled_room("0.1");
  EXPECT_EQ(lit.bsp.bspx, light_decoupled_room("0").bsp.bspx);
  ASSERT_EQ(lit.warnings.size(), 1u);
  EXPECT_EQ(lit.warnings[0].kind, "light map too fine");
  EXPECT_TRUE(lit.warnings[0].what.starts_with("face 0 at ")) << lit.warnings[0].what;
}

}  // namespace
}  // namespace temblor::test
