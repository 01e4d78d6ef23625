// Rate limits for peers whose address is unverified. Anybody can forge the sender address of a datagram, and
// the reply then hits the real owner of that address; so a server without limits is an amplifier for attacks.
//
// - Connection requests: a rate for each host (across its ports), and one for all hosts together.
// - Replies that are larger than their request (queries, rejections): a budget of bytes for each host, and
//   one for all hosts together. Both count 28 bytes for the IP and UDP headers of each packet. A complete
//   query of a full server fits into a host's burst many times. But a flood of requests with a forged address
//   sends the victim only that burst plus a trickle. Hosts with a connection are exempt from the common
//   budget, so that a flood does not lock out players.
// - Wrong passwords for remote commands: a few a minute for each host.
//
// The method is token buckets in a 4-way set-associative table of fixed size, keyed by a seeded hash of the
// host; a new host replaces the least recently active one of its set. So a flood from more hosts than the
// table holds resets the limits of single hosts, and only the common budgets remain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "net/transport/admission/token_bucket.h"
#include "platform/address.h"

namespace temblor::net {

// Defaults of a server. Each pair is {burst, per second}.
struct UnverifiedPeerRates {
  Rate connections_per_host{64, 4}, connections_in_total{256, 64};  // requests
  Rate reply_bytes_per_host{8192, 512}, reply_bytes_in_total{65536, 16384};
  Rate wrong_passwords_per_host{5, 1.0 / 12}, wrong_passwords_in_total{50, 1};
};

class UnverifiedPeerLimits {
 public:
  // `seed`: any number that attackers do not know; they cannot choose addresses that share a set then.
  explicit UnverifiedPeerLimits(const UnverifiedPeerRates& rates = {}, std::uint64_t seed = 0);

  // Returns whether to process a connection request, and charges it.
  bool admit_connection_request(const platform::Address& from, double now_s);
  // Returns whether to process a query, and charges 28 bytes. `is_known`: the host has a connection.
  bool admit_query(const platform::Address& from, bool is_known, double now_s);
  // Returns whether to send the reply, and charges its bytes; a reply no larger than its request is free.
  bool admit_reply(const platform::Address& to, std::size_t request_bytes, std::size_t reply_bytes,
                   bool is_known, double now_s);
  // Returns whether to check a password from this host. Report each wrong one with record_wrong_password().
  bool admit_password(const platform::Address& from, double now_s);
  void record_wrong_password(const platform::Address& from, double now_s);

 private:
  struct Host {
    std::uint64_t key = 0;  // hash of the address; 0: unused
    double last_seen_s = 0;
    TokenBucket connections{}, reply_bytes{}, wrong_passwords{};
  };
  static constexpr std::size_t kSets = 512, kHostsPerSet = 4;
  Host& find_or_add_host(const platform::Address& address, double now_s);
  bool spend_reply_bytes(const platform::Address& to, std::size_t bytes, bool is_known, double now_s);

  UnverifiedPeerRates rates_;
  std::uint64_t seed_;
  std::vector<std::array<Host, kHostsPerSet>> sets_;
  TokenBucket connections_, reply_bytes_, wrong_passwords_;
};

// Compares passwords in a time that does not depend on where they differ. An empty `expected` means that no
// password is set: returns false for everything.
bool equal_in_constant_time(std::string_view given, std::string_view expected);

}  // namespace temblor::net
