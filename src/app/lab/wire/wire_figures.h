// Measurements of the wire's methods: how long a lost packet freezes the world, bytes, and the time from
// input to picture.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bench/distribution.h"
#include "app/html/plot.h"
#include "lab/wire.h"

namespace temblor::app {

struct WireGrid {
  std::vector<double> losses;  // 0 to 1
  std::vector<double> pings_ms;
  int players = 2;
};

// A link that loses packets at random, over kWireRuns runs. Milliseconds.
constexpr int kWireRuns = 5;
struct WireFigures {
  lab::wire::Method method{};
  double ping_ms = 0, loss = 0;
  // Per second, to and from the player, with the headers of IP and UDP.
  double bytes_in = 0, bytes_out = 0, packets_in = 0, packets_out = 0;
  Distribution gap_ms;      // from a state to the next newer one
  Distribution picture_ms;  // from input to the first picture that follows it, at 60 pictures per second
};

// A link that loses one packet with a state, or with a peer's inputs: the longest time without a newer state.
// The median of several moments at which the packet is lost.
struct WireFreeze {
  lab::wire::Method method{};
  double ping_ms = 0;
  double tick_ms = 0;
  double gap_ms = 0;       // without loss
  double lost_gap_ms = 0;  // with the loss
  // Longer than a tick.
  double frozen_ms() const { return lost_gap_ms - tick_ms; }
};

struct WireResults {
  std::string world;  // its name
  std::size_t ticks = 0;
  double tick_s = 0;
  int players = 0;
  std::vector<WireFreeze> freezes{};  // by method, then ping
  // Whole states from servers with about 20 and 10 ticks per second, as in the article, at the plotted ping.
  std::vector<WireFreeze> slower{};
  std::vector<WireFigures> figures{};  // by ping, then method, then loss

  const WireFreeze& freeze(lab::wire::Method method, double ping_ms) const;
};

// The ping of the article's example.
constexpr double kArticlePing_ms = 200;

// Adds a jitter of kWireJitter_ms to links that lose packets at random. The world must last longer than the
// warm time of lab::wire::Setup.
constexpr double kWireJitter_ms = 5;
WireResults measure_wire(const std::string& name, const lab::wire::World& world, const WireGrid& grid);
WireFreeze measure_freeze(const lab::wire::World& world, lab::wire::Method method, double ping_ms,
                          int players);
WireFigures measure_link(const lab::wire::World& world, lab::wire::Method method, double ping_ms, double loss,
                         int players);

const lab::wire::MethodInfo& find_method_info(lab::wire::Method method);
// The ping that plots show: the article's if it was measured, or else the longest.
double choose_plotted_ping(const WireResults& results);

// Tables for a terminal.
std::string describe_wire(const WireResults& results);
std::string make_wire_json(const WireResults& results);
// Freezes and bytes against loss.
std::vector<Plot> plot_wire(const WireResults& results);

}  // namespace temblor::app
