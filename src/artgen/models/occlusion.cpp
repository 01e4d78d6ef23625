// Method: cast rays over the hemisphere, distributed by the cosine to the normal, at the triangles nearby. A
// ray that hits at distance d counts 1 - d / reach.
#include "artgen/models/occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace temblor::artgen {
namespace {

using math::Vec3d;

// Few rays are enough, because skins have only 16 shades of a color.
constexpr int kRays = 20;
// Rays start so many units above the surface.
constexpr double kOffSurface = 0.05;

// The terms of the ray-triangle test that are the same for all rays from one point (T. Moeller and B.
// Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997).
struct SeenTriangle {
  Vec3d edge_a, edge_b, offset, across;
  double height = 0;
};

// Shortens io_nearest to the distance at which the ray meets the triangle. It divides only after the hit is
// certain, because most rays miss.
void clip_ray(const SeenTriangle& triangle, const Vec3d& direction, double& io_nearest) {
  const Vec3d normal = glm::cross(direction, triangle.edge_b);
  const double volume = glm::dot(triangle.edge_a, normal);
  const double sign = volume < 0 ? -1 : 1, size = volume * sign;
  const double u = glm::dot(triangle.offset, normal) * sign, v = glm::dot(direction, triangle.across) * sign;
  if (u < 0 || v < 0 || u + v > size || size < 1e-12) return;
  const double distance = triangle.height / volume;
  if (distance > 0 && distance < io_nearest) io_nearest = distance;
}

}  // namespace

Occlusion::Occlusion(const Mesh& mesh, double reach) : reach_(reach) {
  for (const MeshTriangle& triangle : mesh.triangles) {
    const Vec3d a = mesh.points[triangle.corners[0].point].rest,
                b = mesh.points[triangle.corners[1].point].rest,
                c = mesh.points[triangle.corners[2].point].rest;
    const Vec3d middle = (a + b + c) / 3.0;
    const double radius =
        std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
    triangles_.push_back({a, b - a, c - a, middle, radius});
  }
  near_.resize(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (std::size_t j = 0; j < triangles_.size(); ++j)
      if (glm::distance(triangles_[i].middle, triangles_[j].middle) <
          reach + triangles_[i].radius + triangles_[j].radius)
        near_[i].push_back(j);
  // Points on a golden-angle spiral are evenly distributed without a visible pattern. The square root makes
  // them uniform on the disc; projected up to the hemisphere, they follow the cosine (Malley's method).
  for (int i = 0; i < kRays; ++i) {
    const double out = std::sqrt((i + 0.5) / kRays), angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    directions_.emplace_back(out * std::cos(angle), out * std::sin(angle), std::sqrt(1 - out * out));
  }
}

double Occlusion::at(std::size_t triangle, const Vec3d& position, const Vec3d& normal) const {
  const Vec3d from = position + normal * kOffSurface;
  std::vector<SeenTriangle> close;
  for (const std::size_t other : near_[triangle]) {
    const Triangle& candidate = triangles_[other];
    if (other == triangle || glm::distance(candidate.middle, from) > reach_ + candidate.radius) continue;
    // Triangles below the tangent plane, such as the rest of a convex shape, hide nothing.
    const double height = glm::dot(candidate.corner - from, normal);
    const double highest =
        height + std::max({0.0, glm::dot(candidate.edge_a, normal), glm::dot(candidate.edge_b, normal)});
    if (highest <= 0) continue;
    const Vec3d offset = from - candidate.corner, across = glm::cross(offset, candidate.edge_a);
    close.push_back({candidate.edge_a, candidate.edge_b, offset, across, glm::dot(candidate.edge_b, across)});
  }
  const Vec3d hint = std::abs(normal.z) < 0.7 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
  const Vec3d side = glm::normalize(glm::cross(hint, normal)), up = glm::cross(normal, side);
  double hidden = 0;
  for (const Vec3d& direction : directions_) {
    const Vec3d world = side * direction.x + up * direction.y + normal * direction.z;
    double nearest = reach_;
    for (const SeenTriangle& candidate : close) clip_ray(candidate, world, nearest);
    hidden += 1 - nearest / reach_;
  }
  return hidden / kRays;
}

}  // namespace temblor::artgen
