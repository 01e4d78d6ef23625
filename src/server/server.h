// A server: clients that come and go, and one level after another. Knows no clock and no socket of its own:
// both are given to it, so that tests run it on a clock of theirs, and two can live in one process.
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
#include "net/protocol/client_message.h"
#include "net/transport/server_endpoint.h"
#include "server/game.h"
#include "server/game/game_loader.h"
#include "server/save/autosave.h"
#include "server/server_variables.h"
#include "server/session/client_datagram.h"
#include "server/session/clients.h"
#include "server/session/recorder.h"
#include "server/session/snapshot.h"

namespace temblor::server {

struct ServerSetup {
  // These must outlive the server.
  const assets::Library& library;
  const ServerVariables& settings;
  net::ServerEndpoint::Sockets sockets;  // one or more
  net::ServerEndpointSettings wire{};    // how many connections there may be follows from max_clients
  std::uint32_t max_clients = 8;         // 1: single player; more than 16: stock clients refuse
  std::filesystem::path program_file{};  // the game's code on disk; empty: the game folders' progs.dat
  // Where saves, recordings and game code's own files go; empty: nothing is written.
  std::filesystem::path write_folder{};
  // Replaces a file whole, or leaves the old one.
  std::function<base::Status(const std::filesystem::path& file, base::Bytes bytes)> write_file{};
  std::function<void(std::string_view text)> print;  // for the host's eyes; newlines are in it
  // Who comes and speaks, and what of a level's entities the program does not know, is printed as well. Not
  // for a host who plays: as a player he is told.
  bool prints_events = true;
  std::uint64_t seed = 1;  // of the games' dice
};

class Server {
 public:
  explicit Server(ServerSetup setup);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // --- Levels. Each of these fails where level or program cannot be used; what was running then goes on.
  // A new game: everybody starts anew.
  base::Status start_map(std::string_view map);
  // Players take along what SetChangeParms says, and the world its server flags.
  base::Status change_level(std::string_view map);
  // The level again, everybody with what he came into it with.
  base::Status restart();
  // The level again, with the program and the level as they are on disk now.
  base::Status reload();
  base::Status save(std::string_view name);
  base::Status load(std::string_view name);
  // Whether the game of a single player is saved when it is left, so that nothing is lost by that.
  bool saves_when_left() const { return autosave_.is_worth_saving(now_s_) && can_autosave(); }
  // The name of a game that was saved without being asked, once; else empty.
  std::string take_autosaved() { return std::exchange(autosaved_, {}); }
  // Whether a dead player who fires goes on from a saved game of this level.
  bool goes_on_from_save() const;

  // --- Time. `now_s` is any clock's and never goes back.
  // Packets in, commands, as many ticks as are due (the rest of a long wait is forgotten), packets out.
  void step(double now_s);
  // Seconds until the next tick is due, for who wants to sleep; 0 at the least.
  double until_next_tick_s(double now_s) const;
  // Tells everybody and lets go of them. Nothing else may follow.
  void shut_down(std::string_view reason);

  // --- The host's commands (host_commands.h adds them).
  command::Console& console() { return console_; }
  bool wants_to_quit() const { return wants_to_quit_; }
  void quit() { wants_to_quit_ = true; }
  void set_paused(bool paused);
  bool is_paused() const { return is_paused_; }
  base::Status record(std::size_t slot, std::string_view name);
  base::Status stop_recording();
  bool is_recording() const { return recorder_.has_value(); }
  // A host's command on behalf of somebody else: what it printed.
  std::string run_and_capture(std::string_view line);
  // The game's code has failed.
  void fail(const base::Error& error);
  // Lets go of a client; `reason` is for his eyes and everybody's.
  void drop(std::size_t slot, std::string_view reason);

