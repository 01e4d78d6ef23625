// What a server grants to senders whose address proves nothing: anybody can write any address into a
// datagram, and whoever really has it gets the answers.
//
// - Connection requests: so many a second from one host, whatever its ports, and so many from everybody.
// - Answers that are larger than their question (queries, refusals): a budget of bytes for each host, and one
//   for all hosts together. Both count 28 bytes a packet for the headers below it. One look at a server with
//   all its players and rules fits a host's burst many times over; but a flood of questions in a victim's
//   name brings the victim that burst and a trickle, and the world in all no more than the common budget. A
//   host that has a connection is spared the common one, so that a flood does not blind those who play.
// - Passwords for remote commands that were wrong: a few a minute from one host.
//
// Memory is fixed: a host that has not asked for long gives way to a new one. A flood from more hosts than
// the table holds thus forgets what each had used, and the common budgets hold alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "net/transport/admission/token_bucket.h"
#include "platform/address.h"

namespace temblor::net {

struct UnverifiedPeerRates {
  Rate connections_of_host{64, 4}, connections_of_all{256, 64};  // requests
  Rate answer_bytes_of_host{8192, 512}, answer_bytes_of_all{65536, 16384};
  Rate wrong_passwords_of_host{5, 1.0 / 12}, wrong_passwords_of_all{50, 1};
};

class UnverifiedPeerLimits {
 public:
  // `seed` makes the places of hosts in the table unforeseeable; any number.
  explicit UnverifiedPeerLimits(const UnverifiedPeerRates& rates = {}, std::uint64_t seed = 0);

  bool admit_connection_request(const platform::Address& from, double now_s);
  // To look at a query at all: 28 bytes of the budgets. `is_known`: the host has a connection.
  bool admit_query(const platform::Address& from, bool is_known, double now_s);
  // To answer it: the answer's bytes; nothing for one no larger than its question.
  bool admit_answer(const platform::Address& to, std::size_t question_bytes, std::size_t answer_bytes,
                    bool is_known, double now_s);
  // Whether a password from there is looked at at all; each that is wrong is told to wrong_password().
  bool admit_password(const platform::Address& from, double now_s);
  void wrong_password(const platform::Address& from, double now_s);

 private:
  struct Host {
    std::uint64_t key = 0;  // 0: nobody
    double asked_s = 0;
    TokenBucket connections{}, answer_bytes{}, wrong_passwords{};
  };
  static constexpr std::size_t kSets = 512, kHostsOfSet = 4;
  Host& host_of(const platform::Address& address, double now_s);
  bool take_answer_bytes(const platform::Address& to, std::size_t bytes, bool is_known, double now_s);

  UnverifiedPeerRates rates_;
  std::uint64_t seed_;
  std::vector<std::array<Host, kHostsOfSet>> sets_;
  TokenBucket connections_, answer_bytes_, wrong_passwords_;
};

// Takes the same time whatever characters differ. An empty `expected` is no password: nothing equals it.
bool equal_in_constant_time(std::string_view given, std::string_view expected);

}  // namespace temblor::net
