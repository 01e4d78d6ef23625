// Built-in functions that convert texts: letters and their codes, cases, colors, padding, integers, info
// strings
// ("\key\value"), and URIs.
#include <algorithm>
#include <bit>
#include <charconv>

#include "base/text.h"
#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// In the game's character set, codes from 128 on are the same letters in red.
constexpr unsigned char kRed = 128, kShape = 127;

unsigned char shape(char c) {
  return static_cast<unsigned char>(c) & kShape;
}

// str2chr(text, place): the code of a letter, or 0 outside of the text. A negative place counts from the end.
base::Status str2chr(Call& io_call) {
  const std::string_view text = io_call.text(0);
  int place = to_whole(io_call.number_or(1, 0));
  if (place < 0) place += static_cast<int>(text.size());
  const bool is_inside = place >= 0 && static_cast<std::size_t>(place) < text.size();
  return io_call.return_number(is_inside ? static_cast<unsigned char>(text[static_cast<std::size_t>(place)])
                                         : 0);
}

// chr2str(code, ...)
base::Status chr2str(Call& io_call) {
  std::string text;
  for (int i = 0; i < io_call.count(); ++i)
    if (const auto code = static_cast<char>(io_call.whole(i) & 255); code != '\0') text += code;
  return io_call.return_text(text);
}

template <typename Change>
base::Status return_changed(Call& io_call, std::string text, Change change) {
  std::transform(text.begin(), text.end(), text.begin(), change);
  return io_call.return_text(text);
}

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
base::Status strtolower(Call& io_call) {
  return return_changed(io_call, std::string(io_call.text(0)), [](char c) { return base::to_lower(c); });
}
base::Status strtoupper(Call& io_call) {
  return return_changed(io_call, std::string(io_call.text(0)), upper);
}

// The color of a letter: 1 white, 2 red, other values leave it as it is.
char recolor(char c, int color) {
  if (color == 1) return static_cast<char>(shape(c));
  if (color == 2) return static_cast<char>(shape(c) | kRed);
  return c;
}

// strconv(case, letters, digits, text, ...): case is 1 for lower and 2 for upper; the others are colors.
base::Status strconv(Call& io_call) {
  const int letter_case = io_call.whole(0), letter_color = io_call.whole(1), digit_color = io_call.whole(2);
  return return_changed(io_call, io_call.joined_text(3), [=](char c) {
    const char plain = static_cast<char>(shape(c));
    if (plain >= '0' && plain <= '9') return recolor(c, digit_color);
    const bool is_letter = (plain >= 'a' && plain <= 'z') || (plain >= 'A' && plain <= 'Z');
    if (!is_letter) return c;
    const char cased = letter_case == 1 ? base::to_lower(plain) : letter_case == 2 ? upper(plain) : plain;
    return recolor(static_cast<char>(cased | (c & static_cast<char>(kRed))), letter_color);
  });
}

// strpad(width, text, ...): fills with spaces at the end, or for a negative width at the beginning.
base::Status strpad(Call& io_call) {
  constexpr int kMaxWidth = 4096;
  const int width = std::clamp(io_call.whole(0), -kMaxWidth, kMaxWidth);
  std::string text = io_call.joined_text(1);
  const auto wanted = static_cast<std::size_t>(std::abs(width));
  if (text.size() < wanted) text.insert(width < 0 ? 0 : text.size(), wanted - text.size(), ' ');
  return io_call.return_text(text);
}

// Removes color codes: "^" and a digit, or "^x" and three hexadecimal digits. "^^" is one "^".
std::string without_colors(std::string_view text) {
  const auto is_hex = [](char c) {
    const char lower = base::to_lower(c);
    return (c >= '0' && c <= '9') || (lower >= 'a' && lower <= 'f');
  };
  std::string plain;
  while (!text.empty()) {
    std::size_t skipped = 0;
    if (text[0] == '^' && text.size() > 1) {
      if (text[1] == '^') skipped = 1;
      if (text[1] >= '0' && text[1] <= '9') skipped = 2;
      if (text[1] == 'x' && text.size() > 4 && std::all_of(text.begin() + 2, text.begin() + 5, is_hex))
        skipped = 5;
    }
    if (skipped < 2) plain += text[0];
    text.remove_prefix(std::max<std::size_t>(skipped == 1 ? 2 : skipped, 1));
  }
  return plain;
}
base::Status strlennocol(Call& io_call) {
  return io_call.return_number(static_cast<double>(without_colors(io_call.text(0)).size()));
}
base::Status strdecolorize(Call& io_call) {
  return io_call.return_text(without_colors(io_call.text(0)));
}

