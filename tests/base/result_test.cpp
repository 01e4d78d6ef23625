#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace temblor::base {
namespace {

Result<int> half(int number) {
  if (number % 2 != 0) return malformed("{} is odd", number);
  return number / 2;
}

Result<int> quarter(int number) {
  TRY(const int halved, half(number));
  TRY(const int quartered, half(halved));
  return quartered;
}

Result<std::unique_ptr<int>> boxed_half(int number) {
  TRY(const int halved, half(number));
  return std::make_unique<int>(halved);
}

Status is_divisible_by_four(int number, int& io_calls) {
  TRY_STATUS(quarter(number));
  ++io_calls;
  return Ok{};
}

TEST(Result, HoldsAValueOrAnError) {
  EXPECT_TRUE(half(4).ok());
  EXPECT_EQ(*half(4), 2);
  EXPECT_FALSE(half(3));
  EXPECT_EQ(half(3).error().code, ErrorCode::kMalformed);
  EXPECT_EQ(half(3).error().what, "3 is odd");
}

TEST(Result, TryPassesTheFirstErrorOn) {
  EXPECT_EQ(quarter(12).value(), 3);
  EXPECT_EQ(quarter(5).error().what, "5 is odd");
  EXPECT_EQ(quarter(6).error().what, "3 is odd");
}

TEST(Result, TryMovesTheValueOut) {
  const auto unbox = [](int number) -> Result<int> {
    TRY(const std::unique_ptr<int> box, boxed_half(number));
    return *box;
  };
  EXPECT_EQ(unbox(8).value(), 4);
  EXPECT_EQ(unbox(7).error().what, "7 is odd");
}

TEST(Result, TryStatusStopsBeforeWhatFollows) {
  int calls = 0;
  EXPECT_TRUE(is_divisible_by_four(8, calls).ok());
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(is_divisible_by_four(6, calls).ok());
  EXPECT_EQ(calls, 1);
}

TEST(Result, FileIsNamedByTheFirstWhoKnowsIt) {
  EXPECT_EQ(half(3).error().message(), "3 is odd");
  const Result<int> named = half(3).with_file("maps/start.bsp").with_file("pak0.pak");
  EXPECT_EQ(named.error().message(), "maps/start.bsp: 3 is odd");
  EXPECT_EQ(half(4).with_file("maps/start.bsp").value(), 2);
}

TEST(Result, ErrorKeepsItsCode) {
  EXPECT_EQ(error(ErrorCode::kTooLarge, "{} bytes", 7).code, ErrorCode::kTooLarge);
  EXPECT_EQ(error(ErrorCode::kTooLarge, "{} bytes", 7).what, "7 bytes");
}

TEST(ResultDeathTest, AskingAnErrorForItsValueEndsTheProgram) {
  EXPECT_DEATH(half(3).value(), "CHECK failed.*3 is odd");
  EXPECT_DEATH(half(4).error(), "CHECK failed");
}

TEST(CheckDeathTest, PrintsWhereAndWhat) {
  const int faces = 3;
  CHECK(faces == 3);
  EXPECT_DEATH(CHECK(faces == 4, "there are {} faces", faces),
               "result_test.cpp:[0-9]+: CHECK failed: faces == 4: there are 3 faces");
}

}  // namespace
}  // namespace temblor::base
