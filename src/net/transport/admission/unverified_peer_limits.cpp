#include "net/transport/admission/unverified_peer_limits.h"

#include <span>

#include "base/hash.h"

namespace temblor::net {
namespace {

constexpr std::size_t kHeadersBelowBytes = 28;  // IPv4 and UDP

// Providers commonly assign a whole /64 network of IPv6 to one customer, so those count as one host.
std::size_t count_host_bytes(const platform::Address& address) {
  return address.is_ip4() ? 16 : 8;
}

}  // namespace

UnverifiedPeerLimits::UnverifiedPeerLimits(const UnverifiedPeerRates& rates, std::uint64_t seed)
    : rates_(rates), seed_(seed), sets_(kSets) {}

UnverifiedPeerLimits::Host& UnverifiedPeerLimits::find_or_add_host(const platform::Address& address,
                                                                   double now_s) {
  const base::Bytes host = std::as_bytes(std::span(address.host)).first(count_host_bytes(address));
  const std::uint64_t key = base::hash_with_bytes(seed_, host) | 1;
  // Bit 0 is set so that no key is 0, the mark of an unused entry; the set comes from other bits.
  auto& set = sets_[(key >> 32) % kSets];
  Host* oldest = &set[0];
  for (Host& candidate : set) {
    if (candidate.key == key) {
      candidate.last_seen_s = now_s;
      return candidate;
    }
    const bool older =
        candidate.key == 0 || (oldest->key != 0 && candidate.last_seen_s < oldest->last_seen_s);
    if (older) oldest = &candidate;
  }
  *oldest = Host{.key = key, .last_seen_s = now_s};
  return *oldest;
}

bool UnverifiedPeerLimits::admit_connection_request(const platform::Address& from, double now_s) {
  // Check the host's own bucket first, so that its rejected requests do not drain the common bucket.
  return find_or_add_host(from, now_s).connections.spend(1, rates_.connections_per_host, now_s) &&
         connections_.spend(1, rates_.connections_in_total, now_s);
}

bool UnverifiedPeerLimits::admit_query(const platform::Address& from, bool is_known, double now_s) {
  return spend_reply_bytes(from, kHeadersBelowBytes, is_known, now_s);
}

bool UnverifiedPeerLimits::admit_reply(const platform::Address& to, std::size_t request_bytes,
                                       std::size_t reply_bytes, bool is_known, double now_s) {
  return reply_bytes <= request_bytes || spend_reply_bytes(to, reply_bytes, is_known, now_s);
}

bool UnverifiedPeerLimits::admit_password(const platform::Address& from, double now_s) {
  return find_or_add_host(from, now_s).wrong_passwords.can_spend(1, rates_.wrong_passwords_per_host, now_s) &&
         wrong_passwords_.can_spend(1, rates_.wrong_passwords_in_total, now_s);
}

void UnverifiedPeerLimits::record_wrong_password(const platform::Address& from, double now_s) {
  find_or_add_host(from, now_s).wrong_passwords.spend(1, rates_.wrong_passwords_per_host, now_s);
  wrong_passwords_.spend(1, rates_.wrong_passwords_in_total, now_s);
}

bool UnverifiedPeerLimits::spend_reply_bytes(const platform::Address& to, std::size_t bytes, bool is_known,
                                             double now_s) {
  const auto cost = static_cast<double>(bytes);
  return find_or_add_host(to, now_s).reply_bytes.spend(cost, rates_.reply_bytes_per_host, now_s) &&
         (is_known || reply_bytes_.spend(cost, rates_.reply_bytes_in_total, now_s));
}

bool equal_in_constant_time(std::string_view given, std::string_view expected) {
  if (expected.empty()) return false;
  // The number of steps is the length of `given`, which the sender knows anyway.
  unsigned difference = given.size() == expected.size() ? 0 : 1;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const char other = expected[i % expected.size()];
    difference |=
        static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(other));
  }
  // volatile: the compiler must not leave the loop early.
  const volatile unsigned result = difference;
  return result == 0;
}

}  // namespace temblor::net
