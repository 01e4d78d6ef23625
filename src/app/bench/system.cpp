#include "app/bench/system.h"

#include <chrono>
#include <random>

namespace temblor::app {

double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint64_t any_seed() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

net::Secret any_secret() {
  net::Secret secret{};
  std::random_device device;
  for (auto& word : secret) word = std::uint64_t{device()} << 32 | device();
  return secret;
}

}  // namespace temblor::app
