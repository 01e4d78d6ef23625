// The history of input lines: to step through, to search, and to save between runs.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace temblor::client {

// Lines are numbered from 0, the oldest. Numbers shift when a line is dropped, so they are valid only until
// the next add().
class InputHistory {
 public:
  static constexpr std::size_t kMaxLines = 512;  // older lines are dropped

  // Adds a line, unless it is empty or repeats the last one. Ends stepping through the history.
  void add(std::string_view line);

  // Steps through the history and returns the line to show, or nothing at the ends. `typed` is the line being
  // typed: the first step saves it, and newer() returns it again after the newest line.
  std::optional<std::string> older(std::string_view typed);
  std::optional<std::string> newer();
  // Ends stepping: the next older() starts at the newest line.
  void stop() { shown_.reset(); }

  // The number of the last line before line `before` that contains the text, ignoring case.
  std::optional<std::size_t> find_before(std::size_t before, std::string_view text) const;
  const std::string& line(std::size_t number) const { return lines_[number]; }  // 0 is the oldest
  std::size_t size() const { return lines_.size(); }

  // The saved form: one line each, oldest first. load() appends to the history; lines pass through the same
  // filter as typed text, so a damaged file does no harm.
  void load(std::string_view text);
  std::string text() const;

 private:
  std::deque<std::string> lines_;
  // The line shown while stepping; nothing otherwise.
  std::optional<std::size_t> shown_;
  // The line that was being typed before stepping.
  std::string typed_;
};

}  // namespace temblor::client
