#include "net/transport/admission/half_open.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace temblor::net {

HalfOpen* HalfOpenTable::find(const platform::Address& address) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const HalfOpen& entry) { return entry.address == address; });
  return found == entries_.end() ? nullptr : &*found;
}

HalfOpen* HalfOpenTable::add(const platform::Address& address, std::size_t socket,
                             const ChannelSettings& settings, double now_s) {
  CHECK(find(address) == nullptr);
  const auto has_same_host = [&](const HalfOpen& entry) { return entry.address.same_host(address); };
  const bool host_is_full = static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(),
                                                                   has_same_host)) >= kMaxEntriesPerHost;
  if (host_is_full || entries_.size() >= kMaxEntries) {
    // Replace the oldest entry: of this host if its share is full, otherwise of all.
    const auto older = [&](const HalfOpen& a, const HalfOpen& b) {
      if (host_is_full && has_same_host(a) != has_same_host(b)) return has_same_host(a);
      return a.began_s < b.began_s;
    };
    const auto oldest = std::min_element(entries_.begin(), entries_.end(), older);
    if (now_s - oldest->began_s < kMinAge_s) return nullptr;
    entries_.erase(oldest);
  }
  return &entries_.emplace_back(HalfOpen{address, socket, now_s, Channel(settings), {}});
}

void HalfOpenTable::remove(const platform::Address& address) {
  std::erase_if(entries_, [&](const HalfOpen& entry) { return entry.address == address; });
}

void HalfOpenTable::remove_older_than(double life_s, double now_s) {
  std::erase_if(entries_, [&](const HalfOpen& entry) { return now_s - entry.began_s > life_s; });
}

}  // namespace temblor::net
