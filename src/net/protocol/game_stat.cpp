#include "net/protocol/game_stat.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "base/words.h"
#include "net/transport/base64url.h"

namespace temblor::net {
namespace {

constexpr std::string_view kStatPrefix = "//temblor stat ";

// Removes the first word and the space after it.
std::string_view take_word(std::string_view& io_text) {
  const std::string_view word = io_text.substr(0, io_text.find(' '));
  io_text.remove_prefix(std::min(word.size() + 1, io_text.size()));
  return word;
}

base::Result<StatValue> read_value(std::string_view type, std::string_view word) {
  if (type == "i") {
    if (const auto value = base::parse_number<std::int32_t>(word)) return StatValue(*value);
  } else if (type == "f") {
    if (const auto value = base::parse_number<float>(word)) return StatValue(*value);
  } else if (type == "s") {
    std::string text(GameStat::kMaxTextChars, '\0');
    if (const auto size = read_base64url(word, std::as_writable_bytes(std::span(text)))) {
      text.resize(*size);
      return StatValue(std::move(text));
    }
  }
  return base::malformed("a stat of type \"{}\" has a wrong value", type.substr(0, 1));
}

struct FormatValue {
  std::string operator()(std::int32_t value) const { return fmt::format("i {}", value); }
  std::string operator()(float value) const {
    return fmt::format("f {}", std::isfinite(value) ? value : 0.0f);
  }
  std::string operator()(const std::string& value) const {
    std::string text = "s ";
    append_base64url(std::as_bytes(std::span(value).first(std::min(value.size(), GameStat::kMaxTextChars))),
                     text);
    return text;
  }
};

}  // namespace

std::string format_game_stat(const GameStat& stat) {
  return fmt::format("{}{} {}\n", kStatPrefix, stat.number, std::visit(FormatValue{}, stat.value));
}

bool is_game_stat(std::string_view line) {
  return line.starts_with(kStatPrefix);
}

base::Result<GameStat> read_game_stat(std::string_view line) {
  line.remove_prefix(kStatPrefix.size());
  const auto number = base::parse_number<int>(take_word(line));
  if (!number || *number < GameStat::kFirst || *number > GameStat::kLast)
    return base::malformed("the number of a stat is not {} to {}", GameStat::kFirst, GameStat::kLast);
  const std::string_view type = take_word(line);
  TRY(StatValue value, read_value(type, line));
  return GameStat{static_cast<std::uint8_t>(*number), std::move(value)};
}

}  // namespace temblor::net
