// Lines of numbers in the corner of the screen: scr_showfps, scr_showlatency, scr_clock, scr_showspeed,
// r_speeds, and the figures of the laboratory's technique (r_technique).
#pragma once

#include <string>
#include <vector>

#include "render/frame_stats.h"

namespace temblor::client {
struct Game;
}

namespace temblor::host {

struct SpeedMeter;
struct FrameTimes;

// Which lines are shown.
struct ReadoutSettings {
  bool frame_rate = false, latency = false, clock = false, player_speed = false;
  int renderer = 0;  // r_speeds; 2: also the time of each stage
  // r_technique: the number in lab::list_techniques(). The engine's own, 0, adds no line.
  std::size_t technique = 0;

  bool operator==(const ReadoutSettings&) const = default;
};

// Counts a frame. The texts change only at the end of an interval.
void update_meter(SpeedMeter& io_meter, const FrameTimes& times);

// The frame and the game that the readouts describe.
struct ReadoutInput {
  const SpeedMeter& meter;
  const client::Game* game = nullptr;  // null: no level is shown
  double time_s = 0;                   // since the level began
  const render::FrameStats& stats;
};

// The lines from top to bottom.
std::vector<std::string> list_readouts(const ReadoutSettings& settings, const ReadoutInput& input);

}  // namespace temblor::host
