// A Channel::Sink that sends every packet to one peer through one socket.
#pragma once

#include "base/bytes.h"
#include "platform/datagram_socket.h"

namespace temblor::net {

// Borrows both; create one for each call and do not store it.
struct SendTo {
  platform::DatagramSocket& socket;
  const platform::Address& address;
  void operator()(base::Bytes packet) const { socket.send(address, packet); }
};

}  // namespace temblor::net
