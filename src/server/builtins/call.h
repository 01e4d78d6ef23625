// What a built-in function sees while it runs: its parameters, checked, and what it acts upon.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "server/builtins/builtins.h"
#include "server/system_globals.h"

namespace temblor::server {

// Towards 0, into the range of int; 0 for what is no number.
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
  base::Result<vm::EntityIndex> entity(int i) const;
  // One of the entities that are players' places, whether somebody plays there or not.
  base::Result<vm::EntityIndex> player(int i) const;
  // A field of one word; of three for vectors.
  base::Result<vm::FieldIndex> field(int i) const;
  // All texts from there on, one behind the other: the original's way to print several things.
  std::string joined_text(int first) const;

  // --- Globals of the program.
  vm::EntityIndex self() const { return machine.global_entity(global::kSelf); }
  math::Vec3 forward() const { return machine.global_vector(global::kForward); }

  bool is_player(vm::EntityIndex entity) const {
    const std::size_t number = base::to_size(entity);
    return number >= 1 && number <= world.edicts.client_count();
  }
  // 0 for a variable that there is not, and for one that holds no number.
  float variable(std::string_view variable_name) const;
  // Of a precached sound; nothing, and a warning, for another.
  std::optional<std::uint16_t> sound_number(std::string_view sample) const;
  void print(std::string_view text) const {
    if (game.print) game.print(text);
  }
  // ", in FUNCTION (FILE:LINE), statement N": who called this function; empty where nobody did.
  std::string place() const;
  // The same words only once a game.
  void warn_once(const std::string& text) const;

  // Makes the text a string and returns it.
  base::Status return_text(std::string_view text) const;

  // What is wrong, with parameters counted from 1; the machine says in which function.
  template <typename... Args>
  base::Error error(fmt::format_string<Args...> format, Args&&... args) const {
    return base::malformed(format, std::forward<Args>(args)...);
  }

 private:
  std::string_view name_;
};

// Number 0: known by its name only.
struct BuiltinEntry {
  int number;
  const char* name;
  base::Status (*function)(Call& io_call);
};

}  // namespace temblor::server
