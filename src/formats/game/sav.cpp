#include "formats/game/sav.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace temblor::formats {
namespace {

constexpr std::string_view kSavVersion = "5";
constexpr std::string_view kSavBlanks = " \t\r\n";
constexpr float kMaxSkill = 3;

// Reads lines, then blocks, and counts the lines for errors.
class SavReader {
 public:
  explicit SavReader(std::string_view text) : rest_(text) {}

  std::size_t line() const { return line_; }

  template <typename... Args>
  base::Error error(fmt::format_string<Args...> format, Args&&... args) const {
    return base::malformed("line {}: {}", line_, fmt::format(format, std::forward<Args>(args)...));
  }

  // Reads a line without its end. `what` names it in errors.
  base::Result<std::string_view> whole_line(std::string_view what) {
    if (rest_.empty()) return error("the file ends, expected {}", what);
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view text = rest_.substr(0, end);
    skip(std::min(end + 1, rest_.size()));
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  // Reads a line without the blanks around its text. Skips empty lines, as stock engines do.
  base::Result<std::string_view> text_line(std::string_view what) {
    skip(std::min(rest_.find_first_not_of(kSavBlanks), rest_.size()));
    TRY(std::string_view text, whole_line(what));
    return text.substr(0, text.find_last_not_of(kSavBlanks) + 1);
  }

  // The number may be infinite or NaN.
  base::Result<float> number(std::string_view what) {
    TRY(const std::string_view text, text_line(what));
    float value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size())
      return base::malformed("line {}: {} must be a number, not \"{}\"", line_ - 1, what, text.substr(0, 40));
    return value;
  }
  base::Result<float> finite_number(std::string_view what) {
    TRY(const float value, number(what));
    if (!std::isfinite(value)) return base::malformed("line {}: {} is {}", line_ - 1, what, value);
    return value;
  }

  // Reads a block { "name" "value" ... }; nullopt at the end of the text.
  base::Result<std::optional<SavPairs>> block() {
    skip_blanks();
    if (rest_.empty()) return std::optional<SavPairs>{};
    if (rest_.front() != '{') return error("{{ expected at the next block, not \"{}\"", rest_.substr(0, 20));
    skip(1);
    SavPairs pairs;
    while (true) {
      skip_blanks();
      if (rest_.starts_with('}')) break;
      TRY(std::string name, quoted("a name"));
      skip_blanks();
      TRY(std::string value, quoted("a value"));
      pairs.emplace_back(std::move(name), std::move(value));
    }
    skip(1);
    return std::optional<SavPairs>(std::move(pairs));
  }

 private:
  void skip(std::size_t chars) {
    line_ += static_cast<std::size_t>(
        std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(chars), '\n'));
    rest_.remove_prefix(chars);
  }
  void skip_blanks() {
    while (true) {
      skip(std::min(rest_.find_first_not_of(kSavBlanks), rest_.size()));
      if (rest_.starts_with("//")) {
        skip(std::min(rest_.find('\n'), rest_.size()));
      } else if (rest_.starts_with("/*")) {
        const std::size_t end = rest_.find("*/", 2);
        skip(end == std::string_view::npos ? rest_.size() : end + 2);
      } else {
        return;
      }
    }
  }
  base::Result<std::string> quoted(std::string_view what) {
    if (rest_.empty()) return error("the file ends in the middle of a block");
    const std::size_t end = rest_.front() == '"' ? rest_.find('"', 1) : std::string_view::npos;
    if (end == std::string_view::npos) return error("{} expected in quotes", what);
    std::string text(rest_.substr(1, end - 1));
    skip(end + 1);
    return text;
  }

  std::string_view rest_;
  std::size_t line_ = 1;
};

std::string replace_chars(std::string_view text, char from, char to) {
  std::string result(text);
  std::replace(result.begin(), result.end(), from, to);
  return result;
}

// A line end in a value would shift all following lines.
base::Status check_line(std::string_view what, std::string_view text) {
  if (text.find_first_of("\n\r") == std::string_view::npos) return base::Ok{};
  return base::error(base::ErrorCode::kUsage, "{} contains a line end", what);
}

// The format has no escapes, so values with quotes cannot be stored.
base::Status append_block(const SavPairs& pairs, std::string& io_text) {
  io_text += "{\n";
  for (const auto& [name, value] : pairs) {
    if (name.find('"') != std::string::npos || value.find('"') != std::string::npos)
      return base::error(base::ErrorCode::kUsage, "the value of \"{}\" contains quotes", name);
    io_text += fmt::format("\"{}\" \"{}\"\n", name, value);
  }
  io_text += "}\n";
  return base::Ok{};
}

}  // namespace

base::Result<Sav> read_sav(std::string_view text) {
  SavReader reader(text.substr(0, text.find('\0')));
  TRY(const std::string_view version, reader.whole_line("the version"));
  if (version != kSavVersion)
    return base::error(base::ErrorCode::kUnsupported, "not a saved game of version {}: it starts with \"{}\"",
                       kSavVersion, version.substr(0, 20));
  Sav sav;
  TRY(const std::string_view comment, reader.whole_line("the comment"));
  sav.comment = replace_chars(comment, '_', ' ');
  while (sav.comment.ends_with(' ')) sav.comment.pop_back();  // the file pads it to its full length
  for (float& parameter : sav.spawn_parameters) {
    TRY(parameter, reader.number("a spawn parameter"));
    if (!std::isfinite(parameter))
      parameter = 0;  // game code may leave anything in those that it does not use
  }
  TRY(const float skill, reader.finite_number("the skill"));
  sav.skill = static_cast<int>(std::clamp(std::floor(skill + 0.1f), 0.0f, kMaxSkill));
  TRY(const std::string_view map, reader.text_line("the level's name"));
  sav.map = map;
  TRY(sav.time_s, reader.finite_number("the time"));
  for (std::string& style : sav.light_styles) {
    TRY(const std::string_view pattern, reader.whole_line("a light style"));
    style = pattern;
  }
  TRY(std::optional<SavPairs> globals, reader.block());
  if (!globals) return reader.error("the file ends before the globals");
  sav.globals = std::move(*globals);
  while (true) {
    TRY(std::optional<SavPairs> entity, reader.block());
    if (!entity) break;
    sav.entities.push_back(std::move(*entity));
  }
  if (sav.entities.empty()) return reader.error("the file ends before the first entity");
  return sav;
}

base::Result<std::string> write_sav(const Sav& sav) {
  TRY_STATUS(check_line("the comment", sav.comment));
  TRY_STATUS(check_line("the level's name", sav.map));
  std::string text =
      fmt::format("{}\n{:_<{}}\n", kSavVersion,
                  replace_chars(sav.comment, ' ', '_').substr(0, kSavCommentChars), kSavCommentChars);
  for (const float parameter : sav.spawn_parameters) text += fmt::format("{:.9g}\n", parameter);
  text += fmt::format("{}\n{}\n{:.9g}\n", sav.skill, sav.map, sav.time_s);
  for (const std::string& style : sav.light_styles) {
    TRY_STATUS(check_line("a light style", style));
    text += style.empty() ? "m\n" : style + "\n";
  }
  TRY_STATUS(append_block(sav.globals, text));
  for (const SavPairs& entity : sav.entities) TRY_STATUS(append_block(entity, text));
  return text;
}

}  // namespace temblor::formats
