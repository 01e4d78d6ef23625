// Hash functions with the same results on every machine and in every run: for cache keys, golden hashes, and
// repeatable pseudorandom numbers. An attacker can construct collisions, so tables with keys from the network
// need a secret start value.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/bytes.h"

namespace temblor::base {

// Increment of splitmix64: odd, and its bits look random.
constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15u;

// The last step of splitmix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014):
// each input bit changes about half of the output bits.
constexpr std::uint64_t mix_bits(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

// Folds a value into the hash of a sequence. The order of the values matters.
constexpr std::uint64_t hash_with(std::uint64_t hash, std::uint64_t value) {
  return mix_bits((hash ^ value) + kGoldenGamma);
}

// Folds bytes into a hash: eight at a time, then the rest one by one.
inline std::uint64_t hash_with_bytes(std::uint64_t hash, Bytes bytes) {
  ByteReader reader(bytes);
  while (reader.remaining() >= sizeof(std::uint64_t)) hash = hash_with(hash, reader.read<std::uint64_t>());
  while (reader.remaining() > 0) hash = hash_with(hash, reader.u8());
  return hash;
}

// Hashes bytes and their count, so that trailing zeros matter.
inline std::uint64_t hash_bytes(Bytes bytes) {
  return hash_with_bytes(hash_with(0, bytes.size()), bytes);
}

// Hashes bytes and their count, several times as fast as hash_bytes(): in four chains that do not wait for
// each other. A rotation before each multiplication lets the highest bits reach the others.
inline std::uint64_t hash_bytes_fast(Bytes bytes) {
  constexpr std::size_t kLanes = 4;
  std::uint64_t lanes[kLanes] = {1, 2, 3, 4};
  std::size_t done = 0;
  for (; done + sizeof(lanes) <= bytes.size(); done += sizeof(lanes)) {
    std::uint64_t words[kLanes];
    std::memcpy(words, bytes.data() + done, sizeof(words));
    for (std::size_t i = 0; i < kLanes; ++i) lanes[i] = std::rotl(lanes[i] ^ words[i], 29) * kGoldenGamma;
  }
  std::uint64_t hash = hash_with(0, bytes.size());
  for (const std::uint64_t lane : lanes) hash = hash_with(hash, lane);
  return hash_with_bytes(hash, bytes.subspan(done));
}

// Returns the bits of a float for hashing; the same for 0 and -0.
constexpr std::uint64_t float_bits(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0f);
}

}  // namespace temblor::base
