// Runs share the graph of a level if their floods would be the same, and play as without a cache.
#include "scripted_player/navigation/graph_cache.h"

#include <gtest/gtest.h>

#include <string>

#include "scripted_player/made_rooms.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

// A hall with a table, a brush model that never moves, and an exit behind a door.
std::string hall_with_door(float table, const std::string& wall_flags) {
  return entity_text("worldspawn", "",
                     walls_text({0, 0, 0}, {768, 256, 256}, "wall") +
                         box_text({500, 0, 0}, {516, 80, 256}, "wall") +
                         box_text({500, 176, 0}, {516, 256, 256}, "wall") +
                         box_text({500, 80, 112}, {516, 176, 256}, "wall") +
                         box_text({200, 0, 0}, {264, 64, table}, "table")) +
         entity_text("info_player_start", "\"origin\" \"64 128 32\"\n\"angle\" \"0\"") +
         entity_text("func_wall", wall_flags, box_text({200, 160, 0}, {264, 224, 200}, "wall")) +
         entity_text("func_door", "\"angle\" \"-1\"", box_text({500, 80, 0}, {516, 176, 112}, "door")) +
         exit_text({700, 0, 0}, {768, 256, 96});
}

player::RunReport play(const MadeRooms& rooms, int skill, std::uint64_t seed, player::GraphCache* graphs) {
  player::RunSetup setup = rooms.setup();
  setup.session.skill = skill;
  setup.session.seed = seed;
  setup.graphs = graphs;
  return player::play_level(setup).value();
}

TEST(GraphCache, SharesAGraphBetweenSeedsAndSkillsAndChangesNoGame) {
  const MadeRooms rooms(hall_with_door(40, ""));
  player::GraphCache graphs;
  for (int skill = 0; skill < 4; ++skill)
    for (const std::uint64_t seed : {1u, 2u}) {
      const player::RunReport shared = play(rooms, skill, seed, &graphs),
                              alone = play(rooms, skill, seed, nullptr);
      EXPECT_TRUE(shared.reached_exit);
      EXPECT_EQ(shared.links, alone.links);
      EXPECT_EQ(shared.time_s, alone.time_s);
      EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
  EXPECT_EQ(graphs.size(), 1u);
}

TEST(GraphCache, KeepsLevelsApart) {
  player::GraphCache graphs;
  const player::RunReport low = play(MadeRooms(hall_with_door(40, "")), 1, 1, &graphs);
  const player::RunReport high = play(MadeRooms(hall_with_door(120, "")), 1, 1, &graphs);
  EXPECT_EQ(graphs.size(), 2u);
  EXPECT_NE(low.links, high.links) << "the player can jump onto one of the tables only";
}

// Spawnflag 256: the brush model is not there on easy.
TEST(GraphCache, KeepsSkillsWithOtherObstaclesApart) {
  const MadeRooms rooms(hall_with_door(40, "\"spawnflags\" \"256\""));
  player::GraphCache graphs;
  const player::RunReport easy = play(rooms, 0, 1, &graphs), normal = play(rooms, 1, 1, &graphs);
  EXPECT_EQ(graphs.size(), 2u);
  EXPECT_GT(easy.links, normal.links);
  EXPECT_EQ(play(rooms, 2, 1, &graphs).links, normal.links);
  EXPECT_EQ(graphs.size(), 2u);
}

}  // namespace
}  // namespace temblor::test
