// What shots and explosions leave on the world's faces: a hit is a ball around the point of a face that is
// nearest to it, and marks every face where the ball cuts its plane.
#pragma once

#include <cstdint>
#include <vector>

#include "render/marks.h"
#include "world/face_at.h"

namespace temblor::client {

struct Hit {
  render::MarkKind kind{};
  math::Vec3 origin_world{0.0f};
  float reach = 0;   // units to the nearest face at most
  float radius = 0;  // units
  std::uint32_t seed = 0;
};

class HitMarks {
 public:
  // No mark when there is no lit face within reach, or the nearest surface is the sky's. Liquids are looked
  // through.
  void leave(const world::Level& level, const Hit& hit, render::MarkSet& io_marks);

 private:
  world::FacesNear faces_near_;
};

}  // namespace temblor::client
