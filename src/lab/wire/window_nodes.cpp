// Everything in reliable messages, one per tick, with as many in flight as the round trip is long.
#include <variant>

#include "lab/wire/methods.h"
#include "lab/wire/snapshot_stream.h"
#include "lab/wire/window.h"

namespace temblor::lab::wire {
namespace {

class WindowServer : public Node {
 public:
  explicit WindowServer(const Parts& parts) : parts_(parts) {}

  void step(std::size_t number, double now_s, Send send) override {
    const auto to_client = [&](base::Bytes packet) { send(kViewer, packet); };
    window_.resend(now_s, to_client);
    if (number >= parts_.world.ticks.size()) return window_.acknowledge(to_client);
    if (has_input_) parts_.record.play(number, input_);
    window_.send(stream_.encode(parts_.world.ticks[number]), now_s, to_client);
    stream_.mark_sent();
    stream_.rely_on_last();
  }

  void receive(std::size_t, base::Bytes packet, double now_s, Send send) override {
    const auto play = [&](base::Bytes message) {
      net::ClientMessageReader reader(message, parts_.world.dialect.protocol);
      const auto move = reader.next();
      if (!move.ok() || !*move || !std::holds_alternative<net::Move>(**move))
        return parts_.record.count_unreadable();
      input_ = find_input(std::get<net::Move>(**move));
      has_input_ = true;
    };
    if (!window_.receive(packet, now_s, play).ok()) parts_.record.count_unreadable();
    window_.resend(now_s, [&](base::Bytes resent) { send(kViewer, resent); });
  }

 private:
  Parts parts_;
  Window window_;
  SnapshotStream stream_;
  std::size_t input_ = 0;
  bool has_input_ = false;
};

class WindowClient : public Node {
 public:
  explicit WindowClient(const Parts& parts) : parts_(parts) {}

  void step(std::size_t number, double now_s, Send send) override {
    const auto to_server = [&](base::Bytes packet) { send(kServer, packet); };
    window_.resend(now_s, to_server);
    if (number >= parts_.world.ticks.size()) return window_.acknowledge(to_server);
    base::ByteWriter writer;
    if (!write_client_message(make_move(number, time_s_), parts_.world.dialect.protocol, writer).ok())
      return parts_.record.count_unreadable();
    window_.send(writer.view(), now_s, to_server);
  }

  void receive(std::size_t, base::Bytes packet, double now_s, Send send) override {
    const auto show = [&](base::Bytes message) {
      const auto state = received_.read(message, parts_.world.dialect);
      if (!state.ok() || !*state) return parts_.record.count_unreadable();
      parts_.record.show(**state, now_s);
      time_s_ = static_cast<float>(now_s);
    };
    if (!window_.receive(packet, now_s, show).ok()) parts_.record.count_unreadable();
    window_.resend(now_s, [&](base::Bytes resent) { send(kServer, resent); });
  }

 private:
  Parts parts_;
  Window window_;
  net::ReceivedSnapshots received_;
  float time_s_ = 0;
};

}  // namespace

Nodes make_window_nodes(const Parts& parts) {
  return make_server_and_client<WindowServer, WindowClient>(parts);
}

}  // namespace temblor::lab::wire
