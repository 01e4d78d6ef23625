// Doors, lifts, buttons and triggers of stock levels, operated as by a player.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "game/played_level.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

math::Vec3 middle(server::Edict edict) {
  return (edict[field::kAbsMin] + edict[field::kAbsMax]) * 0.5f;
}

// The largest distance of an entity from its start in this time.
float farthest_way(PlayedLevel& game, std::uint32_t number, double seconds) {
  const math::Vec3 from = game.edict(number)[field::kOrigin];
  float farthest = 0;
  for (const double end = game.time_s() + seconds; game.time_s() < end;) {
    game.tick();
    farthest = std::max(farthest, glm::length(game.edict(number)[field::kOrigin] - from));
  }
  return farthest;
}

TEST(Movers, DoorsWithoutAKeyOrANameOpenForPlayersNearby) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m1", kProgs);
  game.join(0);
  game.run(1);
  int opened = 0;
  for (const std::uint32_t box : game.of_class("trigger_box")) {
    const auto door = static_cast<std::uint32_t>(game.edict(box)[field::kOwner]);
    if (game.text(game.edict(door)[field::kClassName]) != "func_door") continue;
    const math::Vec3 closed = game.edict(door)[field::kOrigin];
    game.put(game.player(0), middle(game.edict(box)));
    EXPECT_GT(farthest_way(game, door, 2), 8) << door;
    game.put(game.player(0), {-160, -8, 64});
    game.run(12);
    EXPECT_EQ(game.edict(door)[field::kOrigin], closed) << door;
    ++opened;
  }
  EXPECT_GT(opened, 0);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, DoorsWithAKeyOpenForItsBearerAndKeepIt) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m1", kProgs);
  game.join(0);
  game.run(1);
  const server::Edict player = game.player(0);
  player.set_flag(server::flag::kGodMode);
  std::uint32_t door = 0;
  for (const std::uint32_t number : game.of_class("func_door"))
    if (game.edict(number).whole(field::kSpawnFlags) & 8) door = number;
  ASSERT_NE(door, 0u);
  game.touch(door, 1);
  EXPECT_EQ(farthest_way(game, door, 2), 0);
  player.set(field::kItems, player[field::kItems] + 262144);
  game.touch(door, 1);
  EXPECT_GT(farthest_way(game, door, 3), 8);
  EXPECT_EQ(player.whole(field::kItems) & 262144, 0);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, LiftsRiseWithTheirRiderAndReturn) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e1m2", kProgs);
  game.join(0);
  game.run(1);
  int lifts = 0;
  for (const std::uint32_t lift : game.of_class("func_plat")) {
    const math::Vec3 below = game.edict(lift)[field::kOrigin];
    math::Vec3 on = middle(game.edict(lift));
    on[2] = game.edict(lift)[field::kAbsMax][2] + 24;
    const server::Edict player = game.player(0);
    player.set(field::kVelocity, math::Vec3(0.0f));
    game.put(player, on);
    const float way = farthest_way(game, lift, 6);
    EXPECT_GT(way, 32) << lift;
    EXPECT_GT(player[field::kOrigin][2], on[2] + 16) << lift;
    game.put(player, {472, -392, 536});
    game.run(12);
    EXPECT_EQ(game.edict(lift)[field::kOrigin], below) << lift;
    ++lifts;
  }
  EXPECT_EQ(lifts, 2);  // without those for deathmatch
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, ButtonsMoveAndFireTheirTargets) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m1", kProgs);
  game.join(0);
  game.run(1);
  for (const std::uint32_t button : game.of_class("func_button")) {
    game.touch(button, 1);
    EXPECT_GT(farthest_way(game, button, 1), 0) << button;
  }
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, TrainsGoRound) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m2", kProgs);
  game.join(0);
  game.run(1);
  const auto trains = game.of_class("func_train");
  EXPECT_FALSE(trains.empty());
  for (const std::uint32_t train : trains) EXPECT_GT(farthest_way(game, train, 3), 100) << train;
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, TeleportersMovePlayersWhoWalkIn) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs);
  game.join(0);
  game.run(1);
  int moved = 0;
  for (const std::uint32_t teleporter : game.of_class("trigger_teleport")) {
    if (game.text(game.edict(teleporter)[field::kTargetName]) != "") continue;
    const std::string target = game.text(game.edict(teleporter)[field::kTarget]);
    math::Vec3 goal(0.0f);
    for (const std::uint32_t place : game.of_class("info_teleport_destination"))
      if (game.text(game.edict(place)[field::kTargetName]) == target)
        goal = game.edict(place)[field::kOrigin];
    game.put(game.player(0), middle(game.edict(teleporter)));
    EXPECT_LT(glm::length(game.player(0)[field::kOrigin] - goal), 1);
    // The player is thrown forward, out of the teleporter.
    EXPECT_NEAR(glm::length(game.player(0)[field::kVelocity]), 300, 1);
    game.run(1);
    ++moved;
  }
  EXPECT_GT(moved, 0);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, SecretsCountOnce) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m1", kProgs);
  game.join(0);
  game.run(1);
  const auto secrets = game.of_class("trigger_secret");
  for (const std::uint32_t secret : secrets) {
    const math::Vec3 at = middle(game.edict(secret));
    for (int i = 0; i < 2; ++i) {
      game.put(game.player(0), at);
      game.run(0.3);
    }
  }
  EXPECT_EQ(game.global("found_secrets"), static_cast<float>(secrets.size()));
  EXPECT_EQ(game.global("total_secrets"), static_cast<float>(secrets.size()));
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, CountersFireWhenTheirCountIsReached) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e1m2", kProgs);
  game.join(0);
  game.run(1);
  const std::uint32_t counter = game.of_class("trigger_counter").at(0);
  const float count = game.edict_number(counter, "count");
  ASSERT_GT(count, 0);
  for (float i = 1; i < count; ++i) {
    game.use(counter, 1);
    EXPECT_THAT(game.of_class("delayed_fire"), IsEmpty());
  }
  game.use(counter, 1);
  EXPECT_THAT(game.of_class("delayed_fire"), ::testing::SizeIs(1));  // it has a delay
  game.run(1);
  EXPECT_TRUE(game.is_free(counter));
}

