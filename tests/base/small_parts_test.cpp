// The small headers of base: text, words, typed indices, function references.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/function_ref.h"
#include "base/hash.h"
#include "base/index.h"
#include "base/text.h"
#include "base/words.h"

namespace temblor::base {
namespace {

constexpr std::string_view kUpper = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kLower = "abcdefghijklmnopqrstuvwxyz";

// Also two changes of the highest bits, which multiplication does not spread, 32 bytes apart.
TEST(Hash, OfAnySizeFollowsEveryBit) {
  for (const std::size_t size : {0u, 1u, 31u, 32u, 33u, 64u, 100u}) {
    ByteVector bytes(size);
    const std::uint64_t whole = hash_bytes_fast(bytes);
    bytes.push_back(std::byte{0});
    EXPECT_NE(hash_bytes_fast(bytes), whole) << "trailing zeros matter";
    bytes.pop_back();
    for (std::size_t bit = 0; bit < size * 8; ++bit) {
      ByteVector changed = bytes;
      changed[bit / 8] ^= std::byte{1} << (bit % 8);
      EXPECT_NE(hash_bytes_fast(changed), whole) << size << " " << bit;
      if (bit / 8 + 32 >= size) continue;
      changed[bit / 8 + 32] ^= std::byte{1} << (bit % 8);
      EXPECT_NE(hash_bytes_fast(changed), whole) << size << " " << bit;
    }
  }
}

TEST(Text, LowerCaseTouchesAsciiLettersOnly) {
  for (int code = 0; code < 256; ++code) {
    const char c = static_cast<char>(code);
    const std::size_t letter = kUpper.find(c);
    EXPECT_EQ(to_lower(c), letter == std::string_view::npos ? c : kLower[letter]) << code;
  }
  EXPECT_EQ(to_lower("Maps/START.bsp"), "maps/start.bsp");
}

TEST(Text, EqualIgnoringCaseOfEveryPairOfCharacters) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const std::string left(1, static_cast<char>(a)), right(1, static_cast<char>(b));
      const std::size_t upper =
          kUpper.find(left) == std::string::npos ? kLower.find(left) : kUpper.find(left);
      const bool same = a == b || (upper != std::string_view::npos &&
                                   (right[0] == kUpper[upper] || right[0] == kLower[upper]));
      ASSERT_EQ(equal_ignoring_case(left, right), same) << a << " " << b;
    }
  }
  EXPECT_TRUE(equal_ignoring_case("gfx/Palette.LMP", "GFX/palette.lmp"));
  EXPECT_FALSE(equal_ignoring_case("start", "start2"));
  EXPECT_TRUE(equal_ignoring_case("", ""));
}

enum class CrateIndex : std::uint32_t {};
enum class ShelfIndex : std::uint32_t {};
static_assert(IndexType<CrateIndex>);
enum class Color : std::uint8_t {};
static_assert(!IndexType<std::uint32_t> && !IndexType<Color>);
static_assert(!std::is_convertible_v<CrateIndex, ShelfIndex> && !std::is_convertible_v<int, CrateIndex>);

TEST(Words, AreSplitAtSeparators) {
  using Words = std::vector<std::string_view>;
  EXPECT_EQ(split_words(" at 2,  3\t", " ,\t"), (Words{"at", "2", "3"}));
  EXPECT_EQ(split_words("one", " "), Words{"one"});
  EXPECT_EQ(split_words("", " "), Words{});
  EXPECT_EQ(split_words(" ,", ", "), Words{});
}

TEST(Words, AreNumbersOnlyAsAWhole) {
  EXPECT_EQ(parse_number<float>("-2.5"), -2.5f);
  EXPECT_EQ(parse_number<int>("12"), 12);
  for (const char* const word : {"", "2x", " 2", "+2", "nan", "inf", "1e99"})
    EXPECT_FALSE(parse_number<float>(word)) << word;
  EXPECT_FALSE(parse_number<std::uint8_t>("256"));
  EXPECT_FALSE(parse_number<std::uint8_t>("-1"));
}

TEST(Index, GoesToAPositionAndBack) {
  EXPECT_EQ(to_size(CrateIndex{7}), 7u);
  EXPECT_EQ(to_index<CrateIndex>(0xfffffffe), CrateIndex{0xfffffffe});
  EXPECT_EQ(to_size(to_index<CrateIndex>(0xffffffff)), 0xffffffffu);
}

int call_with_five(FunctionRef<int(int)> function) {
  return function(5);
}

TEST(FunctionRef, CallsWhatItRefersTo) {
  int sum = 0;
  auto add = [&sum](int number) { return sum += number; };
  EXPECT_EQ(call_with_five(add), 5);
  EXPECT_EQ(call_with_five(add), 10);
  EXPECT_EQ(sum, 10);
}

TEST(FunctionRef, TakesConstCallablesAndTemporaries) {
  const auto twice = [](int number) { return number * 2; };
  EXPECT_EQ(call_with_five(twice), 10);
  EXPECT_EQ(call_with_five([](int number) { return number * 3; }), 15);
}

TEST(FunctionRef, CopyRefersToTheSameCallable) {
  int calls = 0;
  auto count = [&calls] { ++calls; };
  const FunctionRef<void()> first(count);
  const FunctionRef<void()> second = first;
  first();
  second();
  EXPECT_EQ(calls, 2);
}

TEST(FunctionRef, PassesReferencesAndMoveOnlyArguments) {
  const auto fill = [](std::string& out, std::unique_ptr<int> number) { out = std::to_string(*number); };
  std::string text;
  FunctionRef<void(std::string&, std::unique_ptr<int>)> reference(fill);
  reference(text, std::make_unique<int>(42));
  EXPECT_EQ(text, "42");
}

}  // namespace
}  // namespace temblor::base
