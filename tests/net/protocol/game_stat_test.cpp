#include "net/protocol/game_stat.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace temblor::net {
namespace {

using ::testing::HasSubstr;

GameStat after_transport(const GameStat& stat) {
  std::string line = format_game_stat(stat);
  EXPECT_TRUE(line.ends_with('\n'));
  line.pop_back();
  EXPECT_TRUE(is_game_stat(line));
  return read_game_stat(line).value();
}

std::string stat_problem(std::string_view words) {
  const base::Result<GameStat> stat = read_game_stat("//temblor stat " + std::string(words));
  return stat.ok() ? "none" : stat.error().message();
}

TEST(GameStat, SurvivesTransport) {
  for (const StatValue& value :
       {StatValue(0), StatValue(-2147483647 - 1), StatValue(0.1f), StatValue(-1.5e30f),
        StatValue(std::string()), StatValue(std::string("two\nlines; \"and\" \x80\xff bytes")),
        StatValue(std::string(1024, 'x'))})
    for (const int number : {32, 127, 255}) {
      const GameStat stat{static_cast<std::uint8_t>(number), value};
      EXPECT_EQ(after_transport(stat), stat);
    }
}

// A stock client would run whatever follows a line end or a semicolon.
TEST(GameStat, IsOneCommentWithoutSemicolons) {
  const std::string line = format_game_stat({40, std::string("x;quit\nquit\n")});
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_EQ(line.find(';'), std::string::npos);
  EXPECT_TRUE(line.starts_with("//"));
}

TEST(GameStat, CutsLongTextsAndSendsNoInfinity) {
  EXPECT_EQ(std::get<std::string>(after_transport({33, std::string(5000, 'y')}).value).size(), 1024u);
  EXPECT_EQ(after_transport({33, std::numeric_limits<float>::infinity()}).value, StatValue(0.0f));
}

TEST(GameStat, SaysWhatIsWrong) {
  for (const char* words : {"", "31 i 1", "256 i 1", "x i 1", "-1 i 1", "4294967328 i 1"})
    EXPECT_THAT(stat_problem(words), HasSubstr("number of a stat")) << words;
  for (const char* words : {"32", "32 i", "32 i 1.5", "32 i 99999999999", "32 f", "32 f inf", "32 f x",
                            "32 q 1", "32 s !", "32 i 1 2"})
    EXPECT_THAT(stat_problem(words), HasSubstr("wrong value")) << words;
  EXPECT_THAT(stat_problem("32 s " + std::string(3000, 'A')), HasSubstr("wrong value"));
}

}  // namespace
}  // namespace temblor::net
