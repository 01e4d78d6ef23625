// Small text helpers. Names in Quake's data are ASCII, and are compared without case.
#pragma once

#include <string>
#include <string_view>

namespace temblor::base {

constexpr char to_lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = to_lower(c);
  return lower;
}

constexpr bool equal_ignoring_case(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (to_lower(a[i]) != to_lower(b[i])) return false;
  return true;
}

// Makes text from a file or a packet safe for a one-line message: replaces everything except printable ASCII
// with '?'.
inline std::string printable(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (c < ' ' || c > '~') c = '?';
  return line;
}

// Formats a count: "1 frag", "2 frags". `noun`: singular, with a plural in -s.
inline std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

// Like printable(), truncated to `max_chars` with "...".
inline std::string quotable(std::string_view text, std::size_t max_chars = 40) {
  return printable(text.substr(0, max_chars)) + (text.size() > max_chars ? "..." : "");
}

}  // namespace temblor::base
