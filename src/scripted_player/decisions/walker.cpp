#include "scripted_player/decisions/walker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scripted_player/decisions/lift_wait.h"

namespace temblor::player {
namespace {

// The wish speed of a running client; the server limits the actual speed to 320 units/s.
constexpr float kRunSpeed = 400;
constexpr float kWalkGravity = 800;
// Within this distance a place of a plain link counts as passed.
constexpr float kArrived_units = 26, kArrivedHeight_units = 40;
// Farther than this from both ends of a plain link, the player is off the route.
constexpr float kLost_units = 90;
// How many links, and how far, the player looks ahead for a straight line.
constexpr std::size_t kLookAhead = 14;
constexpr float kLookAhead_units = 160;
// A player that stays within kStuck_units for kStuck_s is stuck. It then moves in a random direction for
// kWriggle_s, at most kMaxStuck - 1 times.
constexpr double kStuck_s = 0.9, kWriggle_s = 0.35;
constexpr float kStuck_units = 14;
constexpr int kMaxStuck = 4;
constexpr int kMaxStepsBack = 30;  // of a route
// Limits for a link without and with a wait for a mover.
constexpr double kMaxWay_s = 8, kMaxWait_s = 40, kPatience_s = 5;
constexpr float kRunUp_units = 88;
// Air acceleration changes velocity by 10/72 of the wish per tick.
constexpr float kAirBrake = 5;

float horizontal_distance(const math::Vec3& a, const math::Vec3& b) {
  return glm::length(math::Vec2(a - b));
}

math::Vec3 horizontal_direction(const math::Vec3& from, const math::Vec3& to) {
  const float distance = horizontal_distance(from, to);
  return distance > 0 ? math::Vec3((to.x - from.x) / distance, (to.y - from.y) / distance, 0)
                      : math::Vec3(0.0f);
}

// Returns the wish velocity that brings the walker's velocity to `wanted` and corrects sideways drift.
math::Vec3 compute_wish(const math::Vec3& wanted, const math::Vec3& velocity) {
  math::Vec3 wish = wanted + (wanted - velocity) * 0.4f;
  wish.z = wanted.z;
  const float length = glm::length(wish);
  return length > kRunSpeed ? wish * (kRunSpeed / length) : wish;
}

// Returns a velocity to stop at a place: slower the nearer it is.
math::Vec3 velocity_to_stand_at(const Self& self, const math::Vec3& at) {
  const float distance = horizontal_distance(self.origin, at);
  return horizontal_direction(self.origin, at) * std::min(kRunSpeed, distance * 6);
}

}  // namespace

void Walker::follow(Route route, double now_s) {
  steps_back_ = 0;
  route_ = std::move(route);
  index_ = 0;
  stuck_ = 0;
  start_link(now_s);
}

void Walker::start_link(double now_s) {
  passed_s_ = now_s;
  watched_since_s_ = now_s;
  was_in_air_ = false;
  is_running_up_ = false;
  run_up_.reset();
}

std::string Walker::describe() const {
  if (!route_ || index_ >= route_->links.size()) return "stands";
  static constexpr std::array<const char*, 9> kNames = {
      "walks", "swims", "drops", "hops", "jumps", "climbs out", "rides", "teleports", "is thrown"};
  const math::Vec3 from = graph_->place(route_->places[index_]).at;
  const math::Vec3 to = graph_->place(route_->places[index_ + 1]).at;
  const Link& link = route_->links[index_];
  std::string text =
      fmt::format("{} from {:.0f} {:.0f} {:.0f} to {:.0f} {:.0f} {:.0f}",
                  kNames[static_cast<std::size_t>(link.kind)], from.x, from.y, from.z, to.x, to.y, to.z);
  for (const MoverCondition& condition : link.conditions)
    if (condition.mover >= 0 && !movers_->is_in(condition.mover, condition.states))
      text += fmt::format(", waits for {}",
                          space_->facts().movers[static_cast<std::size_t>(condition.mover)].description);
  return text;
}

bool Walker::is_plain(std::size_t link) const {
  return route_->links[link].kind == LinkKind::kWalk || route_->links[link].kind == LinkKind::kSwim;
}

bool Walker::is_ready(const Link& link) const {
  return std::all_of(link.conditions.begin(), link.conditions.end(), [&](const MoverCondition& condition) {
    return condition.mover < 0 || movers_->is_in(condition.mover, condition.states);
  });
}

// Returns whether to stand still until a mover arrives: for lifts and trains, and for doors that do not open
// on touch.
bool Walker::waits_for_mover(const Link& link) const {
  return std::any_of(link.conditions.begin(), link.conditions.end(), [&](const MoverCondition& condition) {
    if (condition.mover < 0 || movers_->is_in(condition.mover, condition.states)) return false;
    // After some time, ignore movers that are only near the link: the player himself may be blocking them.
    if (is_impatient_ && graph_->place(link.to).mover != condition.mover) return false;
    const Mover& mover = space_->facts().movers[static_cast<std::size_t>(condition.mover)];
    // A door that must be closed (state 0) closes automatically, so wait for that, too.
    return mover.kind == MoverKind::kLift || mover.kind == MoverKind::kTrain || (condition.states & 1) != 0 ||
           !(mover.opens_automatically || mover.key != 0);
  });
}

// Returns whether a train on which the link depends passes through the place on its way between two
// of its states.
bool Walker::is_in_way(const Link& link, const math::Vec3& at) const {
  // Half the player's width and some space to stop.
  constexpr math::Vec3 kBelow(28, 28, 32), kAbove(28, 28, 24);
  for (const MoverCondition& condition : link.conditions) {
    if (condition.mover < 0) continue;
    const Mover& mover = space_->facts().movers[static_cast<std::size_t>(condition.mover)];
    if (mover.kind != MoverKind::kTrain) continue;  // lifts turn back when they meet a player
    for (const MoverPart& part : mover.parts)
      for (std::size_t i = 0; i < part.places.size(); ++i) {
        const math::Vec3& from = part.places[i];
        const math::Vec3& to = part.places[(i + 1) % part.places.size()];
        if (boxes_overlap(
                {part.box.mins + glm::min(from, to) - kBelow, part.box.maxs + glm::max(from, to) + kAbove},
                {at, at}))
          return true;
      }
  }
  return false;
}

// Returns the number of places along the route to the nearest one out of the way of the movers, negative:
// back. 0: the player is not in their way, or there is no such place.
int Walker::count_steps_out_of_way(const Self& self, const Link& link) const {
  constexpr int kMaxSteps = 40;
  if (!is_in_way(link, self.origin)) return 0;
  const int index = static_cast<int>(index_), last = static_cast<int>(route_->links.size());
  bool can_go_on = true, can_go_back = true;
  for (int steps = 1; steps <= kMaxSteps; ++steps) {
    can_go_on = can_go_on && index + steps <= last && is_plain(static_cast<std::size_t>(index + steps - 1));
    can_go_back = can_go_back && index - steps >= 0 && is_plain(static_cast<std::size_t>(index - steps));
    const auto is_out = [&](int i) {
      return !is_in_way(link, graph_->place(route_->places[static_cast<std::size_t>(i)]).at);
    };
    if (can_go_on && is_out(index + steps)) return steps;
    if (can_go_back && is_out(index - steps)) return -steps;
  }
  return 0;
}

WalkResult Walker::give_up_route(float penalize_link) {
  if (penalize_link > 0 && index_ < route_->links.size())
    router_->penalize_link(route_->places[index_], route_->places[index_ + 1], penalize_link);
  route_.reset();
  return WalkResult::kLost;
}

// Skips plain links: continues from the nearest of the next places.
void Walker::advance(const Self& self, double now_s) {
  std::size_t best = index_;
  float best_distance = kArrived_units;
  for (std::size_t i = index_ + 1; i <= std::min(index_ + kLookAhead, route_->links.size()); ++i) {
    // Below a lift that is at another floor, the player is near the place on it but has not stepped onto it.
    if (!is_plain(i - 1) || waits_for_mover(route_->links[i - 1])) break;
    const Place& place = graph_->place(route_->places[i]);
    if (std::abs(place.at.z - self.origin.z) > kArrivedHeight_units) continue;
    const float distance = horizontal_distance(place.at, self.origin);
    if (distance < best_distance) {
      best_distance = distance;
      best = i;
    }
  }
  if (best == index_) return;
  index_ = best;
  start_link(now_s);
}

// Returns whether the current special link is done.
bool Walker::has_finished_link(const Self& self) {
  const Link& link = route_->links[index_];
  const Place& next = graph_->place(link.to);
  const float distance = horizontal_distance(next.at, self.origin);
  const float height = std::abs(next.at.z - self.origin.z);
  if (link.kind == LinkKind::kRide) return movers_->is_in(next.mover, 1u << next.state) && height < 24;
  if (link.kind == LinkKind::kTeleport) return distance < 72 && height < 72;
  if (!self.on_ground && !self.swims()) was_in_air_ = true;
  const bool has_landed = (self.on_ground || self.swims()) && (was_in_air_ || distance < 12);
  return has_landed && distance < 40 && height < 28;
}

// In order: note which links have been passed, stop at the end, give up if the link fails, steer, and get
// unstuck. The penalties are in units of walking: jumps that miss cost most, because they often end far from
// the route.
WalkResult Walker::walk(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if (!route_) return WalkResult::kLost;
  is_impatient_ = now_s - passed_s_ > kPatience_s;
  if (index_ < route_->links.size() && is_plain(index_)) advance(self, now_s);
  while (index_ < route_->links.size() && !is_plain(index_) && has_finished_link(self)) {
    ++index_;
    start_link(now_s);
  }
  const math::Vec3 here = graph_->place(route_->places[index_]).at;
  if (index_ == route_->links.size()) {
    const bool is_there =
        horizontal_distance(here, self.origin) < 10 && std::abs(here.z - self.origin.z) < 32;
    out.velocity = velocity_to_stand_at(self, here);
    out.look_at = self.eye() + horizontal_direction(self.origin, here) * 100.0f;
    if (is_there) return WalkResult::kArrived;
    if (!is_stuck(self, now_s, false)) return WalkResult::kGoing;
    if (index_ > 0) router_->penalize_link(route_->places[index_ - 1], route_->places[index_], 600);
    return give_up_route(0);
  }
  const Link& link = route_->links[index_];
  const bool waits = link.kind == LinkKind::kRide || waits_for_mover(link);
  const math::Vec3 next = graph_->place(link.to).at;
  const bool is_in_air = !self.on_ground && !self.swims();
  if (is_plain(index_) && !is_in_air &&
      std::min(horizontal_distance(here, self.origin), horizontal_distance(next, self.origin)) > kLost_units)
    return give_up_route(0);
  if (!is_plain(index_) && was_in_air_ && !is_in_air && link.kind != LinkKind::kRide &&
      link.kind != LinkKind::kClimbOut)
    return give_up_route(link.kind == LinkKind::kJump || link.kind == LinkKind::kHop ? 1500.0f : 300.0f);
  // The lift or train has left without the player.
  if (link.kind == LinkKind::kRide && missed_ride(graph_->place(route_->places[index_])))
    return give_up_route(0);
  if (now_s - passed_s_ > (waits ? kMaxWait_s : kMaxWay_s)) return give_up_route(3000);

  if (is_plain(index_))
    steer_plain(io_game, self, out);
  else
    steer_special(io_game, self, out);
  if (now_s < wriggles_until_s_) {
    out.velocity = wriggle_;
    out.jumps = true;
    return WalkResult::kGoing;
  }
  if (is_stuck(self, now_s, waits)) {
    if (++stuck_ >= kMaxStuck) return give_up_route(600);
    wriggles_until_s_ = now_s + kWriggle_s;
    const float turn = dice_->between(-2.0f, 2.0f);
    const math::Vec3 ahead = horizontal_direction(self.origin, next) * kRunSpeed;
    wriggle_ = {ahead.x * std::cos(turn) - ahead.y * std::sin(turn),
                ahead.x * std::sin(turn) + ahead.y * std::cos(turn), 100};
  }
  return WalkResult::kGoing;
}

// Restarts the watch after each report, so the next one comes kStuck_s later.
bool Walker::is_stuck(const Self& self, double now_s, bool waits) {
  if (waits || glm::distance(self.origin, watched_from_) > kStuck_units) {
    watched_from_ = self.origin;
    watched_since_s_ = now_s;
    return false;
  }
  if (now_s - watched_since_s_ < kStuck_s) return false;
  watched_since_s_ = now_s;
  return true;
}

// Returns whether the mover stands still, but not where the ride begins.
bool Walker::missed_ride(const Place& from) const {
  return from.mover >= 0 && !movers_->is_moving(from.mover) && movers_->state(from.mover) >= 0 &&
         movers_->state(from.mover) != from.state;
}

// Waits in front of a mover, and goes back if it is coming. After some time, leaves the place below a lift.
void Walker::wait_for_mover(const Self& self, const Link& link, bool goes_back, Steering& out) {
  const math::Vec3 here = graph_->place(route_->places[index_]).at;
  out.look_at = graph_->place(link.to).at + kEyeHeight;
  if (!goes_back) {
    std::optional<math::Vec3> beside;
    if (is_impatient_)
      beside = find_place_beside_lift(*graph_, space_->facts(), *movers_, link, route_->places[index_]);
    out.velocity = compute_wish(velocity_to_stand_at(self, beside.value_or(here)), self.velocity);
    return;
  }
  const math::Vec3 back = graph_->place(route_->places[index_ - 1]).at;
  out.velocity = compute_wish(horizontal_direction(self.origin, back) * kRunSpeed, self.velocity);
  if (horizontal_distance(self.origin, back) >= 16) return;
  --index_;
  ++steps_back_;
}

// Waits for a mover unless the way on is the shortest out of its way, or heads for the farthest place ahead
// in a straight line. The view looks up to ten places ahead, as people look where they go.
void Walker::steer_plain(server::Game& io_game, const Self& self, Steering& out) {
  const Link& link = route_->links[index_];
  const bool waits = waits_for_mover(link);
  const int steps_out = waits && steps_back_ < kMaxStepsBack ? count_steps_out_of_way(self, link) : 0;
  if (waits && steps_out <= 0) return wait_for_mover(self, link, steps_out < 0, out);
  // Head for the farthest place ahead that can be reached in a straight line.
  std::size_t last = index_ + 1;
  while (last < route_->links.size() && last < index_ + kLookAhead && is_plain(last) &&
         is_ready(route_->links[last]) &&
         glm::distance(graph_->place(route_->places[last + 1]).at, self.origin) < kLookAhead_units)
    ++last;
  math::Vec3 target = graph_->place(route_->places[index_ + 1]).at;
  for (std::size_t i = last; i > index_ + 1; i -= std::max<std::size_t>(1, (i - index_) / 3)) {
    const Place& place = graph_->place(route_->places[i]);
    const bool can = self.swims() ? can_swim(io_game.world(), self.entity, self.origin, place.at)
                                  : can_walk(io_game.world(), self.entity, self.origin, place.at);
    if (!can) continue;
    target = place.at;
    break;
  }
  math::Vec3 wanted = horizontal_direction(self.origin, target) * kRunSpeed;
  // Approach the start of a special link slowly, so as not to overshoot it.
  if (last < route_->links.size() && !is_plain(last) && route_->links[last].kind != LinkKind::kDrop) {
    const math::Vec3 edge = graph_->place(route_->places[last]).at;
    if (horizontal_distance(edge, self.origin) < 48 && route_->links[last].kind != LinkKind::kJump)
      wanted *= 0.6f;
  }
  if (self.swims()) {
    const math::Vec3 ahead = target - self.origin;
    wanted = ahead * (kRunSpeed / std::max(glm::length(ahead), 1.0f));
  }
  out.velocity = compute_wish(wanted, self.velocity);
  if (!self.on_ground && !self.swims()) steer_in_air(self, target, out);
  const std::size_t far = std::min(index_ + 10, route_->links.size());
  out.look_at = graph_->place(route_->places[far]).at + kEyeHeight;
}

// In the air, all kinds aim for the landing. On the ground, each kind approaches its takeoff in its own way.
void Walker::steer_special(server::Game& io_game, const Self& self, Steering& out) {
  const Link& link = route_->links[index_];
  const math::Vec3 here = graph_->place(route_->places[index_]).at;
  const math::Vec3 next = graph_->place(link.to).at;
  out.is_free = false;
  out.look_at = next + kEyeHeight;
  if (link.kind == LinkKind::kRide) return steer_ride(self, link, out);
  if (link.kind != LinkKind::kDrop && !self.on_ground && !self.swims() && was_in_air_ &&
      link.kind != LinkKind::kClimbOut)
    return steer_in_air(self, next, out);
  if (waits_for_mover(link) && self.on_ground) {
    out.is_free = true;
    out.velocity = compute_wish(velocity_to_stand_at(self, here), self.velocity);
    return;
  }
  switch (link.kind) {
    case LinkKind::kJump:
      return steer_jump(io_game, self, link, out);
    case LinkKind::kHop:
      out.velocity = horizontal_direction(here, next) * kRunSpeed;
      // Jump when close to the obstacle, or when it has stopped the player.
      out.jumps = self.on_ground && (horizontal_distance(self.origin, here) < 14 ||
                                     glm::length(math::Vec2(self.velocity)) < 40);
      return;
    case LinkKind::kDrop: {
      if (!self.on_ground) return steer_in_air(self, next, out);
      math::Vec3 direction = horizontal_direction(self.origin, next);
      if (direction == math::Vec3(0.0f)) direction = horizontal_direction(here, next);
      out.velocity = compute_wish(direction * 220.0f, self.velocity);
      return;
    }
    case LinkKind::kClimbOut:
      // Rise to the surface first, then move over the edge, which may overhang the water.
      if (self.swims() && self.water_level == 3) {
        out.velocity = velocity_to_stand_at(self, here) * 0.5f;
        out.velocity.z = 300;
      } else {
        out.velocity = horizontal_direction(self.origin, next) * kRunSpeed;
        out.velocity.z = 60;
      }
      out.look_at.z = self.eye().z;
      return;
    default:
      out.velocity = velocity_to_stand_at(self, here);
      return;
  }
}

// Stays in the middle of the lift or train, because the trigger of a lift covers only its middle.
void Walker::steer_ride(const Self& self, const Link& link, Steering& out) {
  const Place& next = graph_->place(link.to);
  const MoverPart& part = space_->facts().movers[static_cast<std::size_t>(next.mover)].parts[0];
  const math::Vec3 middle = box_center(part.box) + movers_->origin(next.mover);
  out.look_at = self.eye() + horizontal_direction(self.origin, next.at) * 64.0f;
  if (!movers_->is_moving(next.mover))
    out.velocity = compute_wish(velocity_to_stand_at(self, middle) * 0.5f, self.velocity);
}

// Solves for the time until the player falls to the height of the landing: h + v t - g t^2 / 2 = 0, with h
// the height above it. The wanted speed covers the remaining distance in that time.
void Walker::steer_in_air(const Self& self, const math::Vec3& landing, Steering& out) const {
  const float height = self.origin.z - landing.z;
  const float root = self.velocity.z * self.velocity.z + 2 * kWalkGravity * height;
  const float left_s = root > 0 ? std::max((self.velocity.z + std::sqrt(root)) / kWalkGravity, 0.05f) : 0.05f;
  const math::Vec3 wanted = horizontal_direction(self.origin, landing) *
                            std::min(horizontal_distance(self.origin, landing) / left_s, kRunSpeed);
  const math::Vec3 change(wanted.x - self.velocity.x, wanted.y - self.velocity.y, 0);
  const float length = glm::length(change);
  // Speed lost in the air cannot be regained, so correct only the difference, spread over the next ticks.
  out.velocity = length > 8 ? change * (std::min(kRunSpeed, length * kAirBrake) / length) : math::Vec3(0.0f);
}

// Walks back from the edge as far as the floor allows, runs up along the line of the jump, and jumps at the
// edge:
//
//   run_up_ ----- up to 88 units -----> edge ~~~~~~ gap ~~~~~~> landing
void Walker::steer_jump(server::Game& io_game, const Self& self, const Link& link, Steering& out) {
  const math::Vec3 edge = graph_->place(route_->places[index_]).at;
  const math::Vec3 landing = graph_->place(link.to).at;
  const math::Vec3 direction = horizontal_direction(edge, landing);
  if (!run_up_) {
    run_up_ = edge;
    for (float back = 24; back <= kRunUp_units; back += 16) {
      const math::Vec3 from = edge - direction * back;
      if (!can_walk(io_game.world(), self.entity, edge, from)) break;
      run_up_ = from;
    }
  }
  const float along = glm::dot(self.origin - edge, direction);
  const float speed = glm::dot(self.velocity, direction);
  if (!is_running_up_) {
    const bool is_back = horizontal_distance(self.origin, *run_up_) < 16;
    if (!is_back && !(speed > link.speed * 0.9f && along < 0)) {
      out.velocity = compute_wish(velocity_to_stand_at(self, *run_up_), self.velocity);
      return;
    }
    is_running_up_ = true;
  }
  // Run along the line of the jump and correct sideways drift.
  const math::Vec3 drift = (edge + direction * along) - self.origin;
  math::Vec3 wanted = direction * (link.speed + 20) + math::Vec3(drift.x, drift.y, 0) * 6.0f;
  out.velocity = compute_wish(wanted, self.velocity);
  if (self.on_ground && along > -6) out.jumps = true;
  if (!self.on_ground) steer_in_air(self, landing, out);
}

}  // namespace temblor::player
