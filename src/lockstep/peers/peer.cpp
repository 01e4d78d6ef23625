#include "lockstep/peers/peer.h"

#include <algorithm>
#include <span>

namespace temblor::lockstep {
namespace {

constexpr std::size_t kMaxHashes = 1 << 16;

}  // namespace

// Parts arrive in order, or again: one that does not continue the others is ignored, and comes once more.
void HashCollector::add(const EntityHashes& part) {
  if (complete_ || part.count > kMaxHashes) return;
  if (part.first == 0) collected_ = {.tick = part.tick, .first = 0, .count = part.count};
  if (part.tick != collected_.tick || part.count != collected_.count ||
      part.first != collected_.hashes.size())
    return;
  collected_.hashes.insert(collected_.hashes.end(), part.hashes.begin(), part.hashes.end());
  if (collected_.hashes.size() >= collected_.count) complete_ = collected_;
}

std::vector<base::ByteVector> make_hash_packets(const EntityHashes& hashes) {
  std::vector<base::ByteVector> packets;
  const std::span all = hashes.hashes;
  for (std::size_t first = 0; first < all.size(); first += kMaxHashesInPacket) {
    const auto part = all.subspan(first, std::min(kMaxHashesInPacket, all.size() - first));
    packets.push_back(make_packet(EntityHashes{.tick = hashes.tick,
                                               .first = static_cast<std::uint32_t>(first),
                                               .count = static_cast<std::uint32_t>(all.size()),
                                               .hashes = {part.begin(), part.end()}}));
  }
  return packets;
}

}  // namespace temblor::lockstep
