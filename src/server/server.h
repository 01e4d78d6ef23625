// A game server: it accepts clients, plays one level after another, and sends every player what it sees and
// hears.
// `Server` is a plain struct of parts. The functions below act on it; each step of the server is a list of
// such calls (server_tick.cpp), and the stages that they consist of are in session/stages.h:
//    sockets -> receive_packets -> moves, commands -> server_tick ... -> snapshots, messages -> sockets
//                                                     |
//                                                     play_moves, physics, bots, send_snapshots,
//                                                     QuakeC's requests
// A server has neither a clock nor sockets of its own. Callers pass both in, so that tests run it on their
// own clock and network, and two servers can live in one process. The protocols are the stock ones
// (docs/network.md); what we add to them looks like comments to stock clients.
// Unlike stock Quake, a tick has a fixed length, whatever the frame rate of a client in the same process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/library.h"
#include "base/result.h"
#include "command/console.h"
#include "net/transport/server_endpoint.h"
#include "server/game.h"
#include "server/save/autosave.h"
#include "server/save/player_places.h"
#include "server/server_variables.h"
#include "server/session/client_datagram.h"
#include "server/session/clients.h"
#include "server/session/demo_recorder.h"
#include "server/session/snapshot.h"

namespace temblor::server {

struct ServerSetup {
  // These must outlive the server.
  const assets::Library& library;
  const ServerVariables& settings;
  net::ServerEndpoint::Sockets sockets;  // one or more
  net::ServerEndpointSettings wire{};    // its number of connections follows from max_clients
  std::uint32_t max_clients = 8;         // 1: single player; stock clients refuse more than 16
  net::Protocol oldest_protocol = net::Protocol::kNetQuake;  // see GameRequest
  std::filesystem::path program_file{};  // the game's code on disk; empty: progs.dat of the game folders
  // The folder for saved games, demos and files that the game's code writes. Empty: nothing is written.
  std::filesystem::path write_folder{};
  // Replaces a file as a whole, or leaves the old one.
  std::function<base::Status(const std::filesystem::path& file, base::Bytes bytes)> write_file{};
  std::function<void(std::string_view text)> print;  // to the host's console; text includes its newlines
  std::string version = "Temblor";                   // that the command `version` prints
  // Also print who joins and chats, and which entities of a level have no spawn function. A host who also
  // plays leaves this off, because the client shows the same.
  bool prints_events = true;
  std::uint64_t seed = 1;  // of the game's random numbers
};

struct ServerClock {
  double now_s = 0;       // of the caller's clock; never decreases
  double unplayed_s = 0;  // time that has passed, but was not played in ticks yet
  // Ticks of all levels since the server started.
  std::uint64_t ticks = 0;
  bool has_started = false;
  bool is_paused = false;
};

// A single player's saved games.
struct SavedGames {
  Autosave autosave;
  std::string new_autosave;  // the last autosave's name, until take_autosave_name() returns it
  std::string last_save;     // of this level, saved or loaded; empty: none
};

// The buffers of send_snapshots(), kept from tick to tick so that it allocates nothing.
struct SnapshotBuffers {
  Snapshot snapshot;
  DatagramScratch scratch;
  base::ByteWriter datagram, delta;
  bool has_warned_of_entity_limit = false;  // of protocol 15
};

struct Server {
  explicit Server(ServerSetup setup);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  const ServerVariables& settings() const { return setup.settings; }

  ServerSetup setup;
  command::Console console;  // with the host's commands (commands/host_commands.h)
  net::ServerEndpoint endpoint;
  Clients clients;
  std::unique_ptr<Game> game;  // null: no level is running
  ServerClock clock;
  std::vector<PlayerInput> tick_inputs;  // by slot: the move that each player makes in this tick
  // By slot: the game already contains this player, because it was loaded or reloaded. spawn_client() then
  // leaves its entity as it is.
  std::vector<bool> resuming_players;
  PlayerPlaces kept_places;  // by slot: where to put a player after it has spawned; may be empty
  SnapshotBuffers buffers;
  SavedGames saves;
  std::optional<DemoRecorder> recorder;
  std::optional<std::string> captured_output;  // see run_and_capture()
  std::uint64_t sent_rules_version = 0;  // of the variables, when players were last sent the changed rules
  // From where all players see and hear, for recordings of camera flights. Empty: from their own eyes.
  std::optional<math::Vec3> camera_world;
  double failed_at_s = -1e9;  // when the game's code last failed
  bool wants_to_quit = false;
};

// --- Time. `now_s` may come from any clock that never decreases.

// Receives packets, runs commands, plays all ticks that are due (a long pause is cut short), and sends
// packets.
void step_server(Server& io_server, double now_s);
// Plays one tick of the level that is running, and sends its snapshots.
void server_tick(Server& io_server);
// Seconds until the next tick is due; never less than 0.
double time_until_next_tick_s(const Server& server, double now_s);
// Stops time, or lets it run again, and tells all clients so.
void set_paused(Server& io_server, bool is_paused);
// Sends `reason` to all clients and disconnects them. The server must not be used afterwards.
void shut_down(Server& io_server, std::string_view reason);

// Changes the number of player slots, 1 to 255. Fails with kUsage once a level runs, because game code and
// players have used the number.
base::Status set_max_clients(Server& io_server, std::uint32_t count);

// --- Levels. If the level or the game's code cannot be used, these fail, and the running level continues.

// Starts a new game on this level: every player begins with what a new player has.
base::Status start_map(Server& io_server, std::string_view map);
// Continues in another level. Players keep what game code lets them carry over (SetChangeParms), and the
// world its server flags. Without a running level it is start_map().
base::Status change_level(Server& io_server, std::string_view map);
// Starts the level again. Every player begins with what it entered the level with.
base::Status restart_level(Server& io_server);
// Reads game code and the level from disk again. The game continues where it was if both still fit; else the
// level starts again, and players stay where they were.
base::Status reload_level(Server& io_server);

// --- Saved games of a single player: NAME.sav in the write folder.

// Prints the result. Menus show `title`, or the level's if it is empty; its first 22 characters are stored.
// kUsage if the game cannot be saved: there are several players, or none that lives.
base::Status save_game(Server& io_server, std::string_view name, std::string_view title = {});
// Replaces the running level. The game is paused until the player has joined.
base::Status load_saved_game(Server& io_server, std::string_view name);
// Whether the game is saved automatically when the player leaves it, so that nothing is lost.
bool autosaves_on_leave(const Server& server);
// The name of an autosave that was written since the last call; empty: there was none.
std::string take_autosave_name(Server& io_server);
// Whether a dead player who fires continues from a saved game of this level.
bool can_resume_from_save(const Server& server);

// --- Clients and the host.

// Appends the last tick's updates of all visible entities, of which a player is sent only those in sight.
void write_visible_entities(const Server& server, base::ByteWriter& io_writer);
// Disconnects a client. The client and the host see the `reason`.
void drop_client(Server& io_server, std::size_t slot, std::string_view reason);
// Records what this player sees and hears, as NAME.dem in the write folder.
base::Status record_demo(Server& io_server, std::size_t slot, std::string_view name);
// Writes the recording. kUsage if there is none.
base::Status stop_demo(Server& io_server);
// Runs a console command for somebody who is not at the console (rcon), and returns what it printed.
std::string run_and_capture(Server& io_server, std::string_view line);
// To the host's console, and to the output that run_and_capture() collects.
void print(Server& io_server, std::string_view text);
// Prints only if ServerSetup::prints_events.
void print_event(Server& io_server, std::string_view text);
void print_if_error(Server& io_server, const base::Status& status);

}  // namespace temblor::server
