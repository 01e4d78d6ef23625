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
// Punctuation that writers use in place of ASCII, and letters beyond Latin-1.
constexpr std::array kSubstitutes = {
    Substitute{0xa0, " "},    Substitute{0xa1, "!"},    Substitute{0xab, "\""},    Substitute{0xbb, "\""},
    Substitute{0xbf, "?"},    Substitute{0x152, "OE"},  Substitute{0x153, "oe"},   Substitute{0x2013, "-"},
    Substitute{0x2014, "-"},  Substitute{0x2018, "'"},  Substitute{0x2019, "'"},   Substitute{0x201c, "\""},
    Substitute{0x201d, "\""}, Substitute{0x201e, "\""}, Substitute{0x2026, "..."}, Substitute{0xfeff, ""},
};

std::string_view to_game_characters(std::uint32_t code_point) {
  if (code_point >= 0xc0 && code_point <= 0xff) return kLatinLetters[code_point - 0xc0];
  const auto found = std::find_if(kSubstitutes.begin(), kSubstitutes.end(),
                                  [&](const Substitute& entry) { return entry.code_point == code_point; });
  return found == kSubstitutes.end() ? "?" : found->text;
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

// `text` begins after the opening quote. Returns nullopt if there is no closing one.
std::optional<std::string> read_quoted(std::string_view text) {
  std::string value;
  while (!text.empty()) {
    const std::uint32_t character = take_character(text);
    if (character == '"') return value;
    if (character == '\\')
      take_escaped(text, value);
    else if (character < 0x80)
      value += static_cast<char>(character);
    else
      value += to_game_characters(character);
  }
  return std::nullopt;
}

struct Entry {
  std::string text;
  std::size_t line = 0;
};
using Entries = std::map<std::string, Entry, std::less<>>;

struct KeyAndText {
  std::string key, text;
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
  std::optional<std::string> text = read_quoted(rest.substr(1));
  if (!text) return base::malformed("{}: the text has no closing quote", key);
  if (text->size() > kMaxLocalizedBytes)
    return base::error(ErrorCode::kTooLarge, "{}: a text of {} characters, the limit is {}", key,
                       text->size(), kMaxLocalizedBytes);
  return KeyAndText{std::string(key), *std::move(text)};
}

void add_problem(std::size_t line, std::string what, ReadLocalization& io_read) {
  if (++io_read.problem_count <= ReadLocalization::kMaxProblems)
    io_read.problems.push_back({line, std::move(what)});
}

// Returns the key that the text refers to, if it is one of the entries and the text is nothing else.
const Entry* find_reference(const Entries& entries, const Entry& entry) {
  const std::string_view key = find_key(entry.text);
  if (key.empty() || key.size() + 1 != entry.text.size()) return nullptr;
  const auto found = entries.find(key);
  return found == entries.end() ? nullptr : &found->second;
}

// Follows references to the text at their end; null if there is none.
const std::string* follow_references(const Entries& entries, const Entry& entry) {
  const Entry* current = &entry;
  for (int i = 0; i <= kMaxReferences; ++i) {
    const Entry* const next = find_reference(entries, *current);
    if (next == nullptr) return &current->text;
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
      entries.insert_or_assign(std::move(pair->key), Entry{std::move(pair->text), number});
  }
  Localization::Texts texts;
  for (const auto& [key, entry] : entries) {
    if (const std::string* const end = follow_references(entries, entry))
      texts.emplace(key, *end);
    else
      add_problem(entry.line, fmt::format("{}: \"{}\" refers to itself", key, base::quotable(entry.text)),
                  read);
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
