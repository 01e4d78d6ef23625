#include "app/files/system.h"

#include <chrono>
#include <random>

namespace temblor::app {

// A steady clock does not jump when the time of day is set.
double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint64_t make_seed() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

// Not make_seed(): peers could guess the time at which the program started.
net::Secret make_secret() {
  net::Secret secret{};
  std::random_device device;
  for (auto& word : secret) word = std::uint64_t{device()} << 32 | device();
  return secret;
}

}  // namespace temblor::app
