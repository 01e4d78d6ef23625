// `temblor lab wire`: how the state of a game gets to its players over a network that loses packets.
#pragma once

#include <string>
#include <string_view>

#include "app/commands/options.h"
#include "app/lab/wire/wire_figures.h"
#include "base/result.h"

namespace temblor::app {

class Command;

constexpr const char* kWireName = "wire";

// From the lowest to the highest measured value; both may be the same.
struct ValueRange {
  double low = 0, high = 0;
};

struct WireOptions {
  ValueRange loss_percent{0, 10};
  ValueRange latency_ms{0, 300};  // round trip
  int seconds = 20, players = 2;
  std::string map;  // empty: a small built-in world
};

void add_wire_options(Command& command, WireOptions& io_options);

// The values that are measured: both ends of the ranges, and round numbers between them.
WireGrid make_wire_grid(const WireOptions& options);

// Records the game, and measures all methods. Errors: those of record_game().
base::Result<WireResults> measure_wire(const WireOptions& options, const GameFolders& folders);

// `out`: a .svg for plots, or empty. With `json`, prints JSON in place of tables. Errors: another file name,
// a level that cannot be played, or a file that cannot be written.
base::Status run_wire(const WireOptions& options, const GameFolders& folders, bool json,
                      const std::string& out);

// The paragraph of `lab list`.
std::string describe_wire_methods();

}  // namespace temblor::app
