#include "host/frame/corner_readouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "client/session/client_state.h"
#include "host/frame/host_parts.h"
#include "lab/registry.h"

namespace temblor::host {
namespace {

constexpr double kSpeedUpdate_s = 0.5;

std::string format_clock(double time_s) {
  const auto seconds = static_cast<long>(std::max(time_s, 0.0));
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string format_player_speed(const client::Game& game) {
  const math::Vec3& velocity = game.data.velocity;
  return fmt::format("{:.0f} units/s", std::hypot(velocity.x, velocity.y));
}

void add_renderer_lines(int detail, const render::FrameStats& stats, std::vector<std::string>& io_lines) {
  io_lines.push_back(fmt::format("faces {} of {}", stats.faces_seen, stats.faces_in_pvs));
  io_lines.push_back(fmt::format("edges {}  spans {}", stats.edges, stats.spans));
  io_lines.push_back(fmt::format("surfaces {}  built {}", stats.surfaces, stats.surfaces_built));
  io_lines.push_back(fmt::format("models {}  particles {}", stats.models, stats.particles));
  if (detail < 2) return;
  for (std::size_t stage = 0; stage < render::kStages; ++stage)
    io_lines.push_back(fmt::format("{} {:5.2f} ms", render::kStageNames[stage], stats.stages.ms[stage]));
}

void add_technique_line(const lab::Technique& technique, const render::FrameStats& stats,
                        std::vector<std::string>& io_lines) {
  const auto& ms = stats.stages.ms;
  io_lines.push_back(fmt::format("{}  {:5.2f} ms  spans {}", technique.name,
                                 std::accumulate(ms.begin(), ms.end(), 0.0), stats.spans));
}

}  // namespace

// The sums restart at 0 at the end of an interval.
void update_meter(SpeedMeter& io_meter, const FrameTimes& times) {
  io_meter.frames += 1;
  io_meter.seconds += times.frame_s;
  io_meter.worst_latency_s = std::max(io_meter.worst_latency_s, times.latency_s);
  if (io_meter.seconds < kSpeedUpdate_s) return;
  io_meter = {.speed_text = fmt::format("{:.0f} fps", io_meter.frames / io_meter.seconds),
              .latency_text = fmt::format("{:.1f} ms", io_meter.worst_latency_s * 1000)};
}

std::vector<std::string> list_readouts(const ReadoutSettings& settings, const ReadoutInput& input) {
  std::vector<std::string> lines;
  if (settings == ReadoutSettings{}) return lines;
  if (settings.frame_rate) lines.push_back(input.meter.speed_text);
  if (settings.latency) lines.push_back(input.meter.latency_text);
  if (input.game == nullptr) return lines;
  if (settings.clock) lines.push_back(format_clock(input.time_s));
  if (settings.player_speed) lines.push_back(format_player_speed(*input.game));
  if (settings.technique > 0)
    add_technique_line(lab::list_techniques()[settings.technique], input.stats, lines);
  if (settings.renderer > 0) add_renderer_lines(settings.renderer, input.stats, lines);
  return lines;
}

}  // namespace temblor::host
