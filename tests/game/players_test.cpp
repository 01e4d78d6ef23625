// Players: weapons, items, death, and the next level.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/played_level.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
namespace field = server::field;

struct Weapon {
  const char* name;
  float impulse;
  server::Field<float> ammo;
  float shots_in_2_s, ammo_of_shot;
};

// Stock Quake's seconds between shots: 0.5, 0.7, 0.1 (nails, lightning), 0.6 and 0.8.
const Weapon kWeapons[] = {
    {"shotgun", 2, field::kAmmoShells, 4, 1},           {"super shotgun", 3, field::kAmmoShells, 3, 2},
    {"nailgun", 4, field::kAmmoNails, 20, 1},           {"super nailgun", 5, field::kAmmoNails, 20, 2},
    {"grenade launcher", 6, field::kAmmoRockets, 4, 1}, {"rocket launcher", 7, field::kAmmoRockets, 3, 1},
    {"lightning gun", 8, field::kAmmoCells, 20, 1},
};

TEST(Players, ShootAtStockRatesAndUseAmmo) {
  DATA_FOLDER_OR_SKIP(data);
  for (const Weapon& weapon : kWeapons) {
    PlayedLevel game(data, "lqdm1", kProgs);
    game.join(0);
    const server::Edict player = game.player(0);
    player.set_flag(server::flag::kGodMode);
    player.set(field::kItems, 127 + 4096);
    player.set(weapon.ammo, 100);
    player.set(field::kImpulse, weapon.impulse);
    game.run(0.5);
    game.input(0).buttons = kAttack;
    game.run(1.95);
    game.input(0).buttons = 0;
    game.run(0.5);
    EXPECT_NEAR(100 - player[weapon.ammo], weapon.shots_in_2_s * weapon.ammo_of_shot, 2 * weapon.ammo_of_shot)
        << weapon.name;
    game.run(10);  // until all shots have landed
    EXPECT_THAT(game.errors(), IsEmpty());
    EXPECT_THAT(game.printed(), IsEmpty()) << weapon.name;
  }
}

TEST(Players, JumpAndLand) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs);
  game.join(0);
  game.run(1);
  const server::Edict player = game.player(0);
  const float floor = player[field::kOrigin][2];
  float highest = floor;
  game.input(0).buttons = kJump;
  for (int i = 0; i < 72; ++i) {
    game.tick();
    highest = std::max(highest, player[field::kOrigin][2]);
  }
  // 270^2 / (2 * 800), minus the effect of ticks of 1/72 s.
  EXPECT_NEAR(highest - floor, 45.6f, 3);
  EXPECT_NEAR(player[field::kOrigin][2], floor, 0.1f);
  // Holding the button down does not jump again.
  EXPECT_TRUE(player.has_flag(server::flag::kOnGround));
}

TEST(Players, TakeItems) {
  DATA_FOLDER_OR_SKIP(data);
  struct Case {
    const char* item;
    server::Field<float> field;
    float before, after;
  };
  for (const Case& test : {Case{"item_shells", field::kAmmoShells, 25, 45},
                           {"item_spikes", field::kAmmoNails, 0, 25},
                           {"item_rockets", field::kAmmoRockets, 0, 5},
                           {"item_cells", field::kAmmoCells, 0, 6},
                           {"item_shells", field::kAmmoShells, 95, 100},
                           {"item_health", field::kHealth, 50, 75},
                           {"item_health", field::kHealth, 90, 100},
                           {"item_armor1", field::kArmorValue, 0, 100},
                           {"item_armor2", field::kArmorValue, 10, 150},
                           {"item_armorInv", field::kArmorValue, 50, 200},
                           {"weapon_rocketlauncher", field::kAmmoRockets, 0, 5},
                           {"weapon_nailgun", field::kWeapon, 1, 4}}) {
    PlayedLevel game(data, "start", kProgs);
    game.join(0);
    const server::Edict player = game.player(0);
    player.set(test.field, test.before);
    const std::uint32_t item = game.spawn(test.item, player[field::kOrigin], 0);
    game.run(1);
    EXPECT_EQ(player[test.field], test.after) << test.item;
    EXPECT_EQ(game.edict(item)[field::kModelIndex], 0) << test.item;
    EXPECT_THAT(game.errors(), IsEmpty());
  }
}

