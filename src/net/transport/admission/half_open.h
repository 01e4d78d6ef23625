// Connections that were accepted and have shown no sign of life yet: whoever asked for them may have written
// somebody else's address. A fixed number of them, each with a short life.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "net/transport/channel.h"
#include "platform/address.h"

namespace temblor::net {

struct HalfOpen {
  platform::Address address;
  std::size_t socket = 0;  // which of its server's it came through
  double began_s = 0;
  Channel channel;
  std::string
      word{};  // that it was asked to say (net/transport/admission/challenge.h); empty: it was not asked
};

class HalfOpenTable {
 public:
  static constexpr std::size_t kEntries = 64;
  // One host, whatever its ports, leaves room for others.
  static constexpr std::size_t kEntriesOfHost = 48;
  // An entry younger than this does not give way to a newer one: its first acknowledgement may be on the way.
  static constexpr double kSafe_s = 2;

  HalfOpenTable() { entries_.reserve(kEntries); }

  // Null when there is none. Valid until the next call that changes the table.
  HalfOpen* find(const platform::Address& address);
  // The new entry; null when there is no room and nobody gives way. CHECKs that the address has none.
  HalfOpen* add(const platform::Address& address, std::size_t socket, const ChannelSettings& settings,
                double now_s);
  void remove(const platform::Address& address);
  void remove_older_than(double life_s, double now_s);
  std::vector<HalfOpen>& entries() { return entries_; }

 private:
  std::vector<HalfOpen> entries_;
};

}  // namespace temblor::net
