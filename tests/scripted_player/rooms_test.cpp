// The scripted player in small rooms. Each needs one skill that levels need.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "formats/game/dem.h"
#include "scripted_player/made_rooms.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using math::Vec3d;

// A hall of 1024 x 256 x 256 units along x, with its floor at 0. The player starts at its western end.
std::string hall(const std::string& brushes, const std::string& entities) {
  return entity_text("worldspawn", "", walls_text({0, 0, 0}, {1024, 256, 256}, "wall") + brushes) +
         entity_text("info_player_start", "\"origin\" \"64 128 32\"\n\"angle\" \"0\"") +
         entity_text("info_player_coop", "\"origin\" \"64 128 32\"") +
         entity_text("info_player_coop", "\"origin\" \"64 64 32\"") + entities;
}

std::string exit_at_end(float floor = 0) {
  return exit_text({960, 0, floor}, {1024, 256, floor + 96});
}

// A wall across the hall, with an opening of 96 x 112 units in its middle.
std::string wall_with_opening(double x) {
  return box_text({x, 0, 0}, {x + 16, 80, 256}, "wall") + box_text({x, 176, 0}, {x + 16, 256, 256}, "wall") +
         box_text({x, 80, 112}, {x + 16, 176, 256}, "wall");
}

std::string door(double x, std::string_view fields) {
  return entity_text("func_door", std::string("\"angle\" \"-1\"\n") + std::string(fields),
                     box_text({x, 80, 0}, {x + 16, 176, 112}, "door"));
}

TEST(PlayerInRooms, WalksToTheExit) {
  const player::RunReport report = MadeRooms(hall("", exit_at_end())).play();
  EXPECT_TRUE(report.reached_exit);
  EXPECT_EQ(report.exit, "elsewhere");
  EXPECT_LT(report.time_s, 8);
  EXPECT_THAT(report.problems, IsEmpty());
  EXPECT_THAT(report.errors, IsEmpty());
}

TEST(PlayerInRooms, ClimbsStairs) {
  std::string stairs;
  for (int i = 0; i < 8; ++i) stairs += box_text({300.0 + i * 24, 0, 0}, {1024, 256, 16.0 * (i + 1)}, "step");
  EXPECT_TRUE(MadeRooms(hall(stairs, exit_at_end(128))).play().reached_exit);
}

TEST(PlayerInRooms, GoesThroughADoorThatOpensAutomatically) {
  const player::RunReport report =
      MadeRooms(hall(wall_with_opening(500), door(500, "") + exit_at_end())).play();
  EXPECT_TRUE(report.reached_exit);
  EXPECT_THAT(report.closed_doors, IsEmpty());
}

std::string stop_text(const Vec3d& at, const std::string& fields) {
  return entity_text("info_notnull", fmt::format("\"origin\" \"{} {} {}\"\n", at.x, at.y, at.z) + fields);
}

// Both stops are away from the route to the exit. The player stays at the second one for three seconds.
TEST(PlayerInRooms, VisitsStopsInOrder) {
  const std::string stops = stop_text({900, 40, 24}, "\"targetname\" \"stop1\"") +
                            stop_text({80, 220, 24}, "\"targetname\" \"stop2\"\n\"wait\" \"3\"");
  const MadeRooms rooms(hall("", stops + exit_at_end()));
  player::RunSetup setup = rooms.setup();
  const double straight_s = player::play_level(setup).value().time_s;
  setup.visits_stops = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_TRUE(report.reached_exit);
  EXPECT_THAT(report.problems, IsEmpty());
  // There, back, and there again, at no more than 320 units/s.
  EXPECT_GT(report.time_s, straight_s + 3 + 1600 / 320);
}

