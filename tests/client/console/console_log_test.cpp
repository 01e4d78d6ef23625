// Printed text, wrapping, and the visible rows, compared with a list of all rows.
#include "client/console/console_log.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/console/scrollback.h"
#include "client/console/wrap_text.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> lines(const ConsoleLog& log) {
  std::vector<std::string> lines;
  for (std::uint64_t line = log.begin_line(); line < log.end_line(); ++line)
    lines.push_back(log.line(line).text);
  return lines;
}

TEST(ConsoleLog, JoinsPartsOfALine) {
  ConsoleLog log;
  log.print("one\ntw", 1);
  log.print("o", 2);
  log.print("\n\nthree\n", 3);
  EXPECT_THAT(lines(log), ElementsAre("one", "two", "", "three"));
  EXPECT_EQ(log.line(0).time_s, 1);
  EXPECT_EQ(log.line(1).time_s, 2);
  EXPECT_EQ(log.line(2).time_s, 3);
}

TEST(ConsoleLog, CarriageReturnsReplaceTheLine) {
  ConsoleLog log;
  log.print("10 %\r", 1);
  EXPECT_THAT(lines(log), ElementsAre("10 %"));
  log.print("20 %\r30", 1);
  EXPECT_THAT(lines(log), ElementsAre("30"));
  log.print("\r\nnext\r\n", 1);
  EXPECT_THAT(lines(log), ElementsAre("30", "next"));
}

TEST(ConsoleLog, ColorsApplyToTheWholeText) {
  ConsoleLog log;
  log.print(
      "\x02"
      "ab\n\x01z ",
      1);
  log.print(
      "\x01"
      "c\n",
      1);
  log.print("d\xc4\x01\n", 1);
  EXPECT_THAT(lines(log), ElementsAre("\xe1\xe2", "\x81\xfa\xa0\xe3", "d\xc4\x01"));
  log.clear();
  log.print_utf8("\xc3\xa9\x02x\ttab\n", 1);
  EXPECT_THAT(lines(log), ElementsAre("?\x02x tab"));
}

TEST(ConsoleLog, PlainTextIsAscii) {
  ConsoleLog log;
  log.print("\x02Hello\n\x10\x12\x1b\x11 \x1d\x1e\x1f\n", 1);
  log.print("open", 1);
  EXPECT_EQ(log.text(), "Hello\n[09] <->\nopen\n");
  log.clear();
  std::string all;
  for (int c = 1; c < 256; ++c)
    if (c != '\n' && c != '\r') all += static_cast<char>(c);
  log.print("x" + all, 1);
  for (const char c : log.text()) EXPECT_TRUE((c >= ' ' && c <= '~') || c == '\n') << int{c};
}

