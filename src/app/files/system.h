// The machine's name, its clock, and its sources of random numbers. Libraries receive time and seeds as
// parameters, so that tests can repeat them; only the program calls these.
#pragma once

#include <cstdint>
#include <string>

#include "net/transport/server_endpoint.h"

namespace temblor::app {

// Seconds of a steady clock with an arbitrary zero.
double clock_s();
// Returns a different seed in every run, from the wall clock.
std::uint64_t make_seed();
// Returns an unpredictable secret from the system's random device.
net::Secret make_secret();
// Returns the processor's name, as Linux knows it.
std::string processor_name();

}  // namespace temblor::app
