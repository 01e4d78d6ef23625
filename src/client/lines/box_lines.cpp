#include "client/lines/box_lines.h"

namespace temblor::client {

void make_box_lines(std::span<const math::Bounds> boxes, std::vector<render::Line>& out_lines) {
  constexpr float kArm = 8;
  out_lines.clear();
  for (const math::Bounds& box : boxes)
    for (int axis = 0; axis < 3; ++axis) {
      if (box.mins == box.maxs) {
        math::Vec3 arm(0.0f);
        arm[axis] = kArm;
        out_lines.push_back({box.mins - arm, box.mins + arm});
        continue;
      }
      // The four edges along this axis.
      for (unsigned corner = 0; corner < 4; ++corner) {
        math::Vec3 from = box.mins;
        if (corner & 1) from[(axis + 1) % 3] = box.maxs[(axis + 1) % 3];
        if (corner & 2) from[(axis + 2) % 3] = box.maxs[(axis + 2) % 3];
        math::Vec3 to = from;
        to[axis] = box.maxs[axis];
        out_lines.push_back({from, to});
      }
    }
}

}  // namespace temblor::client
