// The functions that QuakeC calls by number: stock Quake's and the extensions of quake-facts.md section 18.
// Each is a few lines over GameWorld, Outbox and the rest of BuiltinContext; none knows a network or a clock.
// docs/builtins.md has the list, and where we differ from the original.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "command/variables.h"
#include "server/game/game_random.h"
#include "server/game_world.h"
#include "server/save/script_files.h"
#include "server/session/outbox.h"
#include "vm/machine.h"
#include "world/animation.h"

namespace temblor::server {

// Names that clients are told before the level begins; their numbers are their places.
struct Precache {
  std::vector<std::string> sounds{""};  // [0] is none; models are GameWorld::models
  bool is_open = true;  // while the level is set up: precache_* later is an error, as in stock
};

// What the program wants of the server, to be done when it has returned.
struct Requests {
  // localcmd: text for the console. More than this at once is an error.
  static constexpr std::size_t kMaxCommandBytes = std::size_t{1} << 16;
  std::string commands;
  std::optional<std::string> change_level;  // the first of a level wins
  // clientcommand: to be done as if the program had not seen it, when it has returned.
  static constexpr std::size_t kMaxPlayerCommands = 64;
  struct PlayerCommand {
    vm::EntityIndex player{};
    std::string line;
  };
  std::vector<PlayerCommand> player_commands{};
  std::vector<std::size_t> dropped_players{};  // dropclient of people: their places
};

// Who plays in a client's place, as clienttype() numbers it.
enum class PlayerType { kNobody = 0, kHuman = 1, kBot = 2, kNoPlace = 3 };

// DP_SV_BOTCLIENT, DP_SV_DROPCLIENT: clients whose hands are the program itself. Places are counted from 0.
struct PlayerPlaces {
  // A bot in a free place, put into the game; kWorld: no place is free.
  std::function<base::Result<vm::EntityIndex>()> spawn_bot{};
  // Bots at once, people when the program has returned.
  std::function<base::Status(std::size_t slot)> drop{};
  std::function<PlayerType(std::size_t slot)> type_of{};
};

struct BuiltinContext {
  GameWorld& world;
  vm::Machine& machine;
  Outbox& outbox;
  Precache& precache;
  Requests& requests;
  GameRandom& random;
  command::Variables& variables;
  ScriptFiles files{};  // FRIK_FILE
  world::LightStylePatterns light_styles{};
  // Of each client slot, for the next level: setspawnparms reads them into parm1 to parm16. A slot that is
  // not there has zeros.
  std::vector<std::array<float, 16>> spawn_parameters{};
  // Loads a model for its box and number: "progs/ogre.mdl", "maps/b_bh25.bsp". An error ends the level. None:
  // there are no files, and every one that is not in GameWorld::models yet is an error.
  std::function<base::Result<ServerModel>(std::string_view name)> load_model{};
  // Text for the server's own console, as QuakeC made it (its newlines are in it). None: it is not shown.
  std::function<void(std::string_view text)> print{};
  // Whose turn it is to be found by checkclient, and what it sees from there (renewed every 0.1 s).
  vm::EntityIndex check_client{};
  double check_client_since_s = 0;
  std::vector<std::uint8_t> check_client_pvs{};
  // KRIMZON_SV_PARSECLIENTCOMMAND: does a player's command as if the program had not seen it. None: the
  // program is told that there is no such extension.
  std::function<void(vm::EntityIndex player, std::string_view command)> client_command{};
  // None: the program is told that there are no bots.
  PlayerPlaces places{};
  // DP_QC_WHICHPACK: the name of the archive or folder that a file of the game is in; empty: it is in none.
  std::function<std::string(std::string_view file)> pack_of{};
  std::vector<std::string> tokens{};  // of the last tokenize()
  // What was said once and need not be said again.
  std::set<std::string, std::less<>> warned{};
};

// `io_context` must outlive the machine's calls. CHECKs check_system_definitions() (system_globals.h).
void add_builtins(vm::Machine& io_machine, BuiltinContext& io_context);

// What checkextension says.
bool has_extension(const BuiltinContext& context, std::string_view name);

}  // namespace temblor::server
