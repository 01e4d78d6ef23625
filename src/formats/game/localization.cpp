#include "formats/game/localization.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/text.h"

namespace temblor::formats {
namespace {

using base::ErrorCode;

constexpr std::size_t kMaxKeyChars = 128;
// Longer chains of references are taken for an error, like endless ones.
constexpr int kMaxReferences = 8;

bool is_key_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.';
}

// Returns the key of "$key and more"; empty if the text does not begin with one.
std::string_view find_key(std::string_view text) {
  if (!text.starts_with('$')) return {};
  text.remove_prefix(1);
  const auto end = std::find_if_not(text.begin(), text.end(), is_key_char);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kLineBlanks = " \t\r";
  const std::size_t begin = std::min(text.find_first_not_of(kLineBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kLineBlanks) + 1 - begin);
}

// The letters U+00C0 to U+00FF without their accents, in order. Two letters stand for one where readers
// expect it.
constexpr std::array<std::string_view, 64> kLatinLetters = {
    "A", "A", "A", "A", "A", "A", "AE", "C", "E", "E", "E", "E", "I", "I", "I", "I",   // C0
    "D", "N", "O", "O", "O", "O", "O",  "x", "O", "U", "U", "U", "U", "Y", "?", "ss",  // D0
    "a", "a", "a", "a", "a", "a", "ae", "c", "e", "e", "e", "e", "i", "i", "i", "i",   // E0
    "d", "n", "o", "o", "o", "o", "o",  "/", "o", "u", "u", "u", "u", "y", "?", "y",   // F0
};

struct Substitute {
  std::uint32_t code_point;
  std::string_view text;
};
// Punctuation that writers use in place of ASCII, and letters for which one of the tables below is too short.
constexpr std::array kSubstitutes = {
    Substitute{0xa0, " "},    Substitute{0xa1, "!"},    Substitute{0xab, "\""},    Substitute{0xbb, "\""},
    Substitute{0xbf, "?"},    Substitute{0x132, "IJ"},  Substitute{0x133, "ij"},   Substitute{0x152, "OE"},
    Substitute{0x153, "oe"},  Substitute{0x401, "Yo"},  Substitute{0x451, "yo"},   Substitute{0x2013, "-"},
    Substitute{0x2014, "-"},  Substitute{0x2018, "'"},  Substitute{0x2019, "'"},   Substitute{0x201c, "\""},
    Substitute{0x201d, "\""}, Substitute{0x201e, "\""}, Substitute{0x2026, "..."}, Substitute{0xfeff, ""},
};

// The letters U+0100 to U+017F, of the other languages with Latin letters, without their accents.
constexpr std::string_view kMoreLatinLetters =
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(kMoreLatinLetters.size() == 128);

// The Russian letters U+0410 to U+042F in Latin ones, as maps and newspapers write them; the small letters
// follow the capitals at U+0430.
constexpr std::array<std::string_view, 32> kRussianLetters = {
    "A", "B", "V", "G", "D", "E",  "Zh", "Z",  "I",  "Y",    "K", "L", "M", "N", "O",  "P",   // 410
    "R", "S", "T", "U", "F", "Kh", "Ts", "Ch", "Sh", "Shch", "",  "Y", "",  "E", "Yu", "Ya",  // 420
};

// Returns nullopt for a letter that the game's characters cannot write.
std::optional<std::string> to_game_characters(std::uint32_t code_point) {
  if (code_point >= 0xc0 && code_point <= 0xff) return std::string(kLatinLetters[code_point - 0xc0]);
  const auto found = std::find_if(kSubstitutes.begin(), kSubstitutes.end(),
                                  [&](const Substitute& entry) { return entry.code_point == code_point; });
  if (found != kSubstitutes.end()) return std::string(found->text);
  if (code_point >= 0x100 && code_point <= 0x17f)
    return std::string(1, kMoreLatinLetters[code_point - 0x100]);
  if (code_point >= 0x410 && code_point <= 0x42f) return std::string(kRussianLetters[code_point - 0x410]);
  if (code_point >= 0x430 && code_point <= 0x44f) return base::to_lower(kRussianLetters[code_point - 0x430]);
  return std::nullopt;
}

// Takes one character off the front. Invalid bytes count as one character each, U+FFFD.
std::uint32_t take_character(std::string_view& io_text) {
  const auto first = static_cast<std::uint8_t>(io_text.front());
  io_text.remove_prefix(1);
  if (first < 0x80) return first;
  const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  constexpr std::uint32_t kReplacement = 0xfffd;
  if (more == 0 || static_cast<std::size_t>(more) > io_text.size()) return kReplacement;
  std::uint32_t code_point = first & (0x3fu >> more);
  for (int i = 0; i < more; ++i) {
    const auto byte = static_cast<std::uint8_t>(io_text[static_cast<std::size_t>(i)]);
    if ((byte & 0xc0) != 0x80) return kReplacement;
    code_point = code_point << 6 | (byte & 0x3fu);
  }
  io_text.remove_prefix(static_cast<std::size_t>(more));
  return code_point;
}

// Reads what follows a backslash. Before any other character, the backslash stands for itself.
void take_escaped(std::string_view& io_text, std::string& io_value) {
  constexpr std::string_view kEscapes = "nt\"\\", kMeanings = "\n\t\"\\";
  const std::size_t escape = io_text.empty() ? std::string_view::npos : kEscapes.find(io_text.front());
  io_value += escape == std::string_view::npos ? '\\' : kMeanings[escape];
  if (escape != std::string_view::npos) io_text.remove_prefix(1);
}

struct QuotedText {
  std::string text;
  bool has_unknown_letters = false;  // each is '?' in the text
};

// `text` begins after the opening quote. Returns nullopt if there is no closing one.
std::optional<QuotedText> read_quoted(std::string_view text) {
  QuotedText value;
  while (!text.empty()) {
    const std::uint32_t character = take_character(text);
    if (character == '"') return value;
    if (character == '\\') {
      take_escaped(text, value.text);
    } else if (character < 0x80) {
      value.text += static_cast<char>(character);
    } else {
      const std::optional<std::string> known = to_game_characters(character);
      value.text += known.value_or("?");
      value.has_unknown_letters |= !known;
    }
  }
  return std::nullopt;
}

struct Entry {
  QuotedText quoted;
  std::size_t line = 0;
};
using Entries = std::map<std::string, Entry, std::less<>>;

struct KeyAndText {
  std::string key;
  QuotedText quoted;
};

// Reads `key = "text"`.
base::Result<KeyAndText> read_line(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return base::malformed("no '=' between a key and its text");
  const std::string_view key = trim(line.substr(0, equals));
  if (key.empty()) return base::malformed("no key before '='");
  if (key.size() > kMaxKeyChars)
    return base::error(ErrorCode::kTooLarge, "a key of {} characters, the limit is {}", key.size(),
                       kMaxKeyChars);
  if (!std::all_of(key.begin(), key.end(), is_key_char))
    return base::malformed("\"{}\" is not a key: letters, digits, '_', '-', and '.'", base::quotable(key));
  const std::string_view rest = trim(line.substr(equals + 1));
  if (!rest.starts_with('"')) return base::malformed("{}: no text in quotes after '='", key);
  std::optional<QuotedText> quoted = read_quoted(rest.substr(1));
  if (!quoted) return base::malformed("{}: the text has no closing quote", key);
  if (quoted->text.size() > kMaxLocalizedBytes)
    return base::error(ErrorCode::kTooLarge, "{}: a text of {} characters, the limit is {}", key,
                       quoted->text.size(), kMaxLocalizedBytes);
  return KeyAndText{std::string(key), *std::move(quoted)};
}

void add_problem(std::size_t line, std::string what, ReadLocalization& io_read) {
  if (++io_read.problem_count <= ReadLocalization::kMaxProblems)
    io_read.problems.push_back({line, std::move(what)});
}

// Returns the key that the text refers to, if it is one of the entries and the text is nothing else.
const Entry* find_reference(const Entries& entries, const Entry& entry) {
  const std::string& text = entry.quoted.text;
  const std::string_view key = find_key(text);
  if (key.empty() || key.size() + 1 != text.size()) return nullptr;
  const auto found = entries.find(key);
  return found == entries.end() ? nullptr : &found->second;
}

// Follows references to the text at their end; null if there is none.
const std::string* follow_references(const Entries& entries, const Entry& entry) {
  const Entry* current = &entry;
  for (int i = 0; i <= kMaxReferences; ++i) {
    const Entry* const next = find_reference(entries, *current);
    if (next == nullptr) return &current->quoted.text;
    current = next;
  }
  return nullptr;
}

}  // namespace

