// What the console has printed: lines of the console's characters, one byte each, of which the upper half is
// the lower one in bronze.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace temblor::client {

class ConsoleLog {
 public:
  // When there is more of one of these, the oldest lines go. A line that grows longer is ended.
  static constexpr std::size_t kMaxChars = std::size_t{1} << 19, kMaxLines = std::size_t{1} << 14;
  static constexpr std::size_t kMaxLineChars = 4096;

  struct Line {
    std::string text;
    double time_s = 0;  // when something was last added to it
  };

  // Text of the game and its server, as it comes: any bytes. It goes on where the last left off; '\n' ends a
  // line, '\r' lets what follows take the line's place. A 1 or 2 in front makes all of it bronze.
  void print(std::string_view text, double time_s);
  // Text of ours and of files: UTF-8, '?' for what is not ASCII.
  void print_utf8(std::string_view text, double time_s);
  void clear();

  // Lines have numbers, which stay: [begin_line(), end_line()), the last may still grow.
  std::uint64_t begin_line() const { return begin_line_; }
  std::uint64_t end_line() const { return begin_line_ + lines_.size(); }
  const Line& line(std::uint64_t number) const {
    return lines_[static_cast<std::size_t>(number - begin_line_)];
  }

  // All of it in plain ASCII, as for a file: colors are lost, and what is no letter is the nearest one.
  std::string text() const;

 private:
  void add(std::string_view text, std::uint8_t color, double time_s);
  void add(char c, double time_s);
  void end_line_at(double time_s);
  void forget_old();

  std::deque<Line> lines_;
  std::uint64_t begin_line_ = 0;
  std::size_t chars_ = 0;
  bool grows_ = false;     // the last line has not ended
  bool returned_ = false;  // and what comes next takes its place
};

}  // namespace temblor::client
