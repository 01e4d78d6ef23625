#include "net/transport/admission/unverified_peer_limits.h"

#include <span>

#include "base/hash.h"

namespace temblor::net {
namespace {

constexpr std::size_t kHeadersBelowBytes = 28;  // of IPv4 and UDP

// One customer of a provider commonly has 64 bits of an IPv6 address to himself.
std::size_t host_bytes(const platform::Address& address) {
  return address.is_ip4() ? 16 : 8;
}

}  // namespace

UnverifiedPeerLimits::UnverifiedPeerLimits(const UnverifiedPeerRates& rates, std::uint64_t seed)
    : rates_(rates), seed_(seed), sets_(kSets) {}

UnverifiedPeerLimits::Host& UnverifiedPeerLimits::host_of(const platform::Address& address, double now_s) {
  const base::Bytes host = std::as_bytes(std::span(address.host)).first(host_bytes(address));
  const std::uint64_t key = base::hash_with_bytes(seed_, host) | 1;
  auto& set = sets_[(key >> 32) % kSets];
  Host* oldest = &set[0];
  for (Host& candidate : set) {
    if (candidate.key == key) {
      candidate.asked_s = now_s;
      return candidate;
    }
    const bool older = candidate.key == 0 || (oldest->key != 0 && candidate.asked_s < oldest->asked_s);
    if (older) oldest = &candidate;
  }
  *oldest = Host{.key = key, .asked_s = now_s};
  return *oldest;
}

bool UnverifiedPeerLimits::admit_connection_request(const platform::Address& from, double now_s) {
  // The host's own first: what it is refused does not use up what is everybody's.
  return host_of(from, now_s).connections.take(1, rates_.connections_of_host, now_s) &&
         connections_.take(1, rates_.connections_of_all, now_s);
}

bool UnverifiedPeerLimits::admit_query(const platform::Address& from, bool is_known, double now_s) {
  return take_answer_bytes(from, kHeadersBelowBytes, is_known, now_s);
}

bool UnverifiedPeerLimits::admit_answer(const platform::Address& to, std::size_t question_bytes,
                                        std::size_t answer_bytes, bool is_known, double now_s) {
  return answer_bytes <= question_bytes || take_answer_bytes(to, answer_bytes, is_known, now_s);
}

bool UnverifiedPeerLimits::admit_password(const platform::Address& from, double now_s) {
  return host_of(from, now_s).wrong_passwords.has(1, rates_.wrong_passwords_of_host, now_s) &&
         wrong_passwords_.has(1, rates_.wrong_passwords_of_all, now_s);
}

void UnverifiedPeerLimits::wrong_password(const platform::Address& from, double now_s) {
  host_of(from, now_s).wrong_passwords.take(1, rates_.wrong_passwords_of_host, now_s);
  wrong_passwords_.take(1, rates_.wrong_passwords_of_all, now_s);
}

bool UnverifiedPeerLimits::take_answer_bytes(const platform::Address& to, std::size_t bytes, bool is_known,
                                             double now_s) {
  const auto cost = static_cast<double>(bytes);
  return host_of(to, now_s).answer_bytes.take(cost, rates_.answer_bytes_of_host, now_s) &&
         (is_known || answer_bytes_.take(cost, rates_.answer_bytes_of_all, now_s));
}

bool equal_in_constant_time(std::string_view given, std::string_view expected) {
  if (expected.empty()) return false;
  // As many steps as were given, which whoever asks knows anyway.
  unsigned difference = given.size() == expected.size() ? 0 : 1;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const char other = expected[i % expected.size()];
    difference |=
        static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(other));
  }
  // The compiler may not end the loop where it knows the answer.
  const volatile unsigned result = difference;
  return result == 0;
}

}  // namespace temblor::net