TEST(ConsoleLog, OldLinesAreDropped) {
  ConsoleLog log;
  for (int i = 0; i < 100'000; ++i) log.print(fmt::format("line {}\n", i), i);
  EXPECT_EQ(log.end_line(), 100'000u);
  EXPECT_LE(log.end_line() - log.begin_line(), ConsoleLog::kMaxLines);
  EXPECT_LE(log.text().size(), ConsoleLog::kMaxChars + ConsoleLog::kMaxLines);
  EXPECT_EQ(log.line(99'999).text, "line 99999");
  EXPECT_EQ(log.line(log.begin_line()).text, fmt::format("line {}", log.begin_line()));
}

TEST(ConsoleLog, SurvivesAnyText) {
  for (int seed = 0; seed < test::effort(20, 4); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    ConsoleLog log;
    for (int i = 0; i < 200; ++i) {
      std::string text(random.below(3000), ' ');
      for (char& c : text)
        c = random.chance(0.05) ? "\n\r\x01\x02"[random.below(4)] : static_cast<char>(random.bits());
      if (random.chance(0.5))
        log.print(text, i);
      else
        log.print_utf8(text, i);
    }
    std::size_t chars = 0;
    for (const std::string& line : lines(log)) {
      EXPECT_LE(line.size(), ConsoleLog::kMaxLineChars);
      EXPECT_EQ(line.find('\n'), std::string::npos);
      chars += line.size();
    }
    EXPECT_LE(chars, ConsoleLog::kMaxChars);
  }
}

TEST(ConsoleLog, AMegabyteInOneTextIsLimited) {
  for (const char c : {'x', '\n', '\r', ' '}) {
    ConsoleLog log;
    log.print(std::string(std::size_t{1} << 22, c), 1);
    EXPECT_LE(log.text().size(), ConsoleLog::kMaxChars + ConsoleLog::kMaxLines);
    log.print("\nend\n", 1);
    EXPECT_EQ(log.line(log.end_line() - 1).text, "end");
  }
}

std::vector<std::string> wrapped(std::string_view line, int columns) {
  std::vector<std::string_view> rows;
  wrap_line(line, columns, rows);
  EXPECT_EQ(rows.size(), count_rows(line, columns));
  return {rows.begin(), rows.end()};
}

TEST(WrapText, BreaksAtSpaces) {
  EXPECT_THAT(wrapped("", 5), ElementsAre(""));
  EXPECT_THAT(wrapped("hello", 5), ElementsAre("hello"));
  EXPECT_THAT(wrapped("hello world", 5), ElementsAre("hello", "world"));
  EXPECT_THAT(wrapped("a b c d", 3), ElementsAre("a b", "c d"));
  EXPECT_THAT(wrapped("abcdefgh i", 3), ElementsAre("abc", "def", "gh", "i"));
  EXPECT_THAT(wrapped("ab\xa0"
                      "cd",
                      4),
              ElementsAre("ab", "cd"))
      << "a bronze space";
  EXPECT_THAT(wrapped("hello ", 5), ElementsAre("hello"));
  EXPECT_THAT(wrapped(" hello", 5), ElementsAre(" hell", "o"));
  EXPECT_THAT(wrapped("abc", 1), ElementsAre("a", "b", "c"));
}

// The definition: the last of all places at which the row could end.
std::vector<std::string> slowly_wrapped(const std::string& line, std::size_t columns) {
  std::vector<std::string> rows;
  std::size_t begin = 0;
  do {
    std::size_t best = std::min(columns, line.size() - begin), skipped = 0;
    if (line.size() - begin > columns)
      for (std::size_t length = 1; length <= columns; ++length)
        if ((line[begin + length] & 0x7f) == ' ') best = length, skipped = 1;
    rows.push_back(line.substr(begin, best));
    begin += best + skipped;
  } while (begin < line.size());
  return rows;
}

TEST(WrapText, MatchesTheDefinitionAtEveryWidth) {
  for (int seed = 0; seed < test::effort(2000, 200); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    std::string line(random.below(60), ' ');
    const double spaces = random.uniform(0, 0.5);
    for (char& c : line) c = random.chance(spaces) ? ' ' : static_cast<char>('a' + random.below(26));
    for (int columns = 1; columns < 70; columns += 1 + static_cast<int>(random.below(5)))
      ASSERT_EQ(wrapped(line, columns), slowly_wrapped(line, static_cast<std::size_t>(columns)))
          << "seed " << seed << ", " << columns << ": " << line;
  }
}

// A reference: all rows in a list, and the lowest row on the page.
class ReferencePage {
 public:
  void set_log(const ConsoleLog& log, int columns) {
    const bool was_at_end = lowest_ + 1 == rows_.size() || rows_.empty();
    rows_.clear();
    for (const std::string& line : lines(log))
      for (std::string& row : slowly_wrapped(line, static_cast<std::size_t>(columns))) rows_.push_back(row);
    if (was_at_end) scroll_to_end();
  }
  void set_page(int rows) { page_ = static_cast<std::size_t>(rows); }
  void scroll_up(std::size_t rows) {
    lowest_ = std::max(lowest_ - std::min(rows, lowest_), std::min(page_, rows_.size()) - 1);
  }
  void scroll_down(std::size_t rows) { lowest_ = std::min(lowest_ + rows, rows_.size() - 1); }
  void scroll_to_start() { scroll_up(rows_.size()); }
  void scroll_to_end() { lowest_ = rows_.size() - 1; }
  bool is_at_end() const { return lowest_ + 1 == rows_.size(); }
  std::size_t page_step() const { return page_ > 3 ? page_ - 2 : 1; }
  std::vector<std::string> upwards(std::size_t count) const {
    std::vector<std::string> shown;
    for (std::size_t row = lowest_ + 1; row-- > 0 && shown.size() < count;) shown.push_back(rows_[row]);
    return shown;
  }

 private:
  std::vector<std::string> rows_;
  std::size_t lowest_ = 0, page_ = 1;
};

TEST(Scrollback, ShowsTheRowsOfTheReference) {
  for (int seed = 0; seed < test::effort(300, 40); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    ConsoleLog log;
    Scrollback scrollback;
    ReferencePage reference;
    const int columns = 1 + static_cast<int>(random.below(12)), page = 1 + static_cast<int>(random.below(9));
    scrollback.set_page(columns, page);
    reference.set_page(page);
    for (int step = 0; step < 60; ++step) {
      const std::size_t action = step == 0 ? 0 : random.below(7);
      const std::size_t rows = random.below(8);
      if (action == 0) {
        for (std::size_t i = 1 + random.below(4); i > 0; --i)
          log.print(std::string(random.below(30), 'x') + " end\n", step);
        reference.set_log(log, columns);
      } else if (action == 1) {
        scrollback.scroll_up(log, static_cast<int>(rows)), reference.scroll_up(rows);
      } else if (action == 2) {
        scrollback.scroll_down(log, static_cast<int>(rows)), reference.scroll_down(rows);
      } else if (action == 3) {
        scrollback.page_up(log), reference.scroll_up(reference.page_step());
      } else if (action == 4) {
        scrollback.page_down(log), reference.scroll_down(reference.page_step());
      } else if (action == 5) {
        scrollback.scroll_to_start(log), reference.scroll_to_start();
      } else {
        scrollback.scroll_to_end(), reference.scroll_to_end();
      }
      std::vector<std::string_view> shown;
      scrollback.collect_rows_upwards(log, 12, shown);
      ASSERT_EQ(std::vector<std::string>(shown.begin(), shown.end()), reference.upwards(12))
          << "seed " << seed << ", step " << step << ", action " << action;
      ASSERT_EQ(scrollback.is_at_end(), reference.is_at_end()) << "seed " << seed << ", step " << step;
    }
  }
}

TEST(Scrollback, SurvivesTheLossOfItsLines) {
  ConsoleLog log;
  Scrollback scrollback;
  std::vector<std::string_view> shown;
  scrollback.set_page(10, 3);
  scrollback.scroll_up(log, 5);
  scrollback.collect_rows_upwards(log, 9, shown);
  EXPECT_THAT(shown, IsEmpty());
  for (int i = 0; i < 10; ++i) log.print(fmt::format("{}\n", i), 0);
  scrollback.scroll_to_start(log);
  scrollback.collect_rows_upwards(log, 9, shown);
  EXPECT_THAT(shown, ElementsAre("2", "1", "0"));
  for (std::size_t i = 0; i < 2 * ConsoleLog::kMaxLines; ++i) log.print("new\n", 0);
  scrollback.collect_rows_upwards(log, 9, shown);
  EXPECT_THAT(shown, ElementsAre("new", "new", "new"));
  scrollback.set_page(1, 2);
  scrollback.collect_rows_upwards(log, 9, shown);
  EXPECT_FALSE(shown.empty());
  log.clear();
  scrollback.collect_rows_upwards(log, 9, shown);
  EXPECT_THAT(shown, IsEmpty());
  EXPECT_TRUE(scrollback.is_at_end());
}

}  // namespace
}  // namespace temblor::client
