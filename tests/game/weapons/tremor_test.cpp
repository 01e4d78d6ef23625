// The Tremor: where its wave goes, and its effects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace field = server::field;

constexpr float kTremorItem = 128, kThunderbolt = 64, kAxe = 4096;
constexpr float kTremorImpulse = 13;

// Two players in a hall of 1200 units; the first strikes the ground in the direction of the second.
class Tremor : public ::testing::Test {
 protected:
  void begin(const std::string& brushes = {}, double floor = 0, HasTremor has_tremor = HasTremor::kYes) {
    data_ = std::make_unique<RoomData>(hall_text({0, -256, floor}, {1200, 256, 256}, brushes), has_tremor);
    game_ = std::make_unique<PlayedLevel>(
        data_->path(), "room", kProgs,
        PlayedSettings{.skill = 1, .kind = server::GameKind::kDeathmatch, .players = 2});
    game_->join(0);
    game_->join(1);
    game_->put(game_->player(0), {64, 0, 25});
    server::Edict striker = game_->player(0);
    striker.set(field::kItems, kTremorItem + kAxe);
    striker.set(field::kAmmoCells, 50);
    striker.set(field::kImpulse, kTremorImpulse);
    game_->run(1);
  }

  void stand_victim_at(const math::Vec3& origin) {
    victim().set(field::kVelocity, math::Vec3(0.0f));
    victim().set(field::kHealth, 200);
    game_->put(victim(), origin);
    game_->run(0.3);
  }

  // The health that one blow takes from the victim; also records how high it is thrown.
  float strike() {
    const float before = victim()[field::kHealth], floor = victim()[field::kOrigin].z;
    highest_ = 0;
    game_->input(0).command.view_angles_deg = {};
    game_->input(0).buttons = kAttack;
    for (const double end = game_->time_s() + 2; game_->time_s() < end;) {
      game_->tick();
      if (game_->time_s() > end - 1.7) game_->input(0).buttons = 0;
      highest_ = std::max(highest_, victim()[field::kOrigin].z - floor);
    }
    return before - victim()[field::kHealth];
  }

  server::Edict victim() { return game_->player(1); }

  std::unique_ptr<RoomData> data_;
  std::unique_ptr<PlayedLevel> game_;
  float highest_ = 0;
};

TEST_F(Tremor, HurtsOnceAndThrowsItsVictimUpward) {
  begin();
  stand_victim_at({200, 0, 25});
  const float near = strike();
  // 90 at its start, 30 after 640 units.
  EXPECT_NEAR(near, 90 - 60 * 136 / 640.0f, 6);
  EXPECT_GT(highest_, 32);
  EXPECT_EQ(game_->player(0)[field::kAmmoCells], 45);
  EXPECT_EQ(game_->player(0)[field::kHealth], 100);

  stand_victim_at({600, 0, 25});
  const float far = strike();
  EXPECT_GT(far, 25);
  EXPECT_LT(far, near - 20);
  EXPECT_GT(highest_, 8);
  EXPECT_THAT(game_->errors(), IsEmpty());
  EXPECT_THAT(game_->of_class("tremor_wave"), IsEmpty());
}

TEST_F(Tremor, EndsAfterItsReachAndIsNarrow) {
  begin();
  stand_victim_at({800, 0, 25});
  EXPECT_EQ(strike(), 0);
  stand_victim_at({300, 120, 25});
  EXPECT_EQ(strike(), 0);
  stand_victim_at({300, 60, 25});
  EXPECT_GT(strike(), 0);
}

TEST_F(Tremor, ClimbsStepsAndFallsOffALowLedge) {
  std::string steps;
  for (int i = 0; i < 3; ++i)
    steps += box_text({200.0 + 32 * i, -256, 0}, {450, 256, 18.0 * (i + 1)}, "wall");
  begin(steps);
  stand_victim_at({400, 0, 79});
  EXPECT_GT(strike(), 40);
  stand_victim_at({550, 0, 25});  // 54 units lower
  EXPECT_GT(strike(), 30);
}

TEST_F(Tremor, IsStoppedByAWallTooHighToStepOn) {
  begin(box_text({200, -256, 0}, {216, 256, 40}, "wall"));
  stand_victim_at({300, 0, 25});
  EXPECT_EQ(strike(), 0);
}

TEST_F(Tremor, IsStoppedByADeepDrop) {
  begin(
      box_text({0, -256, -128}, {300, 256, 0}, "wall") + box_text({500, -256, -128}, {1200, 256, 0}, "wall"),
      -128);
  stand_victim_at({400, 0, -103});
  EXPECT_EQ(strike(), 0);
  stand_victim_at({550, 0, 25});
  EXPECT_EQ(strike(), 0);
}

