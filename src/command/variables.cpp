#include "command/variables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"

namespace temblor::command {
namespace {

using base::ErrorCode;

// A valid value: Variable::number, and its canonical text.
struct Parsed {
  double number;
  std::string text;
};

std::optional<Parsed> parse_bool(std::string_view text) {
  for (std::string_view yes : {"1", "true", "on", "yes"})
    if (base::equal_ignoring_case(text, yes)) return Parsed{1, "1"};
  for (std::string_view no : {"0", "false", "off", "no"})
    if (base::equal_ignoring_case(text, no)) return Parsed{0, "0"};
  return std::nullopt;
}

// The text of the result is the shortest that reads back as the same number, so "+0.50" becomes "0.5".
template <typename Number>
std::optional<Parsed> parse_number(const Variable& variable, std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  const auto value = static_cast<double>(number);
  // Written so that NaN fails too.
  const bool is_in_range = value >= variable.min && value <= variable.max;
  if (!is_in_range && !(variable.allows_zero && value == 0)) return std::nullopt;
  return Parsed{value, fmt::format("{}", number)};
}

std::optional<Parsed> parse_choice(const Variable& variable, std::string_view text) {
  for (std::size_t i = 0; i < variable.choices.size(); ++i)
    if (base::equal_ignoring_case(text, variable.choices[i]))
      return Parsed{static_cast<double>(i), variable.choices[i]};
  return std::nullopt;
}

// Returns nullopt if the variable cannot have this value.
std::optional<Parsed> parse_value(const Variable& variable, std::string_view text) {
  switch (variable.type) {
    case VariableType::kBool:
      return parse_bool(text);
    case VariableType::kInt:
      return parse_number<std::int64_t>(variable, text);
    case VariableType::kFloat:
      return parse_number<double>(variable, text);
    case VariableType::kChoice:
      return parse_choice(variable, text);
    case VariableType::kText:
      break;
  }
  return Parsed{0, std::string(text)};
}

Variable int_variable(std::string_view name, std::int64_t value, std::int64_t min, std::int64_t max,
                      std::string_view help) {
  // Values are stored as double, which represents integers up to 2^53 exactly.
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  CHECK(min >= -kExact && max <= kExact, "{}", name);
  Variable variable;
  variable.name = name;
  variable.type = VariableType::kInt;
  variable.default_text = fmt::format("{}", value);
  variable.help = help;
  variable.min = static_cast<double>(min);
  variable.max = static_cast<double>(max);
  return variable;
}

base::Error unknown_variable(std::string_view name) {
  return base::error(ErrorCode::kNotFound, "there is no variable \"{}\"", base::quotable(name));
}

}  // namespace

// Parses the default like any other value, which also makes its text canonical.
VariableIndex Variables::add(Variable variable) {
  CHECK(!variable.name.empty());
  const std::optional<Parsed> parsed = parse_value(variable, variable.default_text);
  CHECK(parsed, "{}: default {}", variable.name, variable.default_text);
  variable.default_text = variable.registered_text = variable.text = parsed->text;
  variable.number = parsed->number;
  const auto index = base::to_index<VariableIndex>(variables_.size());
  const std::string key = base::to_lower(variable.name);
  const bool is_new = !aliases_.contains(key) && by_name_.emplace(key, index).second;
  CHECK(is_new, "{}", variable.name);
  variables_.push_back(std::move(variable));
  return index;
}

VariableIndex Variables::add_bool(std::string_view name, bool value, std::string_view help) {
  Variable variable;
  variable.name = name;
  variable.type = VariableType::kBool;
  variable.default_text = value ? '1' : '0';
  variable.help = help;
  return add(std::move(variable));
}

VariableIndex Variables::add_int(std::string_view name, std::int64_t value, std::int64_t min,
                                 std::int64_t max, std::string_view help) {
  return add(int_variable(name, value, min, max, help));
}

VariableIndex Variables::add_int_or_zero(std::string_view name, std::int64_t value, std::int64_t min,
                                         std::int64_t max, std::string_view help) {
  Variable variable = int_variable(name, value, min, max, help);
  variable.allows_zero = true;
  return add(std::move(variable));
}

VariableIndex Variables::add_float(std::string_view name, double value, double min, double max,
                                   std::string_view help) {
  Variable variable;
  variable.name = name;
  variable.type = VariableType::kFloat;
  variable.default_text = fmt::format("{}", value);
  variable.help = help;
  variable.min = min;
  variable.max = max;
  return add(std::move(variable));
}

VariableIndex Variables::add_text(std::string_view name, std::string_view value, std::string_view help) {
  Variable variable;
  variable.name = name;
  variable.type = VariableType::kText;
  variable.default_text = value;
  variable.help = help;
  return add(std::move(variable));
}

VariableIndex Variables::add_choice(std::string_view name, std::span<const std::string_view> choices,
                                    std::string_view help) {
  CHECK(!choices.empty(), "{}", name);
  Variable variable;
  variable.name = name;
  variable.type = VariableType::kChoice;
  variable.default_text = choices[0];
  variable.help = help;
  variable.choices.assign(choices.begin(), choices.end());
  return add(std::move(variable));
}

void Variables::add_alias(std::string_view old_name, std::string_view name) {
  const auto target = by_name_.find(base::to_lower(name));
  CHECK(target != by_name_.end(), "{}", name);
  const std::string key = base::to_lower(old_name);
  const bool is_new = !by_name_.contains(key) && aliases_.emplace(key, target->second).second;
  CHECK(is_new, "{}", old_name);
}

std::optional<VariableIndex> Variables::find_index(std::string_view name) const {
  const std::string key = base::to_lower(name);
  if (const auto found = by_name_.find(key); found != by_name_.end()) return found->second;
  if (const auto found = aliases_.find(key); found != aliases_.end()) return found->second;
  return std::nullopt;
}

base::Status Variables::set(std::string_view name, std::string_view value) {
  const std::optional<VariableIndex> index = find_index(name);
  if (!index) return unknown_variable(name);
  Variable& variable = variables_[base::to_size(*index)];
  std::optional<Parsed> parsed = parse_value(variable, value);
  if (!parsed)
    return base::error(ErrorCode::kUsage, "{} cannot be \"{}\": it takes {}", variable.name,
                       base::quotable(value), describe_values(variable));
  if (parsed->text == variable.text) return base::Ok{};
  variable.text = std::move(parsed->text);
  variable.number = parsed->number;
  variable.version = ++version_;
  return base::Ok{};
}

base::Status Variables::make(std::string_view name, std::string_view value) {
  constexpr std::string_view kSeparators = "\"{};()'";
  const bool is_readable = std::ranges::all_of(
      name, [&](char c) { return c > ' ' && c < 127 && kSeparators.find(c) == std::string_view::npos; });
  if (name.empty() || name.size() > kMaxUserMadeChars || !is_readable || name.starts_with("//") ||
      name.starts_with('+') || name.starts_with('-'))
    return base::error(ErrorCode::kUsage, "\"{}\" cannot be the name of a variable", base::quotable(name));
  if (user_made_ >= kMaxUserMade)
    return base::error(ErrorCode::kTooLarge, "there are already {} variables made by set", kMaxUserMade);
  Variable variable;
  variable.name = name;
  variable.help = "Made by set.";
  variable.is_user_made = true;
  add(std::move(variable));
  ++user_made_;
  return set(name, value);
}

void Variables::keep(std::string_view name) {
  if (const std::optional<VariableIndex> index = find_index(name)) {
    Variable& variable = variables_[base::to_size(*index)];
    variable.is_kept = variable.is_user_made;
  }
}

base::Status Variables::set_assignment(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return base::error(ErrorCode::kUsage, "\"{}\" is not NAME=VALUE", assignment);
  return set(assignment.substr(0, equals), assignment.substr(equals + 1));
}

base::Status Variables::reset(std::string_view name) {
  const Variable* variable = find(name);
  if (variable == nullptr) return unknown_variable(name);
  return set(name, std::string(variable->default_text));
}

base::Status Variables::adopt_as_default(std::string_view name) {
  const std::optional<VariableIndex> index = find_index(name);
  if (!index) return unknown_variable(name);
  Variable& variable = variables_[base::to_size(*index)];
  variable.default_text = variable.text;
  return base::Ok{};
}

base::Status Variables::restore(std::string_view name) {
  const std::optional<VariableIndex> index = find_index(name);
  if (!index) return unknown_variable(name);
  Variable& variable = variables_[base::to_size(*index)];
  variable.default_text = variable.registered_text;
  return reset(name);
}

VariableValue Variables::value(VariableIndex index) const {
  const Variable& variable = get(index);
  return {variable.text, variable.version, variable.is_kept};
}

void Variables::put_back(VariableIndex index, const VariableValue& value) {
  Variable& variable = variables_[base::to_size(index)];
  const std::optional<Parsed> parsed = parse_value(variable, value.text);
  CHECK(parsed, "{}: {}", variable.name, value.text);
  variable.text = parsed->text;
  variable.number = parsed->number;
  variable.version = value.version;
  variable.is_kept = value.is_kept;
  ++version_;
}

const Variable* Variables::find(std::string_view name) const {
  const std::optional<VariableIndex> index = find_index(name);
  return index ? &get(*index) : nullptr;
}

std::vector<const Variable*> Variables::all() const {
  std::vector<const Variable*> sorted;
  for (const auto& [name, index] : by_name_) sorted.push_back(&get(index));
  return sorted;
}

const Variable& Variables::get_typed(VariableIndex index, VariableType type) const {
  const Variable& variable = get(index);
  CHECK(variable.type == type, "{}", variable.name);
  return variable;
}

bool Variables::bool_value(VariableIndex index) const {
  return get_typed(index, VariableType::kBool).number != 0;
}

std::int64_t Variables::int_value(VariableIndex index) const {
  return static_cast<std::int64_t>(get_typed(index, VariableType::kInt).number);
}

double Variables::float_value(VariableIndex index) const {
  return get_typed(index, VariableType::kFloat).number;
}

const std::string& Variables::text_value(VariableIndex index) const {
  return get_typed(index, VariableType::kText).text;
}

std::size_t Variables::choice_value(VariableIndex index) const {
  return static_cast<std::size_t>(get_typed(index, VariableType::kChoice).number);
}

bool has_value(const Variable& variable, std::string_view value) {
  const std::optional<Parsed> parsed = parse_value(variable, value);
  return parsed && parsed->text == variable.text;
}

std::string describe_values(const Variable& variable) {
  switch (variable.type) {
    case VariableType::kBool:
      return "0 or 1";
    case VariableType::kInt:
    case VariableType::kFloat:
      return fmt::format("{}a{} from {} to {}", variable.allows_zero ? "0 or " : "",
                         variable.type == VariableType::kInt ? " whole number" : " number", variable.min,
                         variable.max);
    case VariableType::kChoice:
      return fmt::format("{}{}", variable.choices.size() > 2 ? "one of " : "",
                         fmt::join(variable.choices, variable.choices.size() > 2 ? ", " : " or "));
    case VariableType::kText:
      break;
  }
  return "any text";
}

}  // namespace temblor::command
