#include "artgen/scripts/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/text.h"

namespace temblor::artgen {
namespace {

// A parsed line before nest_lines attaches it to the line above.
struct FlatLine {
  // Where its text starts, from 0.
  std::size_t column = 0;
  ScriptLine line;
};

// Removes the next word from `rest` and returns it without its quotes. A word may contain quoted pieces, as
// in title="The Toll House". Returns nothing at the end of the line or at a comment.
base::Result<std::optional<std::string>> next_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  if (rest.empty() || rest.front() == '#') return std::optional<std::string>();
  std::string word;
  while (!rest.empty() && rest.front() != ' ') {
    if (rest.front() != '"') {
      word += rest.front();
      rest.remove_prefix(1);
      continue;
    }
    const std::size_t end = rest.find('"', 1);
    if (end == std::string_view::npos) return base::malformed("a quote is not closed");
    word += rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
  }
  return std::optional(std::move(word));
}

// The first word is the keyword. A word with an equals sign after its first character is a setting; it is
// split at the first one.
base::Status parse_words(std::string_view rest, ScriptLine& out_line) {
  while (true) {
    TRY(std::optional<std::string> word, next_word(rest));
    if (!word) return base::Ok{};
    const std::size_t equals = word->find('=');
    if (out_line.keyword.empty())
      out_line.keyword = std::move(*word);
    else if (equals == std::string::npos || equals == 0)
      out_line.values.push_back(std::move(*word));
    else
      out_line.settings.emplace_back(word->substr(0, equals), word->substr(equals + 1));
  }
}

base::Result<std::vector<FlatLine>> split_lines(std::string_view text) {
  std::vector<FlatLine> lines;
  for (std::int32_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.ends_with('\r')) row.remove_suffix(1);
    const std::size_t column = row.find_first_not_of(' ');
    if (column == std::string_view::npos || row[column] == '#') continue;
    if (row.find('\t') != std::string_view::npos)
      return base::malformed("line {}: scripts are indented with spaces, not tabs", number);
    FlatLine line{column, {}};
    line.line.number = number;
    if (const base::Status read = parse_words(row, line.line); !read.ok())
      return base::malformed("line {}: {}", number, read.error().what);
    lines.push_back(std::move(line));
  }
  return lines;
}

// Returns the lines from `io_next` on that start in `column`, each with the lines under it, and moves io_next
// behind them. Recursion depth is the depth of the indentation.
base::Result<std::vector<ScriptLine>> nest_lines(std::vector<FlatLine>& lines, std::size_t column,
                                                 std::size_t& io_next) {
  std::vector<ScriptLine> nested;
  while (io_next < lines.size() && lines[io_next].column >= column) {
    if (lines[io_next].column == column) {
      nested.push_back(std::move(lines[io_next++].line));
      continue;
    }
    // A deeper line must follow its parent directly. If the parent already has lines, this one is between two
    // columns.
    if (nested.empty() || !nested.back().below.empty())
      return base::malformed("line {}: the indentation matches no line above", lines[io_next].line.number);
    TRY(nested.back().below, nest_lines(lines, lines[io_next].column, io_next));
  }
  return nested;
}

