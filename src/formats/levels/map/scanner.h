// Tokenizer for .map texts. Skips white space and comments before each token. If the next token is not of the
// requested type, nothing is consumed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace temblor::formats::map {

class Scanner {
 public:
  // The text ends at its first zero byte; a byte order mark is skipped.
  explicit Scanner(std::string_view text);

  // Returns the first character of the next token; 0 at the end.
  char peek();
  // Consumes the next character if it is `expected`, and returns whether it was.
  bool accept(char expected);
  // Reads up to white space; empty at the end. Unquoted texture names look like this, and may contain braces.
  std::string_view run();
  // Reads up to white space, a brace, or a quote.
  std::string_view word();
  // Reads a quoted text on one line. Returns nullopt if the next token is not a quote, or the quote is not
  // closed.
  std::optional<std::string_view> quoted();
  // Like quoted(), for the value of an entity: replaces the \" of some editors with an apostrophe, because
  // the entity text of a level cannot contain quotes. However, a backslash before the last quote of a line is
  // the end of a path, and the quote closes the value:
  //
  //   "message" "The \"Slipgate\""   reads as   The 'Slipgate'
  //   "wad" "c:\quake\"              reads as   c:\quake\ with the backslash
  std::optional<std::string> quoted_value();
  // Reads a finite number.
  std::optional<double> number();
  // Reads a 32-bit integer with an optional sign.
  std::optional<std::int32_t> whole_number();

  // Returns the line of the next token, from 1.
  std::uint32_t line();

 private:
  // Skips white space and comments.
  void skip();
  // Returns whether only white space is left on the line.
  bool ends_line(const char* at) const;
  template <typename Number>
  const char* parse_number(Number& out_number);

  const char* at_;
  const char* end_;
  std::uint32_t line_ = 1;
};

}  // namespace temblor::formats::map
