#include "scripted_player/navigation/nav_space.h"

#include <algorithm>
#include <limits>

#include "movement/player.h"
#include "movement/walk.h"
#include "server/move_trace.h"

namespace temblor::player {
namespace {

// Deeper than any drop in a level.
constexpr float kDeepest_units = 4096;
constexpr math::Bounds kPlayerBox{movement::kPlayerMins, movement::kPlayerMaxs};
// Slack for bounding box tests, so that rounding never hides a contact.
constexpr float kNear_units = 2;
constexpr float kFlightStep_s = 1.0f / 72;
// A flight with a push on the way, such as wind in a shaft, lasts longer.
constexpr float kMaxFlight_s = 4, kMaxThrow_s = 12;
// Defaults of sv_gravity, sv_maxspeed, and sv_maxvelocity.
constexpr float kGravity = 800, kMaxSpeed = 320, kMaxVelocity = 2000;
// Air acceleration works only up to this speed along the wish direction, as in stock Quake.
constexpr float kSteerSpeed = 30;

// Returns whether the box of the line touches `box`. A cheap test before a trace through the box's model.
bool may_touch(const math::Bounds& box, const math::Vec3& start, const math::Vec3& end) {
  const math::Vec3 low = glm::min(start, end), high = glm::max(start, end);
  return low.x <= box.maxs.x && low.y <= box.maxs.y && low.z <= box.maxs.z && high.x >= box.mins.x &&
         high.y >= box.mins.y && high.z >= box.mins.z;
}

math::Bounds grow_by_player(const math::Bounds& box) {
  return {box.mins - kPlayerBox.maxs - kNear_units, box.maxs - kPlayerBox.mins + kNear_units};
}

// Replaces the nearest hit if this trace ends earlier. A trace that starts in something solid marks the
// result, too.
void keep_nearer(const world::Trace& trace, int mover, NavTrace& io_nearest) {
  const bool is_nearer = trace.fraction < io_nearest.trace.fraction;
  if (trace.start_solid || trace.all_solid) {
    io_nearest.trace.start_solid = true;
    io_nearest.mover = mover;
  }
  if (!is_nearer) return;
  const bool started_solid = io_nearest.trace.start_solid;
  io_nearest.trace = trace;
  io_nearest.trace.start_solid |= started_solid;
  io_nearest.mover = mover;
}

// Connects the movement code to a NavSpace: the obstacle's number is the mover's index + 1, so 0 is the
// world. There is no game code, so touch functions do nothing.
class FlightEnvironment : public movement::Environment {
 public:
  FlightEnvironment(const NavSpace& space, std::span<const MoverPlace> movers)
      : space_(space), movers_(movers) {}
  movement::Contact trace(const math::Vec3& start, const math::Vec3& end) override {
    const NavTrace hit = space_.trace(start, end, movers_);
    return {hit.trace, static_cast<std::uint32_t>(hit.mover + 1),
            hit.trace.fraction < 1 || hit.trace.start_solid, true};
  }
  movement::Contact trace_push(const math::Vec3& start, const math::Vec3& end) override {
    return trace(start, end);
  }
  base::Result<bool> touch(const movement::Contact&, movement::Body&) override { return true; }
  base::Result<bool> moved(movement::Body&) override { return true; }

