#include "client/effects/hit_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "world/trace.h"

namespace temblor::client {

namespace {

using world::NearFace;

constexpr double kMinRadius = 0.5, kMaxRadius = 128;
constexpr double kTouching = 0.25;  // units: nothing stands between
constexpr double kOffFace = 0.5;    // where a line of sight to a face ends, before it

// Whether a line from `from` reaches the face. One that starts inside a wall, as messages' rounding may have
// it, counts as free.
bool in_sight(const world::Level& level, const math::Vec3d& from, const NearFace& near) {
  if (near.distance <= kTouching) return true;
  const math::Vec3d off = world::plane_of(level, level.face(near.face)).normal * kOffFace;
  const world::Trace trace = world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint,
                                               math::Vec3(from), math::Vec3(near.nearest + off));
  return trace.fraction >= 1 || trace.start_solid;
}

bool is_liquid(const world::Level& level, const NearFace& near) {
  return level.face(near.face).kind == world::FaceKind::kLiquid;
}

std::optional<NearFace> nearest_in_sight(const world::Level& level, const math::Vec3d& from,
                                         std::span<const NearFace> faces) {
  std::optional<NearFace> nearest;
  for (const NearFace& near : faces) {
    if (nearest && near.distance >= nearest->distance) continue;
    if (!is_liquid(level, near) && in_sight(level, from, near)) nearest = near;
  }
  return nearest;
}

bool takes_marks(const world::Level& level, const NearFace& near) {
  const world::FaceKind kind = level.face(near.face).kind;
  return kind == world::FaceKind::kLit || kind == world::FaceKind::kUnlit;
}

}  // namespace

void HitMarks::leave(const world::Level& level, const Hit& hit, render::MarkSet& io_marks) {
  const math::Vec3d origin(hit.origin_world);
  const std::optional<NearFace> struck =
      nearest_in_sight(level, origin, faces_near_.find(level, origin, double{hit.reach}));
  if (!struck || !takes_marks(level, *struck)) return;
  const math::Vec3d center = struck->nearest;
  const math::Vec3d off_face = world::plane_of(level, level.face(struck->face)).normal * kOffFace;
  for (const NearFace& near : faces_near_.find(level, center, double{hit.radius})) {
    const double deep = std::max(0.0, near.in_front);
    const double radius = std::sqrt(std::max(0.0, double{hit.radius} * double{hit.radius} - deep * deep));
    if (radius < kMinRadius || !takes_marks(level, near)) continue;
    if (!in_sight(level, center + off_face, near)) continue;
    const math::Vec3d normal = world::plane_of(level, level.face(near.face)).normal;
    io_marks.add(near.face, {hit.kind, math::Vec3(center - normal * near.in_front),
                             static_cast<float>(std::min(radius, kMaxRadius)), hit.seed});
  }
}

}  // namespace temblor::client
