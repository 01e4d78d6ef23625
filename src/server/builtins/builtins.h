// The functions that QuakeC calls by number: stock Quake's and the extensions of quake-facts.md section 18.
// docs/builtins.md lists them, and where we differ from the original.
// Each is a few lines over GameWorld, Outbox and the rest of BuiltinContext; none knows a network or a clock.
// Requests hold the actions that must wait until QuakeC has returned (a change of level, a dropped player):
//    QuakeC: sound(self, ...) --> vm::Machine --> Call (checked parameters, call.h) --> function in a family
//                                                                                        |
//                               GameWorld, Outbox, Requests, variables, files  <---------+
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "builtins/call.h"
#include "formats/game/localization.h"
#include "net/protocol/game_stat.h"
#include "server/debug_shapes.h"
#include "server/game/game_random.h"
#include "server/game/game_world.h"
#include "server/game/outbox.h"
#include "vm/machine.h"
#include "world/animation.h"

namespace temblor::server {

// Names that clients are sent before the level begins; a name's number is its index.
struct Precache {
  std::vector<std::string> sounds{""};  // [0] stands for no sound; models are in GameWorld::models
  bool is_open = true;  // only while the level is set up; a later precache_* is an error, as in stock Quake
};

// Actions that QuakeC requests from the server, to be done when it has returned.
struct Requests {
  // localcmd: text for the console. Waiting for more than this is an error.
  static constexpr std::size_t kMaxCommandBytes = std::size_t{1} << 16;
  std::string commands;
  std::optional<std::string> change_level;  // only the first request of a level counts
  // clientcommand: to be run as if QuakeC had not seen it. More than this many are ignored.
  static constexpr std::size_t kMaxPlayerCommands = 64;
  struct PlayerCommand {
    vm::EntityIndex player{};
    std::string line;
  };
  std::vector<PlayerCommand> player_commands{};
  std::vector<std::size_t> dropped_players{};  // people whom dropclient dropped, by slot
};

// The kind of player in a client slot, with the numbers that clienttype() returns.
enum class PlayerType { kNobody = 0, kHuman = 1, kBot = 2, kNotASlot = 3 };

// DP_SV_BOTCLIENT and DP_SV_DROPCLIENT: clients that QuakeC itself plays. Slots are counted from 0.
struct BotServices {
  // Puts a bot into a free slot and into the game. Returns kWorld if no slot is free.
  std::function<base::Result<vm::EntityIndex>()> spawn_bot{};
  // Drops a bot at once, and a person when QuakeC has returned.
  std::function<base::Status(std::size_t slot)> drop{};
  std::function<PlayerType(std::size_t slot)> player_type{};
};

// A text that ends a level or an episode (svc_finale, svc_cutscene). Clients show it letter by letter.
struct ClosingText {
  double since_s = 0;  // of the game's time
  std::size_t letters = 0;
};

// A value that clientstat() or globalstat() has chosen for players' HUD programs.
struct SentStat {
  enum class Type { kText, kFloat, kVector, kWord };
  Type type = Type::kFloat;
  std::uint32_t word = 0;  // the field of the player, or the global
  bool is_global = false;
};

// The stat's value for this player now.
net::StatValue read_sent_stat(const SentStat& stat, const vm::Machine& machine, vm::EntityIndex player);

// Everything that built-in functions act on. References must outlive the machine's calls. Functions that are
// not set mean that the server lacks that feature.
struct BuiltinContext {
  GameWorld& world;
  vm::Machine& machine;
  Outbox& outbox;
  Precache& precache;
  Requests& requests;
  GameRandom& random;
  builtins::Context shared;  // of the functions that the client has too
  world::LightStylePatterns light_styles{};
  // By client slot, for the next level: setspawnparms() copies them into parm1 to parm16. Zeros for slots
  // that do not exist.
  std::vector<std::array<float, 16>> spawn_parameters{};
  // Loads a model for its box and number: "progs/ogre.mdl", "maps/b_bh25.bsp". After an error the level
  // continues with a placeholder. Not set: there are no files, and every model that is not in
  // GameWorld::models is an error.
  std::function<base::Result<ServerModel>(std::string_view name)> load_model{};
  // The player that checkclient() may return now, since when, and what can be seen from there.
  vm::EntityIndex check_client{};
  double check_client_since_s = 0;
  std::vector<std::uint8_t> check_client_pvs{};
  // KRIMZON_SV_PARSECLIENTCOMMAND: runs a player's command as if QuakeC had not seen it. Not set:
  // checkextension() says that there is no such extension.
  std::function<void(vm::EntityIndex player, std::string_view command)> client_command{};
  // Empty functions: checkextension() says that there are no bots.
  BotServices bot_services{};
  // Texts for "$key" in what game code prints. Null: there are none.
  const formats::Localization* localization = nullptr;
  std::optional<ClosingText> closing_text{};
  std::map<std::uint8_t, SentStat> sent_stats{};  // by number
  DebugShapes debug_shapes{};
};

// Makes all built-in functions known to the machine. `io_context` must outlive the machine's calls. CHECKs
// check_system_definitions() (system_globals.h).
void add_builtins(vm::Machine& io_machine, BuiltinContext& io_context);

// The answer of checkextension(). Names are compared without regard to case.
bool has_extension(const BuiltinContext& context, std::string_view name);

}  // namespace temblor::server
