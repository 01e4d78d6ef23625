#include <fmt/format.h>

#include <algorithm>

#include "artgen/models/reading/read_parts.h"
#include "artgen/models/reading/values.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// Adds a bone or changes the one with this name. A changed bone keeps its index, so its parent must come
// before it.
base::Status add_bone(const ScriptLine& line, const std::string& name, const std::string& parent,
                      const math::Vec3& at, Model& io_model) {
  Bone bone;
  bone.name = name;
  bone.at = math::Vec3d(at);
  if (!parent.empty()) {
    TRY(bone.parent, find_bone(line, io_model.skeleton, parent));
  }
  const auto known = io_model.skeleton.find(name);
  if (!known) {
    io_model.skeleton.bones.push_back(std::move(bone));
    return base::Ok{};
  }
  if (bone.parent && *bone.parent >= *known)
    return script_error(line, fmt::format("its parent '{}' is defined after it", parent));
  Bone& old = io_model.skeleton.bones[*known];
  old.at = bone.at;
  if (bone.parent) old.parent = bone.parent;
  return base::Ok{};
}

// A star in the name makes two bones; the right one is mirrored.
base::Status read_one_bone(const ScriptLine& line, Model& io_model) {
  Arguments arguments(line);
  const std::string name = arguments.text();
  const math::Vec3 at = arguments.vector();
  const std::string parent = arguments.text("on", "");
  TRY_STATUS(arguments.finish());
  if (!is_pair(name)) return add_bone(line, name, parent, at, io_model);
  TRY_STATUS(add_bone(line, select_side(name, 'l'), select_side(parent, 'l'), at, io_model));
  return add_bone(line, select_side(name, 'r'), select_side(parent, 'r'), {at.x, -at.y, at.z}, io_model);
}

// The names of both sides, or the name itself.
std::vector<std::string> expand_pair(const std::string& name) {
  if (!is_pair(name)) return {name};
  return {select_side(name, 'l'), select_side(name, 'r')};
}

base::Status read_scale(const ScriptLine& line, Model& io_model) {
  Arguments arguments(line);
  const std::string name = arguments.text();
  const std::string by = arguments.text("by", "1");
  TRY_STATUS(arguments.finish());
  const auto numbers = parse_numbers(by);
  if (!numbers || (numbers->size() != 1 && numbers->size() != 3) ||
      *std::min_element(numbers->begin(), numbers->end()) <= 0)
    return script_error(line,
                        fmt::format("by={} is neither a number nor X,Y,Z, above 0", base::quotable(by)));
  for (const std::string& side : expand_pair(name)) {
    TRY(const std::size_t bone, find_bone(line, io_model.skeleton, side));
    io_model.skeleton.bones[bone].scale = numbers->size() == 1
                                              ? math::Vec3d(numbers->front())
                                              : math::Vec3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  }
  return base::Ok{};
}

// Adds a limb or replaces the one that ends at the same bone.
base::Status add_limb(const ScriptLine& line, Limb limb, Model& io_model) {
  const auto& bones = io_model.skeleton.bones;
  const auto lower = bones[limb.end].parent;
  if (!lower || !bones[*lower].parent)
    return script_error(line, "a limb needs three bones: this one, its parent and its grandparent");
  for (Limb& known : io_model.skeleton.limbs) {
    if (known.end != limb.end) continue;
    known = limb;
    return base::Ok{};
  }
  io_model.skeleton.limbs.push_back(limb);
  return base::Ok{};
}

// The lines foot and grip.
base::Status read_limb(const ScriptLine& line, Model& io_model) {
  Arguments arguments(line);
  const bool is_grip = line.keyword == "grip";
  const std::string name = arguments.text();
  const std::string on = is_grip ? arguments.text() : "";
  const math::Vec3d at(is_grip ? arguments.vector() : math::Vec3(0.0f));
  const math::Vec3d bend(is_grip ? arguments.vector("elbow", {-1, 0.6f, -0.4f})
                                 : arguments.vector("knee", {1, 0, 0}));
  TRY_STATUS(arguments.finish());
  double side = 1;
  for (const std::string& end : expand_pair(name)) {
    Limb limb;
    TRY(limb.end, find_bone(line, io_model.skeleton, end));
    // Bend directions are given for the left side.
    const double outwards = end.ends_with("_r") ? -1 : 1;
    limb.bend = {bend.x, bend.y * outwards, bend.z};
    if (is_grip) {
      TRY(limb.grip_on, find_bone(line, io_model.skeleton, on));
      limb.grip_at = {at.x, at.y * side, at.z};
    }
    TRY_STATUS(add_limb(line, limb, io_model));
    side = -1;
  }
  return base::Ok{};
}

}  // namespace

base::Result<std::size_t> find_bone(const ScriptLine& line, const Skeleton& skeleton, std::string_view name) {
  if (const auto bone = skeleton.find(name)) return *bone;
  return script_error(line, fmt::format("no bone is named '{}'", base::quotable(name)));
}

base::Status read_bone(const ScriptLine& line, Model& io_model) {
  if (line.keyword == "bone") return read_one_bone(line, io_model);
  if (line.keyword == "scale") return read_scale(line, io_model);
  return read_limb(line, io_model);
}

}  // namespace temblor::artgen
