#include "scripted_player/navigation/flood.h"

#include <algorithm>
#include <cmath>

#include "movement/player.h"
#include "movement/settings.h"

namespace temblor::player {
namespace {

using movement::kFloorNormal;
using movement::kStepHeight;

constexpr float kJumpSpeed = 270, kJumpHeight = 45;
constexpr std::array<float, 3> kRunSpeeds = {300, 220, 140};
constexpr float kHopSpeed = 120;
constexpr float kMinJump_units = 40;
constexpr float kJumpGain_units = 24;  // a jump that ends no higher than a fall there is none
constexpr float kSwimStep_units = 24;
constexpr float kClimbOut_units = 50;
constexpr float kMinDive_units = 4;
constexpr float kSameFloor_units = 10, kSameDepth_units = 10;
constexpr float kDeep_units = 4096;
constexpr std::size_t kMaxAssignments = 24;
constexpr float kHarmlessFall_units = 256;
constexpr float kSlimePenalty = 40;
constexpr float kDeadlyJumpCost = 1500;  // over lava
constexpr float kShort_units = 64;       // a jump may be too short by so much, and too low

constexpr std::array<std::array<int, 2>, 8> kDirections = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

math::Vec3 level_direction(const math::Vec3& way) {
  const float length = glm::length(math::Vec2(way));
  return length > 0 ? math::Vec3(way.x / length, way.y / length, 0) : math::Vec3(0.0f);
}

math::Bounds around(const math::Vec3& at, float side, float below, float above) {
  return {at - math::Vec3(side, side, below), at + math::Vec3(side, side, above)};
}

}  // namespace

void Flood::run(std::span<const math::Vec3> starts) {
  for (const math::Vec3& start : starts) {
    with_movers({}, around(start, 0, kDeep_units, 8));
    std::vector<Found> found;
    Place place;
    place.at = start;
    for (const auto& movers : assignments_) try_throw(place, {0, 0, 0}, movers, found);
    for (const Found& one : found) add_place(one.at, one.mover, one.state, one.swims);
  }
  while (!open_.empty()) {
    const std::uint32_t next = open_.front();
    open_.pop_front();
    expand(next);
  }
  prefer_open_ground();
}

math::Vec3 Flood::neighbor(const math::Vec3& at, int dx, int dy) const {
  const auto middle = [](float x, int d) {
    return (std::floor(x / kCell_units) + static_cast<float>(d) + 0.5f) * kCell_units;
  };
  return {middle(at.x, dx), middle(at.y, dy), at.z};
}

void Flood::expand(std::uint32_t i) {
  const Place place = graph_.places_[i];
  if (place.is_end || pass_triggers(i, place)) return;
  if (place.mover >= 0) add_rides(i, place);
  for (const auto& [dx, dy] : kDirections) {
    const math::Vec3 to = neighbor(place.at, dx, dy);
    const math::Vec3 way = to - place.at;
    falls_ = is_blocked_ = false;
    fall_z_ = -kDeep_units;
    try_all(i, place, way, around(place.at, 28, 24, 24), &Flood::try_step);
    const math::Vec3 direction = level_direction(way);
    if (place.swims) {
      if (is_blocked_) try_all(i, place, direction, around(place.at, 48, 24, 80), &Flood::try_climb_out);
      continue;
    }
    if (is_blocked_) try_all(i, place, direction, around(place.at, 48, 24, 64), &Flood::try_hop);
    if (!falls_) continue;
    try_all(i, place, way, around(place.at, 32, kDeep_units, 24), &Flood::try_fall);
    for (const float turn : {-0.4f, 0.0f, 0.4f}) {
      const math::Vec3 turned(direction.x * std::cos(turn) - direction.y * std::sin(turn),
                              direction.x * std::sin(turn) + direction.y * std::cos(turn), 0);
      try_all(i, place, turned, around(place.at + turned * 120.0f, 150, 300, 60), &Flood::try_jump);
    }
  }
  if (place.swims)
    for (const float up : {-kSwimStep_units, kSwimStep_units})
      try_all(i, place, {0, 0, up}, around(place.at, 4, 28, 28), &Flood::try_step);
}

void Flood::with_movers(const Place& place, const math::Bounds& origins) {
  std::vector<int> near;
  space_.movers_near(origins, near);
  assignments_.assign(1, {});
  for (const int mover : near) {
    const int states = space_.facts().movers[static_cast<std::size_t>(mover)].states;
    std::vector<std::vector<MoverPlace>> next;
    for (const auto& assignment : assignments_)
      for (int state = 0; state < states; ++state) {
        if (mover == place.mover && state != place.state) continue;
        if (next.size() == kMaxAssignments) break;
        next.push_back(assignment);
        next.back().push_back({mover, state});
      }
    assignments_ = std::move(next);
  }
}

// Found in several assignments, it demands of a mover what all of them have.
void Flood::try_all(std::uint32_t i, const Place& place, const math::Vec3& direction,
                    const math::Bounds& origins, Try what) {
  with_movers(place, origins);
  std::vector<Found> found;
  for (const auto& movers : assignments_) {
    // He is not in the middle of something.
    if (!movers.empty() && !space_.is_free(place.at, movers)) continue;
    (this->*what)(place, direction, movers, found);
  }
  for (const Found& one : found) add_way(i, one);
}

void Flood::add_found(Found found, Movers movers, std::vector<Found>& io_found) const {
  for (const MoverPlace& near : movers) {
    if (near.mover == found.mover) found.state = near.state;
    found.demands.push_back({near.mover, 1u << near.state});
  }
  for (Found& known : io_found) {
    if (known.kind != found.kind || known.mover != found.mover || known.state != found.state ||
        known.demands.size() != found.demands.size() || glm::distance(known.at, found.at) > 4)
      continue;
    for (std::size_t d = 0; d < known.demands.size(); ++d) known.demands[d].states |= found.demands[d].states;
    return;
  }
  io_found.push_back(std::move(found));
}

Flood::Step Flood::step(const math::Vec3& from, const math::Vec3& to, bool swims, Movers movers) const {
  const Meeting across = space_.trace(from, to, movers);
  if (across.trace.start_solid) return {};
  math::Vec3 over = to;
  const math::Vec3& end = across.trace.end;
  const bool dives = swims && to.x == from.x && to.y == from.y;
  if (dives && std::abs(end.z - from.z) < kMinDive_units) return {};
  if (dives && space_.water_level(end) >= movement::kSwimmingLevel) return {Step::End::kSwims, end, -1};
  if (dives) return {};
  if (across.trace.fraction < 1) {
    const Meeting up = space_.trace(from, from + math::Vec3(0, 0, kStepHeight), movers);
    const Meeting on = space_.trace(up.trace.end, {to.x, to.y, up.trace.end.z}, movers);
    if (on.trace.fraction < 1) return {};
    over = on.trace.end;
  } else if (swims && space_.water_level(to) >= movement::kSwimmingLevel) {
    return {space_.is_in_lava(to) ? Step::End::kBlocked : Step::End::kSwims, to, -1};
  }
  const Meeting down = space_.trace(over, {over.x, over.y, from.z - kStepHeight - 0.1f}, movers);
  const math::Vec3& at = down.trace.end;
  if (space_.is_in_lava(at)) return {};
  if (space_.water_level(at) >= movement::kSwimmingLevel) return {Step::End::kSwims, at, -1};
  if (down.trace.fraction == 1 || down.trace.plane_normal.z < kFloorNormal)
    return {swims ? Step::End::kBlocked : Step::End::kFalls, over, -1};
  return {Step::End::kStands, at, down.mover};
}

void Flood::try_step(const Place& place, const math::Vec3& way, Movers movers, std::vector<Found>& io_found) {
  const Step step = this->step(place.at, place.at + way, place.swims, movers);
  falls_ |= step.end == Step::End::kFalls;
  is_blocked_ |= step.end == Step::End::kBlocked;
  if (step.end != Step::End::kStands && step.end != Step::End::kSwims) return;
  const bool swims = step.end == Step::End::kSwims;
  add_found({.kind = swims || place.swims ? WayKind::kSwim : WayKind::kWalk,
             .at = step.at,
             .mover = step.mover,
             .swims = swims,
             .cost = glm::distance(place.at, step.at) * (swims ? 1.8f : 1.0f)},
            movers, io_found);
}

void Flood::try_fall(const Place& place, const math::Vec3& way, Movers movers, std::vector<Found>& io_found) {
  const Step step = this->step(place.at, place.at + way, false, movers);
  if (step.end != Step::End::kFalls) return;
  const FlightEnd end = fly(space_, step.at, {}, movers);
  if (end.end == Flight::End::kLost) return;
  const float height = place.at.z - end.place.z;
  fall_z_ = std::max(fall_z_, end.place.z);
  add_found({.kind = WayKind::kDrop,
             .at = end.place,
             .mover = end.mover,
             .swims = end.end == Flight::End::kSwims,
             .cost = 32 + height * 0.5f + (height > kHarmlessFall_units ? 200.0f : 0.0f)},
            movers, io_found);
}

void Flood::try_hop(const Place& place, const math::Vec3& direction, Movers movers,
                    std::vector<Found>& io_found) {
  const Meeting up = space_.trace(place.at, place.at + math::Vec3(0, 0, kJumpHeight), movers);
  const Meeting on = space_.trace(up.trace.end, up.trace.end + direction * 20.0f, movers);
  if (on.trace.fraction < 0.2f) return;
  const FlightEnd end =
      fly(space_, place.at, {direction * kHopSpeed + math::Vec3(0, 0, kJumpSpeed), direction}, movers);
  if (end.end != Flight::End::kStands || end.place.z < place.at.z + 8) return;
  add_found({.kind = WayKind::kHop, .at = end.place, .mover = end.mover, .cost = 90}, movers, io_found);
}

void Flood::try_jump(const Place& place, const math::Vec3& direction, Movers movers,
                     std::vector<Found>& io_found) {
  for (const float speed : kRunSpeeds) {
    const FlightEnd end =
        fly(space_, place.at, {direction * speed + math::Vec3(0, 0, kJumpSpeed), direction}, movers);
    if (end.end == Flight::End::kLost || end.place.z < fall_z_ + kJumpGain_units) continue;
    const float distance = glm::length(math::Vec2(end.place - place.at));
    if (distance < kMinJump_units) continue;
    // What only just works is done when nothing else does.
    const bool is_deadly = fall_z_ <= -kDeep_units || may_fall_short_into_lava(end.place, direction);
    add_found({.kind = WayKind::kJump,
               .at = end.place,
               .mover = end.mover,
               .swims = end.end == Flight::End::kSwims,
               .speed = speed,
               .cost = 200 + distance + (speed > 250 ? 150.0f : 0.0f) + (is_deadly ? kDeadlyJumpCost : 0.0f)},
              movers, io_found);
  }
}

bool Flood::may_fall_short_into_lava(const math::Vec3& landing, const math::Vec3& direction) const {
  for (float short_units = 8; short_units <= kShort_units; short_units += 8)
    if (space_.is_above_lava(landing - direction * short_units - math::Vec3(0, 0, kShort_units))) return true;
  return false;
}

void Flood::try_climb_out(const Place& place, const math::Vec3& direction, Movers movers,
                          std::vector<Found>& io_found) {
  math::Vec3 surface = place.at;
  for (float up = 0; up <= kSwimStep_units; up += 4) {
    const math::Vec3 higher = place.at + math::Vec3(0, 0, up);
    if (space_.water_level(higher) < movement::kSwimmingLevel) break;
    surface = higher;
  }
  if (space_.water_level(surface) != movement::kSwimmingLevel) return;
  const Meeting up = space_.trace(surface, surface + math::Vec3(0, 0, kClimbOut_units), movers);
  const Meeting on = space_.trace(up.trace.end, up.trace.end + direction * 40.0f, movers);
  if (on.trace.fraction < 0.6f) return;
  const Meeting down = space_.trace(on.trace.end, on.trace.end - math::Vec3(0, 0, kClimbOut_units), movers);
  const math::Vec3& at = down.trace.end;
  if (down.trace.fraction == 1 || down.trace.plane_normal.z < kFloorNormal || space_.is_in_lava(at) ||
      space_.water_level(at) >= movement::kSwimmingLevel)
    return;
  add_found({.kind = WayKind::kClimbOut, .at = at, .mover = down.mover, .cost = 150}, movers, io_found);
}

// As it falls, or is thrown, with a wish to go there on the way.
void Flood::try_throw(const Place& place, const math::Vec3& direction, Movers movers,
                      std::vector<Found>& io_found) {
  const FlightEnd end = fly(space_, place.at, {{0, 0, 0}, direction}, movers);
  if (end.end == Flight::End::kLost) return;
  add_found({.kind = WayKind::kPush,
             .at = end.place,
             .mover = end.mover,
             .swims = end.end == Flight::End::kSwims,
             .cost = 100},
            movers, io_found);
}

void Flood::add_rides(std::uint32_t i, const Place& place) {
  const Mover& mover = space_.facts().movers[static_cast<std::size_t>(place.mover)];
  const MoverPart& part = mover.parts[0];
  for (int state = 0; state < mover.states; ++state) {
    if (state == place.state) continue;
    if (mover.kind == MoverKind::kTrain && state != (place.state + 1) % mover.states) continue;
    const math::Vec3 way =
        part.places[static_cast<std::size_t>(state)] - part.places[static_cast<std::size_t>(place.state)];
    const math::Vec3 at = place.at + way;
    if (!space_.is_free(at, {})) continue;
    add_way(i, {.kind = WayKind::kRide,
                .at = at,
                .mover = place.mover,
                .state = state,
                .cost = 150 + 2 * glm::length(way),
                .demands = {{place.mover, 1u << state}}});
  }
}

// True: nobody goes on from here by himself.
bool Flood::pass_triggers(std::uint32_t i, const Place& place) {
  const math::Bounds box{place.at + movement::kPlayerMins, place.at + movement::kPlayerMaxs};
  for (const Trigger& trigger : space_.facts().triggers) {
    const bool teleports = trigger.kind == TriggerKind::kTeleport && !trigger.needs_use;
    if ((!teleports && trigger.kind != TriggerKind::kPush) || !boxes_meet(box, trigger.box)) continue;
    Place from;
    from.at = teleports ? trigger.destination : place.at;
    with_movers({}, around(from.at, teleports ? 4.0f : 200.0f, kDeep_units, 600));
    std::vector<Found> found;
    for (const auto& movers : assignments_) {
      try_throw(from, {0, 0, 0}, movers, found);
      if (teleports) continue;
      for (const auto& [dx, dy] : kDirections) try_throw(from, level_direction({dx, dy, 0}), movers, found);
    }
    for (Found& one : found) {
      one.kind = teleports ? WayKind::kTeleport : WayKind::kPush;
      add_way(i, one);
    }
    return true;
  }
  return false;
}

void Flood::note_triggers(Place& io_place) const {
  const math::Bounds box{io_place.at + movement::kPlayerMins, io_place.at + movement::kPlayerMaxs};
  for (const Trigger& trigger : space_.facts().triggers) {
    if (!boxes_meet(box, trigger.box)) continue;
    if (trigger.kind == TriggerKind::kExit) io_place.is_end = true;
    // One that heals must not make a way cost less than nothing: searches would go round in it for ever.
    if (trigger.kind == TriggerKind::kHurt) io_place.penalty += std::max(trigger.damage, 0.0f) * 50;
  }
  if (space_.is_in_slime(io_place.at)) io_place.penalty += kSlimePenalty;
}

std::optional<std::uint32_t> Flood::add_place(const math::Vec3& at, int mover, int state, bool swims) {
  std::vector<std::uint32_t>& cell = graph_.cells_[graph_.cell_of(at)];
  const float same = swims ? kSameDepth_units : kSameFloor_units;
  for (const std::uint32_t i : cell) {
    const Place& known = graph_.places_[i];
    if (known.mover == mover && known.state == state && known.swims == swims &&
        std::abs(known.at.z - at.z) < same)
      return i;
  }
  if (graph_.places_.size() == limits_.places) return std::nullopt;
  const auto i = static_cast<std::uint32_t>(graph_.places_.size());
  Place place;
  place.at = at;
  place.mover = mover;
  place.state = state;
  place.swims = swims;
  note_triggers(place);
  graph_.places_.push_back(std::move(place));
  cell.push_back(i);
  open_.push_back(i);
  return i;
}

void Flood::add_way(std::uint32_t from, const Found& found) {
  const std::optional<std::uint32_t> to = add_place(found.at, found.mover, found.state, found.swims);
  if (!to || *to == from) return;
  Way way{.to = *to, .kind = found.kind, .cost = found.cost, .speed = found.speed};
  way.cost += graph_.places_[*to].penalty;
  std::size_t demands = 0;
  for (const Demand& demand : found.demands) {
    const int states = space_.facts().movers[static_cast<std::size_t>(demand.mover)].states;
    if (demand.states == (1u << states) - 1) continue;
    if (demands < way.demands.size()) way.demands[demands++] = demand;
  }
  for (Way& known : graph_.places_[from].ways)
    if (known.to == way.to && known.kind == way.kind && known.demands[0].mover == way.demands[0].mover) {
      // Of two tries the one that demands less.
      if (way.cost < known.cost) known = way;
      return;
    }
  graph_.places_[from].ways.push_back(way);
}

// Ways along walls and edges cost a little more: players who are shoved do not fall from the middle.
void Flood::prefer_open_ground() {
  std::vector<float> narrow(graph_.places_.size());
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    const auto walks = std::count_if(
        graph_.places_[i].ways.begin(), graph_.places_[i].ways.end(),
        [](const Way& way) { return way.kind == WayKind::kWalk || way.kind == WayKind::kSwim; });
    narrow[i] = static_cast<float>(std::max<std::ptrdiff_t>(8 - walks, 0)) * 2;
  }
  for (Place& place : graph_.places_)
    for (Way& way : place.ways) way.cost += narrow[way.to];
}

}  // namespace temblor::player
