#include "scripted_player/decisions/walker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace temblor::player {
namespace {

constexpr float kRunSpeed = 400;
constexpr float kGravity = 800;
constexpr float kArrived_units = 26, kArrivedHeight_units = 40;
constexpr float kLost_units = 90;
constexpr std::size_t kLookAhead = 14;
constexpr float kLookAhead_units = 160;
constexpr double kStuck_s = 0.9, kWriggle_s = 0.35;
constexpr float kStuck_units = 14;
constexpr int kMaxStuck = 4;
constexpr double kMaxWay_s = 8, kMaxWait_s = 40, kPatience_s = 5;
constexpr float kRunUp_units = 88;
constexpr float kAirBrake = 5;  // a tick takes 10/72 of the wish

float level_distance(const math::Vec3& a, const math::Vec3& b) {
  return glm::length(math::Vec2(a - b));
}

math::Vec3 level_direction(const math::Vec3& from, const math::Vec3& to) {
  const float distance = level_distance(from, to);
  return distance > 0 ? math::Vec3((to.x - from.x) / distance, (to.y - from.y) / distance, 0)
                      : math::Vec3(0.0f);
}

// The wish that brings a walker's velocity to `wanted`, sideways drift included.
math::Vec3 wish_for(const math::Vec3& wanted, const math::Vec3& velocity) {
  math::Vec3 wish = wanted + (wanted - velocity) * 0.4f;
  wish.z = wanted.z;
  const float length = glm::length(wish);
  return length > kRunSpeed ? wish * (kRunSpeed / length) : wish;
}

// Slower near a place where he wants to stand still.
math::Vec3 velocity_to_stand_at(const Self& self, const math::Vec3& at) {
  const float distance = level_distance(self.origin, at);
  return level_direction(self.origin, at) * std::min(kRunSpeed, distance * 6);
}

}  // namespace

void Walker::follow(Route route, double now_s) {
  route_ = std::move(route);
  index_ = 0;
  stuck_ = 0;
  pass(now_s);
}

void Walker::pass(double now_s) {
  passed_s_ = now_s;
  watched_since_s_ = now_s;
  was_in_air_ = false;
  charges_ = false;
  run_up_.reset();
}

std::string Walker::describe() const {
  if (!route_ || index_ >= route_->ways.size()) return "stands";
  static constexpr std::array<const char*, 9> kNames = {
      "walks", "swims", "drops", "hops", "jumps", "climbs out", "rides", "teleports", "is thrown"};
  const math::Vec3 from = graph_->place(route_->places[index_]).at;
  const math::Vec3 to = graph_->place(route_->places[index_ + 1]).at;
  const Way& way = route_->ways[index_];
  std::string text =
      fmt::format("{} from {:.0f} {:.0f} {:.0f} to {:.0f} {:.0f} {:.0f}",
                  kNames[static_cast<std::size_t>(way.kind)], from.x, from.y, from.z, to.x, to.y, to.z);
  for (const Demand& demand : way.demands)
    if (demand.mover >= 0 && !movers_->is_in(demand.mover, demand.states))
      text += fmt::format(", waits for {}",
                          space_->facts().movers[static_cast<std::size_t>(demand.mover)].describe);
  return text;
}

bool Walker::is_plain(std::size_t way) const {
  return route_->ways[way].kind == WayKind::kWalk || route_->ways[way].kind == WayKind::kSwim;
}

bool Walker::is_ready(const Way& way) const {
  return std::all_of(way.demands.begin(), way.demands.end(), [&](const Demand& demand) {
    return demand.mover < 0 || movers_->is_in(demand.mover, demand.states);
  });
}

