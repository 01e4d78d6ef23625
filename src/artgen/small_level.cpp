// Plan -> grid of cells -> tree -> faces, light, PVS, clip trees -> the structs of a level file. Every plane
// is axial and every leaf a box, which keeps each of these steps a few lines.
#include "artgen/small_level.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "artgen/level/grid.h"
#include "artgen/level/grid_faces.h"
#include "artgen/level/grid_light.h"
#include "artgen/level/grid_tree.h"
#include "artgen/level/grid_visibility.h"
#include "artgen/level/materials.h"
#include "artgen/level/mesh.h"
#include "artgen/level/plan.h"
#include "formats/levels/entities.h"

namespace temblor::artgen {
namespace {

constexpr std::int32_t kTexinfoNoLight = 1;

// The boxes that hulls 1 to 3 are grown by: the player's, a large monster's, and the third, which the stock
// game never asks for, as the second.
constexpr math::Bounds kHullBoxes[3] = {
    {{-16, -16, -24}, {16, 16, 32}}, {{-32, -32, -24}, {32, 32, 64}}, {{-32, -32, -24}, {32, 32, 64}}};

class Builder {
 public:
  explicit Builder(const SmallLevelOptions& options);
  formats::Bsp build() &&;

 private:
  void add_world();
  void add_door();
  formats::BspModel add_tree(const CellGrid& grid, const GridTree& tree);
  void add_faces(const CellGrid& grid, const GridTree& tree, std::size_t first_node);
  void add_face(const CellGrid& grid, const GridFace& face, const Corners& corners);
  void add_light(const CellGrid& grid, const GridFace& face, formats::BspFace& io_face);
  void add_marksurfaces(const std::vector<GridTree::Leaf>& leaves);
  void add_visibility(const std::vector<GridTree::Leaf>& leaves);
  std::int32_t add_clip_tree(const CellGrid& grid, const math::Bounds& box, std::int32_t background);
  void add_entities();
  std::uint32_t plane_of(std::size_t axis, float distance);
  std::uint32_t texinfo_of(Material material, const TextureLayout& layout);

