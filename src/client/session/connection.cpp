#include "client/session/connection.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::client {
namespace {

constexpr int kMovesLeftOut = 2;
constexpr double kMaxHitch_s = 0.25;
constexpr double kAlmostATick = 1e-6;
constexpr std::size_t kMaxCommandsKept = 1000;
constexpr std::size_t kMaxReasonChars = 200;
constexpr std::size_t kMaxSentBytes = 4000;  // and the line that is begun: within what any server takes

}  // namespace

void Connection::connect(const platform::Address& server, double now_s) {
  state_ = ClientState{};
  reader_ = net::MessageReader{};
  to_send_.clear();
  lost_because_.clear();
  answered_signon_ = 0;
  view_angles_deg_ = math::Vec3{0.0f};
  move_parameters_.reset();
  acknowledged_.reset();
  accepts_deltas_ = false;
  received_snapshots_.forget();
  sent_moves_.begin_level();
  endpoint_.connect(server, now_s);
}

void Connection::disconnect() {
  if (is_connected()) lost_because_ = "disconnected";
  endpoint_.disconnect();
}

void Connection::update(double now_s) {
  endpoint_.update(now_s);
  while (std::optional<net::ClientEvent> event = endpoint_.next_event(now_s)) {
    if (const auto* packet = std::get_if<net::FromServer>(&*event)) {
      if (const base::Status status = read_from(*packet); !status.ok()) {
        lost_because_ = status.error().message();
        endpoint_.disconnect();
        return;
      }
      if (!is_connected()) return;
    } else if (const auto* lost = std::get_if<net::ConnectionLost>(&*event)) {
      lost_because_ = lost->reason;
    }
  }
  send_waiting();
}

// Updates that are told as differences become stock messages here: nothing behind knows of them.
base::Status Connection::read_from(const net::FromServer& message) {
  const bool is_delta = accepts_deltas_ && !message.reliable && net::is_delta_packet(message.bytes);
  if (!is_delta) return read(message.bytes);
  // Of the level before, late.
  if (state_.game().signon < kPlaying - 1) return base::Ok{};
  TRY(const std::optional<base::Bytes> stock, received_snapshots_.read(message.bytes, reader_.dialect()));
  return stock ? read(*stock) : base::Status(base::Ok{});
}

base::Status Connection::read(base::Bytes packet) {
  reader_.begin(packet);
  bool has_time = false, has_level = false;
  std::string said_last;  // before a farewell: why
  while (true) {
    TRY(const std::optional<net::ServerMessage> message, reader_.next());
    if (!message) break;
    if (std::holds_alternative<net::Disconnect>(*message)) {
      lost_because_ = "the server has ended the connection";
      if (!said_last.empty())
        lost_because_ += fmt::format(": {}", base::quotable(said_last, kMaxReasonChars));
      endpoint_.disconnect();
      record(packet, has_level);
      return base::Ok{};
    }
    if (const auto* print = std::get_if<net::Print>(&*message))
      said_last = print->text.substr(0, print->text.find('\n'));
    if (const auto* info = std::get_if<net::ServerInfo>(&*message)) {
      endpoint_.set_protocol(info->dialect.protocol);
      answered_signon_ = 0;
      moves_left_out_ = 0;
      move_parameters_.reset();
      acknowledged_.reset();
      received_snapshots_.forget();
      sent_moves_.begin_level();
      has_level = true;
    }
    if (const auto* turn = std::get_if<net::SetAngle>(&*message)) view_angles_deg_ = turn->angles_deg;
    const auto* stuffed = std::get_if<net::StuffText>(&*message);
    if (stuffed) take_comment(stuffed->text);
    has_time |= std::holds_alternative<net::Time>(*message);
    TRY_STATUS(state_.apply(*message));
    if (std::holds_alternative<net::SignonNumber>(*message)) answer_signon();
  }
  state_.end_packet();
  if (has_time) ++updates_;
  record(packet, has_level);
  run_stuffed_commands();
  return base::Ok{};
}

void Connection::record(base::Bytes packet, bool begins_level) {
  if (recording_ && (begins_level || !recording_->is_empty())) recording_->add(view_angles_deg_, packet);
}

std::optional<base::ByteVector> Connection::finish_recording() {
  std::optional<net::DemoRecording> recording = std::exchange(recording_, std::nullopt);
  if (!recording || recording->is_empty()) return std::nullopt;
  return std::move(*recording).finish();
}

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

// What servers of ours say to clients of ours.
// The line itself is text of the server like any other: the state passes over comments.
void Connection::take_comment(std::string_view text) {
  if (const auto terms = net::read_move_parameters(text)) {
    move_parameters_ = terms;
  } else if (const auto told = net::read_acknowledgement(text)) {
    acknowledged_ = told;
    ++acknowledgements_;
  } else if (net::is_delta_offer(text)) {
    accepts_deltas_ = true;
  }
}

void Connection::run_stuffed_commands() {
  for (std::string& line : state_.events().commands) {
    // What follows "reconnect" is another level, which comes by itself.
    if (line.starts_with("reconnect")) continue;
    if (line.starts_with("cmd "))
      send_command(line.substr(4));
    else if (commands_.size() < kMaxCommandsKept)
      commands_.push_back(std::move(line));
  }
  state_.events().commands.clear();
}

void Connection::send_command(std::string_view line) {
  // A server that asks for more than it listens to is not answered.
  if (to_send_.size() < kMaxCommandsKept) to_send_.emplace_back(line);
}

void Connection::send_waiting() {
  if (to_send_.empty() || !endpoint_.can_send_reliable()) return;
  base::ByteWriter writer;
  std::size_t taken = 0;
  for (; taken < to_send_.size() && writer.size() < kMaxSentBytes; ++taken) {
    const std::string& line = to_send_[taken];
    // A line that is too long to be said is not said.
    const base::Status written =
        net::write_client_message(net::StringCommand{line}, reader_.dialect().protocol, writer);
    if (!written.ok()) continue;
  }
  to_send_.erase(to_send_.begin(), to_send_.begin() + static_cast<std::ptrdiff_t>(taken));
  if (writer.size() == 0) return;
  if (const base::Status sent = endpoint_.send_reliable(std::move(writer).take()); !sent.ok()) {
    lost_because_ = sent.error().message();
    endpoint_.disconnect();
  }
}

int Connection::moves_due(double now_s) {
  if (!move_parameters_) return 1;
  const double tick_s = move_parameters_->tick_s;
  const double waited_s = last_move_due_s_ ? now_s - *last_move_due_s_ : kMaxHitch_s;
  if (!(waited_s >= 0 && waited_s < kMaxHitch_s)) {
    last_move_due_s_ = now_s - tick_s;
    return 1;
  }
  // Clocks that go in whole ticks are not to miss one for a rounding.
  return static_cast<int>(waited_s / tick_s + kAlmostATick);
}

double Connection::since_last_move_s(double now_s) const {
  if (!move_parameters_ || !last_move_due_s_) return 0;
  return std::clamp(now_s - *last_move_due_s_, 0.0, move_parameters_->tick_s);
}

void Connection::send_move(net::Move move) {
  if (!is_playing()) return;
  if (moves_left_out_ < kMovesLeftOut) {
    ++moves_left_out_;
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
  // One that does not get through is made good by the next.
  if (!endpoint_.send_unreliable(std::move(writer).take()).ok()) return;
}

}  // namespace temblor::client
