// A sink for a channel's packets (channel.h): sends each to one peer.
#pragma once

#include "base/bytes.h"
#include "platform/datagram_socket.h"

namespace temblor::net {

// Both are borrowed, for as long as the call takes that is given this.
struct SendTo {
  platform::DatagramSocket& socket;
  const platform::Address& address;
  void operator()(base::Bytes packet) const { socket.send(address, packet); }
};

}  // namespace temblor::net
