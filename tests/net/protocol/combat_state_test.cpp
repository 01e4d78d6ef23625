#include "net/protocol/combat_state.h"

#include <gtest/gtest.h>

namespace temblor::net {
namespace {

TEST(CombatState, SurvivesTransport) {
  for (const bool is_hunted : {false, true}) {
    std::string line = format_combat_state(is_hunted);
    ASSERT_EQ(line.back(), '\n');
    line.pop_back();
    EXPECT_TRUE(is_combat_state(line));
    EXPECT_EQ(read_combat_state(line).value(), is_hunted);
  }
}

TEST(CombatState, RejectsOtherLines) {
  EXPECT_FALSE(is_combat_state("//temblor comb 1"));
  for (const char* const line : {"//temblor combat ", "//temblor combat 2", "//temblor combat 1 "})
    EXPECT_FALSE(read_combat_state(line).ok()) << line;
}

}  // namespace
}  // namespace temblor::net
