// Entities from packets: which exist, where, and in which frame.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "client/session/client_state.h"
#include "client/session/messages.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using client::ClientSettings;
using client::ClientState;
using client::FrameBlend;
using client::InterpolatedEntity;

const ClientSettings kSnap = {.interpolate = false, .no_lerp_models = {}};

std::vector<std::uint32_t> list_numbers(std::span<const InterpolatedEntity> entities) {
  std::vector<std::uint32_t> numbers;
  for (const InterpolatedEntity& entity : entities) numbers.push_back(entity.number);
  return numbers;
}

// The entity must exist.
InterpolatedEntity seen(ClientState& io_state, std::uint32_t number, double time_s,
                        const ClientSettings& settings = {}) {
  for (const InterpolatedEntity& entity : io_state.interpolate_entities(time_s, settings))
    if (entity.number == number) return entity;
  CHECK(false, "entity {} is not there", number);
}

FrameBlend frame_blend(const InterpolatedEntity& entity) {
  return {entity.from_frame, entity.to_frame, entity.blend};
}

TEST(Entities, UpdatesAreRelativeToTheBaselineNotTheLastUpdate) {
  ClientState state = state_in_level();
  apply(state, {net::SpawnBaseline{9,
                                   {.model = kOgreModel,
                                    .frame = 5,
                                    .colormap = 2,
                                    .skin = 1,
                                    .origin = {10, 20, 30},
                                    .angles_deg = {0, 90, 0},
                                    .alpha = 0.5f,
                                    .scale = 2}}});
  net::EntityUpdate update;
  update.number = 9;
  update.frame = 7;
  update.origin[1] = 25.0f;
  update.effects = client::kEffectDimLight;
  packet(state, 1, {update});
  InterpolatedEntity entity = seen(state, 9, 1, kSnap);
  EXPECT_EQ(entity.model, kOgreModel);
  EXPECT_EQ(entity.to_frame, 7);
  EXPECT_EQ(entity.colormap, 2);
  EXPECT_EQ(entity.skin, 1);
  EXPECT_EQ(entity.origin_world, math::Vec3(10, 25, 30));
  EXPECT_EQ(entity.angles_deg, math::Vec3(0, 90, 0));
  EXPECT_EQ(entity.effects, client::kEffectDimLight);
  EXPECT_EQ(entity.alpha, 0.5f);
  EXPECT_EQ(entity.scale, 2);

  net::EntityUpdate other;
  other.number = 9;
  other.angles_deg[0] = 15.0f;
  other.alpha = 1.0f;
  packet(state, 1.0625f, {other});
  entity = seen(state, 9, 1.0625, kSnap);
  EXPECT_EQ(entity.to_frame, 5);
  EXPECT_EQ(entity.origin_world, math::Vec3(10, 20, 30));
  EXPECT_EQ(entity.angles_deg, math::Vec3(15, 90, 0));
  EXPECT_EQ(entity.effects, 0);
  EXPECT_EQ(entity.alpha, 1);
}

TEST(Entities, EntitiesMissingFromAPacketAreGone) {
  ClientState state = state_in_level();
  apply(state, {net::SpawnStatic{{.model = kFlameModel, .origin = {1, 1, 1}}},
                net::SpawnStatic{{.model = kFlameModel, .origin = {2, 2, 2}}}});
  constexpr std::uint32_t kStatic = InterpolatedEntity::kFirstStatic;
  packet(state, 1,
         {update_at(31999, kOgreModel, {}), update_at(4, kOgreModel, {}), update_at(8, kOgreModel, {})});
  EXPECT_THAT(list_numbers(state.interpolate_entities(1, {})),
              testing::ElementsAre(4, 8, 31999, kStatic, kStatic + 1));
  packet(state, 1.1f, {update_at(8, kOgreModel, {})});
  EXPECT_THAT(list_numbers(state.interpolate_entities(1.1, {})),
              testing::ElementsAre(8, kStatic, kStatic + 1));
  // A packet without a time (reliable text) does not remove entities.
  apply(state, {net::Print{"hello"}});
  state.end_packet();
  EXPECT_THAT(list_numbers(state.interpolate_entities(1.1, {})),
              testing::ElementsAre(8, kStatic, kStatic + 1));
  packet(state, 1.2f, {});
  EXPECT_THAT(list_numbers(state.interpolate_entities(1.2, {})), testing::ElementsAre(kStatic, kStatic + 1));
}

