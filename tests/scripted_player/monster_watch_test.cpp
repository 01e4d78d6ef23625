// The scripted player reports monsters that stand still in a fight.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scripted_player/made_rooms.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A room of 512 x 512 units without an exit: the player stays at 64 256 and cannot be hurt. A knight in front
// of it stands in a pen of four walls. The knight sees and strikes over them but cannot climb them. It hops
// over walls of up to 36 units.
player::RunReport stand_before_a_penned_knight(double x, double height) {
  const std::string pen = box_text({x - 24, 232, 0}, {x - 20, 280, height}, "pen") +
                          box_text({x + 20, 232, 0}, {x + 24, 280, height}, "pen") +
                          box_text({x - 20, 232, 0}, {x + 20, 236, height}, "pen") +
                          box_text({x - 20, 276, 0}, {x + 20, 280, height}, "pen");
  const std::string text =
      entity_text("worldspawn", "\"peace\" \"-1\"", walls_text({0, 0, 0}, {512, 512, 256}, "wall") + pen) +
      entity_text("info_player_start", "\"origin\" \"64 256 32\"\n\"angle\" \"0\"") +
      entity_text("monster_knight", fmt::format("\"origin\" \"{} 256 32\"\n\"angle\" \"180\"", x));
  const MadeRooms rooms(text);
  player::RunSetup setup = rooms.setup();
  setup.has_god = true;
  setup.fights = false;
  setup.limit_s = 20;
  return player::play_level(setup).value();
}

TEST(MonsterWatch, MonsterThatKeepsAttackingIsNotIdle) {
  EXPECT_THAT(stand_before_a_penned_knight(112, 20).idle_monsters, IsEmpty());
}

TEST(MonsterWatch, MonsterThatHopsOutOfItsPenIsNotIdle) {
  EXPECT_THAT(stand_before_a_penned_knight(320, 20).idle_monsters, IsEmpty());
}

TEST(MonsterWatch, MonsterThatCannotReachItsEnemyIsIdle) {
  EXPECT_THAT(stand_before_a_penned_knight(320, 44).idle_monsters, ElementsAre(HasSubstr("monster_knight")));
}

}  // namespace
}  // namespace temblor::test
