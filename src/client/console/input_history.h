// The lines that were entered before: to go back through, to search, and to keep between runs.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace temblor::client {

class InputHistory {
 public:
  static constexpr std::size_t kMaxLines = 512;  // older ones are forgotten

  // An empty line, and one that is the same as the last, is not kept. Going through them is over.
  void add(std::string_view line);

  // The line before the one that is shown, or after it; nothing where there is none. Going back from what is
  // being typed, that is kept, and comes again after the last line.
  std::optional<std::string> older(std::string_view typed);
  std::optional<std::string> newer();
  void stop() { shown_.reset(); }

  // The last line before line number `before` in which the text occurs, without regard to case.
  std::optional<std::size_t> find_before(std::size_t before, std::string_view text) const;
  const std::string& line(std::size_t number) const { return lines_[number]; }  // 0: the oldest
  std::size_t size() const { return lines_.size(); }

  // One line each. What is read is added to what there is, as far as it can be typed.
  void load(std::string_view text);
  std::string text() const;

 private:
  std::deque<std::string> lines_;
  std::optional<std::size_t> shown_;  // while going through them
  std::string typed_;
};

}  // namespace temblor::client
