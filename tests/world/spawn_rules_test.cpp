#include "world/spawn_rules.h"

#include <gtest/gtest.h>

namespace temblor::world {
namespace {

// Every combination of the four bits, from their definition: 256 not on easy, 512 not on normal, 1024 not on
// hard and nightmare, 2048 not in deathmatch.
TEST(SpawnRules, FollowTheBits) {
  for (int bits = 0; bits < 16; ++bits) {
    const bool not_easy = bits & 1, not_normal = bits & 2, not_hard = bits & 4, not_deathmatch = bits & 8;
    const int flags = bits * 256 + 7;  // the lower bits have other meanings
    EXPECT_EQ(is_excluded(flags, {.skill = 0}), not_easy);
    EXPECT_EQ(is_excluded(flags, {.skill = 1}), not_normal);
    EXPECT_EQ(is_excluded(flags, {.skill = 2}), not_hard);
    EXPECT_EQ(is_excluded(flags, {.skill = 3}), not_hard);
    for (int skill = 0; skill < 4; ++skill)
      EXPECT_EQ(is_excluded(flags, {.skill = skill, .deathmatch = true}), not_deathmatch);
  }
}

TEST(SpawnRules, ReadTheKeyOfAnEntity) {
  const auto is_out = [](const char* flags) {
    return is_excluded(formats::Entity{{{"spawnflags", flags}}}, SpawnRules{});
  };
  EXPECT_TRUE(is_out("512"));
  EXPECT_TRUE(is_out("1792.0"));
  for (const char* flags : {"", "0", "256", "1e30", "-512", "nan", "many"})
    EXPECT_FALSE(is_out(flags)) << flags;
  EXPECT_FALSE(is_excluded(formats::Entity{{{"classname", "func_wall"}}}, SpawnRules{}));
}

}  // namespace
}  // namespace temblor::world
