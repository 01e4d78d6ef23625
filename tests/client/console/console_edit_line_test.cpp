// The input line, compared with a list of characters and a cursor number; and UTF-8, compared with its
// arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/console/edit_line.h"
#include "client/console/input_history.h"
#include "client/console/utf8.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::client {
namespace {

struct Typed {
  const char *bytes, *character;  // the input, and its form in the line
};
constexpr std::array<Typed, 12> kAlphabet = {{{"a", "a"},
                                              {"Z", "Z"},
                                              {" ", " "},
                                              {" ", " "},
                                              {"\xc3\xa9", "\xc3\xa9"},
                                              {"\xe6\xbc\xa2", "\xe6\xbc\xa2"},
                                              {"\xf0\x9f\x98\x80", "\xf0\x9f\x98\x80"},
                                              {"\xff", "?"},
                                              {"\xc0", "?"},
                                              {"\n", " "},
                                              {"\x01", ""},
                                              {"\xc2\x85", ""}}};

// One string per character.
class ReferenceLine {
 public:
  void insert(const std::vector<std::string>& characters) {
    for (const std::string& character : characters)
      if (!character.empty()) characters_.insert(at(cursor_++), character);
  }
  void erase(std::size_t begin, std::size_t end) {
    characters_.erase(at(begin), at(end));
    cursor_ = begin;
  }
  std::size_t word_left() const {
    std::size_t place = cursor_;
    while (place > 0 && characters_[place - 1] == " ") --place;
    while (place > 0 && characters_[place - 1] != " ") --place;
    return place;
  }
  std::size_t word_right() const {
    std::size_t place = cursor_;
    while (place < size() && characters_[place] == " ") ++place;
    while (place < size() && characters_[place] != " ") ++place;
    return place;
  }
  void apply(std::size_t action) {
    switch (action) {
      case 0:
        return erase(cursor_ - (cursor_ > 0 ? 1 : 0), cursor_);
      case 1:
        return erase(cursor_, std::min(cursor_ + 1, size()));
      case 2:
        return erase(word_left(), cursor_);
      case 3:
        return erase(cursor_, word_right());
      case 4:
        return erase(0, cursor_);
      case 5:
        return erase(cursor_, size());
      case 6:
        cursor_ -= cursor_ > 0 ? 1 : 0;
        return;
      case 7:
        cursor_ = std::min(cursor_ + 1, size());
        return;
      case 8:
        cursor_ = word_left();
        return;
      case 9:
        cursor_ = word_right();
        return;
      case 10:
        cursor_ = 0;
        return;
      default:
        cursor_ = size();
    }
  }
  std::string text(std::size_t end) const {
    std::string text;
    for (std::size_t i = 0; i < end; ++i) text += characters_[i];
    return text;
  }
  std::string text() const { return text(size()); }
  std::string before_cursor() const { return text(cursor_); }
  std::size_t size() const { return characters_.size(); }

 private:
  std::vector<std::string>::iterator at(std::size_t place) {
    return characters_.begin() + static_cast<std::ptrdiff_t>(place);
  }
  std::vector<std::string> characters_;
  std::size_t cursor_ = 0;
};

constexpr std::size_t kActions = 12;
void apply(std::size_t action, EditLine& io_line) {
  using Member = void (EditLine::*)();
  constexpr std::array<Member, kActions> kMembers = {
      &EditLine::erase_left,       &EditLine::erase_right,    &EditLine::erase_word_left,
      &EditLine::erase_word_right, &EditLine::erase_to_start, &EditLine::erase_to_end,
      &EditLine::move_left,        &EditLine::move_right,     &EditLine::move_word_left,
      &EditLine::move_word_right,  &EditLine::move_to_start,  &EditLine::move_to_end};
  (io_line.*kMembers[action])();
}

TEST(EditLine, MatchesAListOfCharacters) {
  const int seeds = test::effort(400, 60);
  for (int seed = 0; seed < seeds; ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    EditLine line;
    ReferenceLine reference;
    for (int step = 0; step < 200; ++step) {
      if (random.chance(0.5)) {
        std::string bytes;
        std::vector<std::string> characters;
        for (std::size_t i = 1 + random.below(4); i > 0; --i) {
          const Typed& typed = kAlphabet[random.below(kAlphabet.size())];
          bytes += typed.bytes;
          characters.emplace_back(typed.character);
        }
        EXPECT_EQ(line.insert(bytes), 0u);
        reference.insert(characters);
      } else {
        const std::size_t action = random.below(kActions);
        apply(action, line);
        reference.apply(action);
      }
      ASSERT_EQ(line.text(), reference.text()) << "seed " << seed << ", step " << step;
      ASSERT_EQ(line.text().substr(0, line.cursor()), reference.before_cursor())
          << "seed " << seed << ", step " << step;
    }
  }
}

// In any portions, as many whole characters are inserted as fit.
TEST(EditLine, HasALimit) {
  for (const std::string character : {"x", "\xc3\xa9", "\xe6\xbc\xa2", "\xf0\x9f\x98\x80"}) {
    std::string megabyte;
    while (megabyte.size() < 1'000'000) megabyte += character;
    EditLine line;
    line.insert("ab");
    line.move_left();
    const std::size_t left_out = line.insert(megabyte);
    const std::size_t fit = (EditLine::kMaxBytes - 2) / character.size() * character.size();
    EXPECT_EQ(line.text().size(), fit + 2);
    EXPECT_EQ(left_out, megabyte.size() - fit);
    EXPECT_EQ(line.text().substr(0, 1 + character.size()), "a" + character);
    EXPECT_EQ(line.text().back(), 'b');
    EXPECT_EQ(line.cursor(), fit + 1);
  }
}

TEST(EditLine, ReplacesTextBeforeTheCursor) {
  EditLine line;
  line.set("toggle cross; x");
  for (int i = 0; i < 3; ++i) line.move_left();
  line.replace_before_cursor(7, "crosshair ");
  EXPECT_EQ(line.text(), "toggle crosshair ; x");
  EXPECT_EQ(line.cursor(), 17u);
}

std::string encode(std::uint32_t code) {
  const auto byte = [](std::uint32_t value) { return static_cast<char>(value); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xc0 | code >> 6), byte(0x80 | (code & 63))};
  if (code < 0x10000)
    return {byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 63)), byte(0x80 | (code & 63))};
  return {byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 63)), byte(0x80 | (code >> 6 & 63)),
          byte(0x80 | (code & 63))};
}

