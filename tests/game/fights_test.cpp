// Each kind of monster against a player, in a stock level: it finds and hurts the player, who kills it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "game/open_ground.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

constexpr float kDegree = std::numbers::pi_v<float> / 180;

void aim_at(PlayedLevel& io_game, std::uint32_t monster) {
  const math::Vec3 way = io_game.edict(monster)[field::kOrigin] - io_game.player(0)[field::kOrigin];
  const float flat = std::hypot(way[0], way[1]);
  io_game.input(0).command.view_angles_deg = {-std::atan2(way[2], flat) / kDegree,
                                              std::atan2(way[1], way[0]) / kDegree, 0};
}

// Seconds until the player has lost health; more than `longest`: never.
double time_to_be_hurt(PlayedLevel& io_game, double longest) {
  const double begin = io_game.time_s();
  const float health = io_game.player(0)[field::kHealth];
  while (io_game.time_s() < begin + longest && io_game.player(0)[field::kHealth] == health) io_game.tick();
  return io_game.time_s() - begin;
}

void shoot_dead(PlayedLevel& io_game, std::uint32_t monster, float weapon_impulse, double longest) {
  const server::Edict player = io_game.player(0);
  player.set_flag(server::flag::kGodMode);
  player.set(field::kItems, 127 + 4096);
  player.set(field::kImpulse, weapon_impulse);
  const double begin = io_game.time_s();
  while (io_game.time_s() < begin + longest && io_game.global("killed_monsters") < 1) {
    for (const auto ammo : {field::kAmmoShells, field::kAmmoNails, field::kAmmoRockets})
      player.set(ammo, 100);
    aim_at(io_game, monster);
    io_game.input(0).buttons = kAttack;
    io_game.tick();
  }
  io_game.input(0).buttons = 0;
}

class Fights : public ::testing::TestWithParam<std::string> {};

TEST_P(Fights, MonstersFindAndHurtAPlayerAndDieByItsShots) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs);
  game.join(0);
  game.run(1);
  const float yaw = take_a_stand(game);
  game.player(0).set(field::kHealth, 200);
  const math::Vec3 place = game.player(0)[field::kOrigin] + yaw_direction(yaw) * kOpenGround;
  const std::uint32_t monster = game.spawn(GetParam(), place, yaw + 180);

  EXPECT_LT(time_to_be_hurt(game, 30), 30);

  // Only explosions kill zombies.
  shoot_dead(game, monster, GetParam() == "monster_zombie" ? 7.0f : 3.0f, 60);
  EXPECT_EQ(game.global("killed_monsters"), 1);
  EXPECT_EQ(game.global("total_monsters"), 1);
  game.run(5);
  EXPECT_THAT(game.printed(), IsEmpty());
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST_P(Fights, MonstersIgnorePlayersWithNotarget) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs);
  game.join(0);
  game.run(1);
  const float yaw = take_a_stand(game);
  game.player(0).set_flag(server::flag::kNoTarget);
  const math::Vec3 place = game.player(0)[field::kOrigin] + yaw_direction(yaw) * kOpenGround;
  game.spawn(GetParam(), place, yaw + 180);
  EXPECT_GE(time_to_be_hurt(game, 15), 15);
  EXPECT_THAT(game.errors(), IsEmpty());
}

// The results of a minute in which the player walks back and forth and cannot die.
struct Fight {
  double first_hit_s = 60;
  float damage = 0;
  double longest_idle_s = 0;  // without moving or hitting
};

