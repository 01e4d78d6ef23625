// Debris through Effects, as the client uses it.
#include "client/debris/debris.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "artgen/small_level.h"
#include "support/levels/drawable_level.h"

namespace temblor::client {
namespace {

using net::TempEntity;
using net::TempEntityKind;

constexpr std::uint32_t kViewer = 1;

class DebrisTest : public ::testing::Test {
 protected:
  // Advances by a frame with one entity.
  void show(const InterpolatedEntity& entity, double time_s, const Events& events = {},
            std::optional<HeldGun> held = std::nullopt) {
    const std::vector<InterpolatedEntity> entities = {entity};
    effects_.advance(events,
                     {.level = *level_,
                      .time_s = time_s,
                      .entities = entities,
                      .model_flags = {},
                      .view_entity = kViewer,
                      .model_names = names_,
                      .model_heights = heights_,
                      .held_gun = held,
                      .liquids = liquids_},
                     settings_);
  }
  InterpolatedEntity body(std::uint16_t model, const math::Vec3& origin) const {
    InterpolatedEntity entity;
    entity.number = kViewer;
    entity.model = model;
    entity.origin_world = entity.previous_origin_world = origin;
    return entity;
  }
  math::Vec3 hall() const {
    const math::Bounds bounds = artgen::small_level_boxes().front().bounds;
    return (bounds.mins + bounds.maxs) * 0.5f;
  }

