// Being in a game: the connection to its server, and the server itself where it runs in this program.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/input/player_input.h"
#include "client/session/connection.h"
#include "host/services.h"
#include "net/transport/loopback.h"
#include "server/server.h"

namespace temblor::host {

class Session {
 public:
  // The references must outlive it. The paths are ServerSetup's.
  Session(Services& services, const assets::Library& library, std::filesystem::path write_folder,
          const server::ServerVariables& settings, std::filesystem::path program_file);
  ~Session();

  // A server in this program for that many players, of which this one is the first; one that runs already for
  // as many goes on. More than one: others may join over UDP at `port`.
  base::Status open_server(std::uint32_t max_clients, std::uint16_t port,
                           const client::PlayerSettings& player);
  server::Server* server() { return server_.get(); }
  bool is_alone() const { return server_ != nullptr && max_clients_ == 1; }
  // Another machine's: "HOST", "HOST:PORT".
  base::Status connect(std::string_view address, const client::PlayerSettings& player);
  // Leaves the game, and ends the server that runs here.
  void disconnect(std::string_view reason);

  // Null: not in a game, nor on the way into one.
  client::Connection* connection() { return connection_ ? &*connection_ : nullptr; }
  bool is_playing() const { return connection_ && connection_->is_playing(); }

  // Reads what has come. What ends the connection is returned once, as text for a person.
  std::optional<std::string> read(double now_s);
  // What was recorded of a connection that was lost, once.
  std::optional<base::ByteVector> take_lost_recording() {
    return std::exchange(lost_recording_, std::nullopt);
  }
  // The moment to show, on the server's clock: with the last update or between the last two.
  double time_s() const { return time_s_; }
  // How many moves should be sent now: one before each tick of the own server, or of one that numbers them;
  // 72 times a second to others.
  int moves_due(double now_s);
  void send_move(net::Move move, double now_s);
  // That moves are counted by: of the own server, which may stand still.
  double move_clock_s(double now_s) const;
  // Lets the server here go on to this time; nothing where there is none. While `halted` its time stands
  // still, but it still listens. May run on another thread while nothing else is called.
  void step_server(double now_s, bool halted);
  // What the server had to say since the last time, lines and parts of lines.
  std::string take_server_output() { return std::exchange(server_output_, {}); }

 private:
  void follow_clock(double now_s);
  server::ServerSetup setup_for(net::ServerEndpoint::Sockets sockets, std::uint32_t max_clients);

  Services& services_;
  const assets::Library& library_;
  std::filesystem::path write_folder_;
  const server::ServerVariables& settings_;
  std::filesystem::path program_file_;
  std::optional<net::LoopbackNetwork> network_;
  std::unique_ptr<server::Server> server_;
  std::uint32_t max_clients_ = 0;
  std::string server_output_;
  std::optional<client::Connection> connection_;
  std::optional<base::ByteVector> lost_recording_;
  double now_s_ = 0, time_s_ = 0, moved_s_ = 0;
  double server_now_s_ = 0;  // its own clock, which stands still while it is halted
  double stepped_s_ = 0;     // when it last went on
};

}  // namespace temblor::host
