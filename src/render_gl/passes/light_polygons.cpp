#include "render_gl/passes/light_polygons.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace temblor::render_gl {

namespace {

// A corner of a convex polygon, with its offset from the light in units along both texture axes.
struct Corner {
  math::Vec3d at;
  double along_s, along_t;
};
using Polygon = std::vector<Corner>;

// A line on the face: there, s * along_s + t * along_t + constant is 0. The positive side is inside.
struct Line {
  double s, t, constant = 0;
  double distance(const Corner& corner) const { return s * corner.along_s + t * corner.along_t + constant; }
};

auto order(const Corner& corner) {
  return std::tuple(corner.along_s, corner.along_t, corner.at.x, corner.at.y, corner.at.z);
}

// The same to the last bit for both directions of a side, so that polygons on both sides of it fit.
Corner cut_side(const Corner& from, const Corner& to, const Line& line) {
  if (order(to) < order(from)) return cut_side(to, from, line);
  const double a = line.distance(from), b = line.distance(to);
  const double share = a / (a - b);
  return {from.at + (to.at - from.at) * share, std::lerp(from.along_s, to.along_s, share),
          std::lerp(from.along_t, to.along_t, share)};
}

// The part of a polygon that is inside of a line.
Polygon cut(const Polygon& polygon, const Line& line) {
  Polygon inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &corner = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double here = line.distance(corner), there = line.distance(next);
    if (here >= 0) inside.push_back(corner);
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) inside.push_back(cut_side(corner, next, line));
  }
  return inside.size() < 3 ? Polygon{} : inside;
}

// The tile's part of the face.
Polygon find_tile(const LightPolygonFace& face, const render::FaceLight& light) {
  const world::TextureAxes& axes = face.level.texture_axes[face.face.axes];
  const auto coordinate = [](const math::Vec3& axis, float offset, std::int32_t first,
                             const math::Vec3d& at) {
    return glm::dot(math::Vec3d(axis), at) + double{offset} - first;
  };
  // In texels at first.
  Polygon polygon;
  for (const render::OutlineCorner& corner : face.corners) {
    const math::Vec3d at(corner.position);
    polygon.push_back({at, coordinate(axes.s_axis, axes.s_offset, face.face.texture_mins[0], at),
                       coordinate(axes.t_axis, axes.t_offset, face.face.texture_mins[1], at)});
  }
  const double first_s = face.tile_s * render::kTileTexels, first_t = face.tile_t * render::kTileTexels;
  for (const Line& border : {Line{1, 0, -first_s}, Line{-1, 0, first_s + render::kTileTexels},
                             Line{0, 1, -first_t}, Line{0, -1, first_t + render::kTileTexels}})
    polygon = cut(polygon, border);
  for (Corner& corner : polygon) {
    corner.along_s = (corner.along_s - double{light.s}) * double{light.units_per_s};
    corner.along_t = (corner.along_t - double{light.t}) * double{light.units_per_t};
  }
  return polygon;
}

}  // namespace

void add_light_polygons(const LightPolygonFace& face, const render::FaceLight& light,
                        std::vector<LightCorner>& io_triangles) {
  const Polygon tile = find_tile(face, light);
  for (const double side_s : {1.0, -1.0}) {
    const Polygon half = cut(tile, {side_s, 0});
    for (const double side_t : {1.0, -1.0}) {
      const Polygon quarter = cut(half, {0, side_t});
      for (const bool is_longer_s : {true, false}) {
        const double sign = is_longer_s ? 1 : -1;
        const Line distance{side_s * (is_longer_s ? 1 : 0.5), side_t * (is_longer_s ? 0.5 : 1)};
        const Polygon eighth = cut(cut(quarter, {sign * side_s, -sign * side_t}),
                                   {-distance.s, -distance.t, double{light.reach}});
        const auto add = [&](const Corner& corner) {
          const double amount = double{light.at_nearest} - distance.distance(corner);
          io_triangles.push_back({math::Vec3(corner.at), static_cast<float>(std::max(amount, 0.0))});
        };
        for (std::size_t i = 2; i < eighth.size(); ++i) {
          add(eighth[0]);
          add(eighth[i - 1]);
          add(eighth[i]);
        }
      }
    }
  }
}

}  // namespace temblor::render_gl
