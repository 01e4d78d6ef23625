#include "formats/levels/bsp/repair.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "formats/levels/bsp/repair_faces.h"
#include "formats/levels/bsp/repair_ranges.h"
#include "formats/levels/bsp/repair_trees.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr std::int32_t kEmpty = -1, kSolid = -2;              // contents
constexpr std::int32_t kOutside = ~0;                         // leaf 0
constexpr std::size_t kQuakePlayerHulls = 2, kLargeHull = 2;  // 1: players, 2: large monsters, 3: unused
constexpr BspPlane kAllSpaceBehind{{1, 0, 0}, kBspMaxCoordinate, 0};

float limit(float value) {
  if (std::isnan(value)) return 0;
  return std::clamp(value, -kBspMaxCoordinate, kBspMaxCoordinate);
}

// Makes a plane that other engines treat alike: a point is in front if `dot(point, normal) - distance` is
// positive, so it is behind if that is not a number.
bool repair_plane(BspPlane& io_plane) {
  const BspPlane before = io_plane;
  if (is_valid_plane(before)) return false;
  const math::Vec3d normal(before.normal);
  const double length = glm::length(normal), distance = before.distance;
  const bool has_direction = length > 0 && std::isfinite(length) && std::isfinite(distance);
  if (has_direction) {
    io_plane.normal = math::Vec3(normal / length);
    io_plane.distance = limit(static_cast<float>(distance / length));
  } else {
    io_plane.normal = {1, 0, 0};
    io_plane.distance = length == 0 && distance < 0 ? -kBspMaxCoordinate : kBspMaxCoordinate;
  }
  io_plane.type = find_plane_type(io_plane.normal);
  return true;
}

// An unknown box reaches everywhere, so that nothing in it is culled.
bool repair_box(math::Vec3& io_mins, math::Vec3& io_maxs) {
  if (is_sane(io_mins) && is_sane(io_maxs)) return false;
  io_mins = math::Vec3(-kBspMaxCoordinate);
  io_maxs = math::Vec3(kBspMaxCoordinate);
  return true;
}

template <typename Value>
bool replace(Value& io_value, const Value& replacement) {
  if (io_value == replacement) return false;
  io_value = replacement;
  return true;
}

bool is_known_contents(std::int32_t contents) {
  return contents >= kBspMinContents && contents <= kEmpty;
}

bool repair_leaf(const Bsp& bsp, BspLeaf& io_leaf) {
  bool is_changed = repair_box(io_leaf.mins, io_leaf.maxs);
  if (!is_known_contents(io_leaf.contents)) is_changed |= replace(io_leaf.contents, kEmpty);
  const bool has_row = io_leaf.visibility_offset >= 0 &&
                       static_cast<std::size_t>(io_leaf.visibility_offset) < bsp.visibility.size();
  if (!has_row) is_changed |= replace(io_leaf.visibility_offset, -1);
  return is_changed;
}

std::size_t repair_leaves(Bsp& io_bsp) {
  if (io_bsp.leaves.empty()) return 0;
  std::size_t changed = replace(io_bsp.leaves[0].contents, kSolid);
  for (BspLeaf& leaf : io_bsp.leaves) changed += repair_leaf(io_bsp, leaf);
  return changed + fit_ranges(io_bsp.leaves, io_bsp.marksurfaces.size(), &BspLeaf::first_marksurface,
                              &BspLeaf::marksurface_count);
}

// Compilers list the faces of a leaf side by side, so the one before is a face that can be seen too.
std::size_t repair_marksurfaces(Bsp& io_bsp) {
  if (io_bsp.faces.empty()) {
    const std::size_t removed = io_bsp.marksurfaces.size();
    io_bsp.marksurfaces.clear();
    return removed;
  }
  std::size_t changed = 0;
  std::uint32_t last = 0;
  for (std::uint32_t& face : io_bsp.marksurfaces) {
    if (face >= io_bsp.faces.size()) changed += replace(face, last);
    last = face;
  }
  return changed;
}