TEST_F(Tremor, PassesUnderPlayersInTheAir) {
  begin();
  stand_victim_at({250, 0, 25});
  game_->input(1).buttons = kJump;
  game_->input(0).buttons = kAttack;
  // The blow lands after 0.2 s and runs for 0.3 s: the victim jumps in between, and is up for 0.67 s.
  game_->input(1).buttons = 0;
  game_->run(0.3);
  game_->input(1).buttons = kJump;
  game_->input(0).buttons = 0;
  game_->run(1.5);
  EXPECT_EQ(victim()[field::kHealth], 200);
}

TEST_F(Tremor, IgnoresFliersAndThrowsWalkers) {
  begin();
  // There are no monsters in a deathmatch, but this rule applies to both.
  game_ = std::make_unique<PlayedLevel>(data_->path(), "room", kProgs);
  game_->join(0);
  game_->run(0.5);
  server::Edict striker = game_->player(0);
  striker.set_flag(server::flag::kNoTarget);
  striker.set(field::kItems, kTremorItem + kAxe);
  striker.set(field::kAmmoCells, 50);
  striker.set(field::kImpulse, kTremorImpulse);
  const std::uint32_t flyer = game_->spawn("monster_wizard", {250, 0, 40}, 180);
  const std::uint32_t walker = game_->spawn("monster_ogre", {300, 0, 25}, 180);
  game_->run(1);
  game_->input(0).buttons = kAttack;
  game_->run(0.7);
  game_->input(0).buttons = 0;
  EXPECT_EQ(game_->edict(flyer)[field::kHealth], 80);
  EXPECT_LT(game_->edict(walker)[field::kHealth], 200 - 50);
  EXPECT_GT(game_->edict(walker)[field::kHealth], 200 - 90);
  game_->run(3);
  EXPECT_THAT(game_->errors(), IsEmpty());
}

TEST_F(Tremor, ShakesTheViewOfPlayersNearby) {
  begin();
  stand_victim_at({250, 100, 25});  // beside its path
  float shaken = 0;
  game_->input(0).buttons = kAttack;
  for (int i = 0; i < 72; ++i) {
    game_->tick();
    shaken = std::max(shaken, std::abs(victim()[field::kPunchAngle].x));
  }
  EXPECT_GT(shaken, 0.5f);
}

TEST_F(Tremor, IsNamedWhenItKills) {
  begin();
  stand_victim_at({200, 0, 25});
  victim().set(field::kHealth, 20);
  strike();
  EXPECT_THAT(game_->said(), HasSubstr("was shaken apart by "));
  EXPECT_EQ(game_->player(0)[field::kFrags], 1);
}

TEST_F(Tremor, SharesItsKeyWithTheThunderbolt) {
  begin();
  server::Edict player = game_->player(0);
  player.set(field::kItems, kTremorItem + kThunderbolt + kAxe);
  for (const float expected : {kThunderbolt, kTremorItem, kThunderbolt}) {
    player.set(field::kImpulse, 8);
    game_->run(0.2);
    EXPECT_EQ(player[field::kWeapon], expected);
  }
  player.set(field::kImpulse, 10);  // the weapon after lightning, and then the first one
  game_->run(0.2);
  EXPECT_EQ(player[field::kWeapon], kTremorItem);
  player.set(field::kImpulse, 10);
  game_->run(0.2);
  EXPECT_EQ(player[field::kWeapon], kAxe);
}

TEST_F(Tremor, CanBePickedUp) {
  begin();
  server::Edict player = game_->player(0);
  player.set(field::kItems, kAxe);
  player.set(field::kWeapon, kAxe);
  player.set(field::kAmmoCells, 0);
  game_->spawn("weapon_tremor", player[field::kOrigin], 0);
  game_->run(1);
  EXPECT_EQ(player[field::kWeapon], kTremorItem);
  EXPECT_EQ(player[field::kAmmoCells], 20);
  EXPECT_EQ(game_->text(player[field::kWeaponModel]), "progs/v_tremor.mdl");
}

TEST_F(Tremor, IsAThunderboltIfTheDataLacksIt) {
  begin({}, 0, HasTremor::kNo);
  server::Edict player = game_->player(0);
  EXPECT_EQ(player[field::kWeapon], 1) << "the weapon from the backpack cannot be used";
  game_->spawn("weapon_tremor", player[field::kOrigin], 0);
  game_->run(1);
  EXPECT_EQ(player[field::kWeapon], kThunderbolt);
  EXPECT_THAT(game_->errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
