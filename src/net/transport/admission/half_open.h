// Half-open connections: accepted, but the peer has not yet acknowledged a packet, so the sender address of
// the request may be forged. The table has a fixed size, and entries expire quickly, so a flood of forged
// requests costs a bounded amount of memory (as with SYN floods in TCP).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "net/transport/channel.h"
#include "platform/address.h"

namespace temblor::net {

// One half-open connection.
struct HalfOpen {
  platform::Address address;
  std::size_t socket = 0;  // index of the server socket that received the request
  double began_s = 0;      // time of the request
  Channel channel;
  std::string cookie{};  // that the peer must return (challenge.h); empty: no challenge was sent
};

class HalfOpenTable {
 public:
  static constexpr std::size_t kMaxEntries = 64;
  // Entries of one host, across all of its ports; leaves room for others.
  static constexpr std::size_t kMaxEntriesPerHost = 48;
  // A newer request never replaces an entry younger than this: its acknowledgment may still be on the way.
  static constexpr double kMinAge_s = 2;

  HalfOpenTable() { entries_.reserve(kMaxEntries); }

  // Returns null if the address has no entry. The pointer is valid until the next call that changes the
  // table.
  HalfOpen* find(const platform::Address& address);
  // Adds an entry. If the table (or the host's share) is full, it replaces the oldest entry, unless that one
  // is younger than kMinAge_s: then it returns null. CHECKs that the address has no entry.
  HalfOpen* add(const platform::Address& address, std::size_t socket, const ChannelSettings& settings,
                double now_s);
  void remove(const platform::Address& address);
  // Removes entries older than `life_s` seconds.
  void remove_older_than(double life_s, double now_s);
  std::vector<HalfOpen>& entries() { return entries_; }

 private:
  std::vector<HalfOpen> entries_;
};

}  // namespace temblor::net
