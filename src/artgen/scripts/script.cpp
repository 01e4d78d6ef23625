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

// A line before it found its place under another one.
struct FlatLine {
  std::size_t column = 0;
  ScriptLine line;
};

// The next word of a line, quotes taken off; `rest` is left behind it. Nothing at the line's end or a sharp.
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
    if (end == std::string_view::npos) return base::malformed("a quote is opened and not closed");
    word += rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
  }
  return std::optional(std::move(word));
}

base::Status read_words(std::string_view rest, ScriptLine& out_line) {
  while (true) {
    TRY(std::optional<std::string> word, next_word(rest));
    if (!word) return base::Ok{};
    const std::size_t equals = word->find('=');
    if (out_line.word.empty())
      out_line.word = std::move(*word);
    else if (equals == std::string::npos || equals == 0)
      out_line.values.push_back(std::move(*word));
    else
      out_line.settings.emplace_back(word->substr(0, equals), word->substr(equals + 1));
  }
}

base::Result<std::vector<FlatLine>> read_lines(std::string_view text) {
  std::vector<FlatLine> lines;
  for (std::int32_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.ends_with('\r')) row.remove_suffix(1);
    const std::size_t column = row.find_first_not_of(' ');
    if (column == std::string_view::npos || row[column] == '#') continue;
    if (row.find('\t') != std::string_view::npos)
      return base::malformed("line {}: a tab; scripts are indented with blanks", number);
    FlatLine line{column, {}};
    line.line.number = number;
    if (const base::Status read = read_words(row, line.line); !read.ok())
      return base::malformed("line {}: {}", number, read.error().what);
    lines.push_back(std::move(line));
  }
  return lines;
}

// The lines from `io_next` on that stand in `column`, each with what is under it.
base::Result<std::vector<ScriptLine>> nest(std::vector<FlatLine>& lines, std::size_t column,
                                           std::size_t& io_next) {
  std::vector<ScriptLine> nested;
  while (io_next < lines.size() && lines[io_next].column >= column) {
    if (lines[io_next].column == column) {
      nested.push_back(std::move(lines[io_next++].line));
      continue;
    }
    if (nested.empty() || !nested.back().below.empty())
      return base::malformed("line {}: indented as no line above it", lines[io_next].line.number);
    TRY(nested.back().below, nest(lines, lines[io_next].column, io_next));
  }
  return nested;
}

