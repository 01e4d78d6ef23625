// Closed surfaces with flat sides: boxes and plates.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/models/mesh.h"
#include "artgen/models/transform.h"

namespace temblor::artgen {

// A box around the origin of its own coordinates.
struct BoxSurface {
  // From the box's coordinates to the model's.
  Transform transform;
  // The full lengths of its sides.
  math::Vec3d size{1.0};
  // The size of the upper side in x and y, relative to the lower side.
  math::Vec2d taper{1.0};
  // The width of beveled edges; 0: sharp edges. It is limited to 0.45 of the shortest side.
  double bevel = 0;
  std::size_t bone = 0;
};
// Appends the box to the mesh as part of shape number `shape`. Each side is a chart.
void add_box(const BoxSurface& surface, std::uint32_t shape, Mesh& io_mesh);

// An approximately flat outline that is extruded by half of the thickness to both sides.
struct PlateSurface {
  // At least three points, in either direction; it may be concave.
  std::vector<MeshPoint> outline;
  double thickness = 1;
};
// Appends the plate: front, back, and rim are three charts.
void add_plate(const PlateSurface& surface, std::uint32_t shape, Mesh& io_mesh);

}  // namespace temblor::artgen
