// The bytes of a .map, one token after another. White space and comments before a token are passed over;
// where a token is not what was asked for, nothing is taken.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace temblor::formats::map {

class Scanner {
 public:
  // The text ends at its first zero byte; a byte order mark is passed over.
  explicit Scanner(std::string_view text);

  // The first character of the next token; 0 at the end.
  char peek();
  bool accept(char expected);
  // Up to white space; empty at the end. How unquoted texture names are written, braces and all.
  std::string_view run();
  // Up to white space, a brace or a quote.
  std::string_view word();
  // What stands between quotes on one line. Nothing when the next token is no quote or is never closed.
  std::optional<std::string_view> quoted();
  // The same for an entity's value, in which some editors write \" for a quote. A level's entity text can
  // hold none, so an apostrophe takes its place. A path's last backslash, with nothing behind the quote but
  // the line's end, closes the value.
  std::optional<std::string> quoted_value();
  // A finite number.
  std::optional<double> number();
  // A whole number of 32 bits, with or without sign.
  std::optional<std::int32_t> whole_number();

  // Where the next token starts, from 1.
  std::uint32_t line();

 private:
  void skip();
  bool ends_line(const char* at) const;
  template <typename Number>
  const char* parse_number(Number& out_number);

  const char* at_;
  const char* end_;
  std::uint32_t line_ = 1;
};

}  // namespace temblor::formats::map
