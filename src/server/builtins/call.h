// The context of a built-in function while it runs: its checked parameters, and the objects that it acts on.
// QuakeC passes parameters without types, so a wrong one is normal input. Accessors that can fail return an
// error, which stops the program and names the function, the parameter, and the caller's line.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "server/builtins/builtins.h"
#include "server/system_globals.h"

namespace temblor::server {

// Truncates toward 0, and clamps to the range of int. NaN gives 0.
inline int to_whole(float value) {
  if (std::isnan(value)) return 0;
  if (value >= 2147483648.0f) return 2147483647;
  if (value <= -2147483648.0f) return -2147483647 - 1;
  return static_cast<int>(value);
}

class Call {
 public:
  Call(BuiltinContext& io_game, std::string_view name)
      : game(io_game), world(io_game.world), machine(io_game.machine), name_(name) {}

  BuiltinContext& game;
  GameWorld& world;
  vm::Machine& machine;

  // --- Parameters; the first is 0.
  float number(int i) const { return machine.parameter_float(i); }
  int whole(int i) const { return to_whole(number(i)); }
  math::Vec3 vector(int i) const { return machine.parameter_vector(i); }
  std::string_view text(int i) const { return machine.parameter_text(i); }
  // An entity that exists, free or not.
  base::Result<vm::EntityIndex> entity(int i) const;
  // An entity that belongs to a client slot, even if nobody plays there.
  base::Result<vm::EntityIndex> player(int i) const;
  // A field of one word, or the first of a vector's three.
  base::Result<vm::FieldIndex> field(int i) const;
  // All texts from this parameter on, joined: QuakeC's way to print several things.
  std::string joined_text(int first) const;

  // --- Globals of the program.
  vm::EntityIndex self() const { return machine.global_entity(global::kSelf); }
  math::Vec3 forward() const { return machine.global_vector(global::kForward); }

  bool is_player(vm::EntityIndex entity) const {
    const std::size_t number = base::to_size(entity);
    return number >= 1 && number <= world.edicts.client_count();
  }
  // The value of a console variable. 0 if there is no such variable, or if it does not hold a number.
  float variable(std::string_view variable_name) const;
  // The number of a precached sound. Prints a warning and returns nothing for another one.
  std::optional<std::uint16_t> sound_number(std::string_view sample) const;
  void print(std::string_view text) const {
    if (game.print) game.print(text);
  }
  // The texts from this parameter on. Keys of localized texts ("$qc_died") are replaced by the texts.
  std::vector<std::string> localized_texts(int first) const;
  // All of them, joined. If the first one was a key, its places ({0}) are filled with the others instead.
  std::string localized_text(int first) const;
  // ", in FUNCTION (FILE:LINE), statement N": where QuakeC called this function; empty if it was not called
  // by QuakeC.
  std::string call_site() const;
  // Prints the warning on the server's console, unless the same text was printed in this game before.
  void warn_once(const std::string& text) const;

  // Returns a new string to QuakeC.
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
struct BuiltinEntry {
  int number;
  const char* name;
  base::Status (*function)(Call& io_call);
};

}  // namespace temblor::server