TEST(Utf8, EveryCharacterIsValid) {
  for (std::uint32_t code = 0; code < 0x110000; ++code) {
    if (code >= 0xd800 && code < 0xe000) continue;
    const std::string bytes = encode(code);
    ASSERT_EQ(character_length(bytes, 0), bytes.size()) << code;
    for (std::size_t i = 1; i < bytes.size(); ++i) ASSERT_EQ(character_length(bytes, i), 0u) << code;
    const std::string cut = bytes.substr(0, bytes.size() - 1);
    ASSERT_EQ(character_length(cut, 0), 0u) << code;
  }
}

TEST(Utf8, NothingElseIsValid) {
  for (std::uint32_t code = 0xd800; code < 0xe000; ++code) EXPECT_EQ(character_length(encode(code), 0), 0u);
  for (std::uint32_t code = 0x110000; code < 0x200000; ++code)
    EXPECT_EQ(character_length(encode(code), 0), 0u);
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string bytes = {static_cast<char>(first), static_cast<char>(second), '\x80', '\x80'};
      const std::size_t length = character_length(bytes, 0);
      if (length == 0) continue;
      // These bytes are the only encoding of some character.
      bool found = first < 0x80;
      const std::uint32_t lead = static_cast<std::uint8_t>(first),
                          next = static_cast<std::uint8_t>(second) & 63u;
      if (length == 2) found = encode((lead & 31) << 6 | next) == bytes.substr(0, 2);
      if (length == 3) found = encode((lead & 15) << 12 | next << 6) == bytes.substr(0, 3);
      if (length == 4) found = encode((lead & 7) << 18 | next << 12) == bytes.substr(0, 4);
      EXPECT_TRUE(found) << first << " " << second;
    }
}

TEST(Utf8, EachCharacterBecomesOneGlyph) {
  EXPECT_EQ(to_glyphs("a\xc3\xa9z\xe6\xbc\xa2!\xff\xc3"), "a?z?!??");
  EXPECT_EQ(to_bronze_glyphs("A\xc3\xa9"), "\xc1\xbf");
  EXPECT_EQ(sanitize_typed_text("a\tb\r\nc\x7f"), "a b c");
}

TEST(InputHistory, StepsBackAndForthAndKeepsTheTypedLine) {
  InputHistory history;
  EXPECT_EQ(history.older("x"), std::nullopt);
  EXPECT_EQ(history.newer(), std::nullopt);
  for (const char* line : {"one", "two", "two", "", "three"}) history.add(line);
  EXPECT_EQ(history.text(), "one\ntwo\nthree\n");
  EXPECT_EQ(history.older("draft"), "three");
  EXPECT_EQ(history.older("not looked at"), "two");
  EXPECT_EQ(history.older(""), "one");
  EXPECT_EQ(history.older(""), std::nullopt);
  EXPECT_EQ(history.newer(), "two");
  EXPECT_EQ(history.newer(), "three");
  EXPECT_EQ(history.newer(), "draft");
  EXPECT_EQ(history.newer(), std::nullopt);
  EXPECT_EQ(history.older("again"), "three");
  history.add("four");
  EXPECT_EQ(history.older(""), "four");
}

TEST(InputHistory, IsSearchedBackward) {
  InputHistory history;
  for (const char* line : {"map e1m1", "god", "MAP e1m2", "noclip"}) history.add(line);
  EXPECT_EQ(history.find_before(history.size(), "Map"), 2u);
  EXPECT_EQ(history.find_before(2, "map"), 0u);
  EXPECT_EQ(history.find_before(0, "map"), std::nullopt);
  EXPECT_EQ(history.find_before(99, "zebra"), std::nullopt);
}

TEST(InputHistory, IsLimitedAndSavesExactly) {
  InputHistory history;
  for (int i = 0; i < 2000; ++i) history.add("line " + std::to_string(i));
  EXPECT_EQ(history.size(), InputHistory::kMaxLines);
  EXPECT_EQ(history.line(history.size() - 1), "line 1999");
  InputHistory other;
  other.load(history.text());
  EXPECT_EQ(other.text(), history.text());
}

TEST(InputHistory, LoadsAnyTextSafely) {
  test::Random random(1);
  std::string garbage;
  for (int i = 0; i < 200'000; ++i) garbage += static_cast<char>(random.bits());
  InputHistory history;
  history.load(garbage + "\n" + std::string(3'000'000, 'x') + "\nlast\r\n");
  EXPECT_LE(history.size(), InputHistory::kMaxLines);
  EXPECT_EQ(history.line(history.size() - 1), "last");
  for (std::size_t i = 0; i < history.size(); ++i) {
    EXPECT_EQ(sanitize_typed_text(history.line(i)), history.line(i));
    EXPECT_LE(history.line(i).size(), EditLine::kMaxBytes);
  }
}

}  // namespace
}  // namespace temblor::client