std::optional<math::Vec3> vector_in(std::string_view text) {
  math::Vec3 vector;
  for (std::int32_t axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? text.find(',') : text.size();
    if (end == std::string_view::npos) return {};
    const std::optional<double> value = number_in(text.substr(0, end));
    if (!value) return {};
    vector[axis] = static_cast<float>(*value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return vector;
}

std::optional<std::pair<double, double>> range_in(std::string_view text) {
  const std::size_t dots = text.find("..");
  const std::optional<double> first = number_in(text.substr(0, dots));
  const std::optional<double> second =
      dots == std::string_view::npos ? first : number_in(text.substr(dots + 2));
  if (!first || !second) return {};
  return std::pair(*first, *second);
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

base::Result<std::vector<ScriptLine>> read_script(std::string_view text) {
  TRY(std::vector<FlatLine> lines, read_lines(text));
  std::size_t next = 0;
  return nest(lines, 0, next);
}

base::Error script_error(const ScriptLine& line, std::string_view what) {
  const std::string place = line.part.empty() ? "" : fmt::format("part {}, ", base::quotable(line.part));
  return base::malformed("{}line {}: {}: {}", place, line.number, base::quotable(line.word), what);
}

std::string Arguments::text() {
  const std::string* value = next_value("a word");
  return value != nullptr ? *value : "";
}

std::optional<std::string> Arguments::text_if_there() {
  if (next_value_ >= line_.values.size()) return {};
  return line_.values[next_value_++];
}

double Arguments::number(double lowest, double highest) {
  const std::string* value = next_value("a number");
  if (value == nullptr) return lowest;
  const std::optional<double> number = number_in(*value);
  if (!number) {
    complain(fmt::format("'{}' is not a number", base::quotable(*value)));
    return lowest;
  }
  return checked("", *number, lowest, highest);
}

math::Vec3 Arguments::vector() {
  const std::string* value = next_value("X,Y,Z");
  if (value == nullptr) return {};
  const std::optional<math::Vec3> vector = vector_in(*value);
  if (!vector) complain(fmt::format("'{}' is not X,Y,Z", base::quotable(*value)));
  return vector.value_or(math::Vec3{0.0f});
}

std::pair<std::int32_t, std::int32_t> Arguments::size(std::int32_t highest) {
  const std::string* value = next_value("WIDTHxHEIGHT");
  if (value == nullptr) return {1, 1};
  const std::size_t times = value->find('x');
  if (times == std::string::npos) {
    complain(fmt::format("'{}' is not WIDTHxHEIGHT", base::quotable(*value)));
    return {1, 1};
  }
  std::array<std::int32_t, 2> sides{1, 1};
  const std::string_view text = *value;
  const std::array parts = {text.substr(0, times), text.substr(times + 1)};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double side = number_in(parts[i]).value_or(0);
    if (side < 1 || side > highest || side != std::floor(side))
      complain(fmt::format("'{}' is not WIDTHxHEIGHT, each from 1 to {}", base::quotable(*value), highest));
    else
      sides[i] = static_cast<std::int32_t>(side);
  }
  return {sides[0], sides[1]};
}

bool Arguments::has(std::string_view name) const {
  return std::any_of(line_.settings.begin(), line_.settings.end(),
                     [&](const auto& setting) { return setting.first == name; });
}

std::string Arguments::text(std::string_view name, std::string_view otherwise) {
  const std::string* value = setting(name);
  return value != nullptr ? *value : std::string(otherwise);
}

double Arguments::number(std::string_view name, double otherwise, double lowest, double highest) {
  const std::string* value = setting(name);
  if (value == nullptr) return otherwise;
  const std::optional<double> number = number_in(*value);
  if (!number) {
    complain(fmt::format("{}={} is not a number", name, base::quotable(*value)));
    return otherwise;
  }
  return checked(name, *number, lowest, highest);
}

std::int32_t Arguments::integer(std::string_view name, std::int32_t otherwise, std::int32_t lowest,
                                std::int32_t highest) {
  const double value = number(name, otherwise, lowest, highest);
  if (value != std::floor(value)) complain(fmt::format("{}={} is not a whole number", name, value));
  return static_cast<std::int32_t>(value);
}

bool Arguments::flag(std::string_view name) {
  const std::string* value = setting(name);
  if (value == nullptr || *value == "no") return false;
  if (*value != "yes") complain(fmt::format("{}={} is neither yes nor no", name, base::quotable(*value)));
  return true;
}

math::Vec3 Arguments::vector(std::string_view name, const math::Vec3& otherwise) {
  const std::string* value = setting(name);
  if (value == nullptr) return otherwise;
  const std::optional<math::Vec3> vector = vector_in(*value);
  if (!vector) complain(fmt::format("{}={} is not X,Y,Z", name, base::quotable(*value)));
  return vector.value_or(otherwise);
}

std::pair<double, double> Arguments::range(std::string_view name, std::pair<double, double> otherwise) {
  const std::string* value = setting(name);
  if (value == nullptr) return otherwise;
  const std::optional<std::pair<double, double>> range = range_in(*value);
  if (!range) complain(fmt::format("{}={} is not FROM..TO", name, base::quotable(*value)));
  return range.value_or(otherwise);
}

void Arguments::complain(std::string_view what) {
  if (!wrong_) wrong_ = what;
}

base::Status Arguments::finish() const {
  if (wrong_) return script_error(line_, *wrong_);
  if (next_value_ < line_.values.size())
    return script_error(line_, fmt::format("what is '{}' for?", base::quotable(line_.values[next_value_])));
  for (const auto& [name, value] : line_.settings)
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end())
      return script_error(line_, fmt::format("it has no setting '{}'", base::quotable(name)));
  return base::Ok{};
}

const std::string* Arguments::setting(std::string_view name) {
  asked_.push_back(name);
  for (const auto& [known, value] : line_.settings)
    if (known == name) return &value;
  return nullptr;
}

const std::string* Arguments::next_value(std::string_view kind) {
  if (next_value_ < line_.values.size()) return &line_.values[next_value_++];
  complain(fmt::format("{} is missing", kind));
  return nullptr;
}

double Arguments::checked(std::string_view what, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return value;
  complain(fmt::format("{}{}{} is not from {} to {}", what, what.empty() ? "" : "=", value, lowest, highest));
  return std::clamp(value, lowest, highest);
}

}  // namespace temblor::artgen
