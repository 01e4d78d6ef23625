#include "client/menu/lettering.h"

#include <algorithm>

#include "base/text.h"

namespace temblor::client {
namespace {

constexpr unsigned char kShape = 127, kOtherColor = 128;
// Brackets, a dot and gold digits: text among the codes below the space.
constexpr unsigned char kFirstBracket = 16, kLastDigit = 28;

// Whether a code is a letter, digit or sign in either color, rather than a frame or a slider's part.
bool is_text(char c) {
  const auto shape = static_cast<unsigned char>(static_cast<unsigned char>(c) & kShape);
  return (shape >= kFirstBracket && shape <= kLastDigit) || (shape >= ' ' && shape < kShape);
}

bool is_same_letter(char a, char b) {
  const auto to_plain = [](char c) { return base::to_lower(static_cast<char>(c & kShape)); };
  return to_plain(a) == to_plain(b);
}

// For text longer than `chars`: returns how many characters the first line has, and how many to skip,
// including the space after the line. A word that is longer than a line is split.
std::pair<std::size_t, std::size_t> split_first_line(std::string_view text, std::size_t chars) {
  const std::size_t space = text.substr(0, chars + 1).rfind(' ');
  if (space == std::string_view::npos || space == 0) return {chars, chars};
  return {space, space + 1};
}

}  // namespace

std::string to_printable(std::string_view text) {
  std::string printable(text);
  for (char& c : printable)
    if (!is_text(c)) c = ' ';
  return printable;
}

std::string to_second_color(std::string_view text) {
  std::string colored(text);
  for (char& c : colored) c = static_cast<char>(static_cast<unsigned char>(c) | kOtherColor);
  return colored;
}

std::string truncate(std::string_view text, std::size_t chars) {
  constexpr std::string_view kMissing = "..";
  if (text.size() <= chars) return std::string(text);
  if (chars <= kMissing.size()) return std::string(text.substr(0, chars));
  return std::string(text.substr(0, chars - kMissing.size())) + std::string(kMissing);
}

std::vector<std::string> wrap(std::string_view text, std::size_t chars, std::size_t lines) {
  std::vector<std::string> wrapped;
  while (!text.empty() && wrapped.size() < lines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (wrapped.size() + 1 == lines) {
      wrapped.push_back(truncate(to_printable(text.substr(0, chars + 1)), chars));
      break;
    }
    if (line.size() <= chars) {
      wrapped.push_back(to_printable(line));
      text.remove_prefix(std::min(end + 1, text.size()));
    } else {
      const auto [line_length, skipped] = split_first_line(line, chars);
      wrapped.push_back(to_printable(line.substr(0, line_length)));
      text.remove_prefix(skipped);
    }
  }
  return wrapped;
}

bool contains_text(std::string_view text, std::string_view part) {
  return std::search(text.begin(), text.end(), part.begin(), part.end(), is_same_letter) != text.end();
}

}  // namespace temblor::client