std::string Localization::localize(std::string_view text) const {
  const std::string_view key = find_key(text);
  const auto found = key.empty() ? texts_.end() : texts_.find(key);
  if (found == texts_.end()) return std::string(text);
  return found->second + std::string(text.substr(1 + key.size()));
}

std::string Localization::localize_joined(std::string_view text) const {
  std::string_view key = find_key(text).substr(0, kMaxKeyChars);
  auto found = texts_.find(key);
  const auto has_place = [&] { return found->second.find("{0}") != std::string::npos; };
  if (found != texts_.end() && !has_place()) return localize(text);
  // An argument in plain letters looks like a part of the key.
  while (!key.empty() && (found == texts_.end() || !has_place())) {
    key.remove_suffix(1);
    found = texts_.find(key);
  }
  if (key.empty()) return std::string(text);
  std::string_view rest = text.substr(1 + key.size());
  const std::string_view end = rest.substr(std::min(rest.find_last_not_of('\n') + 1, rest.size()));
  rest.remove_suffix(end.size());
  std::vector<std::string> arguments;
  for (rest = trim(rest); !rest.empty();) {
    const std::string_view argument = rest.substr(0, rest.find('$', 1));
    rest.remove_prefix(argument.size());
    arguments.push_back(localize(trim(argument)));
  }
  return fill_places(found->second, arguments) + std::string(end);
}