 private:
  const NavSpace& space_;
  std::span<const MoverPlace> movers_;
};

}  // namespace

NavSpace::NavSpace(std::shared_ptr<const world::Level> level, const LevelFacts& facts)
    : level_(std::move(level)),
      facts_(&facts),
      to_hull_(world::choose_hull(*level_, kPlayerBox.mins, kPlayerBox.maxs).offset),
      player_hull_(*level_, world::ModelIndex{0}, world::Hull::kPlayer),
      point_hull_(*level_, world::ModelIndex{0}, world::Hull::kPoint) {
  for (std::size_t i = 0; i < facts.movers.size(); ++i) {
    math::Bounds reach = mover_box(static_cast<int>(i), 0);
    for (int state = 1; state < facts.movers[i].states; ++state) {
      const math::Bounds box = mover_box(static_cast<int>(i), state);
      reach = {glm::min(reach.mins, box.mins), glm::max(reach.maxs, box.maxs)};
    }
    reach_.push_back(grow_by_player(reach));
  }
  for (const StaticModel& still : facts.static_models) {
    const math::Bounds& box = level_->models[base::to_size(still.model)].bounds;
    static_model_reach_.push_back(grow_by_player({box.mins + still.origin, box.maxs + still.origin}));
  }
  for (const math::Bounds& box : facts.static_boxes) static_box_reach_.push_back(grow_by_player(box));
}

math::Bounds NavSpace::part_box(const MoverPart& part, int state) {
  const math::Vec3& at = part.places[static_cast<std::size_t>(state)];
  return {part.box.mins + at, part.box.maxs + at};
}

math::Bounds NavSpace::mover_box(int mover, int state) const {
  const Mover& m = facts_->movers[static_cast<std::size_t>(mover)];
  math::Bounds box = part_box(m.parts[0], state);
  for (const MoverPart& part : m.parts) {
    const math::Bounds next = part_box(part, state);
    box = {glm::min(box.mins, next.mins), glm::max(box.maxs, next.maxs)};
  }
  return box;
}

world::Trace NavSpace::trace_world(const math::Vec3& start, const math::Vec3& end) const {
  world::Trace trace = player_hull_.trace_line(start + to_hull_, end + to_hull_);
  trace.end = trace.fraction == 1 ? end : trace.end - to_hull_;
  return trace;
}

// Keeps the nearest hit of: the world, static models, static boxes, and the parts of the movers in their
// states.
NavTrace NavSpace::trace(const math::Vec3& start, const math::Vec3& end,
                         std::span<const MoverPlace> movers) const {
  NavTrace nearest{trace_world(start, end), -1};
  for (std::size_t i = 0; i < static_model_reach_.size(); ++i) {
    if (!may_touch(static_model_reach_[i], start, end)) continue;
    const StaticModel& still = facts_->static_models[i];
    keep_nearer(world::trace_box_through_model(*level_, still.model, still.origin, kPlayerBox, start, end),
                -1, nearest);
  }
  for (std::size_t i = 0; i < static_box_reach_.size(); ++i) {
    if (!may_touch(static_box_reach_[i], start, end)) continue;
    // A box against a box is a line against the sum of both.
    const math::Bounds& box = facts_->static_boxes[i];
    const math::Bounds grown{box.mins - kPlayerBox.maxs, box.maxs - kPlayerBox.mins};
    keep_nearer(server::trace_box(grown, start, end), -1, nearest);
  }
  for (const MoverPlace& place : movers) {
    const Mover& mover = facts_->movers[static_cast<std::size_t>(place.mover)];
    if (mover.kind == MoverKind::kWall && place.state != 0) continue;
    for (const MoverPart& part : mover.parts) {
      if (!may_touch(grow_by_player(part_box(part, place.state)), start, end)) continue;
      keep_nearer(world::trace_box_through_model(*level_, part.model,
                                                 part.places[static_cast<std::size_t>(place.state)],
                                                 kPlayerBox, start, end),
                  place.mover, nearest);
    }
  }
  return nearest;
}

bool NavSpace::is_free(const math::Vec3& place, std::span<const MoverPlace> movers) const {
  return !trace(place, place, movers).trace.start_solid;
}

bool NavSpace::is_line_free(const math::Vec3& from, const math::Vec3& to) const {
  if (world::trace_line(*level_, world::ModelIndex{0}, world::Hull::kPoint, from, to).fraction < 1)
    return false;
  for (const StaticModel& still : facts_->static_models)
    if (world::trace_line(*level_, still.model, world::Hull::kPoint, from - still.origin, to - still.origin)
            .fraction < 1)
      return false;
  return true;
}

// A hit is allowed if it is on the target's box.
bool NavSpace::is_line_free_of_movers(const math::Vec3& from, const math::Vec3& to,
                                      const math::Bounds& target) const {
  const auto is_free_from = [&](world::ModelIndex model, const math::Vec3& origin) {
    const world::Trace trace =
        world::trace_line(*level_, model, world::Hull::kPoint, from - origin, to - origin);
    if (trace.fraction == 1) return true;
    const math::Vec3 at = trace.end + origin;
    return boxes_overlap({at - kNear_units, at + kNear_units}, target);
  };
  for (const StaticModel& still : facts_->static_models)
    if (!is_free_from(still.model, still.origin)) return false;
  for (const Mover& mover : facts_->movers)
    for (const MoverPart& part : mover.parts)
      if (!is_free_from(part.model, part.places[0])) return false;
  return true;
}

world::Contents NavSpace::contents(const math::Vec3& point) const {
  const world::Contents contents = point_hull_.contents(point);
  return contents <= world::Contents::kCurrent0 ? world::Contents::kWater : contents;
}

int NavSpace::water_level(const math::Vec3& place) const {
  return movement::find_water(place, {}, [&](const math::Vec3& point) { return contents(point); }).level;
}

// Tests the point 1 unit above the feet, where movement::find_water() tests for liquids.
bool NavSpace::is_in_lava(const math::Vec3& place) const {
  return contents(place + math::Vec3(0, 0, kPlayerBox.mins.z + 1)) == world::Contents::kLava;
}

bool NavSpace::is_above_lava(const math::Vec3& point) const {
  if (contents(point) == world::Contents::kSolid) return false;
  const math::Vec3 deep(point.x, point.y, point.z - kDeepest_units);
  const world::Trace down =
      world::trace_line(*level_, world::ModelIndex{0}, world::Hull::kPoint, point, deep);
  return contents(down.end + math::Vec3(0, 0, 1)) == world::Contents::kLava;
}

bool NavSpace::is_in_slime(const math::Vec3& place) const {
  return contents(place + math::Vec3(0, 0, kPlayerBox.mins.z + 1)) == world::Contents::kSlime;
}

void NavSpace::movers_near(const math::Bounds& origins, std::vector<int>& out_movers) const {
  out_movers.clear();
  for (std::size_t i = 0; i < reach_.size(); ++i)
    if (boxes_overlap(reach_[i], origins)) out_movers.push_back(static_cast<int>(i));
}

namespace {

// Returns the first trigger_push that a player there touches; null if there is none.
const Trigger* find_push(const NavSpace& space, const math::Vec3& at) {
  const math::Bounds box{at + kPlayerBox.mins, at + kPlayerBox.maxs};
  for (const Trigger& trigger : space.facts().triggers)
    if (trigger.kind == TriggerKind::kPush && boxes_overlap(box, trigger.box)) return &trigger;
  return nullptr;
}

}  // namespace

FlightEnd fly(const NavSpace& space, const math::Vec3& from, const Flight& flight,
              std::span<const MoverPlace> movers) {
  FlightEnvironment environment(space, movers);
  movement::Body body{.origin = from, .velocity = flight.velocity};
  float longest_s = kMaxFlight_s;
  for (float time_s = 0; time_s < longest_s; time_s += kFlightStep_s) {
    if (const Trigger* push = find_push(space, body.origin)) {
      body.velocity = push->velocity;
      longest_s = kMaxThrow_s;
    }
    const float along = glm::dot(body.velocity, flight.direction);
    if (flight.direction != math::Vec3(0.0f) && along < kSteerSpeed)
      body.velocity += flight.direction * std::min(kSteerSpeed - along, 10 * kMaxSpeed * kFlightStep_s);
    body.velocity.z = std::max(body.velocity.z - kGravity * kFlightStep_s, -kMaxVelocity);
    body.on_ground = false;
    // Only touch functions fail, and there are none.
    if (!movement::slide(body, kFlightStep_s, environment).ok()) return {};
    const world::Contents feet = space.contents(body.origin + math::Vec3(0, 0, kPlayerBox.mins.z + 1));
    if (feet == world::Contents::kLava) return {};
    if (movement::is_liquid(feet) && space.water_level(body.origin) >= movement::kSwimmingLevel)
      return {Flight::End::kSwims, body.origin, -1, time_s};
    if (body.on_ground) return {Flight::End::kStands, body.origin, static_cast<int>(body.ground) - 1, time_s};
  }
  return {};
}

}  // namespace temblor::player