Fight fight_for_a_minute(PlayedLevel& io_game, std::uint32_t monster) {
  Fight fight;
  const server::Edict player = io_game.player(0);
  const double begin = io_game.time_s();
  double idle_since = begin;
  math::Vec3 place = io_game.edict(monster)[field::kOrigin];
  float taken = player[field::kDamageTaken];
  for (int tick = 0; io_game.time_s() < begin + 60; ++tick) {
    io_game.input(0).command.view_angles_deg = {0, static_cast<float>(tick % 720) * 0.5f, 0};
    io_game.input(0).command.forward = tick / 144 % 2 == 0 ? -100.0f : 100.0f;
    io_game.tick();
    const float hit = player[field::kDamageTaken] - std::exchange(taken, player[field::kDamageTaken]);
    const math::Vec3 at = io_game.edict(monster)[field::kOrigin];
    if (hit > 0 && fight.damage == 0) fight.first_hit_s = io_game.time_s() - begin;
    fight.damage += hit;
    if (hit > 0 || glm::length(at - place) > 8) {
      place = at;
      idle_since = io_game.time_s();
    }
    fight.longest_idle_s = std::max(fight.longest_idle_s, io_game.time_s() - idle_since);
  }
  return fight;
}

TEST_P(Fights, MonstersFightAtEverySkillWithoutStandingStill) {
  DATA_FOLDER_OR_SKIP(data);
  for (const int skill : {0, 1, 2, 3}) {
    if (kQuick && skill != 1) continue;
    SCOPED_TRACE(skill);
    PlayedLevel game(data, "lqdm1", kProgs, {.skill = skill});
    game.set("skill", std::to_string(skill));
    game.join(0);
    game.run(1);
    const float yaw = take_a_stand(game);
    game.player(0).set_flag(server::flag::kGodMode);
    const math::Vec3 place = game.player(0)[field::kOrigin] + yaw_direction(yaw) * kOpenGround;
    const Fight fight = fight_for_a_minute(game, game.spawn(GetParam(), place, yaw + 180));
    EXPECT_LT(fight.first_hit_s, 8);
    EXPECT_GT(fight.damage, 120);
    EXPECT_LT(fight.longest_idle_s, 6);
    EXPECT_THAT(game.errors(), IsEmpty());
  }
}

// The player is behind a door that does not open again: the monster searches for half a minute, then forgets
// it.
TEST(Hunts, MonstersForgetAPlayerWhoIsGone) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs);
  game.join(0);
  game.run(1);
  const float yaw = take_a_stand(game);
  game.player(0).set_flag(server::flag::kGodMode);
  const math::Vec3 here = game.player(0)[field::kOrigin];
  const std::uint32_t monster =
      game.spawn("monster_army", here + yaw_direction(yaw) * kOpenGround, yaw + 180);
  game.run(5);
  EXPECT_EQ(game.edict(monster)[field::kEnemy], game.player(0).index());
  game.player(0).set(field::kMoveType, static_cast<float>(server::MoveType::kNone));
  game.put(game.player(0), {8000, 8000, 8000});
  game.run(20);
  EXPECT_EQ(game.edict(monster)[field::kEnemy], game.player(0).index());
  game.run(20);
  EXPECT_EQ(game.edict(monster)[field::kEnemy], vm::kWorld);
  EXPECT_THAT(game.errors(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, Fights,
                         ::testing::Values("monster_army", "monster_dog", "monster_knight", "monster_ogre",
                                           "monster_wizard", "monster_enforcer", "monster_demon1",
                                           "monster_shambler", "monster_zombie", "monster_hell_knight",
                                           "monster_shalrath", "monster_tarbaby"),
                         [](const auto& kind) { return kind.param; });

TEST(Quarrels, AMonsterThatIsHitByAnotherKindTurnsAgainstIt) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs);
  game.join(0);
  game.run(1);
  const float yaw = take_a_stand(game);
  game.player(0).set_flag(server::flag::kNoTarget);
  const math::Vec3 here = game.player(0)[field::kOrigin];
  const std::uint32_t ogre = game.spawn("monster_ogre", here + yaw_direction(yaw) * kOpenGround, yaw);
  const std::uint32_t knight = game.spawn("monster_knight", here + yaw_direction(yaw) * 120.0f, yaw);
  game.run(2);
  game.hurt(ogre, knight, 10);
  game.run(0.2);
  EXPECT_EQ(game.edict(ogre)[field::kEnemy], game.edict(knight).index());
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
