// Clipping: cutting off the part of a polygon that is too near, or behind the eye.
#pragma once

#include <vector>

#include "lab/school/interpolation.h"
#include "lab/school/space.h"

namespace temblor::lab::school {

// A corner of a polygon in space, with its color and its place in a texture (1: the texture's whole side).
struct Vertex {
  Vector place;
  Color color{};
  float s = 0, t = 0;
};

inline Vertex interpolate(const Vertex& from, const Vertex& to, float share) {
  return {from.place + (to.place - from.place) * share, interpolate(from.color, to.color, share),
          interpolate(from.s, to.s, share), interpolate(from.t, to.t, share)};
}

// Walks around the polygon. Corners beyond the plane stay; an edge that crosses the plane gets a new corner
// there (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). A triangle may become a quadrilateral,
// or nothing.
inline std::vector<Vertex> clip_to_near_plane(const std::vector<Vertex>& polygon, float near) {
  std::vector<Vertex> clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &begin = polygon[i], &end = polygon[(i + 1) % polygon.size()];
    const float before = begin.place.z - near, behind = end.place.z - near;
    if (before >= 0) clipped.push_back(begin);
    if ((before >= 0) != (behind >= 0))
      clipped.push_back(interpolate(begin, end, before / (before - behind)));
  }
  return clipped;
}

}  // namespace temblor::lab::school