// The hatch that the button opens leads nowhere, so only the stop is a reason to press it.
TEST(PlayerInRooms, PressesTheButtonOfAStop) {
  const std::string button =
      entity_text("func_button", "\"target\" \"hatch\"\n\"angle\" \"90\"\n\"wait\" \"-1\"",
                  box_text({500, 240, 16}, {532, 252, 80}, "button"));
  const std::string hatch = entity_text("func_door", "\"targetname\" \"hatch\"\n\"angle\" \"0\"",
                                        box_text({500, 100, 220}, {564, 132, 250}, "door"));
  const std::string stop = stop_text({300, 128, 24}, "\"targetname\" \"stop1\"\n\"target\" \"hatch\"");
  const MadeRooms rooms(hall("", button + hatch + stop + exit_at_end()));
  player::RunSetup setup = rooms.setup();
  EXPECT_THAT(player::play_level(setup).value().closed_doors, ElementsAre(HasSubstr("func_door")));
  setup.visits_stops = true;
  EXPECT_THAT(player::play_level(setup).value().closed_doors, IsEmpty());
}

TEST(PlayerInRooms, FetchesTheKeyFirst) {
  const std::string key = point_text("item_key1", {128, 32, 24});
  EXPECT_TRUE(
      MadeRooms(hall(wall_with_opening(500), door(500, "\"spawnflags\" \"16\"") + key + exit_at_end()))
          .play()
          .reached_exit);
}

TEST(PlayerInRooms, ReportsDoorsThatOnlyOpenEachOther) {
  const std::string other =
      entity_text("func_door", "\"targetname\" \"b\"\n\"target\" \"a\"\n\"angle\" \"-1\"",
                  box_text({200, 240, 0}, {232, 256, 96}, "door"));
  const player::RunReport report =
      MadeRooms(hall(wall_with_opening(500),
                     door(500, "\"targetname\" \"a\"\n\"target\" \"b\"") + other + exit_at_end()))
          .play();
  EXPECT_FALSE(report.reached_exit);
  EXPECT_THAT(report.problems, Contains(HasSubstr("targets \"a\"")));
}

// Links into the trigger must not have negative costs.
TEST(PlayerInRooms, PassesATriggerThatHeals) {
  const std::string spring =
      entity_text("trigger_hurt", "\"dmg\" \"-5\"", box_text({400, 0, 0}, {600, 256, 64}, "trigger"));
  EXPECT_TRUE(MadeRooms(hall("", spring + exit_at_end())).play().reached_exit);
}

TEST(PlayerInRooms, ReportsWhichKeyIsMissing) {
  const player::RunReport report =
      MadeRooms(hall(wall_with_opening(500), door(500, "\"spawnflags\" \"16\"") + exit_at_end())).play();
  EXPECT_FALSE(report.reached_exit);
  EXPECT_THAT(report.problems, Contains(HasSubstr("item_key1")));
  EXPECT_THAT(report.problems, Contains(HasSubstr("blocked by func_door")));
  EXPECT_THAT(report.closed_doors, ElementsAre(HasSubstr("func_door")));
}

TEST(PlayerInRooms, ReportsADoorThatNothingTargets) {
  const player::RunReport report =
      MadeRooms(hall(wall_with_opening(500), door(500, "\"targetname\" \"gate\"") + exit_at_end())).play();
  EXPECT_FALSE(report.reached_exit);
  EXPECT_THAT(report.problems, Contains(HasSubstr("targets \"gate\"")));
}

TEST(PlayerInRooms, PressesTheButtonThatOpensADoor) {
  const std::string button = entity_text("func_button", "\"angle\" \"90\"\n\"target\" \"gate\"",
                                         box_text({200, 248, 32}, {232, 256, 64}, "button"));
  EXPECT_TRUE(MadeRooms(hall(wall_with_opening(500),
                             door(500, "\"targetname\" \"gate\"\n\"wait\" \"-1\"") + button + exit_at_end()))
                  .play()
                  .reached_exit);
}

