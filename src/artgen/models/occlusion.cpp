// Rays over the hemisphere, dense where light matters most (cosine-weighted), against the triangles near by.
#include "artgen/models/occlusion.h"

#include <cmath>
#include <numbers>

namespace temblor::artgen {
namespace {

using math::Vec3d;

constexpr int kRays = 20;
constexpr double kOffSurface = 0.05;  // units

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
  // A spiral with the golden angle: even, and without a pattern.
  for (int i = 0; i < kRays; ++i) {
    const double out = std::sqrt((i + 0.5) / kRays), angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    ways_.emplace_back(out * std::cos(angle), out * std::sin(angle), std::sqrt(1 - out * out));
  }
}

// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
bool Occlusion::hit(const Triangle& triangle, const Vec3d& from, const Vec3d& way, double& io_nearest) const {
  const Vec3d across = glm::cross(way, triangle.edge_b);
  const double volume = glm::dot(triangle.edge_a, across);
  if (std::abs(volume) < 1e-12) return false;
  const Vec3d offset = from - triangle.corner;
  const double u = glm::dot(offset, across) / volume;
  if (u < 0 || u > 1) return false;
  const Vec3d other = glm::cross(offset, triangle.edge_a);
  const double v = glm::dot(way, other) / volume;
  if (v < 0 || u + v > 1) return false;
  const double distance = glm::dot(triangle.edge_b, other) / volume;
  if (distance <= 0 || distance >= io_nearest) return false;
  io_nearest = distance;
  return true;
}

double Occlusion::at(std::size_t triangle, const Vec3d& place, const Vec3d& normal) const {
  const Vec3d from = place + normal * kOffSurface;
  std::vector<const Triangle*> close;
  for (const std::size_t other : near_[triangle]) {
    const Triangle& candidate = triangles_[other];
    const Vec3d way = candidate.middle - from;
    if (other != triangle && glm::length(way) < reach_ + candidate.radius &&
        glm::dot(way, normal) > -candidate.radius)
      close.push_back(&candidate);
  }
  const Vec3d hint = std::abs(normal.z) < 0.7 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
  const Vec3d side = glm::normalize(glm::cross(hint, normal)), up = glm::cross(normal, side);
  double hidden = 0;
  for (const Vec3d& way : ways_) {
    const Vec3d world = side * way.x + up * way.y + normal * way.z;
    double nearest = reach_;
    for (const Triangle* candidate : close) hit(*candidate, from, world, nearest);
    hidden += 1 - nearest / reach_;
  }
  return hidden / kRays;
}

}  // namespace temblor::artgen
