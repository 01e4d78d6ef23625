#include "client/session/connection.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::client {
namespace {

// Moves at the start of a level that are not sent, as in stock clients.
constexpr int kSkippedMoves = 2;
// After a longer pause no moves are made up: the player stands still instead of replaying its keys.
constexpr double kMaxHitch_s = 0.25;
constexpr double kTickTolerance = 1e-6;
constexpr std::size_t kMaxQueuedCommands = 1000;
constexpr std::size_t kMaxReasonChars = 200;
// Reliable bytes per batch, which any server accepts.
constexpr std::size_t kMaxSentBytes = 4000;

}  // namespace

// Resets what belongs to an earlier connection. Counters, a recording, and console lines that nobody has
// taken yet stay.
void Connection::connect(const platform::Address& server, double now_s) {
  state_ = ClientState{};
  reader_ = net::MessageReader{};
  to_send_.clear();
  disconnect_reason_.clear();
  answered_signon_ = 0;
  view_angles_deg_ = math::Vec3{0.0f};
  move_parameters_.reset();
  acknowledged_.reset();
  accepts_deltas_ = false;
  received_snapshots_.reset();
  sent_moves_.begin_level();
  endpoint_.connect(server, now_s);
}

void Connection::disconnect() {
  if (is_connected()) disconnect_reason_ = "disconnected";
  endpoint_.disconnect();
}

void Connection::update(double now_s) {
  endpoint_.update(now_s);
  while (std::optional<net::ClientEvent> event = endpoint_.next_event(now_s)) {
    if (const auto* packet = std::get_if<net::FromServer>(&*event)) {
      if (const base::Status status = handle_transport_event(*packet); !status.ok()) {
        disconnect_reason_ = status.error().message();
        endpoint_.disconnect();
        return;
      }
      if (!is_connected()) return;
    } else if (const auto* lost = std::get_if<net::ConnectionLost>(&*event)) {
      disconnect_reason_ = lost->reason;
    }
  }
  send_waiting();
}

// Converts delta packets to stock messages, so nothing downstream needs to know about them.
base::Status Connection::handle_transport_event(const net::FromServer& message) {
  const bool is_delta = accepts_deltas_ && !message.reliable && net::is_delta_packet(message.bytes);
  if (!is_delta) return read(message.bytes);
  // Before the signon is complete, a delta can only be a late packet of the last level.
  if (state_.game().signon < kPlaying - 1) return base::Ok{};
  TRY(const std::optional<base::Bytes> stock, received_snapshots_.read(message.bytes, reader_.dialect()));
  return stock ? read(*stock) : base::Status(base::Ok{});
}

// Reads one packet, message by message. Some messages concern the connection as well as the state: a new
// level, view angles, comments of Temblor servers, and the stages of the signon.
base::Status Connection::read(base::Bytes packet) {
  reader_.begin(packet);
  bool has_time = false, has_level = false, is_whole = true;
  std::string last_text;  // the last text before a disconnect is the reason for it
  while (true) {
    base::Result<std::optional<net::ServerMessage>> next = reader_.next();
    if (!next.ok() && reader_.is_at_unknown()) {
      TRY_STATUS(state_.pass_over_unknown(next.error()));
      is_whole = false;
      break;
    }
    TRY(const std::optional<net::ServerMessage> message, std::move(next));
    if (!message) break;
    if (std::holds_alternative<net::Disconnect>(*message)) {
      disconnect_reason_ = last_text.empty() ? "The server closed the connection."
                                             : std::string(base::quotable(last_text, kMaxReasonChars));
      endpoint_.disconnect();
      record(packet, has_level);
      return base::Ok{};
    }
    if (const auto* print = std::get_if<net::Print>(&*message))
      last_text = print->text.substr(0, print->text.find('\n'));
    if (const auto* info = std::get_if<net::ServerInfo>(&*message)) {
      endpoint_.set_protocol(info->dialect.protocol);
      answered_signon_ = 0;
      skipped_moves_ = 0;
      move_parameters_.reset();
      acknowledged_.reset();
      received_snapshots_.reset();
      sent_moves_.begin_level();
      has_level = true;
    }
    if (const auto* turn = std::get_if<net::SetAngle>(&*message)) view_angles_deg_ = turn->angles_deg;
    const auto* stuffed = std::get_if<net::StuffText>(&*message);
    if (stuffed) handle_comment(stuffed->text);
    has_time |= std::holds_alternative<net::Time>(*message);
    TRY_STATUS(state_.apply(*message));
    if (std::holds_alternative<net::SignonNumber>(*message)) answer_signon();
  }
  if (is_whole) state_.end_packet();
  if (has_time) ++updates_;
  record(packet, has_level);
  run_stuffed_commands();
  return base::Ok{};
}

// A demo must begin with a level's serverinfo, so packets before it are skipped.
void Connection::record(base::Bytes packet, bool begins_level) {
  if (recording_ && (begins_level || !recording_->is_empty())) recording_->add(view_angles_deg_, packet);
}

