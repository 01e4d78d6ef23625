// The machine's clock and its sources of chance.
#pragma once

#include <cstdint>

#include "net/transport/server_endpoint.h"

namespace temblor::app {

// Seconds, steady.
double clock_s();
std::uint64_t any_seed();
net::Secret any_secret();

}  // namespace temblor::app
