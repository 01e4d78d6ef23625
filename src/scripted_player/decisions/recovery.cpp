// Recovery when no place of the graph is near: an explosion has thrown the player onto a ledge that no route
// leads to, or it has landed on a monster's head, which is no floor, so that it slides off slowly. It walks
// in random directions until it is at a known place again.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scripted_player/decisions/brain.h"

namespace temblor::player {
namespace {

// A fall takes less than kLostAfter_s. Within kHeading_s, a player slides off the largest head, at 21
// units/s.
constexpr double kLostAfter_s = 2, kHeading_s = 2.5, kRestartAfter_s = 15;
constexpr float kPace_units_s = 200, kLook_units = 48;
constexpr int kTries = 8;

}  // namespace

void Brain::return_to_graph(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if ((self.on_ground || self.swims()) && nearest_place(self) >= 0) {
    lost_since_s_.reset();
    return;
  }
  if (!lost_since_s_) lost_since_s_ = now_s;
  if (now_s - *lost_since_s_ < kLostAfter_s) return;
  if (now_s - *lost_since_s_ > kRestartAfter_s) {
    lost_since_s_ = now_s;
    request_restart(self);
  }
  if (now_s > heading_until_s_) {
    heading_until_s_ = now_s + kHeading_s;
    heading_ = choose_heading(io_game, self);
  }
  out.velocity = heading_ * kPace_units_s;
  out.look_at = self.eye() + heading_ * 200.0f;
}

// Returns a random direction that does not lead into lava or slime; 0 if none was found.
math::Vec3 Brain::choose_heading(server::Game& io_game, const Self& self) {
  for (int i = 0; i < kTries; ++i) {
    const float angle = dice_.between(0, 2 * std::numbers::pi_v<float>);
    const math::Vec3 heading(std::cos(angle), std::sin(angle), 0);
    if (!leads_into_lava(io_game.world(), self.entity, self.origin, self.origin + heading * kLook_units))
      return heading;
  }
  return math::Vec3(0.0f);
}

// The link that failed last probably led here, so its penalty stays.
void Brain::request_restart(const Self& self) {
  if (dead_ends_ >= kMaxDeadEnds) return;
  ++dead_ends_;
  router_.keep_last_penalty();
  report_problem(fmt::format("dead end at {:.0f} {:.0f} {:.0f}; restarted the level", self.origin.x,
                             self.origin.y, self.origin.z));
  wants_restart_ = true;
}

}  // namespace temblor::player
