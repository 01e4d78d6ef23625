#include "net/protocol/powerup_end.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace temblor::net {
namespace {

TEST(PowerupEnd, SurvivesTransport) {
  for (const std::uint8_t bit : std::initializer_list<std::uint8_t>{0, 22, 31})
    for (const float end_s : {0.0f, 31.1f, 16777215.0f}) {
      std::string line = format_powerup_end({bit, end_s});
      ASSERT_EQ(line.back(), '\n');
      line.pop_back();
      EXPECT_TRUE(is_powerup_end(line));
      EXPECT_EQ(read_powerup_end(line).value(), (PowerupEnd{bit, end_s}));
    }
}

TEST(PowerupEnd, SaysWhatIsWrong) {
  EXPECT_FALSE(is_powerup_end("//temblor power 22 30"));
  const auto message = [](const std::string& words) {
    const base::Result<PowerupEnd> end = read_powerup_end("//temblor powerup " + words);
    return end.ok() ? std::string() : std::string(end.error().message());
  };
  for (const char* const words : {"", "32 1", "-1 1", "x 1", "22", "999 1"})
    EXPECT_NE(message(words).find("bit"), std::string::npos) << words;
  for (const char* const words : {"22 ", "22 soon", "22 1 2", "22 inf", "22 nan", "22 1e99"})
    EXPECT_NE(message(words).find("not a time"), std::string::npos) << words;
}

}  // namespace
}  // namespace temblor::net
