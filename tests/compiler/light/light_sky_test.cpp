// Light from the sky in a room whose ceiling is sky.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/light/lighting.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

// Where a ray from a place to the sky leaves the room: whether through the ceiling, and how far from its
// edges.
struct WayOut {
  bool ceiling = false;
  double from_edge = 0;
};
WayOut way_out(const math::Vec3d& place, const math::Vec3d& toward) {
  if (toward.z <= 0) return {};
  const math::Vec3d at = place + toward * ((kHalfRoom - place.z) / toward.z);
  const double inside = kHalfRoom - std::max(std::abs(at.x), std::abs(at.y));
  return {inside > 0, std::abs(inside)};
}

TEST(LightSky, SunReachesFacesThatSeeTheSkyInItsDirection) {
  // It shines in the direction of yaw 30, pitch -50.
  constexpr double kYaw = 30 * std::numbers::pi / 180, kPitch = -50 * std::numbers::pi / 180;
  const math::Vec3d toward =
      -math::Vec3d(std::cos(kYaw) * std::cos(kPitch), std::sin(kYaw) * std::cos(kPitch), std::sin(kPitch));
  const LitResult lit = light(room_with({"", "'_sunlight' '220' '_sun_mangle' '30 -50 0'", true}));
  int bright = 0, dark = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    const WayOut way = way_out(luxel.place_world, toward);
    const double cosine = glm::dot(toward, luxel.normal);
    // Within a luxel of the shadow's edge, the filter decides.
    if (way.from_edge < 24) continue;
    const double expected = way.ceiling && cosine > 0 ? 110 * (0.5 + 0.5 * cosine) : 0;
    ++(expected > 0 ? bright : dark);
    ASSERT_NEAR(luxel.gray, expected, 1) << luxel;
  }
  EXPECT_GT(bright, 20);
  EXPECT_GT(dark, 20);
}

TEST(LightSky, SunShinesStraightDownByDefault) {
  const LitResult lit = light(room_with({"", "'_sunlight' '100' '_sunlight_color' '255 0 255'", true}));
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    if (luxel.normal.z < 1) continue;
    ASSERT_EQ(luxel.rgb, (std::array<std::uint8_t, 3>{50, 0, 50}));
  }
}

TEST(LightSky, DomeLightsFromTheWholeHemisphere) {
  const LitResult lit = light(room_with({"", "'_sunlight2' '200'", true}));
  int looked_at = 0;
  double difference = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    // The mean of the arriving light over elevations from 0 to 72 degrees.
    constexpr int kRings = 60, kTurns = 120;
    constexpr double kHighestRad = 72 * std::numbers::pi / 180;
    double sum = 0;
    for (int ring = 0; ring < kRings; ++ring)
      for (int turn = 0; turn < kTurns; ++turn) {
        const double elevation = kHighestRad * (ring + 0.5) / kRings;
        const double z = std::sin(elevation), radius = std::cos(elevation);
        const double angle = (turn + 0.5) / kTurns * 2 * std::numbers::pi;
        const math::Vec3d toward(radius * std::cos(angle), radius * std::sin(angle), z);
        const double cosine = glm::dot(toward, luxel.normal);
        if (cosine > 0 && way_out(luxel.place_world, toward).ceiling) sum += 0.5 + 0.5 * cosine;
      }
    const double expected = 100 * sum / (kRings * kTurns);
    ASSERT_NEAR(luxel.gray, expected, 4) << luxel;
    difference += luxel.gray - expected;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 100);
  EXPECT_NEAR(difference / looked_at, 0, 0.5);
}

// A shaft so narrow that only the sky straight above is visible.
TEST(LightSky, DomeLightsTheFloorOfADeepShaft) {
  const std::string shaft =
      box_text({-64, -64, -64}, {-8, 64, 64}, "wall") + box_text({8, -64, -64}, {64, 64, 64}, "wall") +
      box_text({-8, -64, -64}, {8, -8, 64}, "wall") + box_text({-8, 8, -64}, {8, 64, 64}, "wall");
  const LitResult lit =
      light(room_with({"{ 'classname' 'func_group' " + shaft + "}", "'_sunlight2' '1000'", true}));
  int of_floor = 0;
  for (const RoomLuxel& luxel : room_luxels(lit, 0, 0)) {
    if (luxel.normal.z < 1 || luxel.place_world.z > 0) continue;
    EXPECT_GT(luxel.gray, 3) << luxel;
    ++of_floor;
  }
  EXPECT_GT(of_floor, 0);
}

TEST(LightSky, PenumbraBlursEdgesAndKeepsTheCenter) {
  const std::string keys = "'_sunlight' '200' '_sun_mangle' '0 -45 0'";
  const LitResult sharp = light(room_with({"", keys, true}));
  const LitResult soft = light(room_with({"", keys + "'_sunlight_penumbra' '20'", true}));
  const auto a = room_luxels(sharp), b = room_luxels(soft);
  int between = 0, between_sharp = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].normal.z < 1) continue;
    const auto is_between = [&](int gray) { return gray > 8 && gray < 77; };
    between += is_between(b[i].gray);
    between_sharp += is_between(a[i].gray);
  }
  EXPECT_GT(between, between_sharp);
}

TEST(LightSky, SunsAndDomesMayBeEntities) {
  const LitResult world =
      light(room_with({"", "'_sunlight' '150' '_sun_mangle' '10 -70 0' '_sunlight2' '60'", true}));
  const LitResult entities =
      light(room_with({"{ 'classname' 'light' 'light' '150' '_sun' '1' 'mangle' '10 -70 0' }"
                       "{ 'classname' 'light' 'light' '60' '_sunlight2' '1' }",
                       "", true}));
  EXPECT_GT(world.bsp.lighting.size(), 0u);
  EXPECT_EQ(world.bsp.lighting, entities.bsp.lighting);
}

TEST(LightSky, NoSkyNoSkyLight) {
  EXPECT_EQ(light(room_with({"", "'_sunlight' '220' '_sunlight2' '100'"})).summary.lit_faces, 0u);
}

}  // namespace
}  // namespace temblor::test
