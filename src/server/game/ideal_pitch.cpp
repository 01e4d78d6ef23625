#include "server/game/ideal_pitch.h"

#include <array>
#include <cmath>
#include <numbers>

#include "server/move_trace.h"

namespace temblor::server {
namespace {

constexpr std::size_t kProbes = 6;
// Ahead of the player's eye; and how far down a probe looks for the floor.
constexpr float kFirstProbe_units = 36, kProbeStep_units = 12;
constexpr float kReachDown_units = 160;
constexpr float kSameHeight_units = 10;  // steps that differ by less belong to one staircase
constexpr int kMinStairSteps = 2;

// The floor's height at each probe. Empty: there is a wall or a deep drop.
std::optional<std::array<float, kProbes>> floor_ahead(GameWorld& io_world, const Edict& player) {
  const float yaw = player[field::kAngles].y * std::numbers::pi_v<float> / 180;
  const math::Vec3 forward{std::cos(yaw), std::sin(yaw), 0};
  const math::Vec3 eye = player[field::kOrigin] + player[field::kViewOffset];
  std::array<float, kProbes> heights;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const math::Vec3 top = eye + forward * (kFirstProbe_units + kProbeStep_units * static_cast<float>(i));
    const math::Vec3 bottom = top - math::Vec3{0, 0, kReachDown_units};
    const EntityTrace trace = trace_move(io_world, top, math::Vec3{0.0f}, math::Vec3{0.0f}, bottom,
                                         MoveKind::kNoMonsters, player.index());
    if (trace.trace.all_solid || trace.trace.fraction == 1) return std::nullopt;
    heights[i] = trace.trace.end.z;
  }
  return heights;
}

}  // namespace

void set_ideal_pitch(GameWorld& io_world, vm::EntityIndex index) {
  const Edict player = io_world.edicts[index];
  if (!player.has_flag(flag::kOnGround)) return;
  const auto heights = floor_ahead(io_world, player);
  if (!heights) return;
  float step = 0;
  int steps = 0;
  for (std::size_t i = 1; i < kProbes; ++i) {
    const float rise = (*heights)[i] - (*heights)[i - 1];
    if (std::abs(rise) < 1.0f / 32) continue;
    if (step != 0 && std::abs(rise - step) > kSameHeight_units) return;  // not one staircase
    step = rise;
    ++steps;
  }
  if (step == 0)
    player.set(field::kIdealPitch, 0.0f);
  else if (steps >= kMinStairSteps)
    player.set(field::kIdealPitch, -step * io_world.ideal_pitch_scale);
}

}  // namespace temblor::server