std::size_t repair_nodes(Bsp& io_bsp) {
  std::size_t changed = 0;
  const auto planes = static_cast<std::uint32_t>(io_bsp.planes.size());
  for (BspNode& node : io_bsp.nodes) {
    bool is_changed = repair_box(node.mins, node.maxs);
    if (node.plane >= planes) {
      node.plane = planes;
      is_changed = true;
    }
    for (std::int32_t& child : node.children)
      if (!is_node_or_leaf(io_bsp, child)) is_changed |= replace(child, kOutside);
    changed += is_changed;
  }
  if (std::ranges::count(io_bsp.nodes, planes, &BspNode::plane) > 0) io_bsp.planes.push_back(kAllSpaceBehind);
  return changed + fit_ranges(io_bsp.nodes, io_bsp.faces.size(), &BspNode::first_face, &BspNode::face_count);
}

std::size_t repair_clipnodes(Bsp& io_bsp) {
  std::size_t changed = 0;
  for (BspClipnode& clipnode : io_bsp.clipnodes) {
    bool is_changed = false;
    for (std::int32_t& child : clipnode.children)
      if (!is_clipnode_or_contents(io_bsp, child)) is_changed |= replace(child, child < 0 ? kEmpty : kSolid);
    changed += is_changed;
  }
  return changed;
}

// The bounds of a model's faces; a point if it has none. Requires that its faces and their outlines are
// valid.
void measure_faces(const Bsp& bsp, BspModel& io_model) {
  constexpr float kFar = std::numeric_limits<float>::max();
  math::Vec3 mins(kFar), maxs(-kFar);
  for (std::uint32_t i = 0; i < io_model.face_count; ++i) {
    const BspFace& face = bsp.faces[io_model.first_face + i];
    for (std::uint32_t k = 0; k < face.surfedge_count; ++k) {
      const math::Vec3& vertex = bsp.vertices[find_start(bsp, face.first_surfedge + k)];
      mins = glm::min(mins, vertex);
      maxs = glm::max(maxs, vertex);
    }
  }
  const bool is_empty = mins.x > maxs.x;
  io_model.mins = is_empty ? math::Vec3(0.0f) : mins;
  io_model.maxs = is_empty ? math::Vec3(0.0f) : maxs;
}

bool repair_heads(const Bsp& bsp, bool is_world, BspModel& io_model) {
  bool is_changed = false;
  if (!is_world && !is_node_or_leaf(bsp, io_model.head_nodes[0]))
    is_changed |= replace(io_model.head_nodes[0], find_empty_leaf(bsp));
  // Without them, players would fall through the world.
  const std::size_t kept = !is_world                        ? 1
                           : bsp.version == BspVersion::k30 ? io_model.head_nodes.size()
                                                            : kQuakePlayerHulls;
  for (std::size_t hull = kept; hull < io_model.head_nodes.size(); ++hull)
    if (!is_clipnode_or_contents(bsp, io_model.head_nodes[hull]))
      is_changed |= replace(io_model.head_nodes[hull],
                            is_world && hull == kLargeHull ? io_model.head_nodes[1] : kEmpty);
  return is_changed;
}

std::size_t repair_models(Bsp& io_bsp) {
  std::size_t changed =
      fit_ranges(io_bsp.models, io_bsp.faces.size(), &BspModel::first_face, &BspModel::face_count);
  const auto max_leaves = static_cast<std::int32_t>(std::max<std::size_t>(io_bsp.leaves.size(), 1) - 1);
  for (std::size_t i = 0; i < io_bsp.models.size(); ++i) {
    BspModel& model = io_bsp.models[i];
    bool is_changed = repair_heads(io_bsp, i == 0, model);
    if (!is_sane(model.origin)) is_changed |= replace(model.origin, math::Vec3(0.0f));
    if (!is_sane(model.mins) || !is_sane(model.maxs)) {
      measure_faces(io_bsp, model);
      is_changed = true;
    }
    if (model.visible_leaves < 0 || model.visible_leaves > max_leaves)
      is_changed |= replace(model.visible_leaves, max_leaves);
    changed += is_changed;
  }
  return changed;
}

}  // namespace

std::size_t repair_level(Bsp& io_bsp) {
  std::size_t changed = 0;
  for (BspPlane& plane : io_bsp.planes) changed += repair_plane(plane);
  changed += repair_faces(io_bsp);
  changed += repair_marksurfaces(io_bsp);
  changed += repair_leaves(io_bsp);
  changed += repair_nodes(io_bsp);
  changed += repair_clipnodes(io_bsp);
  changed += repair_models(io_bsp);
  return changed + repair_node_trees(io_bsp);
}

}  // namespace temblor::formats::bsp_file
