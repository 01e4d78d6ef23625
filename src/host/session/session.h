// A game that the player is in: the connection to its server, and the server itself if it runs in this
// program.
//
// Our own server is connected over a loopback network, with the same packets as a remote one:
//
//   single player, listen server   Connection <-> LoopbackNetwork <-> Server <-> UDP (other players)
//   remote server                  Connection <-> UDP
//   lockstep                       Connection <-> LoopbackNetwork <-> LockstepGame <-> UDP (other players)
//
// Times `now_s` are the window's clock. Our own server has a clock of its own, which stands still while the
// game is halted. In each frame the host calls
//
//   read() -> count_due_moves(), send_move() -> step_server()
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/input/player_input.h"
#include "client/session/connection.h"
#include "host/services.h"
#include "host/session/move_pacer.h"
#include "lockstep/lockstep_game.h"
#include "net/transport/loopback.h"
#include "server/server.h"

namespace temblor::host {

class Session {
 public:
  // The references must outlive this object. The paths are those of server::ServerSetup.
  Session(Services& services, const assets::Library& library, std::filesystem::path write_folder,
          const server::ServerVariables& settings, std::filesystem::path program_file);
  ~Session();

  // Starts a server for this number of players and connects to it. Keeps the running server if it has the
  // same number of players. With more than one, others may join over UDP at `port`; fails if the port is not
  // free. The server has no level until server::start_map() or load_saved_game(). `now_s`: the window's
  // clock.
  base::Status open_server(std::uint32_t max_clients, std::uint16_t port,
                           const client::PlayerSettings& player, double now_s);
  // Null: no server runs in this program.
  server::Server* server() { return server_.get(); }
  // A single-player game on our own server.
  bool is_alone() const { return server_ != nullptr && max_clients_ == 1; }
  // Connects to a server on another machine: "HOST" or "HOST:PORT". Ends the current game, unless the address
  // cannot be resolved.
  base::Status connect(std::string_view address, const client::PlayerSettings& player, double now_s);
  // Plays a lockstep game, instead of the current one.
  void open_lockstep(std::unique_ptr<lockstep::LockstepGame> game, const client::PlayerSettings& player,
                     double now_s);
  // Returns the replay of a lockstep game that has ended, once.
  std::optional<base::ByteVector> take_replay() { return std::exchange(replay_, std::nullopt); }
  // Leaves the game, and shuts down our own server. `reason` is shown to its other players. Does nothing if
  // there is no game.
  void disconnect(std::string_view reason);

  // Null: neither in a game nor connecting.
  client::Connection* connection() { return connection_ ? &*connection_ : nullptr; }
  const client::Connection* connection() const { return connection_ ? &*connection_ : nullptr; }
  bool is_playing() const { return connection_ && connection_->is_playing(); }

  // Reads packets. If the connection was lost, returns the reason once, as text for the player.
  std::optional<std::string> read(double now_s);
  // Returns the demo of a lost connection once, if one was being recorded.
  std::optional<base::ByteVector> take_lost_recording() {
    return std::exchange(lost_recording_, std::nullopt);
  }
  // The time to show, on the server's clock, between the last two snapshots. The view is thus up to one
  // snapshot late, and entities move smoothly between two known positions.
  double time_s() const { return time_s_; }
  // The number of moves to send now: one before each tick of our own server or of a server that numbers
  // moves; for others see move_pacer.h. `next` is the move that would be sent.
  int count_due_moves(const net::Move& next, double now_s);
  void send_move(net::Move move, double now_s);
  // The clock for the times of moves: that of our own server, otherwise the window's.
  double move_clock_s(double now_s) const;
  // Game time per real time from now on, on our own server's clock.
  void set_time_scale(double scale) { time_scale_ = scale; }
  // Runs our own server, or the lockstep game, up to this time; does nothing without one. If `halted`, its
  // clock stands still, but it still receives and sends packets, so that the connection does not time out.
  // May run on another thread while nothing else of this object is called.
  void step_server(double now_s, bool halted);
  // Returns what our own server has printed since the last call. It may end in the middle of a line.
  std::string take_server_output() { return std::exchange(server_output_, {}); }

 private:
  server::ServerSetup make_setup(net::ServerEndpoint::Sockets sockets, std::uint32_t max_clients);

  Services& services_;
  const assets::Library& library_;
  std::filesystem::path write_folder_;
  const server::ServerVariables& settings_;
  std::filesystem::path program_file_;
  std::optional<net::LoopbackNetwork> network_;  // none: no server of our own
  std::unique_ptr<server::Server> server_;
  std::uint32_t max_clients_ = 0;
  std::string server_output_;
  std::unique_ptr<lockstep::LockstepGame> lockstep_;
  std::optional<client::Connection> connection_;
  std::optional<base::ByteVector> lost_recording_, replay_;
  double now_s_ = 0;   // when read() was last called
  double time_s_ = 0;  // see time_s()
  MovePacer move_pacer_;
  double time_scale_ = 1;
  double server_now_s_ = 0;  // our own server's clock
  double stepped_s_ = 0;     // when step_server() was last called
};

}  // namespace temblor::host
