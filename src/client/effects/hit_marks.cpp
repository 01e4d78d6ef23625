#include "client/effects/hit_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "math/angles.h"
#include "world/trace.h"

namespace temblor::client {

namespace {

using world::NearFace;

constexpr double kMinRadius = 0.5, kMaxRadius = 128;
constexpr double kTouching = 0.25;  // units; at this distance nothing can be in between
constexpr double kOffFace = 0.5;    // units before a face where a line of sight to it ends

// Planes that differ by no more than this are one, for pictures.
constexpr double kSameCosine = 0.9999, kSameDistance = 0.1;
// The distance from the center to the corners of a picture, relative to half its side.
constexpr double kCorner = 1.4142135623730951;

math::Vec3d face_normal(const world::Level& level, world::FaceIndex face) {
  return world::compute_face_plane(level, level.face(face)).normal;
}

bool is_liquid(const world::Level& level, const NearFace& near) {
  return level.face(near.face).kind == world::FaceKind::kLiquid;
}

// Sky and liquids cannot be marked.
bool can_be_marked(const world::Level& level, const NearFace& near) {
  const world::FaceKind kind = level.face(near.face).kind;
  return kind == world::FaceKind::kLit || kind == world::FaceKind::kUnlit;
}

// The distance from a point to a box; 0 inside.
double compute_distance(const math::Bounds& box, const math::Vec3d& point) {
  const math::Vec3d outside =
      glm::max(glm::max(math::Vec3d(box.mins) - point, point - math::Vec3d(box.maxs)), math::Vec3d(0.0));
  return glm::length(outside);
}

// The direction of a picture's upper edge on a plane, turned clockwise as seen from the front.
math::Vec3 compute_up(const math::Vec3d& normal, float turn_deg) {
  constexpr double kSteep = 0.99;
  const math::Vec3d wanted = std::abs(normal.z) > kSteep ? math::Vec3d(0, 1, 0) : math::Vec3d(0, 0, 1);
  const math::Vec3d up = glm::normalize(wanted - normal * glm::dot(normal, wanted));
  const math::Vec3d right = glm::cross(up, normal);
  const double turn = static_cast<double>(turn_deg) * std::numbers::pi / 180;
  return math::Vec3(up * std::cos(turn) + right * std::sin(turn));
}

}  // namespace

math::Vec3d HitMarks::Target::to_model(const math::Vec3d& world) const {
  const math::Vec3d away = world - origin_world;
  return {glm::dot(away, x_axis), glm::dot(away, y_axis), glm::dot(away, z_axis)};
}

math::Vec3d HitMarks::Target::to_world(const math::Vec3d& model_point) const {
  return origin_world + x_axis * model_point.x + y_axis * model_point.y + z_axis * model_point.z;
}

// The renderer places brush models in the same way.
HitMarks::Target HitMarks::make_target(const render::BrushModelInstance& mover) {
  const math::Basis basis = math::basis_from_angles(mover.angles_deg);
  return {mover.model, math::Vec3d(mover.origin_world), basis.forward, -basis.right, basis.up};
}

// The world, and the movers that the hit or its ball can reach.
void HitMarks::find_targets(const world::Level& level, std::span<const render::BrushModelInstance> movers,
                            const Hit& hit) {
  targets_.assign(1, Target{});
  const double reach = double{hit.reach} + kCorner * double{hit.radius};
  for (const render::BrushModelInstance& mover : movers) {
    const Target target = make_target(mover);
    const math::Vec3d local = target.to_model(math::Vec3d(hit.origin_world));
    if (compute_distance(level.models[base::to_size(mover.model)].bounds, local) <= reach)
      targets_.push_back(target);
  }
}

// Returns whether a line from `from_world` reaches the face: neither the world nor a mover is in between. A
// line that starts inside one of them, which rounding in messages can cause, counts as free.
bool HitMarks::is_in_sight(const world::Level& level, const math::Vec3d& from_world,
                           const Place& place) const {
  if (place.near.distance <= kTouching) return true;
  const math::Vec3d off_face = face_normal(level, place.near.face) * kOffFace;
  const math::Vec3d to_world = place.target.to_world(place.near.nearest + off_face);
  return std::all_of(targets_.begin(), targets_.end(), [&](const Target& target) {
    const world::Trace trace =
        world::trace_line(level, target.model, world::Hull::kPoint, math::Vec3(target.to_model(from_world)),
                          math::Vec3(target.to_model(to_world)));
    return trace.fraction >= 1 || trace.start_solid;
  });
}

// Adds the marks of a hit at `hit_place` to the faces of one model that its ball cuts. A face at distance d
// from the center is cut in a circle of radius sqrt(r^2 - d^2).
void HitMarks::mark_faces(const world::Level& level, const Hit& hit, const Place& hit_place,
                          const Target& target, render::MarkSet& io_marks) {
  const bool is_picture = hit.kind == render::MarkKind::kPicture;
  const math::Vec3d hit_normal = face_normal(level, hit_place.near.face);
  const math::Vec3d center_world = hit_place.target.to_world(hit_place.near.nearest);
  const math::Vec3d before_world = hit_place.target.to_world(hit_place.near.nearest + hit_normal * kOffFace);
  const math::Vec3d center = target.to_model(center_world);
  const double ball = double{hit.radius}, reach = is_picture ? kCorner * ball : ball;
  for (const NearFace& near : faces_near_.find(level, target.model, center, reach)) {
    if (!can_be_marked(level, near)) continue;
    const math::Vec3d normal = face_normal(level, near.face);
    const double plane_distance = std::max(0.0, near.in_front);
    const double cut = std::sqrt(std::max(0.0, ball * ball - plane_distance * plane_distance));
    if (is_picture && (glm::dot(normal, hit_normal) < kSameCosine || std::abs(near.in_front) > kSameDistance))
      continue;
    if (cut < kMinRadius || !is_in_sight(level, before_world, {target, near})) continue;
    render::Mark mark{.kind = hit.kind,
                      .position_model = math::Vec3(center - normal * near.in_front),
                      .radius = static_cast<float>(std::min(is_picture ? ball : cut, kMaxRadius)),
                      .seed = hit.seed,
                      .picture = hit.picture,
                      .is_lasting = hit.is_lasting};
    if (is_picture) mark.up_model = compute_up(normal, hit.turn_deg);
    io_marks.add(near.face, mark);
  }
}

// The nearest visible face within reach is the one that was hit. Shots pass through the surface of water, so
// liquids are skipped.
std::optional<HitMarks::Place> HitMarks::find_place(const world::Level& level, const Hit& hit) {
  const math::Vec3d origin(hit.origin_world);
  std::optional<Place> hit_place;
  for (const Target& target : targets_)
    for (const NearFace& near :
         faces_near_.find(level, target.model, target.to_model(origin), double{hit.reach})) {
      if (hit_place && near.distance >= hit_place->near.distance) continue;
      if (!is_liquid(level, near) && is_in_sight(level, origin, {target, near}))
        hit_place = Place{target, near};
    }
  if (hit_place && !can_be_marked(level, hit_place->near)) return std::nullopt;
  return hit_place;
}

std::optional<HitMarks::Surface> HitMarks::find_surface(const world::Level& level,
                                                        std::span<const render::BrushModelInstance> movers,
                                                        const Hit& hit) {
  find_targets(level, movers, hit);
  const std::optional<Place> place = find_place(level, hit);
  if (!place) return std::nullopt;
  const math::Vec3d normal = face_normal(level, place->near.face);
  const Target& target = place->target;
  return Surface{place->near.face,
                 math::Vec3(target.x_axis * normal.x + target.y_axis * normal.y + target.z_axis * normal.z)};
}

// The ball around the nearest point of the face marks all faces that it touches.
void HitMarks::add_to_targets(const world::Level& level, const Hit& hit, render::MarkSet& io_marks) {
  const std::optional<Place> hit_place = find_place(level, hit);
  if (!hit_place) return;
  for (const Target& target : targets_) {
    const bool is_hit = target.model == hit_place->target.model;
    if (is_hit || hit.kind != render::MarkKind::kPicture)
      mark_faces(level, hit, *hit_place, target, io_marks);
  }
}

void HitMarks::add(const world::Level& level, std::span<const render::BrushModelInstance> movers,
                   const Hit& hit, render::MarkSet& io_marks) {
  find_targets(level, movers, hit);
  add_to_targets(level, hit, io_marks);
}

void HitMarks::add_to_model(const world::Level& level, world::ModelIndex model, const Hit& hit,
                            render::MarkSet& io_marks) {
  targets_.assign(1, Target{.model = model});
  add_to_targets(level, hit, io_marks);
}

}  // namespace temblor::client