  SmallLevelOptions options_;
  SmallLevelPlan plan_;
  float texels_per_unit_;
  float max_face_units_;
  CellGrid world_;
  GridLighter lighter_;
  formats::Bsp bsp_;
  LevelMesh mesh_;
  std::vector<GridFace> world_faces_;
  std::vector<std::uint8_t> rgb_light_;
  std::map<std::pair<std::size_t, float>, std::uint32_t> planes_;
  std::map<std::tuple<Material, std::size_t, std::size_t>, std::uint32_t> texinfos_;
};

Builder::Builder(const SmallLevelOptions& options)
    : options_(options),
      plan_(make_plan(options)),
      texels_per_unit_(options.wide_faces ? 2.0f : 1.0f),
      max_face_units_(options.wide_faces ? 512.0f : 256.0f),
      world_(make_grid(plan_.boxes, kContentsSolid, max_face_units_)),
      lighter_(plan_, world_),
      mesh_(bsp_, options.edge_used_three_times) {}

formats::Bsp Builder::build() && {
  bsp_.version = formats::BspVersion::k29;
  bsp_.miptexes = make_materials(options_);
  formats::BspLeaf solid;
  solid.contents = kContentsSolid;
  bsp_.leaves.push_back(solid);
  add_world();
  add_door();
  add_entities();
  if (options_.colored_light && options_.light) {
    const base::Bytes bytes = std::as_bytes(std::span(rgb_light_));
    bsp_.bspx.push_back({"RGBLIGHTING", {bytes.begin(), bytes.end()}});
  }
  return std::move(bsp_);
}

void Builder::add_world() {
  const GridTree tree = build_grid_tree(world_);
  formats::BspModel model = add_tree(world_, tree);
  std::vector<GridTree::Leaf> leaves;
  for (const GridTree::Leaf& leaf : tree.leaves)
    if (leaf.contents != kContentsSolid) leaves.push_back(leaf);
  add_marksurfaces(leaves);
  if (options_.pvs) add_visibility(leaves);
  model.visible_leaves = static_cast<std::int32_t>(leaves.size());
  for (std::size_t hull = 0; hull < 3; ++hull)
    model.head_nodes[hull + 1] = add_clip_tree(world_, kHullBoxes[hull], kContentsSolid);
  bsp_.models.push_back(model);
}

void Builder::add_door() {
  const PlanBox box{plan_.door, kContentsSolid, CellLook::kDoor};
  const CellGrid grid = make_grid({&box, 1}, kContentsEmpty, max_face_units_);
  formats::BspModel model = add_tree(grid, build_grid_tree(grid));
  for (std::size_t hull = 0; hull < 3; ++hull)
    model.head_nodes[hull + 1] = add_clip_tree(grid, kHullBoxes[hull], kContentsEmpty);
  bsp_.models.push_back(model);
}

// Adds the nodes and leaves of a model's hull 0, and its faces.
formats::BspModel Builder::add_tree(const CellGrid& grid, const GridTree& tree) {
  const std::size_t first_node = bsp_.nodes.size();
  std::vector<std::int32_t> leaf_children;
  for (const GridTree::Leaf& leaf : tree.leaves) {
    // All solid leaves are leaf 0.
    if (leaf.contents == kContentsSolid) {
      leaf_children.push_back(~0);
      continue;
    }
    leaf_children.push_back(~static_cast<std::int32_t>(bsp_.leaves.size()));
    const math::Bounds bounds = grid.bounds(leaf.range);
    formats::BspLeaf bsp_leaf;
    bsp_leaf.contents = leaf.contents;
    bsp_leaf.mins = bounds.mins;
    bsp_leaf.maxs = bounds.maxs;
    bsp_leaf.first_marksurface = static_cast<std::uint32_t>(bsp_.marksurfaces.size());
    bsp_.leaves.push_back(bsp_leaf);
  }
  for (const GridTree::Node& node : tree.nodes) {
    const math::Bounds bounds = grid.bounds(node.range);
    formats::BspNode bsp_node;
    bsp_node.plane = plane_of(node.axis, grid.lines[node.axis][node.line]);
    for (std::size_t side = 0; side < 2; ++side) {
      const std::int32_t child = node.children[side];
      bsp_node.children[side] = child >= 0 ? child + static_cast<std::int32_t>(first_node)
                                           : leaf_children[static_cast<std::size_t>(~child)];
    }
    bsp_node.mins = bounds.mins;
    bsp_node.maxs = bounds.maxs;
    bsp_.nodes.push_back(bsp_node);
  }
  formats::BspModel model;
  // Without the border of background around what was painted.
  const math::Bounds bounds =
      grid.bounds({{1, 1, 1}, {grid.size(0) - 1, grid.size(1) - 1, grid.size(2) - 1}});
  model.mins = bounds.mins;
  model.maxs = bounds.maxs;
  model.head_nodes[0] = static_cast<std::int32_t>(first_node);
  model.first_face = static_cast<std::uint32_t>(bsp_.faces.size());
  add_faces(grid, tree, first_node);
  model.face_count = static_cast<std::uint32_t>(bsp_.faces.size()) - model.first_face;
  return model;
}

void Builder::add_faces(const CellGrid& grid, const GridTree& tree, std::size_t first_node) {
  std::vector<GridFace> faces;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const std::vector<GridFace> node_faces = find_faces(grid, tree.nodes[i], max_face_units_);
    formats::BspNode& node = bsp_.nodes[first_node + i];
    node.first_face = static_cast<std::uint32_t>(bsp_.faces.size() + faces.size());
    node.face_count = static_cast<std::uint32_t>(node_faces.size());
    faces.insert(faces.end(), node_faces.begin(), node_faces.end());
  }
  const Corners corners(grid, faces);
  for (const GridFace& face : faces) add_face(grid, face, corners);
  if (&grid == &world_) world_faces_ = std::move(faces);
}

void Builder::add_face(const CellGrid& grid, const GridFace& face, const Corners& corners) {
  const SurfedgeRange surfedges = mesh_.add_loop(outline(grid, face, corners));
  formats::BspFace bsp_face;
  bsp_face.plane = plane_of(face.axis, grid.lines[face.axis][face.line]);
  bsp_face.side = face.looks_up ? 0 : 1;
  bsp_face.first_surfedge = surfedges.first;
  bsp_face.surfedge_count = surfedges.count;
  bsp_face.texinfo = texinfo_of(face.material, layout_of(face, texels_per_unit_));
  if (options_.light && is_lit(face.material)) add_light(grid, face, bsp_face);
  bsp_.faces.push_back(bsp_face);
}

void Builder::add_light(const CellGrid& grid, const GridFace& face, formats::BspFace& io_face) {
  const FaceLight light = lighter_.light(grid, face, layout_of(face, texels_per_unit_));
  io_face.styles = light.styles;
  io_face.light_offset = static_cast<std::int32_t>(bsp_.lighting.size());
  for (std::size_t i = 0; i < light.rgb.size(); i += 3) {
    const unsigned luminance = 299u * light.rgb[i] + 587u * light.rgb[i + 1] + 114u * light.rgb[i + 2];
    bsp_.lighting.push_back(static_cast<std::uint8_t>((luminance + 500) / 1000));
  }
  rgb_light_.insert(rgb_light_.end(), light.rgb.begin(), light.rgb.end());
}

bool overlap(const CellRange& a, const CellRange& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (a.first[axis] >= b.last[axis] || b.first[axis] >= a.last[axis]) return false;
  return true;
}

// `leaves`: those of the world that are not solid, as leaves 1 and on.
void Builder::add_marksurfaces(const std::vector<GridTree::Leaf>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    formats::BspLeaf& leaf = bsp_.leaves[i + 1];
    leaf.first_marksurface = static_cast<std::uint32_t>(bsp_.marksurfaces.size());
    for (std::size_t face = 0; face < world_faces_.size(); ++face)
      if (overlap(world_faces_[face].front_cells(), leaves[i].range))
        bsp_.marksurfaces.push_back(static_cast<std::uint32_t>(face));
    leaf.marksurface_count = static_cast<std::uint32_t>(bsp_.marksurfaces.size()) - leaf.first_marksurface;
  }
}