TEST(PlayerInRooms, ShootsAButtonThroughARelay) {
  const std::string button =
      entity_text("func_button", "\"angle\" \"90\"\n\"target\" \"hand_on\"\n\"health\" \"1\"",
                  box_text({200, 248, 180}, {232, 256, 212}, "button"));
  const std::string relay = entity_text(
      "trigger_relay", "\"origin\" \"40 40 40\"\n\"targetname\" \"hand_on\"\n\"target\" \"gate\"");
  EXPECT_TRUE(MadeRooms(hall(wall_with_opening(500), door(500, "\"targetname\" \"gate\"\n\"wait\" \"-1\"") +
                                                         button + relay + exit_at_end()))
                  .play()
                  .reached_exit);
}

TEST(PlayerInRooms, RidesALift) {
  // The eastern half is 160 high; the lift goes up to it.
  const std::string high = box_text({600, 0, 0}, {1024, 256, 160}, "wall");
  const std::string lift =
      entity_text("func_plat", "\"height\" \"152\"", box_text({472, 64, 0}, {600, 192, 160}, "lift"));
  EXPECT_TRUE(MadeRooms(hall(high, lift + exit_at_end(160))).play().reached_exit);
}

TEST(PlayerInRooms, JumpsOverAGap) {
  // Two tables, 96 units high and 144 units apart. A player that falls cannot get up again.
  const std::string tables =
      box_text({0, 0, 0}, {400, 256, 96}, "wall") + box_text({544, 0, 0}, {1024, 256, 96}, "wall");
  const std::string map =
      entity_text("worldspawn", "", walls_text({0, 0, 0}, {1024, 256, 300}, "wall") + tables) +
      entity_text("info_player_start", "\"origin\" \"64 128 128\"") + exit_at_end(96);
  const player::RunReport report = MadeRooms(map).play();
  EXPECT_TRUE(report.reached_exit) << player::as_text(report);
  EXPECT_LT(report.time_s, 10);
}

TEST(PlayerInRooms, HopsOntoACrate) {
  const std::string table = box_text({500, 0, 0}, {1024, 256, 40}, "wall");
  EXPECT_TRUE(MadeRooms(hall(table, exit_at_end(40))).play().reached_exit);
}

TEST(PlayerInRooms, SwimsAndClimbsOut) {
  // A pool, 128 deep, whose edges are 16 above the water.
  const std::string map = entity_text("worldspawn", "",
                                      walls_text({0, 0, -128}, {1024, 256, 256}, "wall") +
                                          box_text({0, 0, -128}, {300, 256, 0}, "wall") +
                                          box_text({700, 0, -128}, {1024, 256, 0}, "wall") +
                                          box_text({300, 0, -128}, {700, 256, -16}, "*water")) +
                          entity_text("info_player_start", "\"origin\" \"64 128 32\"") + exit_at_end();
  EXPECT_TRUE(MadeRooms(map).play().reached_exit);
}

TEST(PlayerInRooms, GoesThroughATeleporter) {
  const std::string wall = box_text({500, 0, 0}, {516, 256, 256}, "wall");
  const std::string teleporter = entity_text("trigger_teleport", "\"target\" \"there\"",
                                             box_text({400, 0, 0}, {432, 64, 96}, "trigger"));
  const std::string there =
      entity_text("info_teleport_destination", "\"origin\" \"600 128 0\"\n\"targetname\" \"there\"");
  EXPECT_TRUE(MadeRooms(hall(wall, teleporter + there + exit_at_end())).play().reached_exit);
}

TEST(PlayerInRooms, ReportsAnExitThatIsTooHigh) {
  const std::string high = box_text({600, 0, 0}, {1024, 256, 120}, "wall");
  const player::RunReport report = MadeRooms(hall(high, exit_at_end(120))).play();
  EXPECT_FALSE(report.reached_exit);
  EXPECT_THAT(report.problems, Contains(HasSubstr("no reachable place touches it")));
}

