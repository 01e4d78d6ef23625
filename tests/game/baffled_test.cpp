// Monsters whose enemy is out of reach do not stand idle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

// How far a monster moves in some time, and its largest horizontal distance from a place.
struct Way {
  float length = 0;
  float farthest = 0;
  double longest_still_s = 0;
};

Way follow_path(PlayedLevel& io_game, std::uint32_t monster, double seconds, const math::Vec3& from) {
  Way way;
  double still_s = 0;
  math::Vec3 before = io_game.edict(monster)[field::kOrigin];
  for (const double end = io_game.time_s() + seconds; io_game.time_s() < end;) {
    io_game.run(0.1);
    const math::Vec3 at = io_game.edict(monster)[field::kOrigin];
    way.length += glm::length(at - before);
    way.farthest = std::max(way.farthest, glm::length(math::Vec3(at.x - from.x, at.y - from.y, 0)));
    still_s = glm::length(at - before) > 1 ? 0 : still_s + 0.1;
    way.longest_still_s = std::max(way.longest_still_s, still_s);
    before = at;
  }
  return way;
}

// A hall with a pillar in its middle, too high to climb; the player stands on it.
class OnAPillar : public ::testing::TestWithParam<std::string> {
 protected:
  OnAPillar()
      : data_(hall_text({-600, -600, 0}, {600, 600, 400}, box_text({-40, -40, 0}, {40, 40, 160}, "wall"))) {}
  RoomData data_;
};

TEST_P(OnAPillar, MonstersBelowMoveAwayFromTheWall) {
  PlayedLevel game(data_.path(), "room", kProgs);
  game.join(0);
  game.run(1);
  game.player(0).set_flag(server::flag::kGodMode);
  const math::Vec3 top(0, 0, 184.03125f);
  game.put(game.player(0), top);
  const std::uint32_t monster = game.spawn(GetParam(), {300, 0, 30}, 180);
  game.run(5);
  EXPECT_EQ(game.edict(monster)[field::kEnemy], game.player(0).index());
  const Way way = follow_path(game, monster, 20, top);
  EXPECT_GT(way.length, 500);
  EXPECT_GT(way.farthest, 180);
  EXPECT_LT(way.longest_still_s, 4);
  EXPECT_EQ(game.edict(monster)[field::kEnemy], game.player(0).index());
  EXPECT_THAT(game.errors(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, OnAPillar,
                         ::testing::Values("monster_dog", "monster_knight", "monster_ogre", "monster_demon1",
                                           "monster_shambler"),
                         [](const auto& kind) { return kind.param; });

// A hall that is only half a unit higher than the box of a fiend.
TEST(BelowALowCeiling, FiendsLeapWithoutEnteringIt) {
  const RoomData data(hall_text({-600, -300, 0}, {600, 300, 88.5}));
  PlayedLevel game(data.path(), "room", kProgs);
  game.join(0);
  game.run(1);
  game.player(0).set_flag(server::flag::kGodMode);
  game.put(game.player(0), {500, 0, 24.03125f});
  const std::uint32_t fiend = game.spawn("monster_demon1", {-200, 0, 24.03125f}, 0);
  float top = 0, fastest = 0;
  for (const double end = game.time_s() + 10; game.time_s() < end;) {
    game.tick();
    top = std::max(top, game.edict(fiend)[field::kOrigin].z);
    fastest = std::max(fastest, game.edict(fiend)[field::kVelocity].x);
  }
  EXPECT_GT(fastest, 500);
  EXPECT_LE(top, 24.5f);
  EXPECT_THAT(game.errors(), IsEmpty());
}

// A shaft in the floor, hardly wider than the monster and a little deeper than a step: no step leads out.
class InAPocket : public ::testing::TestWithParam<std::string> {
 protected:
  InAPocket()
      : data_(hall_text({-600, -600, 0}, {1400, 600, 400},
                        box_text({-600, -600, 0}, {1400, -18, 22}, "wall") +
                            box_text({-600, 18, 0}, {1400, 600, 22}, "wall") +
                            box_text({-600, -18, 0}, {-18, 18, 22}, "wall") +
                            box_text({18, -18, 0}, {1400, 18, 22}, "wall"))) {}
  RoomData data_;
};

TEST_P(InAPocket, TheyHopOut) {
  PlayedLevel game(data_.path(), "room", kProgs);
  game.join(0);
  game.run(1);
  game.player(0).set_flag(server::flag::kGodMode);
  game.put(game.player(0), {300, 0, 50});
  const std::uint32_t monster = game.spawn(GetParam(), {0, 0, 25}, 0);
  game.run(1);
  ASSERT_EQ(game.edict(monster)[field::kEnemy], game.player(0).index());
  EXPECT_LT(game.edict(monster)[field::kOrigin].z, 25);
  game.put(game.player(0), {1300, 0, 50});  // out of range
  game.run(15);
  EXPECT_GT(game.edict(monster)[field::kOrigin].z, 45);
  EXPECT_THAT(game.errors(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, InAPocket,
                         ::testing::Values("monster_knight", "monster_zombie", "monster_army"),
                         [](const auto& kind) { return kind.param; });

TEST(Fish, KeepSwimmingWhenTheirPreyLeavesTheWater) {
  const std::string water = box_text({-600, -600, 0}, {600, 600, 200}, "*water");
  const std::string shore = box_text({400, -600, 0}, {600, 600, 232}, "wall");
  RoomData data(hall_text({-600, -600, 0}, {600, 600, 400}, water + shore));
  PlayedLevel game(data.path(), "room", kProgs);
  game.join(0);
  game.run(1);
  game.player(0).set_flag(server::flag::kGodMode);
  game.put(game.player(0), {200, 0, 100});
  const std::uint32_t fish = game.spawn("monster_fish", {-100, 0, 100}, 0);
  game.run(3);
  ASSERT_EQ(game.edict(fish)[field::kEnemy], game.player(0).index());

  const math::Vec3 ashore(500, 0, 256.03125f);
  game.put(game.player(0), ashore);
  game.run(1);
  EXPECT_GT(follow_path(game, fish, 4, ashore).length, 100);
  game.run(6);
  EXPECT_EQ(game.edict(fish)[field::kEnemy], vm::kWorld);
  EXPECT_GT(follow_path(game, fish, 10, ashore).length, 200);
  EXPECT_THAT(game.errors(), IsEmpty());

  // Back in the water, the player is prey again.
  const math::Vec3 at = game.edict(fish)[field::kOrigin];
  game.put(game.player(0), {at.x - std::copysign(80.0f, at.x), at.y, at.z - 60});
  game.run(3);
  EXPECT_EQ(game.edict(fish)[field::kEnemy], game.player(0).index());
}

}  // namespace
}  // namespace temblor::test