  std::shared_ptr<const world::Level> level_ = test::small_level().level;
  const std::vector<std::string> names_ = {"", "maps/small.bsp", "progs/soldier.mdl", "progs/player.mdl"};
  const std::vector<float> heights_ = {0, 0, 56, 56};
  std::vector<world::PlacedLiquid> liquids_;
  EffectsSettings settings_{.casings = true, .smoke = true, .impacts = true, .splashes = true};
  Effects effects_;
};

TEST_F(DebrisTest, AFlashThrowsACasingAndSmokes) {
  InterpolatedEntity soldier = body(2, hall());
  soldier.has_muzzle_flash = true;
  show(soldier, 1);
  ASSERT_EQ(effects_.casings().size(), 1u);
  EXPECT_EQ(effects_.casings()[0].model, CasingModel::kShell);
  EXPECT_FALSE(effects_.puffs().empty());
  effects_.begin_level();
  EXPECT_TRUE(effects_.casings().empty());
  show(soldier, 2);
  settings_ = {};
  effects_.begin_level();
  show(soldier, 3);
  EXPECT_TRUE(effects_.casings().empty());
  EXPECT_TRUE(effects_.puffs().empty());
}

// Demos show each packet's events at the time of the last frame.
TEST_F(DebrisTest, AFlashCountsWhileTimeStandsStill) {
  InterpolatedEntity soldier = body(2, hall());
  show(soldier, 1);
  soldier.has_muzzle_flash = true;
  show(soldier, 1);
  EXPECT_EQ(effects_.casings().size(), 1u);
  soldier.has_muzzle_flash = false;
  show(soldier, 1);
  EXPECT_EQ(effects_.casings().size(), 1u);
}

// Stock frames of the player: 103 is a nail, 107 a rocket, 113 a shot, 12 a run.
TEST_F(DebrisTest, TheFrameOfAPlayerNamesTheGun) {
  EXPECT_EQ(find_gun_of_body("progs/player.mdl", 103), Gun::kNailgun);
  EXPECT_EQ(find_gun_of_body("progs/player.mdl", 107), Gun::kLauncher);
  EXPECT_EQ(find_gun_of_body("progs/player.mdl", 113), Gun::kShotgun);
  EXPECT_EQ(find_gun_of_body("progs/player.mdl", 12), Gun::kNone);
  EXPECT_EQ(find_gun_of_body("progs/dog.mdl", 113), Gun::kNone);
}

TEST_F(DebrisTest, CasingsLeaveTheGunInTheHand) {
  InterpolatedEntity viewer = body(3, hall());
  viewer.has_muzzle_flash = true;
  const math::Vec3 breech = hall() + math::Vec3(5, 6, 7);
  const auto fire = [&](Gun gun, double time_s) {
    effects_.begin_level();
    show(viewer, time_s, {}, HeldGun{gun, hall(), breech, {}});
    return effects_.casings();
  };
  ASSERT_EQ(fire(Gun::kSuperShotgun, 1).size(), 2u);
  EXPECT_EQ(effects_.casings()[0].origin_world, breech);
  ASSERT_EQ(fire(Gun::kNailgun, 2).size(), 1u);
  EXPECT_EQ(effects_.casings()[0].model, CasingModel::kBrass);
  EXPECT_TRUE(fire(Gun::kLauncher, 3).empty());
  EXPECT_FALSE(effects_.puffs().empty());
  EXPECT_TRUE(fire(Gun::kNone, 4).empty());
  EXPECT_TRUE(effects_.puffs().empty());
}

TEST_F(DebrisTest, LightningStartsAtTheBarrel) {
  settings_.barrel_beams = true;
  const math::Vec3 muzzle = hall() + math::Vec3(30, 2, -9);
  Events events;
  events.temp_entities.push_back(
      {TempEntityKind::kLightning2, hall(), hall() + math::Vec3(200, 0, 0), kViewer});
  show(body(3, hall()), 1, events, HeldGun{Gun::kNone, muzzle, muzzle, {}});
  ASSERT_FALSE(effects_.beams().empty());
  EXPECT_EQ(effects_.beams()[0].origin_world, muzzle);
}

TEST_F(DebrisTest, BodiesSplashIntoThePool) {
  math::Bounds pool;
  for (const artgen::SmallLevelBox& box : artgen::small_level_boxes())
    if (box.contents == static_cast<std::int32_t>(world::Contents::kWater)) pool = box.bounds;
  const math::Vec3 above((pool.mins.x + pool.maxs.x) / 2, (pool.mins.y + pool.maxs.y) / 2, pool.maxs.z + 3);
  InterpolatedEntity viewer = body(3, above);
  show(viewer, 1);
  EXPECT_EQ(effects_.particles().size(), 0u);
  viewer.previous_origin_world = above;
  viewer.origin_world = above - math::Vec3(0, 0, 8);
  show(viewer, 1.05);
  EXPECT_GT(effects_.particles().size(), 20u);
  EXPECT_FALSE(effects_.puffs().empty());
}

// The door of the level becomes a func_water of Half-Life that has moved into the hall.
TEST_F(DebrisTest, BodiesAndShotsSplashWhereWaterHasMoved) {
  const auto flooded = std::make_shared<world::Level>(*level_);
  flooded->is_half_life = true;
  flooded->brush_entities.resize(flooded->models.size());
  flooded->brush_entities[1].liquid = world::Contents::kWater;
  level_ = flooded;
  const math::Bounds door = artgen::small_level_door();
  const math::Vec3 inside = hall(), beside = inside + math::Vec3(door.maxs.x - door.mins.x, 0, 0);
  InterpolatedEntity viewer = body(3, inside);
  viewer.previous_origin_world = beside;
  show(viewer, 1);
  EXPECT_EQ(effects_.particles().size(), 0u) << "the water is still in the doorway";
  liquids_ = {{world::ModelIndex{1}, inside - (door.mins + door.maxs) * 0.5f}};
  show(viewer, 1.05);
  EXPECT_GT(effects_.particles().size(), 20u);
  ASSERT_FALSE(effects_.puffs().empty());
  EXPECT_EQ(effects_.puffs()[0].picture, PuffPicture::kRing);
  effects_.begin_level();
  Events events;
  events.temp_entities.push_back({TempEntityKind::kGunshot, inside, {}, 0});
  show(body(3, beside), 2, events);
  show(body(3, beside), 2.25);
  ASSERT_FALSE(effects_.puffs().empty());
  EXPECT_EQ(effects_.puffs()[0].picture, PuffPicture::kBubble);
}

// A gunshot in front of a wall of bricks: dust. In the pool: bubbles and no chips.
TEST_F(DebrisTest, ShotsHitWallsAndWater) {
  const math::Bounds hall_bounds = artgen::small_level_boxes().front().bounds;
  Events events;
  events.temp_entities.push_back(
      {TempEntityKind::kGunshot, {hall().x + 3, hall().y + 3, hall_bounds.mins.z + 2}, {}, 0});
  show(body(3, hall()), 1, events);
  ASSERT_EQ(effects_.puffs().size(), 1u);
  EXPECT_EQ(effects_.puffs()[0].picture, PuffPicture::kDust);
  math::Bounds pool;
  for (const artgen::SmallLevelBox& box : artgen::small_level_boxes())
    if (box.contents == static_cast<std::int32_t>(world::Contents::kWater)) pool = box.bounds;
  effects_.begin_level();
  events.temp_entities[0].origin = (pool.mins + pool.maxs) * 0.5f;
  show(body(3, hall()), 2, events);
  EXPECT_EQ(effects_.particles().size(), 0u);
  show(body(3, hall()), 2.25);
  ASSERT_FALSE(effects_.puffs().empty());
  EXPECT_EQ(effects_.puffs()[0].picture, PuffPicture::kBubble);
}

}  // namespace
}  // namespace temblor::client
