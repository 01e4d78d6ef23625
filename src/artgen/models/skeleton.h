// A model's bones: a tree of places that turn and carry what is fixed to them; and limbs, whose last bone
// stays where it is put while the two before it bend.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/models/transform.h"
#include "math/vec.h"

namespace temblor::artgen {

struct Bone {
  std::string name;
  std::optional<std::size_t> parent{};  // an earlier bone
  math::Vec3d at{0.0};                  // from the parent, at rest
  math::Vec3d scale{1.0};               // of what is fixed to it, bones included, but not of what is on those
};

// The last of three bones. A foot stays at its rest place in the model's space, a grip at a place of
// another bone.
struct Limb {
  std::size_t end = 0;
  std::optional<std::size_t> grip_on{};
  math::Vec3d grip_at{0.0};
  math::Vec3d bend{1, 0, 0};  // where the knee or elbow points
};

struct Skeleton {
  std::vector<Bone> bones;
  std::vector<Limb> limbs;

  std::optional<std::size_t> find(std::string_view name) const;
  const Limb* limb_at(std::size_t end) const;  // null: this bone ends none
};

// What a bone does beside resting. A limb's end moves by `at` from where the limb puts it.
struct BoneMotion {
  math::Vec3d turn_deg{0.0};  // pitch, yaw, roll
  math::Vec3d at{0.0};
  math::Vec3d scale{1.0};
};

struct BonePose {
  std::vector<BoneMotion> bones;  // one for each
  double plant = 1, hold = 1;     // 0 to 1: how far feet and grips go where their limbs put them
};

// Where the bones are at rest, in the model's space.
std::vector<math::Vec3d> rest_places(const Skeleton& skeleton);

// From each bone's own space to the model's. A limb that is too short stretches out towards its goal.
std::vector<Transform> place_bones(const Skeleton& skeleton, const BonePose& pose);

}  // namespace temblor::artgen
