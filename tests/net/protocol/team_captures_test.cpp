#include "net/protocol/team_captures.h"

#include <gtest/gtest.h>

namespace temblor::net {
namespace {

TEST(TeamCaptures, AreReadFromACommentOfTheServer) {
  ASSERT_TRUE(is_team_captures("//temblor captures 4 12"));
  EXPECT_EQ(read_team_captures("//temblor captures 4 12").value(), (TeamCaptures{4, 12}));
}

TEST(TeamCaptures, OthersAreRejected) {
  EXPECT_FALSE(is_team_captures("//temblor capture 4 1"));
  for (const char* const line :
       {"//temblor captures ", "//temblor captures 4", "//temblor captures 16 1", "//temblor captures 4 ",
        "//temblor captures 4 -1", "//temblor captures 4 1 "})
    EXPECT_FALSE(read_team_captures(line).ok()) << line;
}

}  // namespace
}  // namespace temblor::net
