// Console variables (cvars): named settings with a type, a default, a range, and a help text. The command
// line, the console, config files, and game code set them as text; code reads them by the index that
// registration returned, without a lookup by name:
//
//   const VariableIndex fov = variables.add_float("fov", 90, 10, 170, "Field of view in degrees.");
//   ... variables.float_value(fov) ...
//
// Unlike in the original, a value is parsed and checked when it is set, so readers never see an invalid one.
// A Variables object is one table; a program may have several.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.h"
#include "base/result.h"

namespace temblor::command {

enum class VariableIndex : std::uint32_t {};

enum class VariableType : std::uint8_t { kBool, kInt, kFloat, kText, kChoice };

// A registered variable. Only Variables changes it.
struct Variable {
  std::string name;  // as registered; lookups ignore case
  VariableType type = VariableType::kText;
  std::string default_text;          // registered_text, unless adopt_as_default() replaced it
  std::string registered_text;       // the default that was registered
  std::string text;                  // current value in canonical form ("1", not "on")
  std::string help;                  // one sentence
  double min = 0, max = 0;           // kInt and kFloat: allowed range, inclusive
  bool allows_zero = false;          // kInt: 0 is allowed although it is outside of the range
  std::vector<std::string> choices;  // kChoice: allowed values
  double number = 0;                 // kBool: 0 or 1; kInt, kFloat: value; kChoice: index in choices
  std::uint64_t version = 0;         // Variables::version() just after the last change; 0: never changed
  bool is_user_made = false;         // by make()
  bool is_kept = false;              // user-made: config files must contain it (`seta`)
};

// A value that a variable had, for Variables::put_back().
struct VariableValue {
  std::string text;
  std::uint64_t version = 0;
  bool is_kept = false;
  bool operator==(const VariableValue&) const = default;
};

class Variables {
 public:
  static constexpr std::size_t kMaxUserMade = 1024;
  static constexpr std::size_t kMaxUserMadeChars = 64;  // of a name

  // Register a variable. CHECK that the name is new and the default is valid.
  VariableIndex add_bool(std::string_view name, bool value, std::string_view help);
  VariableIndex add_int(std::string_view name, std::int64_t value, std::int64_t min, std::int64_t max,
                        std::string_view help);
  // Also allows 0, for "no limit" and the like.
  VariableIndex add_int_or_zero(std::string_view name, std::int64_t value, std::int64_t min, std::int64_t max,
                                std::string_view help);
  VariableIndex add_float(std::string_view name, double value, double min, double max, std::string_view help);
  VariableIndex add_text(std::string_view name, std::string_view value, std::string_view help);
  // The default is choices[0].
  VariableIndex add_choice(std::string_view name, std::span<const std::string_view> choices,
                           std::string_view help);
  // Accepts `old_name` wherever the registered variable `name` can be looked up or set by name, so that
  // config files survive a renaming. all() lists only the new name. CHECKs that `old_name` is free and `name`
  // exists.
  void add_alias(std::string_view old_name, std::string_view name);

  // Sets a variable. kBool accepts 1/0, true/false, on/off, yes/no. Returns kNotFound for an unknown name,
  // and kUsage for an invalid value; the variable keeps its value then. Setting the current value does not
  // change version().
  base::Status set(std::string_view name, std::string_view value);
  // Makes a text variable for a name that is not registered, with an empty default, and sets it. Fails with
  // kUsage for a name that the console could not read back, and with kTooLarge above kMaxUserMade.
  base::Status make(std::string_view name, std::string_view value);
  // Marks a user-made variable for config files. Ignores others.
  void keep(std::string_view name);
  // Sets from "NAME=VALUE", as on the command line. VALUE may be empty or contain '='.
  base::Status set_assignment(std::string_view assignment);
  // Sets the default.
  base::Status reset(std::string_view name);
  // Makes the current value the default, until restore().
  base::Status adopt_as_default(std::string_view name);
  // Sets the default that was registered, and makes it the default again.
  base::Status restore(std::string_view name);

  std::size_t size() const { return variables_.size(); }
  VariableValue value(VariableIndex index) const;
  // Sets a value that value() has returned, with its own version: the variable counts as never changed since.
  void put_back(VariableIndex index, const VariableValue& value);

  // Returns null if there is no such variable.
  const Variable* find(std::string_view name) const;
  const Variable& get(VariableIndex index) const { return variables_[base::to_size(index)]; }
  // Sorted by name.
  std::vector<const Variable*> all() const;

  // Each CHECKs the variable's type.
  bool bool_value(VariableIndex index) const;
  std::int64_t int_value(VariableIndex index) const;
  double float_value(VariableIndex index) const;
  const std::string& text_value(VariableIndex index) const;
  std::size_t choice_value(VariableIndex index) const;  // position among the choices

  // Increases by one with every change of any variable. To detect changes, remember the version and compare.
  std::uint64_t version() const { return version_; }

 private:
  VariableIndex add(Variable variable);
  std::optional<VariableIndex> find_index(std::string_view name) const;
  const Variable& get_typed(VariableIndex index, VariableType type) const;

  std::deque<Variable> variables_;                             // which stay in place when one is added
  std::map<std::string, VariableIndex, std::less<>> by_name_;  // by name in lower case
  std::map<std::string, VariableIndex, std::less<>> aliases_;  // by former name in lower case
  std::uint64_t version_ = 0;
  std::size_t user_made_ = 0;
};

// Returns whether set() with this value would change nothing, however the value is written.
bool has_value(const Variable& variable, std::string_view value);

// Describes the values that set() accepts: "0 or 1", "-1 to 3", "stock or footprint", "one of a, b, c", "any
// text".
std::string describe_values(const Variable& variable);

}  // namespace temblor::command
