// What a player does where no place of the graph is near: somebody has thrown him onto a rim that nobody
// walks on, or he has come down on a monster's head, which is no ground: one only slides off it, slowly.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scripted_player/decisions/brain.h"

namespace temblor::player {
namespace {

// A fall takes less than the first; in the second one comes off the largest head, at 21 units a second.
constexpr double kAstrayAfter_s = 2, kHeading_s = 2.5, kBeginAgainAfter_s = 15;
constexpr float kPace_units_s = 200, kLook_units = 48;
constexpr int kTries = 8;

}  // namespace

void Brain::find_back(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if ((self.on_ground || self.swims()) && nearest_place(self) >= 0) {
    astray_since_s_.reset();
    return;
  }
  if (!astray_since_s_) astray_since_s_ = now_s;
  if (now_s - *astray_since_s_ < kAstrayAfter_s) return;
  if (now_s - *astray_since_s_ > kBeginAgainAfter_s) {
    astray_since_s_ = now_s;
    begin_again_from(self);
  }
  if (now_s > heading_until_s_) {
    heading_until_s_ = now_s + kHeading_s;
    heading_ = heading_off(io_game, self);
  }
  out.velocity = heading_ * kPace_units_s;
  out.look_at = self.eye() + heading_ * 200.0f;
}

// Any way that does not end in fire; nowhere, where none was found.
math::Vec3 Brain::heading_off(server::Game& io_game, const Self& self) {
  for (int i = 0; i < kTries; ++i) {
    const float angle = dice_.between(0, 2 * std::numbers::pi_v<float>);
    const math::Vec3 heading(std::cos(angle), std::sin(angle), 0);
    if (!ends_in_fire(io_game.world(), self.entity, self.origin, self.origin + heading * kLook_units))
      return heading;
  }
  return math::Vec3(0.0f);
}

void Brain::begin_again_from(const Self& self) {
  if (dead_ends_ >= kMaxDeadEnds) return;
  ++dead_ends_;
  router_.keep_last_blame();
  complain(fmt::format("a dead end at {:.0f} {:.0f} {:.0f}: began again", self.origin.x, self.origin.y,
                       self.origin.z));
  wants_to_begin_again_ = true;
}

}  // namespace temblor::player
