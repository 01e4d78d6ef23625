#include "app/files/system.h"

#include <algorithm>
#include <chrono>
#include <fstream>
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

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  // A line is, for example, "model name      : AMD EPYC".
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(": ") + 2, line.size()));
  return "unknown processor";
}

}  // namespace temblor::app
