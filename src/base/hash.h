// Hashes of values that are equal on every machine and in every run.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/bytes.h"

namespace temblor::base {

// What splitmix64 adds from number to number: odd, its bits without pattern.
constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15u;

// The last step of splitmix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014):
// every bit of the input changes half of the output's.
constexpr std::uint64_t mixed_bits(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

// The hash of a sequence, one value after another.
constexpr std::uint64_t hash_with(std::uint64_t hash, std::uint64_t value) {
  return mixed_bits((hash ^ value) + kGoldenGamma);
}

// Eight at a time, then the rest one by one.
inline std::uint64_t hash_with_bytes(std::uint64_t hash, Bytes bytes) {
  ByteReader reader(bytes);
  while (reader.remaining() >= sizeof(std::uint64_t)) hash = hash_with(hash, reader.read<std::uint64_t>());
  while (reader.remaining() > 0) hash = hash_with(hash, reader.u8());
  return hash;
}

// How many they are counts as well.
inline std::uint64_t hash_of_bytes(Bytes bytes) {
  return hash_with_bytes(hash_with(0, bytes.size()), bytes);
}

// 0 and -0 are one value.
constexpr std::uint64_t bits_of(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0f);
}

}  // namespace temblor::base
