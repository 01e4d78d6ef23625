// Small text helpers: names in Quake's data are compared without regard to ASCII case.
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

// A name from a file, fit for one line of a message: '?' for what is not printable ASCII.
inline std::string printable(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (c < ' ' || c > '~') c = '?';
  return line;
}

// "1 frag", "2 frags". `noun`: in the singular.
inline std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

// As much of it as a message of one line can bear.
inline std::string quotable(std::string_view text, std::size_t max_chars = 40) {
  return printable(text.substr(0, max_chars)) + (text.size() > max_chars ? "..." : "");
}

}  // namespace temblor::base
