// Built-in functions for changes of the level, and for queries of extensions.
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// changelevel(map): only the first call in a level counts, because several players may reach the exit in one
// tick.
base::Status changelevel(Call& io_call) {
  std::optional<std::string>& next = io_call.game.requests.change_level;
  if (!next) next = std::string(io_call.text(0));
  return base::Ok{};
}

// setspawnparms(player): copies what a player brought from the last level into parm1 to parm16.
base::Status setspawnparms(Call& io_call) {
  TRY(const vm::EntityIndex player, io_call.player(0));
  const std::size_t slot = base::to_size(player) - 1;
  const auto& all = io_call.game.spawn_parameters;
  const std::array<float, 16> values = slot < all.size() ? all[slot] : std::array<float, 16>{};
  for (int i = 0; i < global::kParmCount; ++i)
    io_call.machine.set_global_float(parm(i), values[static_cast<std::size_t>(i)]);
  return base::Ok{};
}

// checkextension(name): 1 if has_extension().
base::Status checkextension(Call& io_call) {
  io_call.machine.return_float(has_extension(io_call.game, io_call.text(0)) ? 1 : 0);
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> level_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {70, "changelevel", changelevel},
      {78, "setspawnparms", setspawnparms},
      {99, "checkextension", checkextension},
  };
  return kEntries;
}

}  // namespace temblor::server