TEST(Movers, MonstersWalkTheirPaths) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m1", kProgs);
  game.run(1);
  int patrols = 0;
  for (const std::uint32_t walker : game.of_class("monster_army")) {
    const std::string target = game.text(game.edict(walker)[field::kTarget]);
    if (!target.starts_with("path")) continue;
    EXPECT_GT(farthest_way(game, walker, 20), 150) << target;
    ++patrols;
  }
  EXPECT_EQ(patrols, 2);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Movers, ItemsReappearInADeathmatch) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs, {.kind = server::GameKind::kDeathmatch});
  game.join(0);
  game.run(1);
  const std::uint32_t rockets = game.of_class("item_rockets").at(0);
  const math::Vec3 elsewhere = game.player(0)[field::kOrigin];
  game.put(game.player(0), middle(game.edict(rockets)));
  game.run(0.1);
  EXPECT_EQ(game.edict(rockets)[field::kModelIndex], 0);
  game.put(game.player(0), elsewhere);
  game.run(29);
  EXPECT_EQ(game.edict(rockets)[field::kModelIndex], 0);
  game.run(2);
  EXPECT_NE(game.edict(rockets)[field::kModelIndex], 0);
}

TEST(Movers, TheStartMapsHallsSetTheSkill) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs);
  game.join(0);
  game.run(1);
  for (const std::uint32_t hall : game.of_class("trigger_setskill")) {
    game.touch(hall, 1);
    EXPECT_EQ(game.variable("skill"), std::stof(game.text(game.edict(hall)[field::kMessage])));
  }
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