  Game* game() { return game_.get(); }  // null: no level is running
  Clients& clients() { return clients_; }
  net::ServerEndpoint& endpoint() { return endpoint_; }
  const ServerVariables& settings() const { return setup_.settings; }
  const vfs::FileSystem& files() const { return setup_.library.files(); }
  void print(std::string_view text);
  void print_event(std::string_view text);  // only where ServerSetup::prints_events
  double now_s() const { return now_s_; }
  std::uint64_t ticks() const { return ticks_; }

 private:
  // Joining a level, and leaving (server_clients.cpp).
  void take_events();
  void take_event(const net::PeerConnected& event);
  void take_event(const net::PeerMessage& event);
  void take_event(const net::PeerDisconnected& event);
  void take_event(const net::RemoteCommand& event);
  net::ServerDescription description() const;
  std::optional<std::size_t> place_for_newcomer();
  void tell_of_leaving(std::size_t slot);
  void leave(std::size_t slot);
  void take_messages(std::size_t slot, base::Bytes bytes, bool is_reliable);
  void take_move(std::size_t slot, const net::Move& move);
  void take_packet_head(std::size_t slot, const net::NumberedPacket& head);
  void note_ping(std::size_t slot, float told_time_s);
  void take_command(std::size_t slot, std::string_view line);
  // Answers to what clients ask for while they join; each fails where QuakeC does.
  base::Status tell_level(std::size_t slot);
  void tell_next_level(std::size_t slot);
  base::Status tell_beginning(std::size_t slot);
  base::Status spawn_client(std::size_t slot);
  void begin_play(std::size_t slot);
  bool may_command(std::size_t slot);
  bool parse_command(std::size_t slot, std::string_view line);
  void drop_failed_clients();

  // Levels (server.cpp).
  GameServices services();
  GameRequest request_for(std::string_view map) const;
  base::Result<std::filesystem::path> file_to_write(std::string_view name, std::string_view suffix) const;
  base::Status replace_game(const GameRequest& request);
  base::Status go_on_from(std::string_view saved_game);
  void take_up(LoadedGame loaded);
  void do_requests();
  void print_if_error(const base::Status& status);

  // Ticks (server_tick.cpp).
  void run_tick();
  base::Status take_numbered_moves(std::size_t slot);
  void send_move_parameters();
  void send_changed_rules();
  void offer_delta_compression(std::size_t slot);
  void acknowledge_moves(std::size_t slot);
  void send_tick();
  bool take_turn(std::size_t slot);
  void record_of(std::size_t slot, base::Bytes messages);
  void send_to(std::size_t slot);
  bool write_delta(std::size_t slot);
  void send_frags();
  void take_in_bots();
  void clear_flashes();
  void autosave();
  void save_unasked();
  bool can_autosave() const;
  bool takes_last_save(std::string_view commands) const;

  ServerSetup setup_;
  command::Console console_;
  net::ServerEndpoint endpoint_;
  Clients clients_;
  std::unique_ptr<Game> game_;
  Snapshot snapshot_;
  DatagramScratch scratch_;
  base::ByteWriter datagram_, difference_;
  std::vector<PlayerInput> inputs_;
  std::optional<Recorder> recorder_;
  double now_s_ = 0;
  double unplayed_s_ = 0;  // of the clock, not yet played
  double failed_at_s_ = -1e9;
  Autosave autosave_;
  std::string autosaved_;  // take_autosaved()
  std::string last_save_;  // of this level, saved or loaded; empty: none
  std::uint64_t ticks_ = 0;
  std::uint64_t told_rules_version_ = 0;  // of the variables, when players were last told of rules
  // By slot: the player is in the game already (loaded or reloaded) when his client asks to be put there.
  std::vector<bool> resuming_;
  std::optional<std::string> captured_;  // run_and_capture()
  bool has_started_ = false;
  bool has_told_of_numbers_ = false;  // that entities have no number in the protocol
  bool is_paused_ = false;
  bool wants_to_quit_ = false;
};

}  // namespace temblor::server