// Each player gets every weapon and key once.
TEST(Players, FindWeaponsAndKeysOfTheirOwnInCoop) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs, {.kind = server::GameKind::kCooperative, .players = 2});
  game.join(0);
  game.join(1);
  const std::uint32_t weapon = game.spawn("weapon_nailgun", game.player(0)[field::kOrigin], 0);
  const std::uint32_t key = game.spawn("item_key1", game.player(0)[field::kOrigin], 0);
  game.run(1);
  for (const std::uint32_t item : {weapon, key}) {
    EXPECT_EQ(game.edict(item).solid(), server::Solid::kTrigger);
    EXPECT_NE(game.edict(item)[field::kModelIndex], 0);
  }
  const float nails = game.player(0)[field::kAmmoNails];
  EXPECT_EQ(nails, 30);
  game.run(2);
  EXPECT_EQ(game.player(0)[field::kAmmoNails], nails);  // this player has it already
  game.put(game.player(1), game.player(0)[field::kOrigin]);
  game.run(1);
  EXPECT_EQ(game.player(1)[field::kAmmoNails], 30);
  EXPECT_EQ(game.player(1).whole(field::kItems) & (4 + 131072), 4 + 131072);
}

TEST(Players, LeaveItemsThatTheyDoNotNeed) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs);
  game.join(0);
  const server::Edict player = game.player(0);
  const std::uint32_t item = game.spawn("item_health", player[field::kOrigin], 0);
  game.run(1);
  EXPECT_EQ(player[field::kHealth], 100);
  EXPECT_NE(game.edict(item)[field::kModelIndex], 0);
}

TEST(Players, ArmorAbsorbsItsShare) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs);
  game.join(0);
  game.spawn("item_armor2", game.player(0)[field::kOrigin], 0);
  game.run(1);
  const std::uint32_t trap = game.spawn("trigger_hurt", {}, 0);
  game.hurt(1, trap, 50);
  // Yellow armor absorbs 0.6 of the damage.
  EXPECT_NEAR(game.player(0)[field::kHealth], 80, 1);
  EXPECT_NEAR(game.player(0)[field::kArmorValue], 120, 1);
  EXPECT_EQ(game.player(0)[field::kHealth] + game.player(0)[field::kArmorValue], 200);
}

TEST(Players, QuadHitsFourTimesAsHard) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs, {.kind = server::GameKind::kDeathmatch, .players = 2});
  game.join(0);
  game.join(1);
  game.run(0.5);
  game.player(0).set(field::kHealth, 100);
  game.hurt(1, 2, 10);
  EXPECT_EQ(game.player(0)[field::kHealth], 90);
  game.spawn("item_artifact_super_damage", game.player(1)[field::kOrigin], 0);
  game.run(1);
  game.player(0).set(field::kHealth, 100);
  game.hurt(1, 2, 10);
  EXPECT_EQ(game.player(0)[field::kHealth], 60);
  game.run(30);
  game.player(0).set(field::kHealth, 100);
  game.hurt(1, 2, 10);
  EXPECT_EQ(game.player(0)[field::kHealth], 90);
}

