// Console variables: named settings with a type, a default and a help text, set from text (the command line,
// the console, a config file) and read by handle. A Variables object is the whole table; a program may have
// several.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.h"
#include "base/result.h"

namespace temblor::command {

enum class VariableIndex : std::uint32_t {};

enum class VariableType : std::uint8_t { kBool, kInt, kFloat, kText, kChoice };

struct Variable {
  std::string name;  // as registered; looked up without regard to case
  VariableType type = VariableType::kText;
  std::string default_text;
  std::string text;                  // the value, always acceptable to set()
  std::string help;                  // one sentence
  double min = 0, max = 0;           // kInt and kFloat: the values allowed, ends included
  bool allows_zero = false;          // kInt: besides those
  std::vector<std::string> choices;  // kChoice: the values allowed
  double number = 0;                 // kBool: 0 or 1; kInt, kFloat: the value; kChoice: position in choices
  std::uint64_t version = 0;         // Variables::version() just after the last change; 0: never changed
};

class Variables {
 public:
  // Registering CHECKs what only a programmer can get wrong: a name twice, a default out of range.
  VariableIndex add_bool(std::string_view name, bool value, std::string_view help);
  VariableIndex add_int(std::string_view name, std::int64_t value, std::int64_t min, std::int64_t max,
                        std::string_view help);
  // Allows 0 as well, which says that there is no such bound or the like.
  VariableIndex add_int_or_zero(std::string_view name, std::int64_t value, std::int64_t min, std::int64_t max,
                                std::string_view help);
  VariableIndex add_float(std::string_view name, double value, double min, double max, std::string_view help);
  VariableIndex add_text(std::string_view name, std::string_view value, std::string_view help);
  // The default is choices[0].
  VariableIndex add_choice(std::string_view name, std::span<const std::string_view> choices,
                           std::string_view help);

  // kBool takes 1/0, true/false, on/off, yes/no. Fails with kNotFound for an unknown name and with kUsage for
  // a value that does not fit; the variable then keeps its value. Setting the value that a variable already
  // has is no change.
  base::Status set(std::string_view name, std::string_view value);
  // "NAME=VALUE", as on the command line. VALUE may be empty or hold further '='.
  base::Status set_assignment(std::string_view assignment);
  base::Status reset(std::string_view name);

  // Null when there is no such variable. Valid until another one is added.
  const Variable* find(std::string_view name) const;
  const Variable& get(VariableIndex index) const { return variables_[base::to_size(index)]; }
  // In order of name.
  std::vector<const Variable*> all() const;

  // Each CHECKs the variable's type.
  bool bool_value(VariableIndex index) const;
  std::int64_t int_value(VariableIndex index) const;
  double float_value(VariableIndex index) const;
  const std::string& text_value(VariableIndex index) const;
  std::size_t choice_value(VariableIndex index) const;  // position among the choices

  // Grows by one with every change of any variable: who depends on a variable remembers the version it last
  // saw and compares.
  std::uint64_t version() const { return version_; }

 private:
  VariableIndex add(Variable variable);
  const Variable& get_typed(VariableIndex index, VariableType type) const;

  std::vector<Variable> variables_;
  std::map<std::string, VariableIndex, std::less<>> by_name_;  // by name in lower case
  std::uint64_t version_ = 0;
};

// Whether the variable has that value, in whatever way it is written: set() would leave it as it is.
bool has_value(const Variable& variable, std::string_view value);

// What set() accepts for a variable: "0 or 1", "-1 to 3", "stock or footprint", "one of a, b, c", "any text".
std::string describe_values(const Variable& variable);

}  // namespace temblor::command
