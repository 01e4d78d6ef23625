// Bullet holes, scorches and blood on the world's faces. Stock Quake has none; r_marks turns them on.
//
// A hit is a ball around the nearest point of a face; it marks every face whose plane the ball cuts, so that
// marks wrap around corners:
//
//      ____.-"-.____ wall        the ball's intersection with each plane is a circle,
//         (  +  )|               the mark on that face
//          `-.-' | other wall
#pragma once

#include <cstdint>
#include <vector>

#include "render/marks.h"
#include "world/face_at.h"

namespace temblor::client {

// A shot or explosion near a wall. `seed` chooses among variants of the mark's shape.
struct Hit {
  render::MarkKind kind{};
  math::Vec3 origin_world{0.0f};
  float reach = 0;   // maximum distance to the nearest face, units
  float radius = 0;  // of the ball, units
  std::uint32_t seed = 0;
};

class HitMarks {
 public:
  // Adds marks. Adds none if no lit face is within reach or the nearest surface is sky. Liquids are ignored.
  void add(const world::Level& level, const Hit& hit, render::MarkSet& io_marks);

 private:
  world::NearFaceFinder faces_near_;
};

}  // namespace temblor::client
