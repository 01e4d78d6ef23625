#include "client/menu/lettering.h"

#include <algorithm>

#include "base/text.h"

namespace temblor::client {
namespace {

constexpr unsigned char kShape = 127, kOtherColor = 128;
constexpr unsigned char kFirstBracket = 16, kLastDigit = 28;  // of those below the space that are text

bool is_text(char c) {
  const auto shape = static_cast<unsigned char>(static_cast<unsigned char>(c) & kShape);
  return (shape >= kFirstBracket && shape <= kLastDigit) || (shape >= ' ' && shape < kShape);
}

bool same_letter(char a, char b) {
  const auto plain = [](char c) { return base::to_lower(static_cast<char>(c & kShape)); };
  return plain(a) == plain(b);
}

// How many characters of `text`, which has more than `chars`, stand on its first line, and how many with the
// space that is dropped behind them.
std::pair<std::size_t, std::size_t> first_line(std::string_view text, std::size_t chars) {
  const std::size_t space = text.substr(0, chars + 1).rfind(' ');
  if (space == std::string_view::npos || space == 0) return {chars, chars};
  return {space, space + 1};
}

}  // namespace

std::string shown(std::string_view text) {
  std::string plain(text);
  for (char& c : plain)
    if (!is_text(c)) c = ' ';
  return plain;
}

std::string in_second_color(std::string_view text) {
  std::string colored(text);
  for (char& c : colored) c = static_cast<char>(static_cast<unsigned char>(c) | kOtherColor);
  return colored;
}

std::string cut(std::string_view text, std::size_t chars) {
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
      wrapped.push_back(cut(shown(text.substr(0, chars + 1)), chars));
      break;
    }
    if (line.size() <= chars) {
      wrapped.push_back(shown(line));
      text.remove_prefix(std::min(end + 1, text.size()));
    } else {
      const auto [kept, taken] = first_line(line, chars);
      wrapped.push_back(shown(line.substr(0, kept)));
      text.remove_prefix(taken);
    }
  }
  return wrapped;
}

bool holds(std::string_view text, std::string_view part) {
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same_letter) != text.end();
}

}  // namespace temblor::client