std::optional<base::ByteVector> Connection::finish_recording() {
  std::optional<net::DemoWriter> recording = std::exchange(recording_, std::nullopt);
  if (!recording || recording->is_empty()) return std::nullopt;
  return std::move(*recording).finish();
}

// Replies to each stage of the signon once, as stock clients do. The reply to the last stage starts the game.
void Connection::answer_signon() {
  const int stage = state_.game().signon;
  if (stage <= answered_signon_) return;
  answered_signon_ = stage;
  if (stage == 1) {
    send_command("prespawn");
  } else if (stage == 2) {
    send_command(fmt::format("name \"{}\"\n", settings_.name));
    send_command(fmt::format("color {} {}\n", settings_.shirt, settings_.pants));
    send_command("spawn ");
  } else if (stage == 3) {
    send_command("begin");
  }
}

// Handles comments ("//..." lines of svc_stufftext) with which Temblor servers talk to Temblor clients. The
// line reaches the state too, which ignores comments.
void Connection::handle_comment(std::string_view text) {
  if (const auto parameters = net::read_move_parameters(text)) {
    move_parameters_ = parameters;
  } else if (const auto acknowledgment = net::read_acknowledgment(text)) {
    acknowledged_ = acknowledgment;
    ++acknowledgments_;
  } else if (net::is_delta_offer(text)) {
    accepts_deltas_ = true;
  }
}

// Runs lines about the connection and keeps the others for the owner. "cmd LINE" asks the client to send LINE
// back.
void Connection::run_stuffed_commands() {
  for (std::string& line : state_.events().commands) {
    // After "reconnect" the server sends the next level without being asked.
    if (line.starts_with("reconnect")) continue;
    if (line.starts_with("cmd "))
      send_command(line.substr(4));
    else if (commands_.size() < kMaxQueuedCommands)
      commands_.push_back(std::move(line));
  }
  state_.events().commands.clear();
}

void Connection::send_command(std::string_view line) {
  // A server that requests commands but reads none could fill the memory; it gets no more replies.
  if (to_send_.size() < kMaxQueuedCommands) to_send_.emplace_back(line);
}

// Sends as many lines as fit into one reliable message, once the last one was acknowledged.
void Connection::send_waiting() {
  if (to_send_.empty() || !endpoint_.can_send_reliable()) return;
  base::ByteWriter writer;
  std::size_t taken = 0;
  for (; taken < to_send_.size() && writer.size() < kMaxSentBytes; ++taken) {
    const std::string& line = to_send_[taken];
    // Lines that are too long for the protocol are dropped.
    const base::Status written =
        net::write_client_message(net::StringCommand{line}, reader_.dialect().protocol, writer);
    if (!written.ok()) continue;
  }
  to_send_.erase(to_send_.begin(), to_send_.begin() + static_cast<std::ptrdiff_t>(taken));
  if (writer.size() == 0) return;
  if (const base::Status sent = endpoint_.send_reliable(std::move(writer).take()); !sent.ok()) {
    disconnect_reason_ = sent.error().message();
    endpoint_.disconnect();
  }
}

// Numbered moves follow the server's tick, others the frame rate. After a hitch, or for the first move, the
// schedule starts over at `now_s`.
int Connection::count_due_moves(double now_s) {
  if (!move_parameters_) return 1;
  const double tick_s = move_parameters_->tick_s;
  const double elapsed_s = last_move_due_s_ ? now_s - *last_move_due_s_ : kMaxHitch_s;
  if (!(elapsed_s >= 0 && elapsed_s < kMaxHitch_s)) {
    last_move_due_s_ = now_s - tick_s;
    return 1;
  }
  // A small tolerance, so that rounding does not skip a tick of a clock in whole ticks.
  return static_cast<int>(elapsed_s / tick_s + kTickTolerance);
}

double Connection::since_last_move_s(double now_s) const {
  if (!move_parameters_ || !last_move_due_s_) return 0;
  return std::clamp(now_s - *last_move_due_s_, 0.0, move_parameters_->tick_s);
}

void Connection::send_move(net::Move move) {
  if (!is_playing()) return;
  if (skipped_moves_ < kSkippedMoves) {
    ++skipped_moves_;
    if (move_parameters_ && last_move_due_s_) *last_move_due_s_ += move_parameters_->tick_s;
    return;
  }
  view_angles_deg_ = move.angles_deg;
  move.time_s = static_cast<float>(state_.time_s());
  const net::Protocol protocol = reader_.dialect().protocol;
  base::ByteWriter writer;
  if (move_parameters_) {
    if (last_move_due_s_) *last_move_due_s_ += move_parameters_->tick_s;
    if (!sent_moves_.add(move, protocol)) return;
    sent_moves_.write_packet(
        {.accepts_deltas = accepts_deltas_, .received_snapshot = received_snapshots_.latest()}, protocol,
        writer);
  } else if (!net::write_client_message(move, protocol, writer).ok()) {
    return;
  }
  // A lost move needs no resend: the next one supersedes it.
  if (!endpoint_.send_unreliable(std::move(writer).take()).ok()) return;
}

}  // namespace temblor::client