bool Localization::has_text_for(std::string_view text) const {
  const std::string_view key = find_key(text);
  return !key.empty() && texts_.find(key) != texts_.end();
}

void Localization::add(Localization other) {
  // merge() keeps the texts of its target, which are to win.
  other.texts_.merge(texts_);
  texts_ = std::move(other.texts_);
}

base::Result<ReadLocalization> read_localization(std::string_view text) {
  if (text.size() > kMaxLocalizationBytes)
    return base::error(ErrorCode::kTooLarge, "{} bytes, the limit is {}", text.size(), kMaxLocalizationBytes);
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    return base::malformed(
        "line {}: not a text file: it has a zero byte",
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n'));
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());

  ReadLocalization read;
  Entries entries;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    const std::string_view line = trim(whole);
    if (line.empty() || line.starts_with("//")) continue;
    base::Result<KeyAndText> pair = read_line(line);
    if (!pair.ok())
      add_problem(number, pair.error().what, read);
    else if (entries.size() >= kMaxLocalizationEntries && !entries.contains(pair->key))
      add_problem(number, fmt::format("more than {} texts", kMaxLocalizationEntries), read);
    else
      entries.insert_or_assign(std::move(pair->key), Entry{std::move(pair->quoted), number});
  }
  Localization::Texts texts;
  for (const auto& [key, entry] : entries) read.unknown_letters += entry.quoted.has_unknown_letters;
  for (const auto& [key, entry] : entries) {
    if (const std::string* const end = follow_references(entries, entry))
      texts.emplace(key, *end);
    else
      add_problem(entry.line,
                  fmt::format("{}: \"{}\" refers to itself", key, base::quotable(entry.quoted.text)), read);
  }
  read.localization = Localization(std::move(texts));
  return read;
}

std::string fill_places(std::string_view text, std::span<const std::string> arguments) {
  std::string filled;
  while (!text.empty() && filled.size() < kMaxLocalizedBytes) {
    const std::size_t open = std::min(text.find('{'), text.size());
    filled += text.substr(0, open);
    text.remove_prefix(open);
    if (text.empty()) break;
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [close, error] = std::from_chars(text.data() + 1, end, number);
    const bool is_place = error == std::errc{} && close != end && *close == '}' && number < arguments.size();
    if (is_place)
      filled += arguments[number];
    else
      filled += '{';
    text.remove_prefix(is_place ? static_cast<std::size_t>(close + 1 - text.data()) : 1);
  }
  filled.resize(std::min(filled.size(), kMaxLocalizedBytes));
  return filled;
}

}  // namespace temblor::formats
