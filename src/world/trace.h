// Traces: move a point or a box along a line until it hits something solid. The base of all collision.
//
// A level has one tree for each box size (hull), whose solid space the map compiler has expanded by that box.
// So a trace of a box is a trace of its origin through an expanded level:
//
//   hull 0:   +-----------      hull 1:  +-------------
//             |  solid                   | . . . . . .      expanded by half of the box
//     [o] --> |                     o -> | . +---------
//
// Method (trace.cpp): walk the path through the tree front to back, and cut it where it crosses planes. Only
// brush models have hulls; callers clip against the boxes of other entities themselves.
#pragma once

#include <span>

#include "world/level.h"

namespace temblor::world {

// Hull 0 is for points: the tree that is drawn. The others are clip hulls, expanded by the boxes in
// Level::hull_boxes: in Quake's levels a player's (32 x 32 x 56 units) and a large monster's (64 x 64 x 88).
// Only Half-Life's levels have a low hull, for ducking players.
enum class Hull : std::uint8_t { kPoint, kPlayer, kLarge, kLow };

// A hull for a box, and the offset to add to positions so that the hull's mins match those of the box.
struct HullChoice {
  Hull hull;
  math::Vec3 offset;
};
// Returns the hull for a box by its width in x, as in the original: kPoint below 3 units, kPlayer up to 32,
// kLarge above. Boxes are never traced with their exact size. In a Half-Life level, a box of kPlayer's width
// that is no higher than a ducking player gets kLow. Quake's player (56 units high) gets the hull of a
// standing one (72): so the feet are on the floor, and the head is never in a ceiling.
HullChoice choose_hull(const Level& level, const math::Vec3& box_mins, const math::Vec3& box_maxs);

// The result of a trace.
struct Trace {
  bool all_solid = false;    // the whole path is in solid; fraction is 1
  bool start_solid = false;  // the start is in solid
  // Part of the path is in empty space; in a liquid, sky, or current.
  bool in_open = false, in_water = false;
  float fraction = 1;  // the part of the path before the hit; 1: nothing was hit
  math::Vec3 end{0.0f};
  math::Vec3 plane_normal{0.0f};  // the plane that was hit, if fraction < 1
  float plane_distance = 0;
};

// Traces from start to end through one model's hull, in that model's space. Stops 1/32 unit before the
// surface, measured along its normal. A path that starts in solid ends where it enters solid again.
Trace trace_line(const Level& level, ModelIndex model, Hull hull, const math::Vec3& start,
                 const math::Vec3& end);

// Traces a box through a model that is at `model_origin`. Arguments and result are in world space. Uses the
// hull that choose_hull() returns.
Trace trace_box_through_model(const Level& level, ModelIndex model, const math::Vec3& model_origin,
                              const math::Bounds& box, const math::Vec3& start, const math::Vec3& end);

// Returns the contents at a point of a model's hull, in the model's space. A point on a plane counts as in
// front.
Contents hull_contents(const Level& level, ModelIndex model, Hull hull, const math::Vec3& point);

// The part of a hull that lies in a box (hull_cells.h), as a tree whose planes are the level's. The tree and
// the level must outlive it. The functions above are defined for it, too, if the whole path is in the box.
struct HullPart {
  std::span<const Clipnode> clipnodes;
  std::int32_t head;  // >= 0: index of a clipnode; < 0: the whole box has these contents
};
Trace trace_line(const Level& level, const HullPart& part, const math::Vec3& start, const math::Vec3& end);
Contents hull_contents(const Level& level, const HullPart& part, const math::Vec3& point);

}  // namespace temblor::world