std::optional<math::Vec3> parse_vector(std::string_view text) {
  math::Vec3 vector;
  for (std::int32_t axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? text.find(',') : text.size();
    if (end == std::string_view::npos) return {};
    const std::optional<double> value = parse_number(text.substr(0, end));
    if (!value) return {};
    vector[axis] = static_cast<float>(*value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return vector;
}

std::optional<std::pair<double, double>> parse_range(std::string_view text) {
  const std::size_t dots = text.find("..");
  const std::optional<double> first = parse_number(text.substr(0, dots));
  const std::optional<double> second =
      dots == std::string_view::npos ? first : parse_number(text.substr(dots + 2));
  if (!first || !second) return {};
  return std::pair(*first, *second);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

base::Result<std::vector<ScriptLine>> read_script(std::string_view text) {
  TRY(std::vector<FlatLine> lines, split_lines(text));
  std::size_t next = 0;
  return nest_lines(lines, 0, next);
}

base::Error script_error(const ScriptLine& line, std::string_view what) {
  const std::string place = line.part.empty() ? "" : fmt::format("part {}, ", base::quotable(line.part));
  return base::malformed("{}line {}: {}: {}", place, line.number, base::quotable(line.keyword), what);
}

std::string Arguments::text() {
  const std::string* value = next_value("a word");
  return value != nullptr ? *value : "";
}

std::optional<std::string> Arguments::text_if_present() {
  if (next_value_ >= line_.values.size()) return {};
  return line_.values[next_value_++];
}

// After an error, returns a value within the limits, so that callers may compute with it.
double Arguments::number(double lowest, double highest) {
  const std::string* value = next_value("a number");
  if (value == nullptr) return lowest;
  const std::optional<double> number = parse_number(*value);
  if (!number) {
    set_error(fmt::format("'{}' is not a number", base::quotable(*value)));
    return lowest;
  }
  return check_limits("", *number, lowest, highest);
}

math::Vec3 Arguments::vector() {
  const std::string* value = next_value("X,Y,Z");
  if (value == nullptr) return {};
  const std::optional<math::Vec3> vector = parse_vector(*value);
  if (!vector) set_error(fmt::format("'{}' is not X,Y,Z", base::quotable(*value)));
  return vector.value_or(math::Vec3{0.0f});
}

std::pair<std::int32_t, std::int32_t> Arguments::size(std::int32_t highest) {
  const std::string* value = next_value("WIDTHxHEIGHT");
  if (value == nullptr) return {1, 1};
  const std::size_t times = value->find('x');
  if (times == std::string::npos) {
    set_error(fmt::format("'{}' is not WIDTHxHEIGHT", base::quotable(*value)));
    return {1, 1};
  }
  std::array<std::int32_t, 2> sides{1, 1};
  const std::string_view text = *value;
  const std::array parts = {text.substr(0, times), text.substr(times + 1)};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double side = parse_number(parts[i]).value_or(0);
    if (side < 1 || side > highest || side != std::floor(side))
      set_error(fmt::format("'{}' is not WIDTHxHEIGHT, each from 1 to {}", base::quotable(*value), highest));
    else
      sides[i] = static_cast<std::int32_t>(side);
  }
  return {sides[0], sides[1]};
}

bool Arguments::has(std::string_view name) const {
  return std::any_of(line_.settings.begin(), line_.settings.end(),
                     [&](const auto& setting) { return setting.first == name; });
}

std::string Arguments::text(std::string_view name, std::string_view fallback) {
  const std::string* value = find_setting(name);
  return value != nullptr ? *value : std::string(fallback);
}

double Arguments::number(std::string_view name, double fallback, double lowest, double highest) {
  const std::string* value = find_setting(name);
  if (value == nullptr) return fallback;
  const std::optional<double> number = parse_number(*value);
  if (!number) {
    set_error(fmt::format("{}={} is not a number", name, base::quotable(*value)));
    return fallback;
  }
  return check_limits(name, *number, lowest, highest);
}

std::int32_t Arguments::integer(std::string_view name, std::int32_t fallback, std::int32_t lowest,
                                std::int32_t highest) {
  const double value = number(name, fallback, lowest, highest);
  if (value != std::floor(value)) set_error(fmt::format("{}={} is not a whole number", name, value));
  return static_cast<std::int32_t>(value);
}

bool Arguments::flag(std::string_view name) {
  const std::string* value = find_setting(name);
  if (value == nullptr || *value == "no") return false;
  if (*value != "yes") set_error(fmt::format("{}={} must be yes or no", name, base::quotable(*value)));
  return true;
}

math::Vec3 Arguments::vector(std::string_view name, const math::Vec3& fallback) {
  const std::string* value = find_setting(name);
  if (value == nullptr) return fallback;
  const std::optional<math::Vec3> vector = parse_vector(*value);
  if (!vector) set_error(fmt::format("{}={} is not X,Y,Z", name, base::quotable(*value)));
  return vector.value_or(fallback);
}

std::pair<double, double> Arguments::range(std::string_view name, std::pair<double, double> fallback) {
  const std::string* value = find_setting(name);
  if (value == nullptr) return fallback;
  const std::optional<std::pair<double, double>> range = parse_range(*value);
  if (!range) set_error(fmt::format("{}={} is not FROM..TO", name, base::quotable(*value)));
  return range.value_or(fallback);
}

void Arguments::set_error(std::string_view what) {
  if (!error_) error_ = what;
}

base::Status Arguments::finish() const {
  if (error_) return script_error(line_, *error_);
  if (next_value_ < line_.values.size())
    return script_error(line_,
                        fmt::format("unexpected value '{}'", base::quotable(line_.values[next_value_])));
  // Every setting that a reader knows was asked for by now.
  for (const auto& [name, value] : line_.settings)
    if (std::find(known_settings_.begin(), known_settings_.end(), name) == known_settings_.end())
      return script_error(line_, fmt::format("unknown setting '{}'", base::quotable(name)));
  return base::Ok{};
}

const std::string* Arguments::find_setting(std::string_view name) {
  known_settings_.push_back(name);
  for (const auto& [known, value] : line_.settings)
    if (known == name) return &value;
  return nullptr;
}

const std::string* Arguments::next_value(std::string_view kind) {
  if (next_value_ < line_.values.size()) return &line_.values[next_value_++];
  set_error(fmt::format("expected {}", kind));
  return nullptr;
}

double Arguments::check_limits(std::string_view what, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return value;
  set_error(
      fmt::format("{}{}{} is not from {} to {}", what, what.empty() ? "" : "=", value, lowest, highest));
  return std::clamp(value, lowest, highest);
}

}  // namespace temblor::artgen
