#include "formats/levels/map/scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace temblor::formats::map {
namespace {

constexpr bool is_space(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}
constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
// Characters that may follow a number.
constexpr bool ends_number(char c) {
  return is_space(c) || c == ')' || c == ']' || c == '}';
}

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

Scanner::Scanner(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  at_ = text.data();
  end_ = at_ + text.size();
}

void Scanner::skip() {
  while (at_ != end_) {
    if (is_space(*at_)) {
      // CR LF, CR, and LF each count as one line end.
      if (*at_ == '\n' || (*at_ == '\r' && (at_ + 1 == end_ || at_[1] != '\n'))) ++line_;
      ++at_;
    } else if (*at_ == ';' || (*at_ == '/' && at_ + 1 != end_ && at_[1] == '/')) {
      at_ = std::find_if(at_, end_, is_line_end);
    } else {
      return;
    }
  }
}

char Scanner::peek() {
  skip();
  return at_ == end_ ? '\0' : *at_;
}

bool Scanner::accept(char expected) {
  if (peek() != expected) return false;
  ++at_;
  return true;
}

std::string_view Scanner::run() {
  skip();
  const char* const begin = at_;
  at_ = std::find_if(at_, end_, is_space);
  return between(begin, at_);
}

std::string_view Scanner::word() {
  skip();
  const char* const begin = at_;
  at_ = std::find_if(at_, end_, [](char c) { return is_space(c) || c == '{' || c == '}' || c == '"'; });
  return between(begin, at_);
}

std::optional<std::string_view> Scanner::quoted() {
  if (peek() != '"') return std::nullopt;
  const char* const begin = at_ + 1;
  const char* const close = std::find_if(begin, end_, [](char c) { return c == '"' || is_line_end(c); });
  if (close == end_ || *close != '"') return std::nullopt;
  at_ = close + 1;
  return between(begin, close);
}

std::optional<std::string> Scanner::quoted_value() {
  if (peek() != '"') return std::nullopt;
  std::string value;
  for (const char* from = at_ + 1;;) {
    const char* const close = std::find_if(from, end_, [](char c) { return c == '"' || is_line_end(c); });
    if (close == end_ || *close != '"') return std::nullopt;
    const bool is_escaped = close != from && close[-1] == '\\' && !ends_line(close + 1);
    value += between(from, is_escaped ? close - 1 : close);
    if (!is_escaped) {
      at_ = close + 1;
      return value;
    }
    value += '\'';
    from = close + 1;
  }
}

bool Scanner::ends_line(const char* at) const {
  const char* const next = std::find_if(at, end_, [](char c) { return !is_space(c) || is_line_end(c); });
  return next == end_ || is_line_end(*next);
}

// Returns the end of the number that starts here, or null.
template <typename Number>
const char* Scanner::parse_number(Number& out_number) {
  skip();
  const char* begin = at_;
  // from_chars rejects a plus sign, so skip it; but not before another sign.
  if (begin != end_ && *begin == '+' && ++begin != end_ && *begin == '-') return nullptr;
  const auto [after, code] = std::from_chars(begin, end_, out_number);
  return code == std::errc{} && (after == end_ || ends_number(*after)) ? after : nullptr;
}

std::optional<double> Scanner::number() {
  double value = 0;
  const char* const after = parse_number(value);
  if (after == nullptr || !std::isfinite(value)) return std::nullopt;
  at_ = after;
  return value;
}

std::optional<std::int32_t> Scanner::whole_number() {
  std::int64_t value = 0;
  const char* const after = parse_number(value);
  if (after == nullptr || value < std::numeric_limits<std::int32_t>::min() ||
      value > std::numeric_limits<std::uint32_t>::max())
    return std::nullopt;
  at_ = after;
  return static_cast<std::int32_t>(value);
}

std::uint32_t Scanner::line() {
  skip();
  return line_;
}

}  // namespace temblor::formats::map
