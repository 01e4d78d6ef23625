#include "client/console/input_history.h"

#include <algorithm>

#include "base/text.h"
#include "client/console/edit_line.h"

namespace temblor::client {

// Repeated lines would make stepping back tedious, so only one of them is kept.
void InputHistory::add(std::string_view line) {
  stop();
  if (line.empty() || (!lines_.empty() && lines_.back() == line)) return;
  lines_.emplace_back(line);
  if (lines_.size() > kMaxLines) lines_.pop_front();
}

// The first step back saves the typed line.
std::optional<std::string> InputHistory::older(std::string_view typed) {
  if (lines_.empty() || shown_ == 0u) return std::nullopt;
  if (!shown_) typed_ = typed;
  shown_ = shown_.value_or(lines_.size()) - 1;
  return lines_[*shown_];
}

// A step past the newest line returns to the typed one.
std::optional<std::string> InputHistory::newer() {
  if (!shown_) return std::nullopt;
  if (++*shown_ < lines_.size()) return lines_[*shown_];
  stop();
  return typed_;
}

std::optional<std::size_t> InputHistory::find_before(std::size_t before, std::string_view text) const {
  const std::string wanted = base::to_lower(text);
  for (std::size_t number = std::min(before, lines_.size()); number-- > 0;)
    if (base::to_lower(lines_[number]).find(wanted) != std::string::npos) return number;
  return std::nullopt;
}

void InputHistory::load(std::string_view text) {
  EditLine line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    // Looks at no more of a line than could fit.
    line.set(text.substr(0, std::min(end, 2 * EditLine::kMaxBytes)));
    add(line.text());
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string InputHistory::text() const {
  std::string text;
  for (const std::string& line : lines_) {
    text += line;
    text += '\n';
  }
  return text;
}

}  // namespace temblor::client
