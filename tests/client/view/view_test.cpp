#include "client/view/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "client/session/powerups.h"
#include "support/levels/drawable_level.h"
#include "world/visibility.h"

namespace temblor::client {
namespace {

const world::Level& level() {
  static const auto small = test::small_level().level;
  return *small;
}

// A place of the level surrounded by these contents.
math::Vec3 place_in(world::Contents contents) {
  for (const artgen::SmallLevelBox& box : artgen::small_level_boxes())
    if (box.contents == static_cast<std::int32_t>(contents)) {
      const math::Vec3 middle = (box.bounds.mins + box.bounds.maxs) * 0.5f + math::Vec3(1.25f, 2.5f, 0);
      if (world::point_contents(level(), middle) == contents) return middle;
    }
  ADD_FAILURE() << "no place with contents " << static_cast<int>(contents);
  return math::Vec3(0.0f);
}

struct Viewer {
  Viewer() {
    game.data.health = 100;
    entity.origin_world = place_in(world::Contents::kEmpty);
  }
  PlayerView at(double time_s) {
    const PlayerView seen = view.advance(
        game, events, {time_s, view_angles_deg, is_there ? &entity : nullptr, level(), own}, settings);
    events = {};
    return seen;
  }
  View view;
  Game game;
  Events events;
  InterpolatedEntity entity;
  ViewSettings settings;
  math::Vec3 view_angles_deg{10, 20, 0};
  bool is_there = true;
  std::optional<PredictedMotion> own;
};

const math::Vec3 kOffGrid(1.0f / 32);

TEST(View, EyesFollowThePrediction) {
  Viewer viewer;
  viewer.own = PredictedMotion{viewer.entity.origin_world + math::Vec3(3, 4, 0), math::Vec3(0.0f), true};
  EXPECT_EQ(viewer.at(1).camera.origin_world, viewer.own->origin_world + math::Vec3(0, 0, 22) + kOffGrid);
  // The head leans with the predicted velocity too.
  viewer.view_angles_deg = {0, 0, 0};
  viewer.own->velocity = {0, 200, 0};
  EXPECT_NE(viewer.at(1.01).camera.angles_deg.z, 0);
  viewer.own.reset();
  EXPECT_EQ(viewer.at(1.02).camera.origin_world.x, viewer.entity.origin_world.x + kOffGrid.x);
}

TEST(View, EyesOfAStandingPlayer) {
  Viewer viewer;
  const PlayerView seen = viewer.at(1);
  EXPECT_EQ(seen.camera.origin_world, viewer.entity.origin_world + math::Vec3(0, 0, 22) + kOffGrid);
  EXPECT_EQ(seen.camera.angles_deg, math::Vec3(10, 20, 0));
  EXPECT_EQ(seen.camera.fov_deg, 90);
  EXPECT_EQ(seen.tint.opacity, 0);
  EXPECT_FALSE(seen.underwater);
  EXPECT_EQ(seen.contents, world::Contents::kEmpty);
  EXPECT_TRUE(seen.show_weapon);
  EXPECT_EQ(seen.weapon_origin_world, viewer.entity.origin_world + math::Vec3(0, 0, 24));
  EXPECT_EQ(seen.weapon_angles_deg, math::Vec3(-10, 20, 0));
}

TEST(View, EyesOfARunningPlayer) {
  Viewer viewer;
  viewer.view_angles_deg = {0, 90, 0};
  viewer.game.data.velocity = {100, 300, 0};  // ahead, and 100 to the right
  const double time_s = 0.15;                 // the top of the bob
  const PlayerView seen = viewer.at(time_s);
  const float bob = compute_bob(time_s, viewer.game.data.velocity);
  EXPECT_GT(bob, 3);
  EXPECT_LT(glm::distance(seen.camera.origin_world,
                          viewer.entity.origin_world + math::Vec3(0, 0, 22 + bob) + kOffGrid),
            1e-4f);
  EXPECT_NEAR(seen.camera.angles_deg.z, 1, 1e-4);
  // The weapon is 0.4 of the bob ahead, and does not lean.
  EXPECT_LT(glm::distance(seen.weapon_origin_world,
                          viewer.entity.origin_world + math::Vec3(0, 0.4f * bob, 24 + bob)),
            1e-4f);
  EXPECT_EQ(seen.weapon_angles_deg.z, 0);
  viewer.settings.bob = viewer.settings.roll = 0;
  const PlayerView still = viewer.at(time_s);
  EXPECT_EQ(still.camera.origin_world, viewer.entity.origin_world + math::Vec3(0, 0, 22) + kOffGrid);
  EXPECT_EQ(still.camera.angles_deg.z, 0);
}

TEST(View, EyesStayWithinTheBody) {
  Viewer viewer;
  viewer.game.data.view_height = 40;
  EXPECT_EQ(viewer.at(1).camera.origin_world.z, viewer.entity.origin_world.z + 30);
  viewer.game.data.view_height = -40;
  EXPECT_EQ(viewer.at(1).camera.origin_world.z, viewer.entity.origin_world.z - 22);
}

TEST(View, Kicks) {
  Viewer viewer;
  viewer.view_angles_deg = {0, 0, 0};
  viewer.at(1);
  viewer.events.damages.push_back({0, 40, viewer.entity.origin_world + math::Vec3(100, 0, 0)});
  viewer.game.data.punch_deg = {-4, 0, 0};
  const PlayerView hit = viewer.at(2);
  EXPECT_NEAR(hit.camera.angles_deg.x, 12 - 4, 1e-3);
  EXPECT_NEAR(hit.weapon_angles_deg.x, -12, 1e-3);  // punches move only the head
  EXPECT_NEAR(hit.tint.opacity, 60.0 / 256, 1e-5);
  // The punch moves evenly to its next value.
  viewer.game.data.punch_deg = {-3, 0, 0};
  EXPECT_NEAR(viewer.at(2.5).camera.angles_deg.x, -4, 1e-3);
  EXPECT_NEAR(viewer.at(2.55).camera.angles_deg.x, -3.5, 1e-3);
  EXPECT_NEAR(viewer.at(2.65).camera.angles_deg.x, -3, 1e-3);
  viewer.settings.kick = 0;
  EXPECT_EQ(viewer.at(2.7).camera.angles_deg.x, -3) << "recoil and blasts have their own setting";
  viewer.settings.shake = 0;
  EXPECT_EQ(viewer.at(2.7).camera.angles_deg.x, 0);
}

TEST(View, DeadPlayersLieOnTheirSide) {
  Viewer viewer;
  viewer.game.data.health = 0;
  viewer.game.data.velocity = {0, 300, 0};
  const PlayerView seen = viewer.at(1);
  EXPECT_EQ(seen.camera.angles_deg.z, 80);
  EXPECT_FALSE(seen.show_weapon);
}

TEST(View, InvisiblePlayersSeeNoWeapon) {
  Viewer viewer;
  viewer.game.data.items = kItemInvisibility;
  const PlayerView seen = viewer.at(1);
  EXPECT_FALSE(seen.show_weapon);
  EXPECT_NEAR(seen.tint.opacity, 100.0 / 256, 1e-5);
  viewer.settings.powerup_tint = 0.5f;
  EXPECT_NEAR(viewer.at(1).tint.opacity, 50.0 / 256, 1e-5);
}

TEST(View, Stairs) {
  Viewer viewer;
  viewer.game.data.on_ground = true;
  const PlayerView before = viewer.at(1);
  viewer.entity.origin_world.z += 8;
  const PlayerView stepped = viewer.at(1);
  EXPECT_NEAR(stepped.camera.origin_world.z, before.camera.origin_world.z, 1e-3);
  EXPECT_NEAR(stepped.weapon_origin_world.z, before.weapon_origin_world.z, 1e-3);
  EXPECT_NEAR(viewer.at(1.05).camera.origin_world.z, before.camera.origin_world.z + 4, 1e-3);
  EXPECT_NEAR(viewer.at(1.2).camera.origin_world.z, before.camera.origin_world.z + 8, 1e-3);
  // A teleport is not a stair.
  viewer.entity.origin_world += math::Vec3(300, 0, 50);
  EXPECT_NEAR(viewer.at(1.2).camera.origin_world.z, before.camera.origin_world.z + 58, 1e-3);
}

TEST(View, UnderWater) {
  Viewer viewer;
  // The eye counts, not the feet.
  viewer.entity.origin_world = place_in(world::Contents::kWater) - math::Vec3(0, 0, 22);
  const PlayerView seen = viewer.at(1);
  EXPECT_EQ(seen.contents, world::Contents::kWater);
  EXPECT_TRUE(seen.underwater);
  EXPECT_EQ(seen.tint.color, math::Vec3(130, 80, 50));
  EXPECT_FLOAT_EQ(seen.tint.opacity, 0.5f);
  // In the order contents, damage, bonus, power-up.
  viewer.events.damages.push_back({0, 40, {0, 0, 0}});
  viewer.events.bonus_flashes = 1;
  viewer.game.data.items = kItemQuad;
  const render::Tint all = viewer.at(1).tint;
  render::Tint expected = blend_tints({{130, 80, 50}, 0.5f}, {{255, 0, 0}, 60.0f / 256});
  expected = blend_tints(expected, {{215, 186, 69}, 50.0f / 256});
  expected = blend_tints(expected, {{0, 0, 255}, 30.0f / 256});
  EXPECT_LT(glm::distance(all.color, expected.color), 1e-3f);
  EXPECT_FLOAT_EQ(all.opacity, expected.opacity);
  viewer.settings.contents_tint = viewer.settings.damage_tint = viewer.settings.bonus_tint = 0;
  EXPECT_FLOAT_EQ(viewer.at(1).tint.opacity, 30.0f / 256);
}

TEST(View, Intermission) {
  Viewer viewer;
  viewer.game.ending = Ending::kIntermission;
  viewer.game.data.velocity = {300, 300, 0};
  viewer.game.data.items = kItemQuad;
  viewer.entity.angles_deg = {5, 130, 0};
  viewer.events.damages.push_back({0, 40, {0, 0, 0}});
  const PlayerView seen = viewer.at(1);
  EXPECT_EQ(seen.camera.origin_world, viewer.entity.origin_world);
  EXPECT_EQ(seen.camera.angles_deg, math::Vec3(5, 130, 0) + compute_idle_sway_deg(1));
  EXPECT_FALSE(seen.show_weapon);
  EXPECT_EQ(seen.tint.opacity, 0);
}

TEST(View, StaysInPlaceWithoutItsEntity) {
  Viewer viewer;
  const math::Vec3 eye = viewer.at(1).camera.origin_world;
  viewer.is_there = false;
  viewer.entity.origin_world += math::Vec3(50, 0, 0);
  EXPECT_EQ(viewer.at(1.1).camera.origin_world, eye);
}

TEST(View, RewindingEndsFadingEffects) {
  Viewer viewer;
  viewer.at(10);
  viewer.events.damages.push_back({0, 100, {0, 0, 0}});
  viewer.events.bonus_flashes = 1;
  EXPECT_GT(viewer.at(10.1).tint.opacity, 0);
  const PlayerView seen = viewer.at(5);
  EXPECT_EQ(seen.tint.opacity, 0);
  EXPECT_EQ(seen.camera.angles_deg, math::Vec3(10, 20, 0));
  EXPECT_EQ(seen.camera.origin_world, viewer.entity.origin_world + math::Vec3(0, 0, 22) + kOffGrid);
}

}  // namespace
}  // namespace temblor::client
