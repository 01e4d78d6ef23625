// Random sealed maps: rooms joined at odd angles, with detail, sky, liquids, and prefabs.
//
//           d ________ c           A room has four walls. Each exit is a door in one of them; behind it the
//            /        \            next room begins, whose first side is the outside of that wall. Rooms do
//           /   room   \           not reach into each other.
//        a /____door____\ b
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::test {

struct RandomMap {
  formats::Map map;  // prefabs are expanded
  std::string text;  // before that, for messages
  // The floors of the rooms without their walls, counterclockwise from above; all rooms are as high.
  std::vector<std::vector<math::Vec2d>> floors;
  double floor_z = 0, ceiling_z = 0;
};

RandomMap make_random_map(std::uint64_t seed);

// How far a point is inside of the nearest room's walls, floor, and ceiling; negative outside of all.
double depth_in_rooms(const RandomMap& map, const math::Vec3d& point);

}  // namespace temblor::test
