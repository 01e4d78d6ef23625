// The context of a built-in function of the server while it runs: the shared Call (builtins/call.h), and the
// objects that the function acts on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "builtins/call.h"
#include "server/builtins/builtins.h"
#include "server/system_globals.h"

namespace temblor::server {

using builtins::to_whole;

class Call : public builtins::Call {
 public:
  Call(BuiltinContext& io_game, std::string_view name)
      : builtins::Call(io_game.shared, io_game.machine, name), game(io_game), world(io_game.world) {}

  BuiltinContext& game;
  GameWorld& world;

  // A parameter: an entity that belongs to a client slot, even if nobody plays there.
  base::Result<vm::EntityIndex> player(int i) const;

  // --- Globals of the program.
  vm::EntityIndex self() const { return machine.global_entity(global::kSelf); }
  math::Vec3 forward() const { return machine.global_vector(global::kForward); }

  bool is_player(vm::EntityIndex entity) const {
    const std::size_t number = base::to_size(entity);
    return number >= 1 && number <= world.edicts.client_count();
  }
  // The number of a precached sound. Prints a warning and returns nothing for another one.
  std::optional<std::uint16_t> sound_number(std::string_view sample) const;
  // The texts from this parameter on. Keys of localized texts ("$qc_died") are replaced by the texts.
  std::vector<std::string> localized_texts(int first) const;
  // All of them, joined. If the first one was a key, its places ({0}) are filled with the others instead.
  std::string localized_text(int first) const;
};

// One row of a family's table. Number 0: QuakeC can declare it by name only.
struct BuiltinEntry {
  int number;
  const char* name;
  base::Status (*function)(Call& io_call);
};

}  // namespace temblor::server