void Builder::add_visibility(const std::vector<GridTree::Leaf>& leaves) {
  const std::vector<std::vector<std::uint8_t>> rows = visible_leaves(world_, leaves);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bsp_.leaves[i + 1].visibility_offset = static_cast<std::int32_t>(bsp_.visibility.size());
    const std::vector<std::uint8_t> coded = compress_row(rows[i]);
    bsp_.visibility.insert(bsp_.visibility.end(), coded.begin(), coded.end());
  }
}

std::int32_t Builder::add_clip_tree(const CellGrid& grid, const math::Bounds& box, std::int32_t background) {
  const CellGrid grown = grow_grid(grid, box.mins, box.maxs, background);
  const GridTree tree = build_grid_tree(grown);
  const auto head = static_cast<std::int32_t>(bsp_.clipnodes.size());
  for (const GridTree::Node& node : tree.nodes) {
    formats::BspClipnode clipnode;
    clipnode.plane = plane_of(node.axis, grown.lines[node.axis][node.line]);
    for (std::size_t side = 0; side < 2; ++side) {
      const std::int32_t child = node.children[side];
      clipnode.children[side] =
          child >= 0 ? child + head : tree.leaves[static_cast<std::size_t>(~child)].contents;
    }
    bsp_.clipnodes.push_back(clipnode);
  }
  return head;
}

std::string vec3_text(const math::Vec3& value) {
  return fmt::format("{} {} {}", value.x, value.y, value.z);
}

void Builder::add_entities() {
  std::vector<formats::Entity> entities;
  entities.push_back({{{"classname", "worldspawn"}, {"message", "Made in code"}}});
  for (const PlanThing& thing : plan_.things) {
    formats::Entity entity{{{"classname", thing.classname}, {"origin", vec3_text(thing.origin)}}};
    const std::string yaw = fmt::format("{}", thing.yaw_deg);
    const bool is_camera = entity.classname() == "info_intermission";
    entity.pairs.emplace_back(is_camera ? "mangle" : "angle", is_camera ? "20 " + yaw + " 0" : yaw);
    entities.push_back(std::move(entity));
  }
  // Angle -1: the door opens upwards.
  entities.push_back({{{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}}});
  for (const PlanLight& light : plan_.lights) {
    entities.push_back({{{"classname", "light"},
                         {"origin", vec3_text(light.origin)},
                         {"light", fmt::format("{}", light.reach)},
                         {"style", fmt::format("{}", light.style)},
                         {"_color", vec3_text(light.color)}}});
  }
  bsp_.entities = formats::write_entities(entities);
}

std::uint32_t Builder::plane_of(std::size_t axis, float distance) {
  const auto next = static_cast<std::uint32_t>(bsp_.planes.size());
  const auto [entry, is_new] = planes_.try_emplace({axis, distance}, next);
  if (is_new) {
    formats::BspPlane plane;
    plane.normal[static_cast<int>(axis)] = 1;
    plane.distance = distance;
    plane.type = static_cast<std::int32_t>(axis);
    bsp_.planes.push_back(plane);
  }
  return entry->second;
}

std::uint32_t Builder::texinfo_of(Material material, const TextureLayout& layout) {
  const auto next = static_cast<std::uint32_t>(bsp_.texinfos.size());
  const auto [entry, is_new] = texinfos_.try_emplace({material, layout.s_axis, layout.t_axis}, next);
  if (is_new) {
    formats::BspTexinfo texinfo;
    texinfo.s_axis[static_cast<int>(layout.s_axis)] = layout.texels_per_unit;
    texinfo.t_axis[static_cast<int>(layout.t_axis)] = -layout.texels_per_unit;
    texinfo.miptex = static_cast<std::int32_t>(material);
    texinfo.flags = is_lit(material) ? 0 : kTexinfoNoLight;
    bsp_.texinfos.push_back(texinfo);
  }
  return entry->second;
}

}  // namespace

formats::Bsp make_small_level(const SmallLevelOptions& options) {
  return Builder(options).build();
}

std::vector<SmallLevelBox> small_level_boxes(const SmallLevelOptions& options) {
  std::vector<SmallLevelBox> boxes;
  for (const PlanBox& box : make_plan(options).boxes) boxes.push_back({box.bounds, box.contents});
  return boxes;
}

math::Bounds small_level_door(const SmallLevelOptions& options) {
  return make_plan(options).door;
}

}  // namespace temblor::artgen
