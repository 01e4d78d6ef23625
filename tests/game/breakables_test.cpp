// func_breakable: what breaks it, and what happens then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
namespace field = server::field;

constexpr std::uint8_t kShotgun = 2, kRocketLauncher = 7, kTremor = 13;

// A pane across the hall, and a wall whose frame shows whether it was used.
class Breakables : public ::testing::Test {
 protected:
  void begin(const std::string& keys) {
    const std::string entities = entity_text("func_breakable", "\"target\" \"witness\"\n" + keys,
                                             box_text({300, -128, 0}, {308, 128, 128}, "wall")) +
                                 entity_text("func_wall", "\"targetname\" \"witness\"",
                                             box_text({580, 100, 0}, {590, 110, 10}, "wall"));
    data_ = std::make_unique<RoomData>(hall_text({0, -128, 0}, {600, 128, 128}, {}, entities));
    game_ = std::make_unique<PlayedLevel>(data_->path(), "room", kProgs);
    game_->join(0);
    game_->put(game_->player(0), {150, 0, 25});
    const server::Edict player = game_->player(0);
    player.set_flag(server::flag::kGodMode);
    player.set(field::kItems, 255 + 4096);
    for (const auto ammo : {field::kAmmoShells, field::kAmmoRockets, field::kAmmoCells})
      player.set(ammo, 100);
    game_->run(0.5);
  }

  void shoot(std::uint8_t impulse, double seconds = 0.3) {
    game_->player(0).set(field::kImpulse, impulse);
    game_->run(0.2);
    game_->input(0).command.view_angles_deg = {};
    game_->input(0).buttons = kAttack;
    game_->run(seconds);
    game_->input(0).buttons = 0;
    game_->run(1.2);
  }

  bool was_used() { return game_->edict(game_->of_class("func_wall").at(0))[field::kFrame] == 1; }
  bool is_whole() {
    const auto panes = game_->of_class("func_breakable");
    return !panes.empty() && game_->edict(panes[0]).solid() == server::Solid::kBsp;
  }

  std::unique_ptr<RoomData> data_;
  std::unique_ptr<PlayedLevel> game_;
};

TEST_F(Breakables, BreakWhenShotFireTheirTargetsAndLeavePieces) {
  begin("\"health\" \"20\"\n\"material\" \"glass\"");
  EXPECT_TRUE(is_whole());
  EXPECT_FALSE(was_used());
  shoot(kShotgun);  // 24 points of damage
  EXPECT_THAT(game_->of_class("func_breakable"), IsEmpty());
  EXPECT_TRUE(was_used());
  ASSERT_THAT(game_->of_class("debris"), Not(IsEmpty()));
  EXPECT_EQ(game_->edict(game_->of_class("debris")[0])[field::kSkin], 2);
  game_->run(5);
  EXPECT_THAT(game_->of_class("debris"), IsEmpty());
  EXPECT_THAT(game_->errors(), IsEmpty());
  EXPECT_THAT(game_->printed(), IsEmpty());
}

TEST_F(Breakables, WithstandDamageUpToTheirHealth) {
  begin("\"health\" \"60\"");
  shoot(kShotgun);
  EXPECT_TRUE(is_whole());
  shoot(kShotgun);
  shoot(kShotgun);
  EXPECT_FALSE(is_whole());
}

TEST_F(Breakables, BreakByExplosionsAndTheTremor) {
  for (const std::uint8_t weapon : {kRocketLauncher, kTremor}) {
    begin("\"health\" \"50\"\n\"material\" \"wood\"");
    shoot(weapon);
    EXPECT_FALSE(is_whole()) << int{weapon};
    EXPECT_TRUE(was_used());
  }
}

TEST_F(Breakables, SomeBreakByStrongDamageOnly) {
  begin("\"health\" \"30\"\n\"spawnflags\" \"1\"");
  for (int i = 0; i < 4; ++i) shoot(kShotgun);
  EXPECT_TRUE(is_whole());
  shoot(kRocketLauncher);
  EXPECT_FALSE(is_whole());
}

TEST_F(Breakables, BreakWhenUsed) {
  begin("\"targetname\" \"pane\"");
  game_->use(game_->of_class("func_breakable").at(0), 1);
  EXPECT_TRUE(was_used());
  EXPECT_THAT(game_->of_class("func_breakable"), IsEmpty());
}

TEST_F(Breakables, ReappearAfterTheirWaitOnceNobodyStandsThere) {
  begin("\"wait\" \"4\"");
  shoot(kShotgun);
  EXPECT_FALSE(is_whole());
  game_->put(game_->player(0), {304, 0, 25});
  game_->run(6);
  EXPECT_FALSE(is_whole());
  game_->put(game_->player(0), {150, 0, 25});
  game_->run(2);
  EXPECT_TRUE(is_whole());
  shoot(kShotgun);
  EXPECT_FALSE(is_whole());
}

TEST_F(Breakables, AnUnknownMaterialIsReported) {
  begin("\"material\" \"cheese\"");
  EXPECT_THAT(game_->printed(), HasSubstr("cheese"));
  EXPECT_THAT(game_->of_class("func_breakable"), SizeIs(1));
}

}  // namespace
}  // namespace temblor::test
