// Levels of Half-Life with the game code of Quake: a player walks on the floor, through doors, and up stairs,
// and brush entities that the game code does not know are there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "game/played_level.h"
#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
namespace field = server::field;

constexpr math::Vec3d kMins(0, -128, 0), kMaxs(1024, 128, 256);
constexpr float kFeet = -24;  // below a player's origin

// A hall whose players start 36 units above the floor: the middle of Half-Life's players.
std::string half_life_hall(const std::string& brushes, const std::string& entities) {
  return entity_text("worldspawn", "", walls_text(kMins, kMaxs, "wall") + brushes) +
         point_text("info_player_start", {64, 0, 36}) + entities;
}

// A wall across the hall with an opening of this height, 64 units wide.
std::string door_frame(double x, double height) {
  return box_text({x, -128, 0}, {x + 16, -32, 256}, "wall") +
         box_text({x, 32, 0}, {x + 16, 128, 256}, "wall") +
         box_text({x, -32, height}, {x + 16, 32, 256}, "wall");
}

// Steps of 16 units, from x to x + 8 * 24, and a landing behind them.
std::string stairs(double x) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += box_text({x + 24 * i, -128, 0}, {x + 24 * (i + 1), 128, 16.0 * (i + 1)}, "wall");
  return text + box_text({x + 192, -128, 0}, {1024, 128, 128}, "wall");
}

// A box across the hall.
std::string barrier(std::string_view class_name, double x, std::string_view keys = {}) {
  return entity_text(class_name, keys, box_text({x, -128, 0}, {x + 16, 128, 64}, "wall"));
}

// Walks along x and returns the place at the end. Checks in each tick that the player is neither stuck nor
// below the floor.
math::Vec3 walk(PlayedLevel& game, double seconds) {
  game.join(0);
  game.run(2);
  game.input(0).command.forward = 320;
  for (const double end = game.time_s() + seconds; game.time_s() < end;) {
    game.tick();
    EXPECT_GE(game.player(0)[field::kOrigin].z + kFeet, -0.05f);
  }
  EXPECT_THAT(game.errors(), IsEmpty());
  return game.player(0)[field::kOrigin];
}

math::Vec3 walk_in(const std::string& brushes, const std::string& entities = {},
                   LevelFor level_for = LevelFor::kHalfLife) {
  const RoomData room(half_life_hall(brushes, entities), HasTremor::kYes, level_for);
  PlayedLevel game(room.path(), "room", kProgs);
  return walk(game, 6);
}

constexpr float kWallReached = 1024 - 16 - 1;

TEST(HalfLifeLevel, FeetAreOnTheFloor) {
  const math::Vec3 end = walk_in("");
  EXPECT_NEAR(end.z + kFeet, 0, 0.1);
  EXPECT_GT(end.x, kWallReached);
}

// 72 units is the height of Half-Life's standing player, whose hull Quake's player gets. A player keeps a
// small distance from the floor, so a door of exactly that height is closed in Half-Life, too.
TEST(HalfLifeLevel, PlayersPassDoorsThatAreMadeForHalfLife) {
  EXPECT_GT(walk_in(door_frame(512, 73)).x, kWallReached);
  EXPECT_NEAR(walk_in(door_frame(512, 71)).x, 512 - 16, 1);
  EXPECT_GT(walk_in(door_frame(512, 71), {}, LevelFor::kQuake).x, kWallReached) << "Quake's hull is lower";
}

TEST(HalfLifeLevel, PlayersClimbStairs) {
  const math::Vec3 end = walk_in(stairs(512));
  EXPECT_GT(end.x, kWallReached);
  EXPECT_NEAR(end.z + kFeet, 128, 0.1);
}

TEST(HalfLifeLevel, BrushEntitiesOfUnknownClassesBlock) {
  for (const char* name :
       {"func_breakable", "func_rotating", "func_pushable", "momentary_door", "button_target"})
    EXPECT_NEAR(walk_in("", barrier(name, 512)).x, 512 - 16, 1) << name;
}

