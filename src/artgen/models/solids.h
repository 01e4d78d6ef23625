// Closed surfaces with flat sides: boxes and plates.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/models/mesh.h"
#include "artgen/models/transform.h"

namespace temblor::artgen {

struct BoxSurface {
  Transform place;         // the model's space from the box's
  math::Vec3d size{1.0};   // edge to edge
  math::Vec2d taper{1.0};  // its upper side's x and y, in parts of the lower's
  double bevel = 0;        // 0: crisp edges
  std::size_t bone = 0;
};
void add_box(const BoxSurface& surface, std::uint32_t shape, Mesh& io_mesh);

// An outline, about flat, with a thickness to both sides.
struct PlateSurface {
  std::vector<MeshPoint> outline;  // at least three
  double thickness = 1;
};
void add_plate(const PlateSurface& surface, std::uint32_t shape, Mesh& io_mesh);

}  // namespace temblor::artgen
