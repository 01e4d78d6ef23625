// The bones of a model: a tree of joints that move everything attached to them; and limbs, chains of three
// bones whose last one stays in place while the two before it bend (two-bone inverse kinematics), as feet and
// hands need.
//
//   Skeleton + BonePose -> place every bone from its parent (forward kinematics)
//                       -> solve the limbs one after another -> a Transform for each bone
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/models/transform.h"
#include "math/vec.h"

namespace temblor::artgen {

// A joint.
struct Bone {
  std::string name;
  // An earlier bone; nothing for a root.
  std::optional<std::size_t> parent{};
  // The offset from the parent at rest, before the parent's scale.
  math::Vec3d at{0.0};
  // Scales the shapes attached to the bone and the offsets of its children, but not what is attached to the
  // children.
  math::Vec3d scale{1.0};
};

// The end of a chain of three bones: `end`, its parent, and its grandparent. A foot stays at its rest
// position in the model's coordinates; a grip stays at a point of another bone, as a hand holds a rifle.
struct Limb {
  std::size_t end = 0;
  // Nothing: the limb is a foot. Otherwise grip_at is in this bone's coordinates.
  std::optional<std::size_t> grip_on{};
  math::Vec3d grip_at{0.0};
  // The direction in which the knee or elbow points.
  math::Vec3d bend{1, 0, 0};
};

// Parents come before their children.
struct Skeleton {
  std::vector<Bone> bones;
  std::vector<Limb> limbs;

  // The index of a bone by its name.
  std::optional<std::size_t> find(std::string_view name) const;
  // The limb that ends at this bone; null if none does.
  const Limb* limb_at(std::size_t end) const;
};

// A bone's deviation from rest. For the end of a limb, `at` moves it from the position that the limb gives
// it.
struct BoneMotion {
  // Pitch, yaw, roll; see make_rotation.
  math::Vec3d turn_deg{0.0};
  math::Vec3d at{0.0};
  math::Vec3d scale{1.0};
};

// A pose of the whole skeleton.
struct BonePose {
  // One for each bone.
  std::vector<BoneMotion> bones;
  // 0 to 1: how far feet (plant) and grips (hold) are pulled to their limb's goal.
  double plant = 1, hold = 1;
};

// The positions of all bones at rest, in the model's coordinates.
std::vector<math::Vec3d> rest_positions(const Skeleton& skeleton);

// Returns a transform from each bone's coordinates to the model's. If a limb cannot reach its goal, it is
// stretched out toward it.
std::vector<Transform> compute_bone_transforms(const Skeleton& skeleton, const BonePose& pose);

}  // namespace temblor::artgen