// Doors are walked at; lifts and trains have to come first.
bool Walker::waits_for_mover(const Way& way) const {
  return std::any_of(way.demands.begin(), way.demands.end(), [&](const Demand& demand) {
    if (demand.mover < 0 || movers_->is_in(demand.mover, demand.states)) return false;
    // What only passes by may be held up by himself.
    if (is_impatient_ && graph_->place(way.to).mover != demand.mover) return false;
    const Mover& mover = space_->facts().movers[static_cast<std::size_t>(demand.mover)];
    // A door that shall be shut has to shut by itself, too.
    return mover.kind == MoverKind::kLift || mover.kind == MoverKind::kTrain || (demand.states & 1) != 0 ||
           !(mover.opens_by_itself || mover.key != 0);
  });
}

WalkEnd Walker::lose(float blame) {
  if (blame > 0 && index_ < route_->ways.size())
    router_->blame(route_->places[index_], route_->places[index_ + 1], blame);
  route_.reset();
  return WalkEnd::kLost;
}

// Over plain ways, to the one that he is nearest to.
void Walker::advance(const Self& self, double now_s) {
  std::size_t best = index_;
  float best_distance = kArrived_units;
  for (std::size_t i = index_ + 1; i <= std::min(index_ + kLookAhead, route_->ways.size()); ++i) {
    // Under a lift that is elsewhere he has not stepped onto it.
    if (!is_plain(i - 1) || waits_for_mover(route_->ways[i - 1])) break;
    const Place& place = graph_->place(route_->places[i]);
    if (std::abs(place.at.z - self.origin.z) > kArrivedHeight_units) continue;
    const float distance = level_distance(place.at, self.origin);
    if (distance < best_distance) {
      best_distance = distance;
      best = i;
    }
  }
  if (best == index_) return;
  index_ = best;
  pass(now_s);
}

// Whether the special way that he is on is behind him.
bool Walker::is_past(const Self& self) {
  const Way& way = route_->ways[index_];
  const Place& next = graph_->place(way.to);
  const float distance = level_distance(next.at, self.origin);
  const float height = std::abs(next.at.z - self.origin.z);
  if (way.kind == WayKind::kRide) return movers_->is_in(next.mover, 1u << next.state) && height < 24;
  if (way.kind == WayKind::kTeleport) return distance < 72 && height < 72;
  if (!self.on_ground && !self.swims()) was_in_air_ = true;
  const bool has_landed = (self.on_ground || self.swims()) && (was_in_air_ || distance < 12);
  return has_landed && distance < 40 && height < 28;
}

WalkEnd Walker::walk(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if (!route_) return WalkEnd::kLost;
  is_impatient_ = now_s - passed_s_ > kPatience_s;
  if (index_ < route_->ways.size() && is_plain(index_)) advance(self, now_s);
  while (index_ < route_->ways.size() && !is_plain(index_) && is_past(self)) {
    ++index_;
    pass(now_s);
  }
  const math::Vec3 here = graph_->place(route_->places[index_]).at;
  if (index_ == route_->ways.size()) {
    const bool is_there = level_distance(here, self.origin) < 10 && std::abs(here.z - self.origin.z) < 32;
    out.velocity = velocity_to_stand_at(self, here);
    out.look_at = self.eye() + level_direction(self.origin, here) * 100.0f;
    if (is_there) return WalkEnd::kArrived;
    if (!is_stuck(self, now_s, false)) return WalkEnd::kGoing;
    if (index_ > 0) router_->blame(route_->places[index_ - 1], route_->places[index_], 600);
    return lose(0);
  }
  const Way& way = route_->ways[index_];
  const bool waits = way.kind == WayKind::kRide || waits_for_mover(way);
  const math::Vec3 next = graph_->place(way.to).at;
  const bool is_in_air = !self.on_ground && !self.swims();
  if (is_plain(index_) && !is_in_air &&
      std::min(level_distance(here, self.origin), level_distance(next, self.origin)) > kLost_units)
    return lose(0);
  if (!is_plain(index_) && was_in_air_ && !is_in_air && way.kind != WayKind::kRide &&
      way.kind != WayKind::kClimbOut)
    return lose(way.kind == WayKind::kJump || way.kind == WayKind::kHop ? 1500.0f : 300.0f);
  // Rides need their mover.
  if (way.kind == WayKind::kRide && has_gone_without(graph_->place(route_->places[index_]))) return lose(0);
  if (now_s - passed_s_ > (waits ? kMaxWait_s : kMaxWay_s)) return lose(3000);

  if (is_plain(index_))
    steer_plain(io_game, self, out);
  else
    steer_special(io_game, self, out);
  if (now_s < wriggles_until_s_) {
    out.velocity = wriggle_;
    out.jumps = true;
    return WalkEnd::kGoing;
  }
  if (is_stuck(self, now_s, waits)) {
    if (++stuck_ >= kMaxStuck) return lose(600);
    wriggles_until_s_ = now_s + kWriggle_s;
    const float turn = dice_->between(-2.0f, 2.0f);
    const math::Vec3 ahead = level_direction(self.origin, next) * kRunSpeed;
    wriggle_ = {ahead.x * std::cos(turn) - ahead.y * std::sin(turn),
                ahead.x * std::sin(turn) + ahead.y * std::cos(turn), 100};
  }
  return WalkEnd::kGoing;
}

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