TEST(Players, DieAndRespawnInADeathmatch) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs, {.kind = server::GameKind::kDeathmatch, .players = 2});
  game.join(0);
  game.join(1);
  game.run(1);
  const server::Edict victim = game.player(0);
  game.hurt(1, 2, 110);
  EXPECT_LE(victim[field::kHealth], 0);
  EXPECT_EQ(game.player(1)[field::kFrags], 1);
  game.run(3);
  EXPECT_GT(victim[field::kDeadFlag], 0);
  game.input(0).buttons = kAttack;
  game.run(0.5);
  EXPECT_EQ(victim[field::kDeadFlag], 0);
  EXPECT_EQ(victim[field::kHealth], 100);
  EXPECT_THAT(game.of_class("backpack"), ::testing::SizeIs(1));
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Players, RestartTheLevelWhenTheyDieInSinglePlayer) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "start", kProgs);
  game.join(0);
  game.run(0.5);
  game.hurt(1, 0, 500);
  game.run(2);
  EXPECT_EQ(game.commands(), "");
  game.input(0).buttons = kAttack;
  game.run(2);
  EXPECT_EQ(game.commands(), "restart\n");
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(Players, SeeObituaries) {
  DATA_FOLDER_OR_SKIP(data);
  const auto last_words = [&](auto kill) {
    PlayedLevel game(data, "start", kProgs);
    game.join(0);
    game.run(0.5);
    const std::size_t before = game.said().size();
    kill(game);
    game.tick();
    return game.said().substr(before);
  };
  const std::vector<const char*> killers = {
      "monster_army",   "monster_demon1",  "monster_dog",      "monster_enforcer", "monster_fish",
      "monster_ogre",   "monster_knight",  "monster_shambler", "monster_shalrath", "monster_hell_knight",
      "monster_zombie", "monster_tarbaby", "monster_wizard",   "misc_explobox",    "trap_spikeshooter",
      "trap_shooter",   "trigger_hurt"};
  for (const char* name : killers)
    EXPECT_THAT(last_words([&](PlayedLevel& game) {
                  const math::Vec3 place = game.player(0)[field::kOrigin] + math::Vec3(0, 0, 64);
                  game.hurt(1, game.spawn(name, place, 0), 500);
                }),
                AllOf(HasSubstr("\n"), Not(HasSubstr(" died"))))
        << name;
  EXPECT_THAT(last_words([](PlayedLevel& game) { game.hurt(1, 1, 500); }),
              HasSubstr(" got too close to the blast"));
  EXPECT_THAT(last_words([](PlayedLevel& game) {
                game.player(0).set(field::kWaterLevel, 3.0f);
                game.player(0).set(field::kWaterType, -5.0f);
                game.hurt(1, 0, 500);
              }),
              HasSubstr(" fell into the lava"));
}

TEST(Players, SeeCorrectSingularsAndPlurals) {
  DATA_FOLDER_OR_SKIP(data);
  for (const float frags : {0.0f, 1.0f, 2.0f}) {
    PlayedLevel game(data, "lqdm1", kProgs, {.kind = server::GameKind::kDeathmatch, .players = 2});
    game.join(0);
    game.run(0.2);
    game.player(0).set(field::kFrags, frags);
    game.call_function("ClientDisconnect", vm::EntityIndex{1});
    game.tick();
    EXPECT_THAT(game.said(), HasSubstr(frags == 1 ? " frag\n" : " frags\n")) << frags;
  }
}

// QuakeSpasm ends with an error if anything but a player walks.
TEST(Players, LeaveABodyThatDoesNotWalk) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lqdm1", kProgs, {.kind = server::GameKind::kDeathmatch, .players = 2});
  game.join(0);
  game.run(0.2);
  game.call_function("ClientDisconnect", vm::EntityIndex{1});
  for (std::uint32_t i = 3; i < game.edict_count(); ++i)
    EXPECT_TRUE(game.is_free(i) || game.edict(i).move_type() != server::MoveType::kWalk) << i;
}

TEST(Players, LeaveThroughTheExitAndKeepTheirItems) {
  DATA_FOLDER_OR_SKIP(data);
  PlayedLevel game(data, "lq_e0m1", kProgs);
  game.join(0);
  game.run(0.5);
  const server::Edict player = game.player(0);
  player.set(field::kItems, 1 + 4 + 4096 + 131072);  // shotgun, nailgun, axe and a key
  player.set(field::kAmmoNails, 77);
  player.set(field::kHealth, 30);
  const std::uint32_t exit = game.of_class("trigger_changelevel").at(0);
  game.put(player, (game.edict(exit)[field::kAbsMin] + game.edict(exit)[field::kAbsMax]) * 0.5f);
  game.run(1);
  EXPECT_EQ(game.global("intermission_running"), 1);
  EXPECT_EQ(game.change_level(), std::nullopt);  // the intermission comes first
  game.run(2);
  game.input(0).buttons = kAttack;
  game.run(0.5);
  EXPECT_EQ(game.change_level(), "lq_e0m2");
  game.call_function("SetChangeParms", player.index());
  EXPECT_EQ(game.global("parm1"), 1 + 4 + 4096);  // keys are not carried
  EXPECT_EQ(game.global("parm2"), 50);            // at least 50 health
  EXPECT_EQ(game.global("parm5"), 77);
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
