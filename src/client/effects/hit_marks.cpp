#include "client/effects/hit_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "world/trace.h"

namespace temblor::client {

namespace {

using world::NearFace;

constexpr double kMinRadius = 0.5, kMaxRadius = 128;
constexpr double kTouching = 0.25;  // units; at this distance nothing can be in between
constexpr double kOffFace = 0.5;    // units before a face where a line of sight to it ends

// Returns whether a line from `from` reaches the face. A line that starts inside a wall, which rounding in
// messages can cause, counts as free.
bool is_in_sight(const world::Level& level, const math::Vec3d& from, const NearFace& near) {
  if (near.distance <= kTouching) return true;
  const math::Vec3d off = world::compute_face_plane(level, level.face(near.face)).normal * kOffFace;
  const world::Trace trace = world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint,
                                               math::Vec3(from), math::Vec3(near.nearest + off));
  return trace.fraction >= 1 || trace.start_solid;
}

bool is_liquid(const world::Level& level, const NearFace& near) {
  return level.face(near.face).kind == world::FaceKind::kLiquid;
}

// Shots pass through the surface of water, so liquids are skipped.
std::optional<NearFace> find_nearest_in_sight(const world::Level& level, const math::Vec3d& from,
                                              std::span<const NearFace> faces) {
  std::optional<NearFace> nearest;
  for (const NearFace& near : faces) {
    if (nearest && near.distance >= nearest->distance) continue;
    if (!is_liquid(level, near) && is_in_sight(level, from, near)) nearest = near;
  }
  return nearest;
}

// Sky and liquids cannot be marked.
bool can_be_marked(const world::Level& level, const NearFace& near) {
  const world::FaceKind kind = level.face(near.face).kind;
  return kind == world::FaceKind::kLit || kind == world::FaceKind::kUnlit;
}

}  // namespace

// Two searches: the nearest visible face within reach is the one that was hit, and the ball around its
// nearest point marks all faces that it touches. A face at distance d from the center is cut in a circle of
// radius sqrt(r^2 - d^2).
void HitMarks::add(const world::Level& level, const Hit& hit, render::MarkSet& io_marks) {
  const math::Vec3d origin(hit.origin_world);
  const std::optional<NearFace> hit_face =
      find_nearest_in_sight(level, origin, faces_near_.find(level, origin, double{hit.reach}));
  if (!hit_face || !can_be_marked(level, *hit_face)) return;
  const math::Vec3d center = hit_face->nearest;
  const math::Vec3d off_face = world::compute_face_plane(level, level.face(hit_face->face)).normal * kOffFace;
  for (const NearFace& near : faces_near_.find(level, center, double{hit.radius})) {
    const double plane_distance = std::max(0.0, near.in_front);
    const double radius =
        std::sqrt(std::max(0.0, double{hit.radius} * double{hit.radius} - plane_distance * plane_distance));
    if (radius < kMinRadius || !can_be_marked(level, near)) continue;
    if (!is_in_sight(level, center + off_face, near)) continue;
    const math::Vec3d normal = world::compute_face_plane(level, level.face(near.face)).normal;
    io_marks.add(near.face, {hit.kind, math::Vec3(center - normal * near.in_front),
                             static_cast<float>(std::min(radius, kMaxRadius)), hit.seed});
  }
}

}  // namespace temblor::client
