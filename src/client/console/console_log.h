// The console's output: lines of text, with their times.
//
// Text is stored in the character set of Quake's conchars picture, one byte per character: codes 32 to 126
// are ASCII, lower ones are frames, dots and gold digits, and the upper 128 codes repeat the lower ones in
// bronze. Stock Quake kept 16 KB in a ring; this log keeps more, and numbers its lines so that readers
// (scrolling, messages over the game) can hold positions while lines are added and dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace temblor::client {

// Owns its text. Not safe for use by several threads.
class ConsoleLog {
 public:
  // Limits. Beyond the first two the oldest lines are dropped; a line that reaches the third is ended.
  static constexpr std::size_t kMaxChars = std::size_t{1} << 19, kMaxLines = std::size_t{1} << 14;
  static constexpr std::size_t kMaxLineChars = 4096;

  struct Line {
    std::string text;
    double time_s = 0;  // of the last addition to the line
  };

  // Prints text from the game or its server: any bytes. Continues the last line; '\n' ends the line, and '\r'
  // lets the next text replace it. A leading byte 1 or 2 prints everything in bronze.
  void print(std::string_view text, double time_s);
  // Prints the engine's own text or that of files: UTF-8, with '?' for characters that are not ASCII.
  void print_utf8(std::string_view text, double time_s);
  // Removes all lines. Line numbers continue.
  void clear();

  // Lines have permanent numbers in [begin_line(), end_line()). The last line may still grow.
  std::uint64_t begin_line() const { return begin_line_; }
  std::uint64_t end_line() const { return begin_line_ + lines_.size(); }
  const Line& line(std::uint64_t number) const {
    return lines_[static_cast<std::size_t>(number - begin_line_)];
  }

  // The whole log in plain ASCII, for a file: without colors, with symbols replaced by similar ASCII
  // characters. Each line ends with '\n'.
  std::string text() const;

 private:
  void add(std::string_view text, std::uint8_t color, double time_s);
  void add(char c, double time_s);
  void end_line_at(double time_s);
  void forget_old();

  std::deque<Line> lines_;
  std::uint64_t begin_line_ = 0;
  std::size_t chars_ = 0;
  bool grows_ = false;     // the last line is incomplete
  bool returned_ = false;  // and the next text replaces it
};

}  // namespace temblor::client
