// A client's connection to a server: connects, answers the signon, keeps the ClientState up to date, and
// sends what the player does. No window, files or clock.
//
//   signon     server                      client
//              serverinfo, signon 1  -->
//                                    <--   prespawn
//              baselines, signon 2   -->
//                                    <--   name, color, spawn
//              clientdata, signon 3  -->
//                                    <--   begin
//              first entities        -->   playing
//
// Once a frame: update() reads packets and answers them; count_due_moves() says how many moves to send with
// send_move(). Servers that take numbered moves (net/protocol/numbered_moves.h) get one move per server tick;
// others get one per frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "client/prediction/sent_moves.h"
#include "client/session/client_state.h"
#include "net/delta/sent_snapshots.h"
#include "net/protocol/client_message.h"
#include "net/protocol/demo_writer.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/numbered_moves.h"
#include "net/transport/client_endpoint.h"

namespace temblor::client {

// The player's name and colors (palette rows), sent to the server during the signon.
struct PlayerSettings {
  std::string name = "player";
  std::uint8_t shirt = 0, pants = 0;
};

class Connection {
 public:
  Connection(std::unique_ptr<platform::DatagramSocket> socket, PlayerSettings settings)
      : endpoint_(std::move(socket)), settings_(std::move(settings)) {}

  // Starts to connect; update() continues. disconnect() ends the connection at once, and it notifies the
  // server.
  void connect(const platform::Address& server, double now_s);
  void disconnect();

  // Reads and answers all packets that have arrived. Call once a frame. An error in a packet ends the
  // connection.
  void update(double now_s);
  // How many moves to send now; call once a frame. A server that takes numbered moves gets one for each tick
  // that has passed (a hitch of more than a quarter of a second is skipped), any other server one.
  int count_due_moves(double now_s);
  // Declares that a move was due at that time, to align moves with the ticks of a local server.
  void align_moves(double due_s) { last_move_due_s_ = due_s; }
  // Sends a move, unreliably, and only while playing. Fills in its time. Skips the first two moves of a
  // level, as stock clients do: the view is not known yet.
  void send_move(net::Move move);
  // Sends a console line for the server to run, reliably.
  void send_command(std::string_view line);

  bool is_connecting() const { return endpoint_.state() == net::ClientEndpoint::State::kConnecting; }
  bool is_connected() const { return endpoint_.state() == net::ClientEndpoint::State::kConnected; }
  bool is_playing() const { return is_connected() && state_.game().signon == kPlaying; }
  // Why the connection ended; empty while connected or before the first connection.
  const std::string& disconnect_reason() const { return disconnect_reason_; }

  ClientState& state() { return state_; }
  const ClientState& state() const { return state_; }
  // How the server simulates numbered moves; nothing if it does not take them.
  const std::optional<net::MoveParameters>& move_parameters() const { return move_parameters_; }
  // The result of the moves as of the last packet; nothing before the first one.
  const std::optional<net::MoveAcknowledgment>& acknowledged() const { return acknowledged_; }
  // How many acknowledgments have arrived, over all levels.
  std::uint64_t acknowledgments() const { return acknowledgments_; }
  std::span<const NumberedMove> sent_moves() const { return sent_moves_.moves(); }
  // Server time since the last numbered move, at most a tick; 0 if the server does not take them.
  double since_last_move_s(double now_s) const;
  // How many packets with a server time have been read.
  std::uint64_t updates() const { return updates_; }
  // Records a demo from the start of the next level on, as a demo holds levels from their start. Continues
  // through level changes until finish_recording().
  void start_recording() { recording_.emplace(); }
  bool is_recording() const { return recording_.has_value(); }
  // A recording has been started, and no level has begun since.
  bool waits_to_record() const { return recording_ && recording_->is_empty(); }
  // The demo's bytes (.dem); nothing if no recording was started or no level has begun since.
  std::optional<base::ByteVector> finish_recording();

  // Returns the console lines that the server wants to be run here, except those that concern the connection
  // itself.
  std::vector<std::string> take_commands() { return std::exchange(commands_, {}); }
  const net::Channel& channel() const { return endpoint_.channel(); }
  std::optional<net::ServerSilence> server_silence() const { return endpoint_.silence(); }

 private:
  base::Status handle_transport_event(const net::FromServer& message);
  base::Status read(base::Bytes packet);
  void record(base::Bytes packet, bool begins_level);
  void answer_signon();
  void handle_comment(std::string_view text);
  void run_stuffed_commands();
  void send_waiting();

  net::ClientEndpoint endpoint_;
  PlayerSettings settings_;
  net::MessageReader reader_;
  ClientState state_;
  // Reliable console lines that wait to be sent, in order.
  std::vector<std::string> to_send_;
  std::vector<std::string> commands_;
  std::string disconnect_reason_;
  int answered_signon_ = 0;
  int skipped_moves_ = 0;
  std::optional<net::MoveParameters> move_parameters_;
  std::optional<net::MoveAcknowledgment> acknowledged_;
  std::uint64_t acknowledgments_ = 0;
  bool accepts_deltas_ = false;  // the server has offered delta compression
  net::ReceivedSnapshots received_snapshots_;
  SentMoves sent_moves_;
  // When the last numbered move was due.
  std::optional<double> last_move_due_s_;
  std::uint64_t updates_ = 0;
  std::optional<net::DemoWriter> recording_;
  math::Vec3 view_angles_deg_{0.0f};  // the latest angles, set by the server or sent to it
};

}  // namespace temblor::client
