// Bits that look random, from bits that do not: for seeds and hashes that must be the same everywhere, which
// std::hash and the standard distributions are not.
#pragma once

#include <cstdint>

namespace temblor::base {

// What splitmix64 adds from number to number: odd, its bits without pattern.
constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15u;

// The last step of splitmix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014): one
// to one, and a changed bit of the input changes each bit of the output half of the time.
constexpr std::uint64_t mixed_bits(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

// A hash of a sequence: start anywhere, then take in one value after the other.
constexpr std::uint64_t mixed_in(std::uint64_t hash, std::uint64_t value) {
  return mixed_bits((hash ^ value) + kGoldenGamma);
}

}  // namespace temblor::base
