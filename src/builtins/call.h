// The built-in functions that the game's program on the server and the HUD program on the client share:
// numbers, text, files, and console variables. They need the machine and a Context, and know neither server
// nor client.
//    QuakeC: strlen("x") --> vm::Machine --> Call (checked parameters) --> function in a family
// docs/builtins.md lists them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "builtins/script_files.h"
#include "command/variables.h"
#include "vm/machine.h"

namespace temblor::builtins {

// Truncates toward 0, and clamps to the range of int. NaN gives 0.
inline int to_whole(float value) {
  if (std::isnan(value)) return 0;
  if (value >= 2147483648.0f) return 2147483647;
  if (value <= -2147483648.0f) return -2147483647 - 1;
  return static_cast<int>(value);
}

// A word of the last tokenize(), and where it is in that text.
struct Token {
  std::string text;
  std::size_t begin = 0, end = 0;
};

// Lists of strings with handles (DP_QC_STRINGBUFFERS).
using StringBuffers = std::map<int, std::vector<std::string>>;

// Everything that the shared functions act on. References must outlive the machine's calls.
struct Context {
  command::Variables& variables;
  std::function<float()> random;  // 0 to 1, both included
  std::function<double()> time_s = [] { return 0.0; };
  ScriptFiles files{};  // FRIK_FILE
  // Prints text on the console, exactly as QuakeC made it (including newlines). Not set: it is not shown.
  std::function<void(std::string_view text)> print{};
  // DP_QC_WHICHPACK: the name of the archive or folder that contains a file of the game; empty if none does.
  std::function<std::string(std::string_view file)> find_pack{};
  std::vector<Token> tokens{};
  StringBuffers buffers{};
  // Warnings that were printed and are not repeated (see Call::warn_once()).
  std::set<std::string, std::less<>> warned{};
};

// The context of a built-in function while it runs. QuakeC passes parameters without types, so a wrong one is
// normal input. Accessors that can fail return an error, which stops the program and names the function, the
// parameter, and the caller's line.
class Call {
 public:
  Call(Context& io_context, vm::Machine& io_machine, std::string_view name)
      : context(io_context), machine(io_machine), name_(name) {}

  Context& context;
  vm::Machine& machine;

  // --- Parameters; the first is 0.
  int count() const { return machine.parameter_count(); }
  float number(int i) const { return machine.parameter_float(i); }
  // The default if the parameter was not passed.
  float number_or(int i, float otherwise) const { return i < count() ? number(i) : otherwise; }
  int whole(int i) const { return to_whole(number(i)); }
  math::Vec3 vector(int i) const { return machine.parameter_vector(i); }
  // Takes instructions from the call's budget for long texts, because every function reads all of them.
  std::string_view text(int i) const {
    constexpr std::size_t kCharsPerInstruction = 16;
    const std::string_view value = machine.parameter_text(i);
    machine.charge(value.size() / kCharsPerInstruction);
    return value;
  }
  // An entity that exists, free or not.
  base::Result<vm::EntityIndex> entity(int i) const;
  // A field of one word, or the first of a vector's three.
  base::Result<vm::FieldIndex> field(int i) const;
  // All texts from this parameter on, joined: QuakeC's way to print several things.
  std::string joined_text(int first) const;

  // The value of a console variable. 0 if there is no such variable, or if it does not hold a number.
  float variable(std::string_view variable_name) const;
  void print(std::string_view text) const {
    if (context.print) context.print(text);
  }
  // ", in FUNCTION (FILE:LINE), statement N": where QuakeC called this function; empty if it was not called
  // by QuakeC.
  std::string call_site() const;
  // Prints the warning on the console, unless the same text was printed in this game before.
  void warn_once(const std::string& text) const;

  // Return a value to QuakeC.
  base::Status return_number(double value) const {
    machine.return_float(static_cast<float>(value));
    return base::Ok{};
  }
  // The text becomes a new string.
  base::Status return_text(std::string_view text) const;

  // An error of QuakeC. Messages count parameters from 1; the machine adds the function.
  template <typename... Args>
  base::Error error(fmt::format_string<Args...> format, Args&&... args) const {
    return base::malformed(format, std::forward<Args>(args)...);
  }

 private:
  std::string_view name_;
};

// One row of a family's table. Number 0: QuakeC can declare it by name only.
struct Entry {
  int number;
  const char* name;
  base::Status (*function)(Call& io_call);
};

// Makes the shared functions known to the machine. `io_context` must outlive the machine's calls.
void add_builtins(vm::Machine& io_machine, Context& io_context);

// Whether all functions of an extension are among the shared ones. Names are compared without regard to case.
bool has_extension(const Context& context, std::string_view name);

}  // namespace temblor::builtins
