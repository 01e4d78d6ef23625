#include "render/alias/clip_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace temblor::render {

namespace {

// The sides are clipped far outside the picture, but well inside the range of coordinates that can be
// projected.
constexpr double kClipPixels = kGuardPixels / 2;
constexpr std::size_t kPlanes = 5;
// A triangle has three corners, and each plane adds at most one.
constexpr std::size_t kMaxCorners = 3 + kPlanes;

// A vertex with everything that is interpolated along an edge.
struct Corner {
  math::Vec3d view;
  double light, s, t;
  std::uint32_t vertex;  // the mesh's vertex, or kNew
  static constexpr std::uint32_t kNew = 0xffffffff;
};

Corner between(const Corner& a, const Corner& b, double along) {
  const auto mix = [along](const auto& from, const auto& to) { return from + (to - from) * along; };
  return {mix(a.view, b.view), mix(a.light, b.light), mix(a.s, b.s), mix(a.t, b.t), Corner::kNew};
}

struct Polygon {
  std::array<Corner, kMaxCorners> corners;
  std::size_t count = 0;
  void add(const Corner& corner) { corners[count++] = corner; }
};

// Clips polygons against one plane at a time (Sutherland and Hodgman), in view space.
class Clipper {
 public:
  Clipper(const ViewFrame& view, const AliasPlacement& placement, const ProjectedMesh& mesh,
          std::int32_t steps_per_pixel, base::Arena& arena)
      : view_(view),
        placement_(placement),
        mesh_(mesh),
        steps_per_pixel_(steps_per_pixel),
        vertices_(arena, mesh.vertices.size() + 64),
        texels_(arena, mesh.vertices.size() + 64),
        triangles_(arena, mesh.triangles.size() + 64),
        codes_(arena.allocate<std::uint8_t>(mesh.vertices.size())) {}

  ClippedMesh clip() {
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
      vertices_.push_back(mesh_.vertices[i]);
      texels_.push_back(mesh_.texels[i]);
      codes_[i] = clip_code(position(i));
    }
    for (const MeshTriangle& triangle : mesh_.triangles) {
      const std::uint8_t a = codes_[triangle[0]], b = codes_[triangle[1]], c = codes_[triangle[2]];
      if ((a & b & c) != 0) continue;
      if ((a | b | c) == 0)
        triangles_.push_back(triangle);
      else
        clip(triangle, static_cast<std::uint8_t>(a | b | c));
    }
    return {vertices_.view(), texels_.view(), triangles_.view()};
  }

 private:
  math::Vec3d position(std::size_t i) const { return {mesh_.view[0][i], mesh_.view[1][i], mesh_.view[2][i]}; }

  // The signed distance from a plane, up to a positive factor. Planes: near, left, right, bottom, top.
  double distance(std::size_t plane, const math::Vec3d& p) const {
    const double scale = placement_.pixels_per_unit;
    const double reach = placement_.perspective ? kClipPixels * p.z : kClipPixels;
    switch (plane) {
      case 0:
        return p.z - double{placement_.near_z};
      case 1:
        return reach + p.x * scale;
      case 2:
        return reach - p.x * scale;
      case 3:
        return reach + p.y * scale;
      default:
        return reach - p.y * scale;
    }
  }

  // One bit for each plane that the point is outside of.
  std::uint8_t clip_code(const math::Vec3d& p) const {
    unsigned code = 0;
    for (std::size_t plane = 0; plane < kPlanes; ++plane)
      if (distance(plane, p) < 0) code |= 1u << plane;
    return static_cast<std::uint8_t>(code);
  }

  void clip(const MeshTriangle& triangle, std::uint8_t planes) {
    Polygon polygon;
    for (const std::uint32_t i : triangle)
      polygon.add({position(i), mesh_.vertices[i].light, mesh_.texels[i].s, mesh_.texels[i].t, i});
    for (std::size_t plane = 0; plane < kPlanes && polygon.count > 0; ++plane)
      if ((planes >> plane & 1) != 0) polygon = cut(polygon, plane);
    if (polygon.count < 3) return;
    std::array<std::uint32_t, kMaxCorners> numbers;
    for (std::size_t i = 0; i < polygon.count; ++i) numbers[i] = emit_vertex(polygon.corners[i]);
    for (std::size_t i = 2; i < polygon.count; ++i)
      triangles_.push_back({numbers[0], numbers[i - 1], numbers[i]});
  }

  Polygon cut(const Polygon& polygon, std::size_t plane) const {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const Corner& here = polygon.corners[i];
      const Corner& next = polygon.corners[i + 1 < polygon.count ? i + 1 : 0];
      const double d = distance(plane, here.view), d_next = distance(plane, next.view);
      if (d >= 0) kept.add(here);
      // Always computed from the inner corner, so that both triangles at an edge get the same point.
      if (d >= 0 && d_next < 0) kept.add(between(here, next, d / (d - d_next)));
      if (d < 0 && d_next >= 0) kept.add(between(next, here, d_next / (d_next - d)));
    }
    return kept;
  }

  // Projects a new corner like the vertex kernels do, but in double.
  std::uint32_t emit_vertex(const Corner& corner) {
    if (corner.vertex != Corner::kNew) return corner.vertex;
    double scale = placement_.pixels_per_unit, depth = -corner.view.z;
    if (placement_.perspective) {
      const double nearness = 1.0 / std::max(corner.view.z, double{placement_.near_z});
      scale *= nearness;
      depth = nearness * double{placement_.depth_scale};
    }
    vertices_.push_back({to_subpixels(view_.center_x + corner.view.x * scale),
                         to_subpixels(view_.center_y - corner.view.y * scale), static_cast<float>(depth),
                         static_cast<float>(corner.light)});
    texels_.push_back({static_cast<float>(corner.s), static_cast<float>(corner.t)});
    return static_cast<std::uint32_t>(vertices_.size() - 1);
  }

  std::int32_t to_subpixels(double pixels) const {
    return static_cast<std::int32_t>(std::nearbyint(pixels * steps_per_pixel_)) *
           (kSubpixels / steps_per_pixel_);
  }

  const ViewFrame& view_;
  const AliasPlacement& placement_;
  const ProjectedMesh& mesh_;
  const std::int32_t steps_per_pixel_;
  base::ArenaVector<ScreenVertex> vertices_;
  base::ArenaVector<TexelPoint> texels_;
  base::ArenaVector<MeshTriangle> triangles_;
  std::span<std::uint8_t> codes_;
};

}  // namespace

ClippedMesh clip_triangles(const ViewFrame& view, const AliasPlacement& placement, const ProjectedMesh& mesh,
                           std::int32_t steps_per_pixel, base::Arena& arena) {
  return Clipper(view, placement, mesh, steps_per_pixel, arena).clip();
}

}  // namespace temblor::render
