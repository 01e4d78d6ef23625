// A network on a virtual clock that loses, doubles, delays and so reorders datagrams: the same for one seed.
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

  // A socket with this address, which nobody else has. It lives no longer than the network.
  std::unique_ptr<platform::DatagramSocket> open(const platform::Address& address);
  // Datagrams whose time has come can be received from here on.
  void advance_to(double now_s);
  void set_conditions(const NetworkConditions& conditions) { conditions_ = conditions; }
  // Bytes and datagrams sent to this address since the beginning, lost ones too.
  std::uint64_t bytes_sent_to(const platform::Address& address) const;
  std::uint64_t datagrams_sent_to(const platform::Address& address) const;

 private:
  friend class BadSocket;
  struct Traveling {
    double arrives_s;
    std::uint64_t number;  // in the order of sending, for those that arrive together
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