TEST(Entities, OnlyTheViewEntityNeedsNoModel) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(0, 1, {}), update_at(1, 0, {5, 6, 7}), update_at(2, 0, {})});
  EXPECT_THAT(list_numbers(state.interpolate_entities(1, {})), testing::ElementsAre(1));
  EXPECT_EQ(seen(state, 1, 1).model, 0);
  EXPECT_EQ(seen(state, 1, 1).origin_world, math::Vec3(5, 6, 7));
}

TEST(Entities, ModelsPastTheListAreKeptAndInvalidColormapsDropped) {
  ClientState state = state_in_level();
  net::EntityUpdate fourth = update_at(5, 60000, {}), fifth = update_at(6, kPlayerModel, {});
  fourth.colormap = std::uint8_t{4};
  fifth.colormap = std::uint8_t{5};
  packet(state, 1, {fourth, fifth});
  EXPECT_EQ(seen(state, 5, 1).model, 60000);
  EXPECT_EQ(seen(state, 5, 1).colormap, 4);
  EXPECT_EQ(seen(state, 6, 1).colormap, 0);
}

TEST(Entities, MoveBetweenTheLastTwoUpdates) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(5, kOgreModel, {0, 0, 0}, {0, 350, 0})});
  packet(state, 1.0625f, {update_at(5, kOgreModel, {16, -8, 0}, {0, 10, 0})});
  const InterpolatedEntity quarter = seen(state, 5, 1.015625);
  EXPECT_EQ(quarter.origin_world, math::Vec3(4, -2, 0));
  EXPECT_EQ(quarter.angles_deg, math::Vec3(0, 355, 0));
  EXPECT_EQ(seen(state, 5, 1.015625, kSnap).origin_world, math::Vec3(16, -8, 0));
  EXPECT_EQ(seen(state, 5, 0).origin_world, math::Vec3(0, 0, 0));
  EXPECT_EQ(seen(state, 5, 2).origin_world, math::Vec3(16, -8, 0));
}

TEST(Entities, LongGapsCountAsATenthOfASecond) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(5, kOgreModel, {0, 0, 0})});
  packet(state, 3, {update_at(5, kOgreModel, {80, 0, 0})});
  EXPECT_EQ(state.previous_time_s(), 1);
  EXPECT_EQ(seen(state, 5, 2).origin_world.x, 0);
  EXPECT_NEAR(seen(state, 5, 2.95).origin_world.x, 40, 1e-4);
}

TEST(Entities, TeleportedEntitiesDoNotGlide) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(1, kPlayerModel, {0, 0, 0}, {0, 0, 0})});
  EXPECT_TRUE(state.has_view_jumped()) << "it is new";
  packet(state, 1.0625f, {update_at(1, kPlayerModel, {0, 100, 0}, {0, 90, 0})});
  EXPECT_FALSE(state.has_view_jumped());
  EXPECT_EQ(seen(state, 1, 1.03125).origin_world.y, 50);
  packet(state, 1.125f, {update_at(1, kPlayerModel, {0, 201, 0}, {0, 180, 0})});
  EXPECT_TRUE(state.has_view_jumped());
  EXPECT_EQ(seen(state, 1, 1.0625).origin_world.y, 201);
  EXPECT_EQ(seen(state, 1, 1.0625).angles_deg.y, 180);
}

TEST(Entities, ReturningEntitiesDoNotGlide) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(5, kOgreModel, {0, 0, 0})});
  packet(state, 1.0625f, {});
  packet(state, 1.125f, {with_frame(update_at(5, kOgreModel, {50, 0, 0}), 9)});
  EXPECT_EQ(seen(state, 5, 1.0625).origin_world.x, 50);
  EXPECT_EQ(frame_blend(seen(state, 5, 1.0625)), (FrameBlend{9, 9, 0}));
}

TEST(Entities, MonstersMoveFromStepToStep) {
  ClientState state = state_in_level();
  const auto ogre = [](float x) { return in_steps(update_at(5, kOgreModel, {x, 0, 0})); };
  packet(state, 1, {ogre(0)});
  packet(state, 1.03125f, {ogre(8)});
  // The step is drawn from 1 s on and takes 0.1 s, although packets arrive faster.
  EXPECT_NEAR(seen(state, 5, 1.025).origin_world.x, 2, 1e-4);
  packet(state, 1.0625f, {ogre(8)});
  EXPECT_NEAR(seen(state, 5, 1.05).origin_world.x, 4, 1e-4);
  packet(state, 1.09375f, {ogre(8)});
  EXPECT_NEAR(seen(state, 5, 1.075).origin_world.x, 6, 1e-4);
  EXPECT_EQ(seen(state, 5, 1.1).origin_world.x, 8);
  EXPECT_EQ(seen(state, 5, 1.075, kSnap).origin_world.x, 8);

  net::EntityUpdate slow = ogre(16);
  slow.next_think_s = 0.5f;
  packet(state, 1.5f, {ogre(8)});
  packet(state, 1.53125f, {slow});
  EXPECT_EQ(seen(state, 5, 1.75).origin_world.x, 12);
}

