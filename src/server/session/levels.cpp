// Levels: how they start, end, and follow one another; requests of QuakeC to the server; failures of game
// code.
#include <fmt/format.h>

#include <algorithm>

#include "command/text.h"
#include "server/commands/player_commands.h"
#include "server/game/game_loader.h"
#include "server/save/save_game.h"
#include "server/server.h"
#include "server/session/signon.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

// Game code that fails again so soon after a level started will keep failing.
constexpr double kRepeatedFailure_s = 10;

base::Status no_level_error() {
  return base::error(base::ErrorCode::kUsage, "no level is running");
}

// Files of game code go into a folder of their own, so that it can overwrite nothing else.
GameServices make_services(Server& io_server) {
  const ServerSetup& setup = io_server.setup;
  return {.library = setup.library,
          .io_variables = setup.settings.variables(),
          .print = setup.print,
          .data_folder = setup.write_folder.empty() ? "" : setup.write_folder / "data",
          .has_client = [&io_server](std::size_t slot) { return !io_server.clients[slot].is_free(); }};
}

// Sends the new level to a client that was in the old one. A client that still loads the old one is sent the
// new one when it is done: stock clients cannot stop loading.
void move_client_to_new_level(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  if (client.is_bot()) client = Client{};  // the new game makes its own bots
  if (client.is_free()) return;
  client.loads_old_level = io_server.clients.is_loading(slot);
  // The client would mistake the old level's messages for the new level's.
  io_server.clients.clear_queue(slot);
  client.sent_frags = 0;
  client.is_last_sent_snapshot = false;
  client.pending = {};
  if (!client.loads_old_level) send_next_level(io_server, slot);
}

// Tries to continue the running game on reloaded files, by saving and restoring it. Returns the reason why
// that is impossible; `io_loaded` then contains parts of the old game. Empty: the game continues.
base::Result<std::string> continue_game(Server& io_server, const formats::Sav& running,
                                        LoadedGame& io_loaded) {
  const auto notes = restore(running, *io_loaded.game);
  if (!notes.ok()) return notes.error().message();
  if (!notes->empty()) return notes->front();
  Clients& clients = io_server.clients;
  std::vector<bool> resuming(clients.size());
  for (std::size_t slot = 0; slot < clients.size(); ++slot)
    resuming[slot] = clients[slot].is_in_game() && !clients[slot].is_bot();
  io_loaded.game->context().spawn_parameters = io_server.game->context().spawn_parameters;
  io_loaded.game->adopt_bots(*io_server.game);
  set_game(io_server, std::move(io_loaded));
  io_server.resuming_players = std::move(resuming);
  if (clients.size() == 1) set_paused(io_server, true);  // until the player is back
  return std::string();
}

// All clients are disconnected, because there is nothing to send them.
void end_level(Server& io_server, const std::string& notice) {
  Clients& clients = io_server.clients;
  for (std::size_t slot = 0; slot < clients.size(); ++slot)
    if (!clients[slot].is_free()) clients.release(slot, notice);
  if (io_server.recorder) print_if_error(io_server, stop_demo(io_server));
  io_server.game.reset();
  print(io_server, "no level is running; `map NAME` starts one\n");
}

// Game code restarts the level when a dead player presses any button. A single player who fires continues
// from the last save instead; one who jumps restarts.
bool should_load_last_save(const Server& server, std::string_view commands) {
  constexpr std::uint8_t kJump = 2;
  while (commands.ends_with('\n')) commands.remove_suffix(1);
  return commands == "restart" && can_resume_from_save(server) &&
         !(server.game->player(0)[field::kHealth] > 0) && (server.tick_inputs[0].buttons & kJump) == 0;
}

}  // namespace

GameRequest make_request(const Server& server, std::string_view map) {
  const ServerSetup& setup = server.setup;
  return {.map = std::string(map),
          .kind = setup.settings.kind(setup.max_clients),
          .skill = setup.settings.skill(),
          .program_file = setup.program_file,
          .max_clients = setup.max_clients,
          .seed = setup.seed,
          .oldest_protocol = setup.oldest_protocol};
}

base::Result<LoadedGame> load_level(Server& io_server, const GameRequest& request) {
  return load_game(request, io_server.settings(), make_services(io_server));
}

// The old game is destroyed first thing, so callers have taken from it what the new one needs.
void set_game(Server& io_server, LoadedGame loaded) {
  io_server.game = std::move(loaded.game);
  const GameSetup& game = io_server.game->setup();
  io_server.settings().set_kind(game.kind);
  for (const std::string& note : loaded.notes)
    print_event(io_server, fmt::format("{}: {}\n", game.map_name, note));
  for (const std::string& fault : io_server.game->spawn_report().unknown_classes)
    print(io_server, fmt::format("{}: {}\n", loaded.entities_file, fault));
  if (io_server.recorder) print_if_error(io_server, stop_demo(io_server));
  Clients& clients = io_server.clients;
  io_server.clock.is_paused = false;
  io_server.clock.unplayed_s = 0;
  io_server.resuming_players.assign(clients.size(), false);
  io_server.kept_places.clear();
  io_server.saves.autosave.begin_level();
  clients.set_dialect(game.dialect, max_reliable_bytes(game.dialect));
  io_server.endpoint.set_protocol(game.dialect.protocol);
  for (std::size_t slot = 0; slot < clients.size(); ++slot) move_client_to_new_level(io_server, slot);
}

