// The game's random numbers: splitmix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
// Generators", 2014). The same seed gives the same game on every platform, unlike the C library's rand().
#pragma once

#include <cstdint>

namespace temblor::server {

class GameRandom {
 public:
  explicit GameRandom(std::uint64_t seed = 0x9e3779b97f4a7c15) : state_(seed) {}

  // 0 to 32767: the 15 bits of which QuakeC's random() is made.
  int next_15_bits() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<int>((z ^ (z >> 31)) >> 49);
  }
  // 0 to 1, both included.
  float next_fraction() { return static_cast<float>(next_15_bits()) / 32767.0f; }

  std::uint64_t state() const { return state_; }

 private:
  std::uint64_t state_;
};

}  // namespace temblor::server
