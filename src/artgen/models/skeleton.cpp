#include "artgen/models/skeleton.h"

#include <algorithm>
#include <cmath>

namespace temblor::artgen {
namespace {

using math::Vec3d;

// Like hip, knee, and foot, or shoulder, elbow, and hand.
struct LimbBones {
  std::size_t upper, lower, end;
};

LimbBones find_limb_bones(const Skeleton& skeleton, const Limb& limb) {
  const std::size_t lower = *skeleton.bones[limb.end].parent;
  return {*skeleton.bones[lower].parent, lower, limb.end};
}

glm::dmat3 make_scaling(const Vec3d& scale) {
  return {{scale.x, 0, 0}, {0, scale.y, 0}, {0, 0, scale.z}};
}

// Forward kinematics. `turns_world`: rotations in the model's coordinates that replace those of the pose, for
// the bones of solved limbs.
std::vector<Transform> chain_bones(const Skeleton& skeleton, const BonePose& pose,
                                   const std::vector<std::optional<glm::dmat3>>& turns_world) {
  std::vector<Transform> placed(skeleton.bones.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    const BoneMotion& motion = pose.bones[i];
    const Transform parent = bone.parent ? placed[*bone.parent] : Transform{};
    const Vec3d grown = bone.parent ? skeleton.bones[*bone.parent].scale : Vec3d(1.0);
    // The `at` of a limb's end belongs to the goal of the limb.
    const Vec3d shift = skeleton.limb_at(i) != nullptr ? Vec3d(0.0) : motion.at;
    placed[i].offset = parent(bone.at * grown + shift);
    const glm::dmat3 turn = turns_world[i] ? *turns_world[i] : parent.linear * make_rotation(motion.turn_deg);
    placed[i].linear = turn * make_scaling(motion.scale);
  }
  return placed;
}

// `fallback` if the vector has no direction.
Vec3d normalize_or(const Vec3d& v, const Vec3d& fallback) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : fallback;
}

// A rotation whose first column is `along` and whose second is as close to `normal` as possible.
glm::dmat3 make_axes(const Vec3d& along, const Vec3d& normal) {
  const Vec3d first = normalize_or(along, {0, 0, 1});
  Vec3d second = normal - first * glm::dot(first, normal);
  if (glm::length(second) < 1e-6) second = glm::cross(first, Vec3d(first.z, first.x, first.y));
  second = glm::normalize(second);
  return {first, second, glm::cross(first, second)};
}

// The rotation that maps one direction and its normal to another pair.
glm::dmat3 turn_between(const Vec3d& from, const Vec3d& from_normal, const Vec3d& to,
                        const Vec3d& to_normal) {
  return make_axes(to, to_normal) * glm::transpose(make_axes(from, from_normal));
}

// The rotation of a matrix without shear.
glm::dmat3 remove_scale(const glm::dmat3& linear) {
  return {glm::normalize(linear[0]), glm::normalize(linear[1]), glm::normalize(linear[2])};
}

// Interpolates the first two axes and makes them orthogonal again.
glm::dmat3 blend_rotations(const glm::dmat3& from, const glm::dmat3& to, double fraction) {
  const Vec3d first = from[0] * (1 - fraction) + to[0] * fraction;
  const Vec3d second = from[1] * (1 - fraction) + to[1] * fraction;
  return make_axes(first, second);
}

// Two-bone inverse kinematics. The three joints form a triangle with known sides: the two bones and the
// distance from the root to the goal. The law of cosines gives the knee's position in the plane of the bend
// direction. Writes the rotations of the three bones.
void solve_limb(const Skeleton& skeleton, const Limb& limb, const BonePose& pose,
                const std::vector<Vec3d>& rest, const std::vector<Transform>& placed,
                std::vector<std::optional<glm::dmat3>>& io_turns_world) {
  const double weight = limb.grip_on ? pose.hold : pose.plant;
  if (weight <= 0) return;
  const LimbBones at = find_limb_bones(skeleton, limb);
  const Vec3d own_goal = limb.grip_on ? placed[*limb.grip_on](limb.grip_at + pose.bones[at.end].at)
                                      : rest[at.end] + pose.bones[at.end].at;
  const Vec3d root = placed[at.upper].offset;
  const Vec3d goal = glm::mix(placed[at.end].offset, own_goal, weight);

  const double upper = glm::distance(rest[at.upper], rest[at.lower]);
  const double lower = glm::distance(rest[at.lower], rest[at.end]);
  const Vec3d along = normalize_or(goal - root, {0, 0, -1});
  const double reach =
      std::clamp(glm::distance(goal, root), std::abs(upper - lower) + 1e-3, (upper + lower) * 0.9995);
  // How far along the line to the goal the knee lies, and how far from that line.
  const double ahead = (upper * upper - lower * lower + reach * reach) / (2 * reach);
  const double aside = std::sqrt(std::max(0.0, upper * upper - ahead * ahead));

  const auto& parent = skeleton.bones[at.upper].parent;
  const Vec3d bend_world = (parent ? remove_scale(placed[*parent].linear) : glm::dmat3(1.0)) * limb.bend;
  const glm::dmat3 plane = make_axes(along, bend_world);
  const Vec3d knee = root + along * ahead + plane[1] * aside;
  const Vec3d end = root + along * reach;
  const Vec3d rest_normal = make_axes(rest[at.end] - rest[at.upper], limb.bend)[2];
  io_turns_world[at.upper] =
      turn_between(rest[at.lower] - rest[at.upper], rest_normal, knee - root, plane[2]);
  io_turns_world[at.lower] = turn_between(rest[at.end] - rest[at.lower], rest_normal, end - knee, plane[2]);
  // A foot is parallel to the floor except for its own rotation; a hand follows the forearm.
  const glm::dmat3 own_turn = make_rotation(pose.bones[at.end].turn_deg);
  io_turns_world[at.end] =
      limb.grip_on ? *io_turns_world[at.lower] * own_turn
                   : blend_rotations(remove_scale(placed[at.end].linear), own_turn, std::min(weight, 1.0));
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

std::vector<Vec3d> rest_positions(const Skeleton& skeleton) {
  std::vector<Vec3d> positions;
  for (const Bone& bone : skeleton.bones)
    positions.push_back(bone.parent ? positions[*bone.parent] + bone.at * skeleton.bones[*bone.parent].scale
                                    : bone.at);
  return positions;
}

std::vector<Transform> compute_bone_transforms(const Skeleton& skeleton, const BonePose& pose) {
  const std::vector<Vec3d> rest = rest_positions(skeleton);
  std::vector<std::optional<glm::dmat3>> turns_world(skeleton.bones.size());
  std::vector<Transform> placed = chain_bones(skeleton, pose, turns_world);
  // In order, because a grip may hold a bone that another limb moves.
  for (const Limb& limb : skeleton.limbs) {
    solve_limb(skeleton, limb, pose, rest, placed, turns_world);
    placed = chain_bones(skeleton, pose, turns_world);
  }
  return placed;
}

}  // namespace temblor::artgen
