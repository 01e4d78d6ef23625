#include "scripted_player/navigation/flood.h"

#include <algorithm>
#include <cmath>

#include "movement/player.h"
#include "movement/walk.h"

namespace temblor::player {
namespace {

using movement::kFloorNormal;
using movement::kStepHeight;

// Vertical speed of a jump in units/s, and the height that it reaches: 270^2 / (2 * 800) = 45.6.
constexpr float kJumpSpeed = 270, kJumpHeight = 45;
// Horizontal takeoff speeds in units/s. The maximum of stock Quake is 320, but a run-up does not always reach
// it.
constexpr std::array<float, 3> kRunSpeeds = {300, 220, 140};
constexpr float kHopSpeed = 120;
constexpr float kMinJump_units = 40;
// A jump has to end this much higher than a plain drop in the same direction; otherwise it gains nothing.
constexpr float kJumpGain_units = 24;
constexpr float kSwimStep_units = 24;
constexpr float kClimbOut_units = 50;
constexpr float kMinDive_units = 4;
// Places in one cell are the same place if their heights differ by less than this.
constexpr float kSameFloor_units = 10, kSameDepth_units = 10;
constexpr float kDeep_units = 4096;
// Limits the combinations when many movers are near each other. Further states are not tried.
constexpr std::size_t kMaxAssignments = 24;
constexpr float kHarmlessFall_units = 256;
constexpr float kSlimePenalty = 40;
// The extra cost of a jump over lava.
constexpr float kDeadlyJumpCost = 1500;
// By how much a jump may turn out too short and too low.
constexpr float kShort_units = 64;

constexpr std::array<std::array<int, 2>, 8> kDirections = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

math::Vec3 horizontal_direction(const math::Vec3& offset) {
  const float length = glm::length(math::Vec2(offset));
  return length > 0 ? math::Vec3(offset.x / length, offset.y / length, 0) : math::Vec3(0.0f);
}

// Returns a box around a place: `side` units to each side, `below` and `above` vertically.
math::Bounds around(const math::Vec3& at, float side, float below, float above) {
  return {at - math::Vec3(side, side, below), at + math::Vec3(side, side, above)};
}

}  // namespace

// Start points may float, so the starts fall to the floor first.
void Flood::run(std::span<const math::Vec3> starts) {
  for (const math::Vec3& start : starts) {
    assign_mover_states({}, around(start, 0, kDeep_units, 8));
    std::vector<Candidate> found;
    Place place;
    place.at = start;
    for (const auto& movers : assignments_) try_throw(place, {0, 0, 0}, movers, found);
    for (const Candidate& one : found) add_place(one.at, one.mover, one.state, one.swims);
  }
  while (!open_.empty()) {
    const std::uint32_t next = open_.front();
    open_.pop_front();
    expand(next);
  }
  penalize_narrow_places();
}

math::Vec3 Flood::neighbor(const math::Vec3& at, int dx, int dy) const {
  const auto middle = [](float x, int d) {
    return (std::floor(x / kCell_units) + static_cast<float>(d) + 0.5f) * kCell_units;
  };
  return {middle(at.x, dx), middle(at.y, dy), at.z};
}

// The boxes given to try_all() bound the player's origin during the attempt. If a mover outside the box could
// be touched, the link would lack its condition, so they are generous.
void Flood::expand(std::uint32_t i) {
  const Place place = graph_.places_[i];
  if (place.is_exit || follow_triggers(i, place)) return;
  if (place.mover >= 0) add_rides(i, place);
  for (const auto& [dx, dy] : kDirections) {
    const math::Vec3 to = neighbor(place.at, dx, dy);
    const math::Vec3 offset = to - place.at;
    falls_ = is_blocked_ = false;
    fall_z_ = -kDeep_units;
    try_all(i, place, offset, around(place.at, 28, 24, 24), &Flood::try_step);
    const math::Vec3 direction = horizontal_direction(offset);
    if (place.swims) {
      if (is_blocked_) try_all(i, place, direction, around(place.at, 48, 24, 80), &Flood::try_climb_out);
      continue;
    }
    if (is_blocked_) try_all(i, place, direction, around(place.at, 48, 24, 64), &Flood::try_hop);
    // At an edge: drop, or jump straight ahead and up to 23 degrees to each side.
    if (!falls_) continue;
    try_all(i, place, offset, around(place.at, 32, kDeep_units, 24), &Flood::try_fall);
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

void Flood::assign_mover_states(const Place& place, const math::Bounds& origins) {
  std::vector<int> near;
  space_.movers_near(origins, near);
  assignments_.assign(1, {});
  for (const int mover : near) {
    // Extend each combination by each state. The mover that the player stands on keeps its state.
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

// Adds a link for each distinct result, with the states of all combinations that lead to it.
void Flood::try_all(std::uint32_t i, const Place& place, const math::Vec3& direction,
                    const math::Bounds& origins, Try attempt) {
  assign_mover_states(place, origins);
  std::vector<Candidate> found;
  for (const auto& movers : assignments_) {
    // Skip combinations in which a mover occupies the place itself.
    if (!movers.empty() && !space_.is_free(place.at, movers)) continue;
    (this->*attempt)(place, direction, movers, found);
  }
  for (const Candidate& one : found) add_link(i, one);
}

// Merges the candidate with a known one that leads to the same place, or adds it. Candidates of one attempt
// list the same movers in the same order, so their conditions merge by position.
void Flood::add_candidate(Candidate found, Movers movers, std::vector<Candidate>& io_found) const {
  for (const MoverPlace& near : movers) {
    if (near.mover == found.mover) found.state = near.state;
    found.conditions.push_back({near.mover, 1u << near.state});
  }
  for (Candidate& known : io_found) {
    if (known.kind != found.kind || known.mover != found.mover || known.state != found.state ||
        known.conditions.size() != found.conditions.size() || glm::distance(known.at, found.at) > 4)
      continue;
    for (std::size_t d = 0; d < known.conditions.size(); ++d)
      known.conditions[d].states |= found.conditions[d].states;
    return;
  }
  io_found.push_back(std::move(found));
}

// Walks or swims one cell, with the same traces as real walking (movement/walk.h): across, and if something
// is in the way, up by a step, across, and down again. A vertical `to` is a dive.
Flood::Step Flood::step(const math::Vec3& from, const math::Vec3& to, bool swims, Movers movers) const {
  const NavTrace across = space_.trace(from, to, movers);
  if (across.trace.start_solid) return {};
  math::Vec3 over = to;
  const math::Vec3& end = across.trace.end;
  const bool dives = swims && to.x == from.x && to.y == from.y;
  if (dives && std::abs(end.z - from.z) < kMinDive_units) return {};
  if (dives && space_.water_level(end) >= movement::kSwimmingLevel) return {Step::End::kSwims, end, -1};
  if (dives) return {};
  if (across.trace.fraction < 1) {
    const NavTrace up = space_.trace(from, from + math::Vec3(0, 0, kStepHeight), movers);
    const NavTrace on = space_.trace(up.trace.end, {to.x, to.y, up.trace.end.z}, movers);
    if (on.trace.fraction < 1) return {};
    over = on.trace.end;
  } else if (swims && space_.water_level(to) >= movement::kSwimmingLevel) {
    return {space_.is_in_lava(to) ? Step::End::kBlocked : Step::End::kSwims, to, -1};
  }
  const NavTrace down = space_.trace(over, {over.x, over.y, from.z - kStepHeight - 0.1f}, movers);
  const math::Vec3& at = down.trace.end;
  if (space_.is_in_lava(at)) return {};
  if (space_.water_level(at) >= movement::kSwimmingLevel) return {Step::End::kSwims, at, -1};
  if (down.trace.fraction == 1 || down.trace.plane_normal.z < kFloorNormal)
    return {swims ? Step::End::kBlocked : Step::End::kFalls, over, -1};
  return {Step::End::kStands, at, down.mover};
}

void Flood::try_step(const Place& place, const math::Vec3& offset, Movers movers,
                     std::vector<Candidate>& io_found) {
  const Step step = this->step(place.at, place.at + offset, place.swims, movers);
  falls_ |= step.end == Step::End::kFalls;
  is_blocked_ |= step.end == Step::End::kBlocked;
  if (step.end != Step::End::kStands && step.end != Step::End::kSwims) return;
  const bool swims = step.end == Step::End::kSwims;
  add_candidate({.kind = swims || place.swims ? LinkKind::kSwim : LinkKind::kWalk,
                 .at = step.at,
                 .mover = step.mover,
                 .swims = swims,
                 .cost = glm::distance(place.at, step.at) * (swims ? 1.8f : 1.0f)},
                movers, io_found);
}

// A drop costs half its height; a drop that hurts costs 200 more.
void Flood::try_fall(const Place& place, const math::Vec3& offset, Movers movers,
                     std::vector<Candidate>& io_found) {
  const Step step = this->step(place.at, place.at + offset, false, movers);
  if (step.end != Step::End::kFalls) return;
  const FlightEnd end = fly(space_, step.at, {}, movers);
  if (end.end == Flight::End::kLost) return;
  const float height = place.at.z - end.place.z;
  fall_z_ = std::max(fall_z_, end.place.z);
  add_candidate({.kind = LinkKind::kDrop,
                 .at = end.place,
                 .mover = end.mover,
                 .swims = end.end == Flight::End::kSwims,
                 .cost = 32 + height * 0.5f + (height > kHarmlessFall_units ? 200.0f : 0.0f)},
                movers, io_found);
}

// Jumps onto an obstacle directly ahead that is higher than a step.
void Flood::try_hop(const Place& place, const math::Vec3& direction, Movers movers,
                    std::vector<Candidate>& io_found) {
  const NavTrace up = space_.trace(place.at, place.at + math::Vec3(0, 0, kJumpHeight), movers);
  const NavTrace on = space_.trace(up.trace.end, up.trace.end + direction * 20.0f, movers);
  if (on.trace.fraction < 0.2f) return;
  const FlightEnd end =
      fly(space_, place.at, {direction * kHopSpeed + math::Vec3(0, 0, kJumpSpeed), direction}, movers);
  if (end.end != Flight::End::kStands || end.place.z < place.at.z + 8) return;
  add_candidate({.kind = LinkKind::kHop, .at = end.place, .mover = end.mover, .cost = 90}, movers, io_found);
}

// Tries run-ups of different speeds. Jumps are expensive, because players sometimes miss them, and jumps at
// full speed or over lava even more.
void Flood::try_jump(const Place& place, const math::Vec3& direction, Movers movers,
                     std::vector<Candidate>& io_found) {
  for (const float speed : kRunSpeeds) {
    const FlightEnd end =
        fly(space_, place.at, {direction * speed + math::Vec3(0, 0, kJumpSpeed), direction}, movers);
    if (end.end == Flight::End::kLost || end.place.z < fall_z_ + kJumpGain_units) continue;
    const float distance = glm::length(math::Vec2(end.place - place.at));
    if (distance < kMinJump_units) continue;
    const bool is_deadly = fall_z_ <= -kDeep_units || may_fall_short_into_lava(end.place, direction);
    add_candidate(
        {.kind = LinkKind::kJump,
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

// The water jump of stock Quake: a player at the surface, with its eyes above the water, swims against an
// edge. Finds the surface, then traces up, across, and down onto the edge.
void Flood::try_climb_out(const Place& place, const math::Vec3& direction, Movers movers,
                          std::vector<Candidate>& io_found) {
  math::Vec3 surface = place.at;
  for (float up = 0; up <= kSwimStep_units; up += 4) {
    const math::Vec3 higher = place.at + math::Vec3(0, 0, up);
    if (space_.water_level(higher) < movement::kSwimmingLevel) break;
    surface = higher;
  }
  if (space_.water_level(surface) != movement::kSwimmingLevel) return;
  const NavTrace up = space_.trace(surface, surface + math::Vec3(0, 0, kClimbOut_units), movers);
  const NavTrace on = space_.trace(up.trace.end, up.trace.end + direction * 40.0f, movers);
  if (on.trace.fraction < 0.6f) return;
  const NavTrace down = space_.trace(on.trace.end, on.trace.end - math::Vec3(0, 0, kClimbOut_units), movers);
  const math::Vec3& at = down.trace.end;
  if (down.trace.fraction == 1 || down.trace.plane_normal.z < kFloorNormal || space_.is_in_lava(at) ||
      space_.water_level(at) >= movement::kSwimmingLevel)
    return;
  add_candidate({.kind = LinkKind::kClimbOut, .at = at, .mover = down.mover, .cost = 150}, movers, io_found);
}

// Starts at rest: falls, or is carried by a trigger_push there, and steers in `direction` (0: not at all).
void Flood::try_throw(const Place& place, const math::Vec3& direction, Movers movers,
                      std::vector<Candidate>& io_found) {
  const FlightEnd end = fly(space_, place.at, {{0, 0, 0}, direction}, movers);
  if (end.end == Flight::End::kLost) return;
  add_candidate({.kind = LinkKind::kPush,
                 .at = end.place,
                 .mover = end.mover,
                 .swims = end.end == Flight::End::kSwims,
                 .cost = 100},
                movers, io_found);
}

// A lift goes from any state to any other, a train only to its next corner. The condition is the state at the
// end: the rider steps on early and waits until the mover is there.
void Flood::add_rides(std::uint32_t i, const Place& place) {
  const Mover& mover = space_.facts().movers[static_cast<std::size_t>(place.mover)];
  const MoverPart& part = mover.parts[0];
  for (int state = 0; state < mover.states; ++state) {
    if (state == place.state) continue;
    if (mover.kind == MoverKind::kTrain && state != (place.state + 1) % mover.states) continue;
    const math::Vec3 offset =
        part.places[static_cast<std::size_t>(state)] - part.places[static_cast<std::size_t>(place.state)];
    const math::Vec3 at = place.at + offset;
    if (!space_.is_free(at, {})) continue;
    add_link(i, {.kind = LinkKind::kRide,
                 .at = at,
                 .mover = place.mover,
                 .state = state,
                 .cost = 150 + 2 * glm::length(offset),
                 .conditions = {{place.mover, 1u << state}}});
  }
}

bool Flood::follow_triggers(std::uint32_t i, const Place& place) {
  const math::Bounds box{place.at + movement::kPlayerMins, place.at + movement::kPlayerMaxs};
  for (const Trigger& trigger : space_.facts().triggers) {
    const bool teleports = trigger.kind == TriggerKind::kTeleport && !trigger.needs_use;
    if ((!teleports && trigger.kind != TriggerKind::kPush) || !boxes_overlap(box, trigger.box)) continue;
    // A teleporter ends at its destination, a push after a flight, steered in any of 8 directions or not at
    // all.
    Place from;
    from.at = teleports ? trigger.destination : place.at;
    assign_mover_states({}, around(from.at, teleports ? 4.0f : 200.0f, kDeep_units, 600));
    std::vector<Candidate> found;
    for (const auto& movers : assignments_) {
      try_throw(from, {0, 0, 0}, movers, found);
      if (teleports) continue;
      for (const auto& [dx, dy] : kDirections)
        try_throw(from, horizontal_direction({dx, dy, 0}), movers, found);
    }
    for (Candidate& one : found) {
      one.kind = teleports ? LinkKind::kTeleport : LinkKind::kPush;
      add_link(i, one);
    }
    return true;
  }
  return false;
}

void Flood::apply_triggers(Place& io_place) const {
  const math::Bounds box{io_place.at + movement::kPlayerMins, io_place.at + movement::kPlayerMaxs};
  for (const Trigger& trigger : space_.facts().triggers) {
    if (!boxes_overlap(box, trigger.box)) continue;
    if (trigger.kind == TriggerKind::kExit) io_place.is_exit = true;
    // A trigger that heals must not make costs negative, because Dijkstra's algorithm would never end.
    if (trigger.kind == TriggerKind::kHurt) io_place.penalty += std::max(trigger.damage, 0.0f) * 50;
  }
  if (space_.is_in_slime(io_place.at)) io_place.penalty += kSlimePenalty;
}

// A place is identified by its cell, its mover and state, whether it is in water, and its height.
std::optional<std::uint32_t> Flood::add_place(const math::Vec3& at, int mover, int state, bool swims) {
  std::vector<std::uint32_t>& cell = graph_.cells_[graph_.cell_index(at)];
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
  apply_triggers(place);
  graph_.places_.push_back(std::move(place));
  cell.push_back(i);
  open_.push_back(i);
  return i;
}

void Flood::add_link(std::uint32_t from, const Candidate& found) {
  const std::optional<std::uint32_t> to = add_place(found.at, found.mover, found.state, found.swims);
  if (!to || *to == from) return;
  Link link{.to = *to, .kind = found.kind, .cost = found.cost, .speed = found.speed};
  link.cost += graph_.places_[*to].penalty;
  std::size_t conditions = 0;
  for (const MoverCondition& condition : found.conditions) {
    // Skip conditions that every state meets. A link has room for two; the flood ignores further ones.
    const int states = space_.facts().movers[static_cast<std::size_t>(condition.mover)].states;
    if (condition.states == (1u << states) - 1) continue;
    if (conditions < link.conditions.size()) link.conditions[conditions++] = condition;
  }
  for (Link& known : graph_.places_[from].links)
    if (known.to == link.to && known.kind == link.kind &&
        known.conditions[0].mover == link.conditions[0].mover) {
      // Keep the cheaper of two links of the same kind.
      if (link.cost < known.cost) known = link;
      return;
    }
  graph_.places_[from].links.push_back(link);
}

// Makes links to places along walls and edges a little more expensive, because a player that is pushed may
// fall there. A place in the open has 8 walking links; each missing one costs 2 units.
void Flood::penalize_narrow_places() {
  std::vector<float> narrow(graph_.places_.size());
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    const auto walks = std::count_if(
        graph_.places_[i].links.begin(), graph_.places_[i].links.end(),
        [](const Link& link) { return link.kind == LinkKind::kWalk || link.kind == LinkKind::kSwim; });
    narrow[i] = static_cast<float>(std::max<std::ptrdiff_t>(8 - walks, 0)) * 2;
  }
  for (Place& place : graph_.places_)
    for (Link& link : place.links) link.cost += narrow[link.to];
}

}  // namespace temblor::player
