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
#include "client/client_state.h"
#include "net/client_endpoint.h"
#include "net/client_message.h"
#include "net/demo_recording.h"
#include "net/message_reader.h"

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
  base::Status read(base::Bytes packet);
  void record(base::Bytes packet, bool begins_level);
  void answer_signon();
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
  std::uint64_t updates_ = 0;
  std::optional<net::DemoRecording> recording_;
  math::Vec3 view_angles_deg_{0.0f};  // as last said by the server or sent to it
};

}  // namespace temblor::client