// Integers are raw words, which newer compilers know as a type.
base::Status return_integer(Call& io_call, std::uint32_t value) {
  io_call.machine.return_float(std::bit_cast<float>(value));
  return base::Ok{};
}
std::uint32_t integer(const Call& call, int i) {
  return std::bit_cast<std::uint32_t>(call.number(i));
}
std::uint32_t parse_integer(std::string_view text, int radix) {
  std::int64_t value = 0;
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (radix == 16 && (text.starts_with("0x") || text.starts_with("0X"))) text.remove_prefix(2);
  std::from_chars(text.data(), text.data() + text.size(), value, radix);
  return static_cast<std::uint32_t>(value);
}
base::Status stoi(Call& io_call) {
  return return_integer(io_call, parse_integer(io_call.text(0), 10));
}
base::Status stoh(Call& io_call) {
  return return_integer(io_call, parse_integer(io_call.text(0), 16));
}
base::Status itos(Call& io_call) {
  return io_call.return_text(fmt::format("{}", static_cast<std::int32_t>(integer(io_call, 0))));
}
base::Status htos(Call& io_call) {
  return io_call.return_text(fmt::format("{:08x}", integer(io_call, 0)));
}

// Finds "\key\value" and returns the place of its value: [begin, end) and where the pair begins.
struct InfoPlace {
  std::size_t pair = std::string_view::npos, begin = 0, end = 0;
};
InfoPlace find_info(std::string_view info, std::string_view key) {
  for (std::size_t pair = info.find('\\'); pair < info.size();) {
    const std::size_t key_end = std::min(info.find('\\', pair + 1), info.size());
    const std::size_t begin = std::min(key_end + 1, info.size());
    const std::size_t end = std::min(info.find('\\', begin), info.size());
    if (info.substr(pair + 1, key_end - pair - 1) == key) return {pair, begin, end};
    pair = end;
  }
  return {};
}

// infoget(info, key): empty if there is no such key.
base::Status infoget(Call& io_call) {
  const std::string_view info = io_call.text(0);
  const InfoPlace place = find_info(info, io_call.text(1));
  return io_call.return_text(info.substr(place.begin, place.end - place.begin));
}

// infoadd(info, key, value): an empty value removes the key.
base::Status infoadd(Call& io_call) {
  std::string info(io_call.text(0));
  const std::string_view key = io_call.text(1), value = io_call.text(2);
  if (const InfoPlace place = find_info(info, key); place.pair != std::string_view::npos)
    info.erase(place.pair, place.end - place.pair);
  if (!value.empty()) info += fmt::format("\\{}\\{}", key, value);
  return io_call.return_text(info);
}

// uri_escape() and uri_unescape(): RFC 3986, section 2.
base::Status uri_escape(Call& io_call) {
  constexpr std::string_view kPlain = "-_.~";
  std::string escaped;
  for (const char c : io_call.text(0)) {
    const char lower = base::to_lower(c);
    const bool is_plain =
        (lower >= 'a' && lower <= 'z') || (c >= '0' && c <= '9') || kPlain.find(c) != kPlain.npos;
    escaped += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return io_call.return_text(escaped);
}
base::Status uri_unescape(Call& io_call) {
  const std::string_view text = io_call.text(0);
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    int code = 0;
    const char* const digits = text.data() + i + 1;
    if (text[i] == '%' && text.size() - i > 2 &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      if (code != 0) plain += static_cast<char>(code);
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return io_call.return_text(plain);
}

// crc16(ignores_case, text, ...): the sum that the network protocol of the original uses (CCITT).
base::Status crc16(Call& io_call) {
  constexpr std::uint32_t kPolynomial = 0x1021;
  std::uint32_t crc = 0xffff;
  for (const char c : io_call.joined_text(1)) {
    const char counted = io_call.number(0) != 0 ? base::to_lower(c) : c;
    crc ^= static_cast<std::uint32_t>(static_cast<unsigned char>(counted)) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1 ^ ((crc & 0x8000) != 0 ? kPolynomial : 0)) & 0xffff;
  }
  return io_call.return_number(crc);
}

}  // namespace

std::span<const Entry> conversion_builtins() {
  static constexpr Entry kEntries[] = {
      {222, "str2chr", str2chr},
      {223, "chr2str", chr2str},
      {224, "strconv", strconv},
      {225, "strpad", strpad},
      {226, "infoadd", infoadd},
      {227, "infoget", infoget},
      {259, "stoi", stoi},
      {260, "itos", itos},
      {261, "stoh", stoh},
      {262, "htos", htos},
      {476, "strlennocol", strlennocol},
      {477, "strdecolorize", strdecolorize},
      {480, "strtolower", strtolower},
      {481, "strtoupper", strtoupper},
      {494, "crc16", crc16},
      {510, "uri_escape", uri_escape},
      {511, "uri_unescape", uri_unescape},
  };
  return kEntries;
}

}  // namespace temblor::builtins