base::Status start_map(Server& io_server, std::string_view map) {
  TRY(LoadedGame loaded, load_level(io_server, make_request(io_server, map)));
  TRY(const SpawnParameters parameters, loaded.game->new_parameters());
  autosave_on_leave(io_server);
  set_game(io_server, std::move(loaded));
  io_server.saves.autosave.begin_game();
  io_server.saves.last_save.clear();
  for (Client& client : io_server.clients.all()) client.parameters = parameters;
  return base::Ok{};
}

base::Status change_level(Server& io_server, std::string_view map) {
  if (!io_server.game) return start_map(io_server, map);
  Clients& clients = io_server.clients;
  GameRequest request = make_request(io_server, map);
  request.server_flags = io_server.game->server_flags();
  TRY(LoadedGame loaded, load_level(io_server, request));
  // From here on only game code can fail. Only now may SetChangeParms change what players have.
  std::vector<SpawnParameters> carried(clients.size());
  for (std::size_t slot = 0; slot < clients.size(); ++slot) {
    carried[slot] = clients[slot].parameters;
    if (!clients[slot].is_in_game()) continue;
    TRY(carried[slot], io_server.game->parameters_to_carry(slot));
  }
  set_game(io_server, std::move(loaded));
  io_server.saves.last_save.clear();
  for (std::size_t slot = 0; slot < clients.size(); ++slot) clients[slot].parameters = carried[slot];
  return base::Ok{};
}

base::Status restart_level(Server& io_server) {
  if (!io_server.game) return no_level_error();
  GameRequest request = make_request(io_server, io_server.game->setup().map_name);
  request.server_flags = io_server.game->setup().server_flags;
  TRY(LoadedGame loaded, load_level(io_server, request));
  set_game(io_server, std::move(loaded));
  return base::Ok{};
}

base::Status reload_level(Server& io_server) {
  if (!io_server.game) return no_level_error();
  const GameSetup& old = io_server.game->setup();
  GameRequest request = make_request(io_server, old.map_name);
  request.kind = old.kind;
  request.skill = old.skill;
  request.server_flags = old.server_flags;
  const formats::Sav running = make_save(*io_server.game, "");
  request.min_entities = count_used_entities(running);
  TRY(LoadedGame loaded, load_level(io_server, request));

  // The game continues if the level is the same, and the new code knows everything that the old one
  // remembers.
  const bool is_same_level = loaded.game->setup().level_hash == old.level_hash;
  if (is_same_level) {
    TRY(const std::string reason, continue_game(io_server, running, loaded));
    if (reason.empty()) {
      print(io_server, "reloaded: the game continues\n");
      return base::Ok{};
    }
    print(io_server, fmt::format("the game cannot continue: {}\n", reason));
  }
  // The loaded game may contain the old game's entities, or use a protocol chosen for their number.
  if (is_same_level || request.min_entities > kMaxEntitiesOfProtocol15) {
    request.min_entities = 0;
    TRY(loaded, load_level(io_server, request));
  }
  PlayerPlaces places = read_player_places(*io_server.game, io_server.clients);
  set_game(io_server, std::move(loaded));
  io_server.kept_places = std::move(places);
  print(io_server, "reloaded: the level restarts\n");
  return base::Ok{};
}

// Takes the requests out of the game first: handling them may run QuakeC, which makes new ones, or replace
// the game.
void handle_game_requests(Server& io_server) {
  Requests requests = std::exchange(io_server.game->requests(), {});
  const std::size_t slots = io_server.clients.size();
  for (const Requests::PlayerCommand& command : requests.player_commands) {
    const std::size_t slot = base::to_size(command.player) - 1;
    if (slot < slots && !io_server.clients[slot].is_free()) run_player_command(io_server, slot, command.line);
  }
  for (const std::size_t slot : requests.dropped_players)
    if (slot < slots) drop_client(io_server, slot, "dropped by the game");
  if (!requests.commands.empty())
    io_server.console.append(should_load_last_save(io_server, requests.commands)
                                 ? command::join_words({"load", io_server.saves.last_save})
                                 : requests.commands);
  if (requests.change_level) io_server.console.append("changelevel \"" + *requests.change_level + "\"\n");
}

// The policy: restart once; if game code fails again soon, drop the player on whose behalf it ran and
// restart; if nobody can be blamed, end the level. A host is never left with a server that keeps restarting.
void handle_game_failure(Server& io_server, const base::Error& error) {
  Game& game = *io_server.game;
  print(io_server, fmt::format("game code failed: {}\n{}", error.message(),
                               game.machine().describe(game.machine().failure_trace())));
  const std::string notice = fmt::format("Game code failed: {}\n", error.message());
  const bool fails_again = io_server.clock.now_s - io_server.failed_at_s < kRepeatedFailure_s;
  io_server.failed_at_s = io_server.clock.now_s;
  // A player whose actions make it fail again and again is dropped, and the others play on.
  const std::optional<std::size_t> blamed = game.blamed_player();
  const bool drops_blamed = fails_again && blamed && !io_server.clients[*blamed].is_free();
  if (drops_blamed) {
    const Client& client = io_server.clients[*blamed];
    print(io_server, fmt::format("client {} ({}) removed: game code failed twice for it\n", client.name,
                                 client.address));
    io_server.clients.release(*blamed, notice);
  }
  if (!fails_again || drops_blamed) {
    // Printed after the restart, because a client shows no text while it loads a level.
    if (const base::Status restarted = restart_level(io_server); restarted.ok())
      return io_server.clients.print_to_all(notice);
  }
  end_level(io_server, notice);
}

}  // namespace temblor::server
