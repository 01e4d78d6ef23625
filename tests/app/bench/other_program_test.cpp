// The parts of `temblor bench --against`.
#include "app/bench/other_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/bench/comparison.h"

namespace temblor::app {
namespace {

using namespace std::string_view_literals;
using ::testing::HasSubstr;

TEST(FindLastNumber, TakesTheLastOne) {
  const std::pair<std::string_view, double> cases[] = {
      {"100.5", 100.5},
      {"100.5\n", 100.5},
      {"72.5 fps", 72.5},
      {"72.5fps.", 72.5},
      {"fps=72.5 (demo1)\n", 72.5},
      {"969 frames  3.1 seconds 312.6 fps\r\n", 312.6},
      {"1.5e3", 1500},
      {"-3", -3},
      {"0", 0},
      {".5", 0.5},
      {"+.5", 0.5},
      {"~$-.5!", -0.5},
      {"60 - fps", 60},
      {"280/310/350", 350},
      {"\"72.5\",", 72.5},
      {"72.5\nnan inf e1m1 v2 _3", 72.5},
      {"1\0002"sv, 2},
      {"\xff\xfe 9 \xff", 9},
  };
  for (const auto& [output, number] : cases) {
    const base::Result<double> found = find_last_number(output);
    ASSERT_TRUE(found.ok()) << output << ": " << found.error().what;
    EXPECT_DOUBLE_EQ(*found, number) << output;
  }
}

TEST(FindLastNumber, RejectsNumbersWithSeveralMeanings) {
  for (const std::string_view output : {"10 1,234.5", "10 72,5", "10 640x480", "10 2026-11-28", "10 1.2.3",
                                        "10 10-20", "10 0x1f", "10 1e999"})
    EXPECT_THAT(find_last_number(output).error().what, HasSubstr(output.substr(3))) << output;
}

TEST(FindLastNumber, RejectsOutputWithoutNumbers) {
  for (const std::string_view output : {""sv, " \n\n"sv, "\0\0"sv, "none"sv, "demo1 nan -inf - ."sv})
    EXPECT_THAT(find_last_number(output).error().what, HasSubstr("no number")) << output;
}

TEST(FindLastNumber, IsFastInLongOutput) {
  const std::string letters(1 << 20, 'a'), lines = [] {
    std::string text = "7 ";
    for (int i = 0; i < (1 << 18); ++i) text += "word\n";
    return text;
  }();
  EXPECT_FALSE(find_last_number(letters).ok());
  EXPECT_FALSE(find_last_number(std::string(1 << 20, '1')).ok());
  EXPECT_DOUBLE_EQ(find_last_number(lines).value(), 7);
}

TEST(Comparison, RatiosAreByRound) {
  Comparison comparison{.command = "echo \"1\"", .fps = {200, 150, 330}, .other_fps = {100, 100, 100}};
  const Spread ratio = compute_ratio(comparison);
  EXPECT_DOUBLE_EQ(ratio.median, 2);
  EXPECT_DOUBLE_EQ(ratio.min, 1.5);
  EXPECT_DOUBLE_EQ(ratio.max, 3.3);
  EXPECT_EQ(describe_last_round(comparison),
            "  round 3: 330.0 fps, the command 100.0 fps: 3.30 times as fast\n");
  EXPECT_EQ(describe_ratio(comparison), "  median ratio 2.00, 1.50 to 3.30\n");
  EXPECT_EQ(make_json(comparison),
            nlohmann::json::parse(R"({"command": "echo \"1\"", "fps": [200.0, 150.0, 330.0],
                "other_fps": [100.0, 100.0, 100.0], "ratio": {"median": 2.0, "min": 1.5, "max": 3.3}})"));
}

TEST(ComputeSpread, MedianOfAnEvenCountIsTheMeanOfBothInTheMiddle) {
  const Spread even = compute_spread({4, 1, 2, 100});
  EXPECT_DOUBLE_EQ(even.median, 3);
  EXPECT_DOUBLE_EQ(even.min, 1);
  EXPECT_DOUBLE_EQ(even.max, 100);
  EXPECT_DOUBLE_EQ(compute_spread({5}).median, 5);
  EXPECT_DOUBLE_EQ(compute_spread({}).median, 0);
}

}  // namespace
}  // namespace temblor::app
