// The way in which a monster dies shows the weapon that killed it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

struct Dying {
  double held_s = 0;  // by which it dies more slowly than its frames take
  float thrown = 0;   // units away from the player
  float highest = 0;  // units above the place where it died
  float turned_deg = 0;
  float last_frame = 0;
  int glows = 0;  // number of times that it lit up
};

// A player kills a monster that stands 64 units before it with one weapon; the last blow leaves it in one
// piece.
class MonsterDeaths : public ::testing::TestWithParam<std::string> {
 protected:
  static constexpr std::uint8_t kAxe = 1, kShotgun = 2, kNailgun = 4, kRockets = 7, kThunderbolt = 8;

  Dying kill_with(std::uint8_t weapon_impulse, float monster_yaw_deg = 180) {
    const RoomData data(hall_text({-700, -700, 0}, {700, 700, 400}));
    PlayedLevel game(data.path(), "room", kProgs);
    game.join(0);
    game.run(1);
    const server::Edict player = game.player(0);
    player.set_flag(server::flag::kGodMode);
    player.set_flag(server::flag::kNoTarget);
    game.put(player, {-64, 0, 24.1f});
    const std::uint32_t monster = game.spawn(GetParam(), {0, 0, 30}, monster_yaw_deg);
    player.set(field::kItems, 127 + 4096);
    for (const auto ammo : {field::kAmmoShells, field::kAmmoNails, field::kAmmoRockets, field::kAmmoCells})
      player.set(ammo, 100);
    player.set(field::kImpulse, weapon_impulse);
    game.run(1);
    const server::Edict edict = game.edict(monster);
    edict.set(field::kHealth, weapon_impulse == kRockets ? 100.0f : 1.0f);
    game.input(0).command.view_angles_deg = {};
    game.input(0).buttons = kAttack;
    for (int tick = 0; tick < 72 && edict[field::kHealth] > 0; ++tick) game.tick();
    game.input(0).buttons = 0;
    EXPECT_LE(edict[field::kHealth], 0);
    const Dying dying = watch(game, monster);
    EXPECT_THAT(game.errors(), IsEmpty());
    return dying;
  }

 private:
  static Dying watch(PlayedLevel& io_game, std::uint32_t corpse_number) {
    const server::Edict corpse = io_game.edict(corpse_number);
    Dying dying;
    const math::Vec3 died_at = corpse[field::kOrigin];
    const float yaw = corpse[field::kAngles].y;
    const double begin_s = io_game.time_s();
    bool glowed = false;
    while (corpse[field::kNextThink] > 0 && io_game.time_s() < begin_s + 5) {
      io_game.tick();
      dying.highest = std::max(dying.highest, corpse[field::kOrigin].z - died_at.z);
      const bool glows = (static_cast<int>(corpse[field::kEffects]) & 8) != 0;
      dying.glows += glows && !std::exchange(glowed, glows) ? 1 : 0;
      glowed = glows;
    }
    const float frames = io_game.edict_number(corpse_number, "seq_last") -
                         io_game.edict_number(corpse_number, "seq_first") + 1;
    dying.held_s = io_game.time_s() - begin_s - 0.1 * frames;
    dying.last_frame = corpse[field::kFrame];
    io_game.run(1);
    dying.thrown = corpse[field::kOrigin].x - died_at.x;
    dying.turned_deg = std::abs(std::remainder(corpse[field::kAngles].y - yaw, 360.0f));
    EXPECT_EQ(corpse.solid(), server::Solid::kNot);
    EXPECT_EQ(static_cast<int>(corpse[field::kEffects]), 0);
    return dying;
  }
};

TEST_P(MonsterDeaths, ShowTheWeapon) {
  const Dying shot = kill_with(kShotgun), nailed = kill_with(kNailgun), cut = kill_with(kAxe),
              blasted = kill_with(kRockets), shocked = kill_with(kThunderbolt);
  EXPECT_GT(shot.thrown, 15);
  EXPECT_GT(shot.highest, 3);

  EXPECT_LT(std::abs(nailed.thrown), 1);
  EXPECT_NEAR(nailed.held_s, shot.held_s + 0.4, 0.15);

  EXPECT_LT(std::abs(cut.thrown), 1);
  EXPECT_GT(cut.turned_deg, 90);

  EXPECT_GT(blasted.thrown, 60);
  EXPECT_GT(blasted.highest, shot.highest + 10);

  EXPECT_LT(std::abs(shocked.thrown), 1);
  EXPECT_GE(shocked.glows, 3);
  EXPECT_NEAR(shocked.held_s, shot.held_s + 0.6, 0.15);
  for (const Dying& other : {shot, nailed, cut, blasted}) EXPECT_EQ(other.glows, 0);
}

TEST_P(MonsterDeaths, AShotFromBehindThrowsThemOntoTheirFaces) {
  const Dying from_front = kill_with(kShotgun, 180), from_behind = kill_with(kShotgun, 0);
  EXPECT_GT(from_behind.thrown, 15);
  EXPECT_NE(from_front.last_frame, from_behind.last_frame);
}

INSTANTIATE_TEST_SUITE_P(All, MonsterDeaths,
                         ::testing::Values("monster_army", "monster_dog", "monster_knight", "monster_ogre",
                                           "monster_enforcer", "monster_hell_knight"),
                         [](const auto& kind) { return kind.param; });

}  // namespace
}  // namespace temblor::test