TEST(Entities, FramesAreBlendedExceptForFlashesNewModelsAndListedOnes) {
  ClientState state = state_in_level();
  const auto ogre = [](std::uint16_t frame) { return with_frame(update_at(5, kOgreModel, {}), frame); };
  packet(state, 1, {ogre(1)});
  packet(state, 1.0625f, {ogre(2)});
  EXPECT_EQ(frame_blend(seen(state, 5, 1)), (FrameBlend{1, 2, 0}));
  const FrameBlend half = frame_blend(seen(state, 5, 1.05));
  EXPECT_EQ(half.from, 1);
  EXPECT_NEAR(half.blend, 0.5, 1e-6);
  EXPECT_EQ(frame_blend(seen(state, 5, 1.05, kSnap)), (FrameBlend{2, 2, 0}));
  const ClientSettings no_lerp = {.interpolate = true, .no_lerp_models = {false, false, false, true}};
  EXPECT_EQ(frame_blend(seen(state, 5, 1.05, no_lerp)), (FrameBlend{2, 2, 0}));

  net::EntityUpdate slow = ogre(3);
  slow.next_think_s = 0.25f;
  packet(state, 1.125f, {slow});
  EXPECT_EQ(frame_blend(seen(state, 5, 1.1875)), (FrameBlend{2, 3, 0.5f}));
  packet(state, 1.1875f, {with_frame(update_at(5, kFlameModel, {}), 4)});
  EXPECT_EQ(frame_blend(seen(state, 5, 1.1875)), (FrameBlend{4, 4, 0})) << "another model";
  packet(state, 1.25f,
         {with_effects(with_frame(update_at(5, kFlameModel, {}), 5), client::kEffectMuzzleFlash)});
  EXPECT_EQ(frame_blend(seen(state, 5, 1.1875)), (FrameBlend{5, 5, 0})) << "a muzzle flash";
}

TEST(Entities, AMuzzleFlashIsReportedOnce) {
  ClientState state = state_in_level();
  const net::EntityUpdate still = update_at(5, kOgreModel, {});
  packet(state, 1, {with_effects(still, client::kEffectMuzzleFlash)});
  packet(state, 1.0625f, {still});
  EXPECT_TRUE(seen(state, 5, 1).has_muzzle_flash) << "it arrived since the last query, in an earlier packet";
  EXPECT_FALSE(seen(state, 5, 1).has_muzzle_flash);
  packet(state, 1.125f, {with_effects(still, client::kEffectMuzzleFlash)});
  EXPECT_TRUE(seen(state, 5, 1.1).has_muzzle_flash);
  EXPECT_FALSE(seen(state, 5, 1.1).has_muzzle_flash);
  EXPECT_EQ(seen(state, 5, 1.1).effects, client::kEffectMuzzleFlash);
}

TEST(Entities, TrailsStartWhereTheEntityWasLastDrawn) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(5, kOgreModel, {0, 0, 0})});
  EXPECT_EQ(seen(state, 5, 1).previous_origin_world.x, 0);
  packet(state, 1.0625f, {update_at(5, kOgreModel, {16, 0, 0})});
  EXPECT_EQ(seen(state, 5, 1.03125).previous_origin_world.x, 0);
  packet(state, 1.125f, {update_at(5, kOgreModel, {32, 0, 0})});
  EXPECT_EQ(seen(state, 5, 1.09375).previous_origin_world.x, 8);
  EXPECT_EQ(seen(state, 5, 1.125).previous_origin_world.x, 24);
  // Not after a teleport, and not across a packet without the entity.
  packet(state, 1.1875f, {update_at(5, kOgreModel, {232, 0, 0})});
  EXPECT_EQ(seen(state, 5, 1.15).previous_origin_world.x, 232);
  packet(state, 1.25f, {});
  state.interpolate_entities(1.25, {});
  packet(state, 1.3125f, {update_at(5, kOgreModel, {240, 0, 0})});
  EXPECT_EQ(seen(state, 5, 1.3).previous_origin_world.x, 240);
}

