// Repeats the disconnect message to peers that did not receive it. UDP may lose the message, and a client
// that lost it would wait for its timeout; so while such a peer keeps sending, the server answers with the
// disconnect again. ServerEndpoint feeds it every packet that belongs to no connection.
#pragma once

#include <cstddef>
#include <deque>
#include <string_view>

#include "net/transport/channel.h"
#include "platform/address.h"

namespace temblor::net {

class DisconnectResender {
 public:
  static constexpr std::size_t kMaxEntries = 64;  // a new entry replaces the oldest
  static constexpr double kLifetime_s = 10;       // of an entry, after the first disconnect message
  static constexpr double kMinInterval_s = 0.5;   // between two messages to one peer

  // Takes over the channel of an ended connection and sends an unreliable svc_print with the reason (unless
  // it is empty; at most 200 bytes) and svc_disconnect. Remembers the peer for kLifetime_s.
  void send(const platform::Address& peer, Channel channel, std::string_view reason, double now_s,
            Channel::Sink sink);
  // Call this when `peer` sent a packet. Repeats the message if the peer has an entry and the last message is
  // at least kMinInterval_s old.
  void resend(const platform::Address& peer, double now_s, Channel::Sink sink);
  // Removes the entry of a peer that connects again.
  void forget(const platform::Address& peer);
  // Removes expired entries. Call it every tick.
  void update(double now_s);

 private:
  struct Entry {
    platform::Address peer;
    Channel channel;
    base::ByteVector message;
    double expires_s = 0, last_sent_s = 0;
  };
  static void send_entry(Entry& io_entry, double now_s, Channel::Sink sink);

  std::deque<Entry> entries_;  // oldest first
};

}  // namespace temblor::net