TEST(HalfLifeLevel, LaddersVolumesAndDoorsThatTurnDoNotBlock) {
  for (const char* name :
       {"func_ladder", "func_door_rotating", "func_water", "env_bubbles", "func_monsterclip"})
    EXPECT_GT(walk_in("", barrier(name, 512)).x, kWallReached) << name;
}

// A ledge of 160 units with a ladder in front of it.
std::string ledge() {
  return box_text({512, -128, 0}, {1024, 128, 160}, "wall");
}
std::string ladder() {
  return entity_text("func_ladder", {}, box_text({496, -32, 0}, {512, 32, 160}, "wall"));
}

TEST(HalfLifeLevel, PlayersClimbLadders) {
  EXPECT_NEAR(walk_in(ledge()).x, 512 - 16, 1);
  const math::Vec3 end = walk_in(ledge(), ladder());
  EXPECT_GT(end.x, kWallReached);
  EXPECT_NEAR(end.z + kFeet, 160, 0.1);
}

TEST(HalfLifeLevel, PlayersRestOnLaddersAndComeDown) {
  const RoomData room(half_life_hall(ledge(), ladder()), HasTremor::kYes, LevelFor::kHalfLife);
  PlayedLevel game(room.path(), "room", kProgs);
  game.join(0);
  game.run(2);
  const auto feet = [&] { return game.player(0)[field::kOrigin].z + kFeet; };
  game.input(0).command.forward = 320;
  while (feet() < 80 && game.time_s() < 20) game.tick();
  game.input(0).command.forward = 0;
  game.run(0.1);
  const float height = feet();
  game.run(2);
  EXPECT_NEAR(feet(), height, 0.1) << "it holds on";
  game.input(0).command.forward = -320;
  game.run(0.2);
  EXPECT_NEAR(feet(), height - 0.2 * 200, 5);
  game.run(2);
  EXPECT_NEAR(feet(), 0, 0.1);
  EXPECT_LT(game.player(0)[field::kOrigin].x, 450) << "walks away";
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(HalfLifeLevel, PlayersJumpOffLadders) {
  const RoomData room(half_life_hall(ledge(), ladder()), HasTremor::kYes, LevelFor::kHalfLife);
  PlayedLevel game(room.path(), "room", kProgs);
  game.join(0);
  game.run(2);
  game.input(0).command.forward = 320;
  while (game.player(0)[field::kOrigin].z + kFeet < 80 && game.time_s() < 20) game.tick();
  game.input(0).command.forward = 0;
  game.input(0).buttons = kJump;
  game.run(1);
  EXPECT_NEAR(game.player(0)[field::kOrigin].z + kFeet, 0, 0.1);
  EXPECT_LT(game.player(0)[field::kOrigin].x, 440);
}

// A passage of this height behind x = 512, and an input that crouches.
std::string low_passage(double height) {
  return box_text({512, -128, height}, {1024, 128, 256}, "wall");
}
constexpr float kDown = -200;

TEST(HalfLifeLevel, PlayersCrouchThroughLowPassages) {
  const RoomData room(half_life_hall(low_passage(37), ""), HasTremor::kYes, LevelFor::kHalfLife);
  PlayedLevel game(room.path(), "room", kProgs);
  EXPECT_NEAR(walk(game, 6).x, 512 - 16, 1) << "standing";
  game.input(0).command.up = kDown;
  game.run(0.1);
  const float eyes = game.player(0)[field::kViewOffset].z;
  EXPECT_GT(eyes, 6) << "the eyes move";
  EXPECT_LT(eyes, 22);
  game.run(8);
  const math::Vec3 end = game.player(0)[field::kOrigin];
  EXPECT_GT(end.x, kWallReached);
  EXPECT_NEAR(end.z + kFeet, 0, 0.1);
  EXPECT_EQ(game.player(0)[field::kViewOffset].z, 6);
  // It cannot stand up under the ceiling.
  game.input(0).command = {};
  game.run(1);
  EXPECT_EQ(game.player(0)[field::kMaxs].z, 12);
  game.input(0).command.forward = -320;
  game.run(10);
  EXPECT_LT(game.player(0)[field::kOrigin].x, 400);
  EXPECT_EQ(game.player(0)[field::kMaxs].z, 32);
  EXPECT_EQ(game.player(0)[field::kViewOffset].z, 22);
  EXPECT_THAT(game.errors(), IsEmpty());
}

TEST(HalfLifeLevel, CrouchingPlayersWalkSlowly) {
  const RoomData room(half_life_hall("", ""), HasTremor::kYes, LevelFor::kHalfLife);
  PlayedLevel game(room.path(), "room", kProgs);
  game.join(0);
  game.run(2);
  game.input(0).command.forward = 300;
  game.input(0).command.up = kDown;
  game.run(1);
  EXPECT_NEAR(game.player(0)[field::kVelocity].x, 100, 1);
}

TEST(HalfLifeLevel, NobodyCrouchesInQuakesLevels) {
  const RoomData room(half_life_hall(low_passage(57), ""), HasTremor::kYes, LevelFor::kQuake);
  PlayedLevel game(room.path(), "room", kProgs);
  game.join(0);
  game.input(0).command.up = kDown;
  game.run(2);
  EXPECT_EQ(game.player(0)[field::kMaxs].z, 32);
  EXPECT_EQ(game.player(0)[field::kViewOffset].z, 22);
}

// A pool across the hall from x = 256 to 768, 128 units deep, of a brush entity.
std::string pool(std::string_view keys, std::string_view texture) {
  return entity_text("func_water", keys, box_text({256, -128, 0}, {768, 128, 128}, texture));
}

// Walks into the pool.
void enter_pool(PlayedLevel& game) {
  game.join(0);
  game.run(2);
  game.input(0).command.forward = 320;
  game.run(2);
}

TEST(HalfLifeLevel, PlayersSwimInWaterEntities) {
  for (const char* const texture : {"*water", "wall"}) {
    const RoomData room(half_life_hall("", pool(R"("skin" "-3")", texture)), HasTremor::kYes,
                        LevelFor::kHalfLife);
    PlayedLevel game(room.path(), "room", kProgs);
    enter_pool(game);
    EXPECT_EQ(game.player(0)[field::kWaterLevel], 3) << texture;
    EXPECT_EQ(game.player(0)[field::kWaterType], -3);
    game.input(0).command = {};
    game.input(0).buttons = kJump;
    game.run(2);
    EXPECT_NEAR(game.player(0)[field::kOrigin].z, 128, 12) << "swims up to the surface";
    EXPECT_THAT(game.errors(), IsEmpty());
  }
}

// How deep a player stands in the pool before and after it is triggered.
struct Depths {
  float before, after;
};
Depths find_depths(std::string_view keys, LevelFor level_for = LevelFor::kHalfLife) {
  const RoomData room(half_life_hall("", pool(keys, "wall")), HasTremor::kYes, level_for);
  PlayedLevel game(room.path(), "room", kProgs);
  enter_pool(game);
  game.input(0).command = {};
  game.run(1);
  Depths depths{};
  depths.before = game.player(0)[field::kWaterLevel];
  const auto water = game.of_class("func_water");
  EXPECT_EQ(water.size(), 1u);
  game.use(water.at(0), 1);
  game.run(4);
  depths.after = game.player(0)[field::kWaterLevel];
  EXPECT_THAT(game.errors(), IsEmpty());
  return depths;
}

TEST(HalfLifeLevel, WaterEntitiesMoveLikeDoorsWhenTriggered) {
  const Depths rises = find_depths(R"("targetname" "sea" "angles" "-90 0 0" "wait" "-1")");
  EXPECT_EQ(rises.before, 3);
  EXPECT_EQ(rises.after, 0) << "now above the player";
  const Depths falls = find_depths(R"("angles" "90 0 0" "wait" "-1" "lip" "40")");
  EXPECT_EQ(falls.after, 2) << "40 of 128 units are left";
  const Depths starts_open = find_depths(R"("angles" "-90 0 0" "wait" "-1" "spawnflags" "1")");
  EXPECT_EQ(starts_open.before, 0);
  EXPECT_EQ(starts_open.after, 3);
  const Depths returns = find_depths(R"("angles" "-90 0 0" "wait" "0.5" "speed" "400")");
  EXPECT_EQ(returns.after, 3) << "back again";
}

TEST(HalfLifeLevel, SkinsOfWaterEntitiesAreLiquids) {
  const auto find_type = [](std::string_view keys, LevelFor level_for = LevelFor::kHalfLife) {
    const RoomData room(half_life_hall("", pool(keys, "wall")), HasTremor::kYes, level_for);
    PlayedLevel game(room.path(), "room", kProgs);
    enter_pool(game);
    return game.player(0)[field::kWaterType];
  };
  EXPECT_EQ(find_type(R"("skin" "-4")"), -4);
  EXPECT_EQ(find_type(R"("skin" "-5")"), -5);
  EXPECT_EQ(find_type(""), -3) << "water is the default";
  EXPECT_EQ(find_type(R"("skin" "-3" "origin" "0 0 512")"), -1) << "high above";
  EXPECT_EQ(find_type(R"("skin" "-3")", LevelFor::kQuake), -1);
}

// The opacity that entities of a class get from their keys; 0 is the default.
float find_alpha(std::string_view class_name, std::string_view keys,
                 LevelFor level_for = LevelFor::kHalfLife) {
  const RoomData room(half_life_hall("", barrier(class_name, 512, keys)), HasTremor::kYes, level_for);
  PlayedLevel game(room.path(), "room", kProgs);
  return game.edict_number(game.of_class(class_name).at(0), "alpha");
}

TEST(HalfLifeLevel, RenderModesBecomeOpacities) {
  constexpr std::string_view kGlass = R"("rendermode" "2" "renderamt" "102")";
  for (const char* name : {"func_wall", "func_breakable", "func_water"})
    EXPECT_FLOAT_EQ(find_alpha(name, kGlass), 0.4f) << name;
  EXPECT_FLOAT_EQ(find_alpha("func_wall", R"("rendermode" "5" "renderamt" "255")"), 1);
  EXPECT_LT(find_alpha("func_wall", R"("rendermode" "2")"), 0) << "invisible";
  EXPECT_EQ(find_alpha("func_wall", R"("rendermode" "4" "renderamt" "9")"), 0) << "holes only";
  EXPECT_EQ(find_alpha("func_wall", R"("rendermode" "x" "renderamt" "9")"), 0);
  EXPECT_EQ(find_alpha("func_wall", R"("renderamt" "9")"), 0);
  EXPECT_EQ(find_alpha("func_wall", kGlass, LevelFor::kQuake), 0);
}

// The bit 256 of Quake leaves an entity out on easy; for Half-Life's doors it means something else.
TEST(HalfLifeLevel, SpawnFlagsDoNotExcludeSkills) {
  const std::string wall = barrier("func_wall", 512, "\"spawnflags\" \"1792\"");
  EXPECT_NEAR(walk_in("", wall).x, 512 - 16, 1);
  EXPECT_GT(walk_in("", wall, LevelFor::kQuake).x, kWallReached);
}

TEST(HalfLifeLevel, UnknownClassesStayLeftOutOfQuakesLevels) {
  EXPECT_GT(walk_in("", barrier("func_pushable", 512), LevelFor::kQuake).x, kWallReached);
}

}  // namespace
}  // namespace temblor::test
