// Everything in reliable messages of the engine's channel, one in flight in each direction.
#include <variant>

#include "lab/wire/methods.h"
#include "lab/wire/snapshot_stream.h"
#include "net/transport/channel.h"

namespace temblor::lab::wire {
namespace {

net::ChannelSettings make_reliable_settings(const World& world) {
  return {.sent = net::message_limits_for(world.dialect.protocol, net::PeerPlace::kNetwork)};
}

class ReliableServer : public Node {
 public:
  explicit ReliableServer(const Parts& parts)
      : parts_(parts), channel_(make_reliable_settings(parts.world)) {}

  void step(std::size_t number, double now_s, Send send) override {
    const auto to_client = [&](base::Bytes packet) { send(kViewer, packet); };
    channel_.update(now_s, to_client);
    if (number >= parts_.world.ticks.size()) return;
    if (has_input_) parts_.record.play(number, input_);
    if (!channel_.can_send_reliable()) return;
    const base::Status queued =
        channel_.send_reliable(stream_.encode(parts_.world.ticks[number]), now_s, to_client);
    if (!queued.ok()) return;
    stream_.mark_sent();
    stream_.rely_on_last();
  }

  void receive(std::size_t, base::Bytes packet, double now_s, Send send) override {
    const auto message = channel_.receive(packet, now_s, [&](base::Bytes answer) { send(kViewer, answer); });
    if (!message.ok()) return parts_.record.count_unreadable();
    if (!*message) return;
    net::ClientMessageReader reader((*message)->bytes, parts_.world.dialect.protocol);
    const auto move = reader.next();
    if (!move.ok() || !*move || !std::holds_alternative<net::Move>(**move))
      return parts_.record.count_unreadable();
    input_ = find_input(std::get<net::Move>(**move));
    has_input_ = true;
  }

 private:
  Parts parts_;
  net::Channel channel_;
  SnapshotStream stream_;
  std::size_t input_ = 0;
  bool has_input_ = false;
};

class ReliableClient : public Node {
 public:
  explicit ReliableClient(const Parts& parts)
      : parts_(parts), channel_(make_reliable_settings(parts.world)) {}

  void step(std::size_t number, double now_s, Send send) override {
    const auto to_server = [&](base::Bytes packet) { send(kServer, packet); };
    channel_.update(now_s, to_server);
    if (!channel_.can_send_reliable()) return;
    base::ByteWriter writer;
    const base::Status written =
        write_client_message(make_move(number, time_s_), parts_.world.dialect.protocol, writer);
    if (!written.ok() || !channel_.send_reliable(writer.view(), now_s, to_server).ok())
      parts_.record.count_unreadable();
  }

  void receive(std::size_t, base::Bytes packet, double now_s, Send send) override {
    const auto message = channel_.receive(packet, now_s, [&](base::Bytes answer) { send(kServer, answer); });
    if (!message.ok()) return parts_.record.count_unreadable();
    if (!*message) return;
    const auto state = received_.read((*message)->bytes, parts_.world.dialect);
    if (!state.ok() || !*state) return parts_.record.count_unreadable();
    parts_.record.show(**state, now_s);
    time_s_ = static_cast<float>(now_s);
  }

 private:
  Parts parts_;
  net::Channel channel_;
  net::ReceivedSnapshots received_;
  float time_s_ = 0;
};

}  // namespace

Nodes make_reliable_nodes(const Parts& parts) {
  return make_server_and_client<ReliableServer, ReliableClient>(parts);
}

}  // namespace temblor::lab::wire
