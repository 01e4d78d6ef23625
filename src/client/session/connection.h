// A client's way into a game on a server: connects, answers while it joins, keeps the state up to date, and
// says what the player does. Without window, files or clock.
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

struct PlayerSettings {
  std::string name = "player";
  std::uint8_t shirt = 0, pants = 0;
};

class Connection {
 public:
  Connection(std::unique_ptr<platform::DatagramSocket> socket, PlayerSettings settings)
      : endpoint_(std::move(socket)), settings_(std::move(settings)) {}

  void connect(const platform::Address& server, double now_s);
  void disconnect();

  // Reads all that has come, and answers it; once a frame. Each packet that was read goes to the state whole.
  void update(double now_s);
  // How many moves are to be sent now, once a frame: one of each tick that has passed to a server that takes
  // them numbered (what a hitch of more than a quarter of a second leaves out is forgotten), else one.
  int moves_due(double now_s);
  // One was due then: to send them with the ticks of a server that is here.
  void align_moves(double due_s) { last_move_due_s_ = due_s; }
  // Unreliable, and only once playing: what the player does now. The time is filled in. The first two of a
  // level are left out, as stock clients do: the view is not known yet.
  void send_move(net::Move move);
  // A line for the server's eyes.
  void send_command(std::string_view line);

  bool is_connecting() const { return endpoint_.state() == net::ClientEndpoint::State::kConnecting; }
  bool is_connected() const { return endpoint_.state() == net::ClientEndpoint::State::kConnected; }
  bool is_playing() const { return is_connected() && state_.game().signon == kPlaying; }
  // Why there is no connection any more; empty while there is, or before.
  const std::string& lost_because() const { return lost_because_; }

  ClientState& state() { return state_; }
  const ClientState& state() const { return state_; }
  // How the server plays moves that are numbered; nothing: it does not take them.
  const std::optional<net::MoveParameters>& move_parameters() const { return move_parameters_; }
  // What came of them, as the last update said; nothing before it has.
  const std::optional<net::MoveAcknowledgement>& acknowledged() const { return acknowledged_; }
  // Counts those of all levels.
  std::uint64_t acknowledgements() const { return acknowledgements_; }
  std::span<const NumberedMove> sent_moves() const { return sent_moves_.moves(); }
  // Of the server's clock, since the last numbered move; at most a tick.
  double since_last_move_s(double now_s) const;
  // Packets with the game's time that were read: updates.
  std::uint64_t updates() const { return updates_; }
  // Records what comes from the next level on that the server tells of: a recording holds levels from their
  // beginning. Goes on through changes of level, until it is taken.
  void start_recording() { recording_.emplace(); }
  bool is_recording() const { return recording_.has_value(); }
  // The recording's bytes (.dem); nothing where no level has begun since, or none was started.
  std::optional<base::ByteVector> finish_recording();

  // Lines that the server wants run here and that are not about the connection itself.
  std::vector<std::string> take_commands() { return std::exchange(commands_, {}); }
  const net::Channel& channel() const { return endpoint_.channel(); }

 private:
  base::Status read_from(const net::FromServer& message);
  base::Status read(base::Bytes packet);
  void record(base::Bytes packet, bool begins_level);
  void answer_signon();
  void take_comment(std::string_view text);
  void run_stuffed_commands();
  void send_waiting();

  net::ClientEndpoint endpoint_;
  PlayerSettings settings_;
  net::MessageReader reader_;
  ClientState state_;
  std::vector<std::string> to_send_;  // lines, in order
  std::vector<std::string> commands_;
  std::string lost_because_;
  int answered_signon_ = 0;
  int moves_left_out_ = 0;
  std::optional<net::MoveParameters> move_parameters_;
  std::optional<net::MoveAcknowledgement> acknowledged_;
  std::uint64_t acknowledgements_ = 0;
  bool accepts_deltas_ = false;  // the server has offered them
  net::ReceivedSnapshots received_snapshots_;
  SentMoves sent_moves_;
  std::optional<double> last_move_due_s_;  // when the last numbered one was
  std::uint64_t updates_ = 0;
  std::optional<net::DemoRecording> recording_;
  math::Vec3 view_angles_deg_{0.0f};  // as last said by the server or sent to it
};

}  // namespace temblor::client
