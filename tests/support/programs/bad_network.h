// A network with a virtual clock that loses, duplicates, delays, and so reorders datagrams: the same for one
// seed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>

#include "platform/datagram_socket.h"
#include "support/random.h"

namespace temblor::test {

struct NetworkConditions {
  double loss = 0, duplication = 0;  // probabilities
  double delay_s = 0;                // one way
  double jitter_s = 0;               // delays are uniform in delay_s +- jitter_s, which reorders
};

class BadNetwork {
 public:
  BadNetwork(const NetworkConditions& conditions, std::uint64_t seed);

  // Makes a socket with this address, which must be unique. The network must outlive it.
  std::unique_ptr<platform::DatagramSocket> open(const platform::Address& address);
  // Advances the clock: datagrams that are due can be received from now on.
  void advance_to(double now_s);
  void set_conditions(const NetworkConditions& conditions) { conditions_ = conditions; }
  // Bytes and datagrams sent to this address since the start, including lost ones.
  std::uint64_t bytes_sent_to(const platform::Address& address) const;
  std::uint64_t datagrams_sent_to(const platform::Address& address) const;

 private:
  friend class BadSocket;
  struct Traveling {
    double arrives_s;
    std::uint64_t number;  // in the order of sending, for datagrams that arrive at the same time
    platform::Address from;
    base::ByteVector bytes;
    bool operator<(const Traveling& other) const {
      return arrives_s != other.arrives_s ? arrives_s < other.arrives_s : number < other.number;
    }
  };
  struct Sent {
    std::uint64_t bytes = 0, datagrams = 0;
  };
  void send(const platform::Address& from, const platform::Address& to, base::Bytes bytes);
  void travel(const platform::Address& from, const platform::Address& to, base::Bytes bytes);

  NetworkConditions conditions_;
  Random random_;
  double now_s_ = 0;
  std::uint64_t number_ = 0;
  std::map<platform::Address, std::set<Traveling>> inboxes_;
  std::map<platform::Address, Sent> sent_;
};

}  // namespace temblor::test
