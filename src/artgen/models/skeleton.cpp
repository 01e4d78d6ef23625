#include "artgen/models/skeleton.h"

#include <algorithm>
#include <cmath>

namespace temblor::artgen {
namespace {

using math::Vec3d;

// An upper bone, a lower one that hangs on it, and the end that hangs on that.
struct LimbBones {
  std::size_t upper, lower, end;
};

LimbBones bones_of(const Skeleton& skeleton, const Limb& limb) {
  const std::size_t lower = *skeleton.bones[limb.end].parent;
  return {*skeleton.bones[lower].parent, lower, limb.end};
}

glm::dmat3 scaling(const Vec3d& scale) {
  return {{scale.x, 0, 0}, {0, scale.y, 0}, {0, 0, scale.z}};
}

// Every bone from its parent. `turns_world`: a limb's bones have their direction already.
std::vector<Transform> chain(const Skeleton& skeleton, const BonePose& pose,
                             const std::vector<std::optional<glm::dmat3>>& turns_world) {
  std::vector<Transform> placed(skeleton.bones.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    const BoneMotion& motion = pose.bones[i];
    const Transform parent = bone.parent ? placed[*bone.parent] : Transform{};
    const Vec3d grown = bone.parent ? skeleton.bones[*bone.parent].scale : Vec3d(1.0);
    const Vec3d shift = skeleton.limb_at(i) != nullptr ? Vec3d(0.0) : motion.at;
    placed[i].offset = parent(bone.at * grown + shift);
    const glm::dmat3 turn = turns_world[i] ? *turns_world[i] : parent.linear * rotation(motion.turn_deg);
    placed[i].linear = turn * scaling(motion.scale);
  }
  return placed;
}

Vec3d direction(const Vec3d& v, const Vec3d& otherwise) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : otherwise;
}

// Axes with the first along `along` and the second as near to `normal` as it can.
glm::dmat3 axes(const Vec3d& along, const Vec3d& normal) {
  const Vec3d first = direction(along, {0, 0, 1});
  Vec3d second = normal - first * glm::dot(first, normal);
  if (glm::length(second) < 1e-6) second = glm::cross(first, Vec3d(first.z, first.x, first.y));
  second = glm::normalize(second);
  return {first, second, glm::cross(first, second)};
}

// The rotation that takes one direction with its normal to another.
glm::dmat3 turn_between(const Vec3d& from, const Vec3d& from_normal, const Vec3d& to,
                        const Vec3d& to_normal) {
  return axes(to, to_normal) * glm::transpose(axes(from, from_normal));
}

glm::dmat3 unscaled(const glm::dmat3& linear) {
  return {glm::normalize(linear[0]), glm::normalize(linear[1]), glm::normalize(linear[2])};
}

// Between two rotations, by their axes.
glm::dmat3 mixed_turn(const glm::dmat3& from, const glm::dmat3& to, double fraction) {
  const Vec3d first = from[0] * (1 - fraction) + to[0] * fraction;
  const Vec3d second = from[1] * (1 - fraction) + to[1] * fraction;
  return axes(first, second);
}

void bend_limb(const Skeleton& skeleton, const Limb& limb, const BonePose& pose,
               const std::vector<Vec3d>& rest, const std::vector<Transform>& placed,
               std::vector<std::optional<glm::dmat3>>& io_turns_world) {
  const double weight = limb.grip_on ? pose.hold : pose.plant;
  if (weight <= 0) return;
  const LimbBones at = bones_of(skeleton, limb);
  const Vec3d own_goal = limb.grip_on ? placed[*limb.grip_on](limb.grip_at + pose.bones[at.end].at)
                                      : rest[at.end] + pose.bones[at.end].at;
  const Vec3d root = placed[at.upper].offset;
  const Vec3d goal = glm::mix(placed[at.end].offset, own_goal, weight);

  const double upper = glm::distance(rest[at.upper], rest[at.lower]);
  const double lower = glm::distance(rest[at.lower], rest[at.end]);
  const Vec3d along = direction(goal - root, {0, 0, -1});
  const double reach =
      std::clamp(glm::distance(goal, root), std::abs(upper - lower) + 1e-3, (upper + lower) * 0.9995);
  const double ahead = (upper * upper - lower * lower + reach * reach) / (2 * reach);
  const double aside = std::sqrt(std::max(0.0, upper * upper - ahead * ahead));

  const auto& parent = skeleton.bones[at.upper].parent;
  const Vec3d bend_world = (parent ? unscaled(placed[*parent].linear) : glm::dmat3(1.0)) * limb.bend;
  const glm::dmat3 plane = axes(along, bend_world);
  const Vec3d knee = root + along * ahead + plane[1] * aside;
  const Vec3d end = root + along * reach;
  const Vec3d rest_normal = axes(rest[at.end] - rest[at.upper], limb.bend)[2];
  io_turns_world[at.upper] =
      turn_between(rest[at.lower] - rest[at.upper], rest_normal, knee - root, plane[2]);
  io_turns_world[at.lower] = turn_between(rest[at.end] - rest[at.lower], rest_normal, end - knee, plane[2]);
  // A foot is flat on the floor but for its own turn; a hand follows the arm.
  const glm::dmat3 own_turn = rotation(pose.bones[at.end].turn_deg);
  io_turns_world[at.end] = limb.grip_on
                               ? *io_turns_world[at.lower] * own_turn
                               : mixed_turn(unscaled(placed[at.end].linear), own_turn, std::min(weight, 1.0));
}

}  // namespace

std::optional<std::size_t> Skeleton::find(std::string_view name) const {
  for (std::size_t i = 0; i < bones.size(); ++i)
    if (bones[i].name == name) return i;
  return {};
}

const Limb* Skeleton::limb_at(std::size_t end) const {
  for (const Limb& limb : limbs)
    if (limb.end == end) return &limb;
  return nullptr;
}

std::vector<Vec3d> rest_places(const Skeleton& skeleton) {
  std::vector<Vec3d> places;
  for (const Bone& bone : skeleton.bones)
    places.push_back(bone.parent ? places[*bone.parent] + bone.at * skeleton.bones[*bone.parent].scale
                                 : bone.at);
  return places;
}

std::vector<Transform> place_bones(const Skeleton& skeleton, const BonePose& pose) {
  const std::vector<Vec3d> rest = rest_places(skeleton);
  std::vector<std::optional<glm::dmat3>> turns_world(skeleton.bones.size());
  std::vector<Transform> placed = chain(skeleton, pose, turns_world);
  // One after the other: a grip may be on what another limb moves.
  for (const Limb& limb : skeleton.limbs) {
    bend_limb(skeleton, limb, pose, rest, placed, turns_world);
    placed = chain(skeleton, pose, turns_world);
  }
  return placed;
}

}  // namespace temblor::artgen