TEST(Entities, AreNewAfterTeleportsAndAbsence) {
  ClientState state = state_in_level();
  packet(state, 1, {update_at(5, kOgreModel, {0, 0, 0})});
  EXPECT_TRUE(seen(state, 5, 1).is_new);
  EXPECT_FALSE(seen(state, 5, 1).is_new);
  packet(state, 1.0625f, {update_at(5, kOgreModel, {16, 0, 0})});
  EXPECT_FALSE(seen(state, 5, 1.03125).is_new);
  packet(state, 1.125f, {update_at(5, kOgreModel, {232, 0, 0})});
  EXPECT_TRUE(seen(state, 5, 1.1).is_new) << "a teleport";
  packet(state, 1.1875f, {});
  state.interpolate_entities(1.1875, {});
  packet(state, 1.25f, {update_at(5, kOgreModel, {240, 0, 0})});
  EXPECT_TRUE(seen(state, 5, 1.2).is_new);
}

net::ClientData weapon(std::uint16_t model, std::uint16_t frame) {
  net::ClientData data;
  data.weapon_model = model;
  data.weapon_frame = frame;
  return data;
}

TEST(WeaponFrame, IsBlendedExceptForFlashesAndWeaponChanges) {
  ClientState state = state_in_level();
  const net::EntityUpdate player = update_at(1, kPlayerModel, {});
  packet(state, 1, {weapon(3, 4), player});
  EXPECT_EQ(state.interpolate_weapon_frame(1, {}), (FrameBlend{4, 4, 0})) << "a new weapon";
  packet(state, 1.0625f, {weapon(3, 5), player});
  EXPECT_NEAR(state.interpolate_weapon_frame(1.025, {}).blend, 0.25, 1e-6);
  EXPECT_EQ(state.interpolate_weapon_frame(1.025, {}).from, 4);
  EXPECT_EQ(state.interpolate_weapon_frame(1.025, kSnap), (FrameBlend{5, 5, 0}));
  const ClientSettings no_lerp = {.interpolate = true, .no_lerp_models = {false, false, false, true}};
  EXPECT_EQ(state.interpolate_weapon_frame(1.025, no_lerp), (FrameBlend{5, 5, 0}));
  // The flash arrives after the frame.
  packet(state, 1.125f, {weapon(3, 6), with_effects(player, client::kEffectMuzzleFlash)});
  EXPECT_EQ(state.interpolate_weapon_frame(1.09, {}), (FrameBlend{6, 6, 0}));
  packet(state, 1.25f, {weapon(3, 7), player});
  EXPECT_EQ(state.interpolate_weapon_frame(1.2, {}), (FrameBlend{7, 7, 0}));
  packet(state, 1.3125f, {weapon(4, 0), player});
  EXPECT_EQ(state.interpolate_weapon_frame(1.275, {}), (FrameBlend{0, 0, 0}));
}

// At a packet's own time all flying entities are where the packet says; with snapping, all entities are, at
// any time. Compares with a table of the last packet.
TEST(Entities, AreAtTheirPacketsPlaceAtItsTime) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    ClientState state = state_in_level();
    float time_s = 1;
    for (int packets = 0; packets < 30; ++packets) {
      time_s += static_cast<float>(random.uniform(0, 0.2));
      std::map<std::uint16_t, net::EntityUpdate> sent;
      for (std::uint16_t number = 1; number < 20; ++number) {
        if (random.chance(0.2)) continue;
        net::EntityUpdate update = update_at(
            number, kOgreModel, random.in_cube(random.chance(0.1) ? 4096 : 60), random.in_cube(360));
        update.frame = static_cast<std::uint16_t>(random.below(5));
        update.step = number % 2 == 0;
        sent[number] = update;
      }
      apply(state, {net::Time{time_s}});
      for (const auto& [number, update] : sent) apply(state, {update});
      state.end_packet();

      const double any_time_s = static_cast<double>(time_s) + random.uniform(-0.2, 0.2);
      for (const bool interpolate : {true, false}) {
        const auto entities =
            state.interpolate_entities(interpolate ? static_cast<double>(time_s) : any_time_s,
                                       {.interpolate = interpolate, .no_lerp_models = {}});
        ASSERT_EQ(entities.size(), sent.size()) << seed;
        for (const InterpolatedEntity& entity : entities) {
          const net::EntityUpdate& update = sent.at(static_cast<std::uint16_t>(entity.number));
          EXPECT_EQ(entity.to_frame, *update.frame) << seed;
          if (interpolate && update.step) continue;
          for (int axis = 0; axis < 3; ++axis) {
            const auto component = static_cast<std::size_t>(axis);
            EXPECT_EQ(entity.origin_world[axis], *update.origin[component]) << seed;
            EXPECT_EQ(entity.angles_deg[axis], *update.angles_deg[component]) << seed;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace temblor::test