TEST(PlayerInRooms, FindsSecretsIfRequested) {
  const std::string secret =
      entity_text("trigger_secret", "", box_text({64, 0, 0}, {128, 32, 96}, "trigger"));
  const MadeRooms rooms(hall("", secret + exit_at_end()));
  player::RunSetup setup = rooms.setup();
  EXPECT_EQ(player::play_level(setup).value().found_secrets, 0);
  setup.visits_secrets = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_EQ(report.found_secrets, 1);
  EXPECT_TRUE(report.reached_exit);
}

TEST(PlayerInRooms, KillsMonstersInTheWay) {
  const MadeRooms rooms(hall("", point_text("monster_army", {700, 128, 32}) + exit_at_end()));
  const player::RunReport report = rooms.play();
  EXPECT_TRUE(report.reached_exit);
  EXPECT_EQ(report.monsters, 1);
  EXPECT_EQ(report.kills, 1);
  EXPECT_THAT(report.stuck_monsters, IsEmpty());
}

TEST(PlayerInRooms, ReportsAMonsterInAWall) {
  const std::string block = box_text({600, 0, 0}, {640, 100, 256}, "wall");
  const std::string key = door(500, "\"spawnflags\" \"16\"");  // keeps the player there for a while
  const player::RunReport report =
      MadeRooms(hall(wall_with_opening(500) + block,
                     key + point_text("monster_army", {600, 90, 32}) + exit_at_end()))
          .play();
  EXPECT_THAT(report.stuck_monsters, Contains(HasSubstr("monster_army")));
}

TEST(PlayerInRooms, PlaysCooperatively) {
  const MadeRooms rooms(hall(wall_with_opening(500), door(500, "") + exit_at_end()));
  player::RunSetup setup = rooms.setup();
  setup.session.players = 2;
  setup.session.cooperative = true;
  EXPECT_TRUE(player::play_level(setup).value().reached_exit);
}

// The same seed gives the same game, a different seed a different one.
TEST(PlayerInRooms, IsDeterministicForASeed) {
  const MadeRooms rooms(hall("", point_text("monster_army", {700, 128, 32}) +
                                     point_text("monster_army", {800, 200, 32}) + exit_at_end()));
  player::RunSetup setup = rooms.setup();
  setup.session.records = true;
  const player::RunReport first = player::play_level(setup).value(),
                          second = player::play_level(setup).value();
  EXPECT_EQ(first.time_s, second.time_s);
  EXPECT_EQ(first.state_hash, second.state_hash);
  EXPECT_EQ(first.demo, second.demo);
  setup.session.seed = 2;
  EXPECT_NE(player::play_level(setup).value().state_hash, first.state_hash);
}

// A demo covers the level from its start to its end, and its view never jerks.
TEST(PlayerInRooms, RecordsAWatchableDemo) {
  const MadeRooms rooms(hall(wall_with_opening(500), door(500, "") + exit_at_end()));
  player::RunSetup setup = rooms.setup();
  setup.session.records = true;
  const player::RunReport report = player::play_level(setup).value();
  base::Result<formats::DemReader> reader = formats::DemReader::open(report.demo);
  ASSERT_TRUE(reader.ok());
  std::size_t messages = 0;
  math::Vec3 last(0.0f);
  while (true) {
    const auto message = reader->next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    const math::Vec3 angles = (*message)->view_angles_deg;
    // The view jumps once when the level starts, and again to the intermission camera.
    if (messages > 20 && messages < static_cast<std::size_t>(report.time_s * 72)) {
      EXPECT_LT(std::abs(std::remainder(angles.y - last.y, 360.0f)), 12) << messages;
    }
    last = angles;
    ++messages;
  }
  EXPECT_GT(messages, 72u * 3);
}

TEST(PlayerInRooms, MissingLevelIsAnError) {
  player::RunSetup setup = MadeRooms(hall("", exit_at_end())).setup();
  EXPECT_FALSE(player::play_level(setup).ok());  // the folder is gone
}

}  // namespace
}  // namespace temblor::test