// The mover stands, and elsewhere than where the ride begins; it may wait at the ride's end for a moment.
bool Walker::has_gone_without(const Place& from) const {
  return from.mover >= 0 && !movers_->is_moving(from.mover) && movers_->state(from.mover) >= 0 &&
         movers_->state(from.mover) != from.state;
}

void Walker::steer_plain(server::Game& io_game, const Self& self, Steering& out) {
  const Way& way = route_->ways[index_];
  const math::Vec3 here = graph_->place(route_->places[index_]).at;
  if (waits_for_mover(way)) {
    out.velocity = wish_for(velocity_to_stand_at(self, here), self.velocity);
    out.look_at = graph_->place(way.to).at + kEyeHeight;
    return;
  }
  // The farthest place ahead that can be walked at straight on.
  std::size_t last = index_ + 1;
  while (last < route_->ways.size() && last < index_ + kLookAhead && is_plain(last) &&
         is_ready(route_->ways[last]) &&
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
  math::Vec3 wanted = level_direction(self.origin, target) * kRunSpeed;
  // A special way from there is begun carefully.
  if (last < route_->ways.size() && !is_plain(last) && route_->ways[last].kind != WayKind::kDrop) {
    const math::Vec3 edge = graph_->place(route_->places[last]).at;
    if (level_distance(edge, self.origin) < 48 && route_->ways[last].kind != WayKind::kJump) wanted *= 0.6f;
  }
  if (self.swims()) {
    const math::Vec3 ahead = target - self.origin;
    wanted = ahead * (kRunSpeed / std::max(glm::length(ahead), 1.0f));
  }
  out.velocity = wish_for(wanted, self.velocity);
  if (!self.on_ground && !self.swims()) steer_in_air(self, target, out);
  const std::size_t far = std::min(index_ + 10, route_->ways.size());
  out.look_at = graph_->place(route_->places[far]).at + kEyeHeight;
}

void Walker::steer_special(server::Game& io_game, const Self& self, Steering& out) {
  const Way& way = route_->ways[index_];
  const math::Vec3 here = graph_->place(route_->places[index_]).at;
  const math::Vec3 next = graph_->place(way.to).at;
  out.is_free = false;
  out.look_at = next + kEyeHeight;
  if (way.kind == WayKind::kRide) return steer_ride(self, way, out);
  if (way.kind != WayKind::kDrop && !self.on_ground && !self.swims() && was_in_air_ &&
      way.kind != WayKind::kClimbOut)
    return steer_in_air(self, next, out);
  if (waits_for_mover(way) && self.on_ground) {
    out.is_free = true;
    out.velocity = wish_for(velocity_to_stand_at(self, here), self.velocity);
    return;
  }
  switch (way.kind) {
    case WayKind::kJump:
      return steer_jump(io_game, self, way, out);
    case WayKind::kHop:
      out.velocity = level_direction(here, next) * kRunSpeed;
      // From close by, or where it stops him.
      out.jumps = self.on_ground &&
                  (level_distance(self.origin, here) < 14 || glm::length(math::Vec2(self.velocity)) < 40);
      return;
    case WayKind::kDrop: {
      if (!self.on_ground) return steer_in_air(self, next, out);
      math::Vec3 direction = level_direction(self.origin, next);
      if (direction == math::Vec3(0.0f)) direction = level_direction(here, next);
      out.velocity = wish_for(direction * 220.0f, self.velocity);
      return;
    }
    case WayKind::kClimbOut:
      // Up where he is, then over the edge, which may hang over the water.
      if (self.swims() && self.water_level == 3) {
        out.velocity = velocity_to_stand_at(self, here) * 0.5f;
        out.velocity.z = 300;
      } else {
        out.velocity = level_direction(self.origin, next) * kRunSpeed;
        out.velocity.z = 60;
      }
      out.look_at.z = self.eye().z;
      return;
    default:
      out.velocity = velocity_to_stand_at(self, here);
      return;
  }
}

// Keeps to the middle of what it stands on: there lifts feel him.
void Walker::steer_ride(const Self& self, const Way& way, Steering& out) {
  const Place& next = graph_->place(way.to);
  const MoverPart& part = space_->facts().movers[static_cast<std::size_t>(next.mover)].parts[0];
  const math::Vec3 middle = middle_of(part.box) + movers_->origin(next.mover);
  out.look_at = self.eye() + level_direction(self.origin, next.at) * 64.0f;
  if (!movers_->is_moving(next.mover))
    out.velocity = wish_for(velocity_to_stand_at(self, middle) * 0.5f, self.velocity);
}

void Walker::steer_in_air(const Self& self, const math::Vec3& landing, Steering& out) const {
  const float height = self.origin.z - landing.z;
  const float root = self.velocity.z * self.velocity.z + 2 * kGravity * height;
  const float left_s = root > 0 ? std::max((self.velocity.z + std::sqrt(root)) / kGravity, 0.05f) : 0.05f;
  const math::Vec3 wanted = level_direction(self.origin, landing) *
                            std::min(level_distance(self.origin, landing) / left_s, kRunSpeed);
  const math::Vec3 change(wanted.x - self.velocity.x, wanted.y - self.velocity.y, 0);
  const float length = glm::length(change);
  // What is braked too hard in the air cannot be had again: just as much as is too fast goes in a tick.
  out.velocity = length > 8 ? change * (std::min(kRunSpeed, length * kAirBrake) / length) : math::Vec3(0.0f);
}

void Walker::steer_jump(server::Game& io_game, const Self& self, const Way& way, Steering& out) {
  const math::Vec3 edge = graph_->place(route_->places[index_]).at;
  const math::Vec3 landing = graph_->place(way.to).at;
  const math::Vec3 direction = level_direction(edge, landing);
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
  if (!charges_) {
    const bool is_back = level_distance(self.origin, *run_up_) < 16;
    if (!is_back && !(speed > way.speed * 0.9f && along < 0)) {
      out.velocity = wish_for(velocity_to_stand_at(self, *run_up_), self.velocity);
      return;
    }
    charges_ = true;
  }
  // Along the line of the jump.
  const math::Vec3 drift = (edge + direction * along) - self.origin;
  math::Vec3 wanted = direction * (way.speed + 20) + math::Vec3(drift.x, drift.y, 0) * 6.0f;
  out.velocity = wish_for(wanted, self.velocity);
  if (self.on_ground && along > -6) out.jumps = true;
  if (!self.on_ground) steer_in_air(self, landing, out);
}

}  // namespace temblor::player
