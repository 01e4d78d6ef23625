// Both methods that send each tick once: whole states (stock), and deltas from acknowledged states (the
// engine's own clients).
#include <algorithm>
#include <string>
#include <variant>

#include "lab/wire/methods.h"
#include "lab/wire/snapshot_stream.h"
#include "net/protocol/numbered_moves.h"
#include "net/transport/channel.h"

namespace temblor::lab::wire {
namespace {

net::ChannelSettings make_unreliable_settings(const World& world) {
  return {.sent = net::message_limits_for(world.dialect.protocol, net::PeerPlace::kNetwork)};
}

class UnreliableServer : public Node {
 public:
  explicit UnreliableServer(const Parts& parts)
      : parts_(parts), channel_(make_unreliable_settings(parts.world)) {}

  void step(std::size_t number, double, Send send) override {
    if (number >= parts_.world.ticks.size()) return;
    if (has_input_) parts_.record.play(number, input_);
    const base::Status sent = channel_.send_unreliable(encode(parts_.world.ticks[number]),
                                                       [&](base::Bytes packet) { send(kViewer, packet); });
    if (!sent.ok()) parts_.record.count_unreadable();
  }

  void receive(std::size_t, base::Bytes packet, double now_s, Send) override {
    const auto message = channel_.receive(packet, now_s, [](base::Bytes) {});
    if (!message.ok()) return parts_.record.count_unreadable();
    if (!*message) return;
    net::ClientMessageReader reader((*message)->bytes, parts_.world.dialect.protocol);
    auto next = reader.next();
    for (; next.ok() && *next; next = reader.next()) {
      if (const auto* move = std::get_if<net::Move>(&**next)) {
        input_ = find_input(*move);
        has_input_ = true;
      } else if (const auto* command = std::get_if<net::StringCommand>(&**next)) {
        const auto head = net::read_numbered_packet(command->text);
        if (head && head->received_snapshot) stream_.acknowledge(*head->received_snapshot);
      }
    }
    if (!next.ok()) parts_.record.count_unreadable();
  }

 private:
  // A delta if that is shorter, as in server/session/send_snapshots.cpp. The first one may be longer, because
  // recorded states lack the acknowledgment of moves, which is long as text.
  base::Bytes encode(const WorldTick& tick) {
    if (parts_.setup.method == Method::kWholeState) return tick.messages;
    const base::Bytes delta = stream_.encode(tick);
    if (delta.size() >= tick.messages.size() && stream_.has_reference()) return tick.messages;
    stream_.mark_sent();
    return delta;
  }

  Parts parts_;
  net::Channel channel_;
  SnapshotStream stream_;
  std::size_t input_ = 0;
  bool has_input_ = false;
};

class UnreliableClient : public Node {
 public:
  explicit UnreliableClient(const Parts& parts)
      : parts_(parts), channel_(make_unreliable_settings(parts.world)) {}

  void step(std::size_t number, double, Send send) override {
    base::ByteWriter writer;
    const base::Status written = write_moves(number, writer);
    const base::Status sent =
        channel_.send_unreliable(writer.view(), [&](base::Bytes packet) { send(kServer, packet); });
    if (!written.ok() || !sent.ok()) parts_.record.count_unreadable();
  }

  void receive(std::size_t, base::Bytes packet, double now_s, Send) override {
    const auto message = channel_.receive(packet, now_s, [](base::Bytes) {});
    if (!message.ok()) return parts_.record.count_unreadable();
    if (!*message) return;
    time_s_ = static_cast<float>(now_s);
    const base::Bytes bytes = (*message)->bytes;
    if (!net::is_delta_packet(bytes)) return parts_.record.show(bytes, now_s);
    const auto state = received_.read(bytes, parts_.world.dialect);
    if (!state.ok() || !*state) return parts_.record.count_unreadable();
    parts_.record.show(**state, now_s);
  }

 private:
  // The newest move; with deltas, also an acknowledgment and the moves before it.
  base::Status write_moves(std::size_t number, base::ByteWriter& io_writer) {
    const net::Protocol protocol = parts_.world.dialect.protocol;
    std::size_t count = 1;
    if (parts_.setup.method == Method::kDeltas) {
      const std::string head = net::format_numbered_packet({.last_move = static_cast<std::uint32_t>(number),
                                                            .accepts_deltas = true,
                                                            .received_snapshot = received_.latest()});
      TRY_STATUS(write_client_message(net::StringCommand{head}, protocol, io_writer));
      count = std::min(net::kMovesInPacket, number + 1);
    }
    for (std::size_t move = number + 1 - count; move <= number; ++move)
      TRY_STATUS(write_client_message(make_move(move, time_s_), protocol, io_writer));
    return base::Ok{};
  }

  Parts parts_;
  net::Channel channel_;
  net::ReceivedSnapshots received_;
  float time_s_ = 0;
};

}  // namespace

Nodes make_whole_state_nodes(const Parts& parts) {
  return make_server_and_client<UnreliableServer, UnreliableClient>(parts);
}

Nodes make_delta_nodes(const Parts& parts) {
  return make_server_and_client<UnreliableServer, UnreliableClient>(parts);
}

}  // namespace temblor::lab::wire
