// Built-in functions that compare texts, and search and replace in them.
#include <algorithm>
#include <limits>

#include "base/text.h"
#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// Bounds what one call makes of short texts.
constexpr std::size_t kMaxReplacedChars = std::size_t{1} << 20;

// The text from parameter `i`, from the place in parameter `offset` on, if that was passed.
std::string_view text_from(const Call& call, int i, int offset) {
  const std::string_view text = call.text(i);
  const int begin = std::max(to_whole(call.number_or(offset, 0)), 0);
  return text.substr(std::min(static_cast<std::size_t>(begin), text.size()));
}

// Returns less than 0, 0, or more than 0, as C's strcmp(). Bytes are unsigned.
base::Status compare(Call& io_call, std::string_view a, std::string_view b, bool ignores_case) {
  const auto byte = [ignores_case](char c) {
    return static_cast<unsigned char>(ignores_case ? base::to_lower(c) : c);
  };
  const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(),
                                          [&](char x, char y) { return byte(x) == byte(y); });
  const int code_a = at_a == a.end() ? 0 : byte(*at_a), code_b = at_b == b.end() ? 0 : byte(*at_b);
  return io_call.return_number(code_a < code_b ? -1 : code_a > code_b ? 1 : 0);
}

// strncmp(a, b, count, first_a, first_b) and strncasecmp(): the last three are optional.
base::Status compare_parts(Call& io_call, bool ignores_case) {
  const int limit = io_call.count() > 2 ? std::max(io_call.whole(2), 0) : std::numeric_limits<int>::max();
  const auto count = static_cast<std::size_t>(limit);
  return compare(io_call, text_from(io_call, 0, 3).substr(0, count),
                 text_from(io_call, 1, 4).substr(0, count), ignores_case);
}
base::Status strncmp(Call& io_call) {
  return compare_parts(io_call, false);
}
base::Status strncasecmp(Call& io_call) {
  return compare_parts(io_call, true);
}
base::Status strcasecmp(Call& io_call) {
  return compare(io_call, io_call.text(0), io_call.text(1), true);
}

// strstrofs(text, part, first): where the part begins, or -1.
base::Status strstrofs(Call& io_call) {
  const std::size_t first = static_cast<std::size_t>(std::max(to_whole(io_call.number_or(2, 0)), 0));
  const std::size_t found = io_call.text(0).find(io_call.text(1), first);
  return io_call.return_number(found == std::string_view::npos ? -1 : static_cast<double>(found));
}

// Replaces each occurrence of `search`; replaced text is not searched again.
base::Status replace(Call& io_call, bool ignores_case) {
  const std::string_view search = io_call.text(0), replacement = io_call.text(1), text = io_call.text(2);
  if (search.empty()) return io_call.return_text(text);
  const auto is_equal = [ignores_case](char a, char b) {
    return ignores_case ? base::to_lower(a) == base::to_lower(b) : a == b;
  };
  std::string replaced;
  auto at = text.begin();
  while (true) {
    const auto found = std::search(at, text.end(), search.begin(), search.end(), is_equal);
    replaced.append(at, found);
    if (found == text.end()) break;
    replaced += replacement;
    if (replaced.size() > kMaxReplacedChars)
      return io_call.error("the result is longer than {} characters", kMaxReplacedChars);
    at = found + static_cast<std::ptrdiff_t>(search.size());
  }
  return io_call.return_text(replaced);
}
base::Status strreplace(Call& io_call) {
  return replace(io_call, false);
}
base::Status strireplace(Call& io_call) {
  return replace(io_call, true);
}

}  // namespace

std::span<const Entry> comparison_builtins() {
  static constexpr Entry kEntries[] = {
      {221, "strstrofs", strstrofs},     {228, "strncmp", strncmp},         {0, "strcmp", strncmp},
      {229, "strcasecmp", strcasecmp},   {230, "strncasecmp", strncasecmp}, {484, "strreplace", strreplace},
      {485, "strireplace", strireplace},
  };
  return kEntries;
}

}  // namespace temblor::builtins
