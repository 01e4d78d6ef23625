// Peers that were disconnected and may not have heard so: who goes on as if nothing were is told again.
#pragma once

#include <deque>
#include <string_view>

#include "net/transport/channel.h"
#include "platform/address.h"

namespace temblor::net {

class DisconnectResender {
 public:
  static constexpr std::size_t kMost = 64;  // the oldest gives way
  static constexpr double kLife_s = 10, kEvery_s = 0.5;

  // Sends the end of a connection over what was its channel: a print of the reason, cut at 200 bytes, unless
  // it is empty, and svc_disconnect.
  void say(const platform::Address& peer, Channel channel, std::string_view reason, double now_s,
           Channel::Sink sink);
  // Says it again to a peer that sent something, unless it was said just now or there is none for it.
  void repeat(const platform::Address& peer, double now_s, Channel::Sink sink);
  // For a peer that connects anew.
  void forget(const platform::Address& peer);
  void update(double now_s);

 private:
  struct Farewell {
    platform::Address peer;
    Channel channel;
    base::ByteVector message;
    double until_s = 0, said_s = 0;
  };
  static void send(Farewell& io_farewell, double now_s, Channel::Sink sink);

  std::deque<Farewell> disconnect_resender_;
};

}  // namespace temblor::net
