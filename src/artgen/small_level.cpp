// The pipeline is shown in small_level.h. Builder runs its steps and writes their results into the lumps of a
// BSP.
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
#include "artgen/level/layout.h"
#include "artgen/level/materials.h"
#include "artgen/level/mesh.h"
#include "formats/levels/entities.h"

namespace temblor::artgen {
namespace {

constexpr std::int32_t kTexinfoNoLight = 1;

// The boxes that clip hulls 1 to 3 are expanded by: a player, a large monster, and the large monster again,
// because stock game code never uses the third.
constexpr math::Bounds kHullBoxes[3] = {
    {{-16, -16, -24}, {16, 16, 32}}, {{-32, -32, -24}, {32, 32, 64}}, {{-32, -32, -24}, {32, 32, 64}}};

// Fills a formats::Bsp lump by lump. Each add_ function appends to one or more lumps, and the indices that it
// returns or stores refer to them.
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
  std::uint32_t add_plane(std::size_t axis, float distance);
  std::uint32_t add_texinfo(Material material, const TextureProjection& projection);

  // The order matters: each of these members is computed from the ones above it.
  SmallLevelOptions options_;
  SmallLevelLayout layout_;
  float texels_per_unit_;
  float max_face_units_;
  CellGrid world_;
  GridLighter lighter_;
  formats::Bsp bsp_;
  LevelMesh mesh_;
  // The world's faces, at the same indices as in bsp_.faces.
  std::vector<GridFace> world_faces_;
  // The colored version of bsp_.lighting: three bytes for each of its bytes.
  std::vector<std::uint8_t> rgb_light_;
  // Planes by axis and distance, and texinfos by material and axes, so that equal ones are stored once.
  std::map<std::pair<std::size_t, float>, std::uint32_t> planes_;
  std::map<std::tuple<Material, std::size_t, std::size_t>, std::uint32_t> texinfos_;
};

Builder::Builder(const SmallLevelOptions& options)
    : options_(options),
      layout_(make_layout(options)),
      texels_per_unit_(options.wide_faces ? 2.0f : 1.0f),
      max_face_units_(options.wide_faces ? 512.0f : 256.0f),
      world_(make_grid(layout_.boxes, kContentsSolid, max_face_units_)),
      lighter_(layout_, world_),
      mesh_(bsp_, options.edge_used_three_times) {}

formats::Bsp Builder::build() && {
  bsp_.version = formats::BspVersion::k29;
  bsp_.miptexes = make_materials(options_);
  formats::BspLeaf solid;
  solid.contents = kContentsSolid;
  // The format reserves leaf 0 for all solid space.
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

// The world's leaves follow leaf 0 in the order of the tree, which is also the order of the bits in a PVS
// row.
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

// The door is a grid of its own, with empty space around a single solid box.
void Builder::add_door() {
  const LayoutBox box{layout_.door, kContentsSolid, CellLook::kDoor};
  const CellGrid grid = make_grid({&box, 1}, kContentsEmpty, max_face_units_);
  formats::BspModel model = add_tree(grid, build_grid_tree(grid));
  for (std::size_t hull = 0; hull < 3; ++hull)
    model.head_nodes[hull + 1] = add_clip_tree(grid, kHullBoxes[hull], kContentsEmpty);
  bsp_.models.push_back(model);
}

// Appends the nodes and leaves of a model's hull 0 and its faces, and returns the model without clip hulls.
// All solid leaves of the tree become leaf 0. Children are stored as in the format: a node's index, or ~leaf.
formats::BspModel Builder::add_tree(const CellGrid& grid, const GridTree& tree) {
  const std::size_t first_node = bsp_.nodes.size();
  std::vector<std::int32_t> leaf_children;
  for (const GridTree::Leaf& leaf : tree.leaves) {
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
    bsp_node.plane = add_plane(node.axis, grid.lines[node.axis][node.line]);
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
  // The border of background cells around the painted boxes does not count.
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

// Faces are stored node by node, so that each node refers to a contiguous range. Outlines are traced only
// when all faces are known, because a face needs a vertex wherever the corner of another one touches its
// border.
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

// All planes point along a positive axis; `side` 1 is the back of such a plane.
void Builder::add_face(const CellGrid& grid, const GridFace& face, const Corners& corners) {
  const SurfedgeRange surfedges = mesh_.add_loop(trace_outline(grid, face, corners));
  formats::BspFace bsp_face;
  bsp_face.plane = add_plane(face.axis, grid.lines[face.axis][face.line]);
  bsp_face.side = face.is_positive ? 0 : 1;
  bsp_face.first_surfedge = surfedges.first;
  bsp_face.surfedge_count = surfedges.count;
  bsp_face.texinfo = add_texinfo(face.material, make_projection(face, texels_per_unit_));
  if (options_.light && is_lit(face.material)) add_light(grid, face, bsp_face);
  bsp_.faces.push_back(bsp_face);
}

// The gray light map has the luminance of the colored one (Rec. 601 weights, rounded). Both lumps grow in
// step, because the RGBLIGHTING lump is addressed with three times the offset of the gray light.
void Builder::add_light(const CellGrid& grid, const GridFace& face, formats::BspFace& io_face) {
  const FaceLight light = lighter_.light_face(grid, face, make_projection(face, texels_per_unit_));
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

// Lists the faces that border each leaf. `leaves` are the world's leaves that are not solid; leaves[i] is
// leaf i + 1 of the level.
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

// `leaves` as for add_marksurfaces.
void Builder::add_visibility(const std::vector<GridTree::Leaf>& leaves) {
  const std::vector<std::vector<std::uint8_t>> rows = find_visible_leaves(world_, leaves);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bsp_.leaves[i + 1].visibility_offset = static_cast<std::int32_t>(bsp_.visibility.size());
    const std::vector<std::uint8_t> coded = compress_row(rows[i]);
    bsp_.visibility.insert(bsp_.visibility.end(), coded.begin(), coded.end());
  }
}

// Appends the clip hull for a box of this size and returns its head node. A clip node's child is another node
// or, if negative, the contents itself. `background` is what lies outside the grid.
std::int32_t Builder::add_clip_tree(const CellGrid& grid, const math::Bounds& box, std::int32_t background) {
  const CellGrid grown = grow_grid(grid, box.mins, box.maxs, background);
  const GridTree tree = build_grid_tree(grown);
  const auto head = static_cast<std::int32_t>(bsp_.clipnodes.size());
  for (const GridTree::Node& node : tree.nodes) {
    formats::BspClipnode clipnode;
    clipnode.plane = add_plane(node.axis, grown.lines[node.axis][node.line]);
    for (std::size_t side = 0; side < 2; ++side) {
      const std::int32_t child = node.children[side];
      clipnode.children[side] =
          child >= 0 ? child + head : tree.leaves[static_cast<std::size_t>(~child)].contents;
    }
    bsp_.clipnodes.push_back(clipnode);
  }
  return head;
}

std::string format_vec3(const math::Vec3& value) {
  return fmt::format("{} {} {}", value.x, value.y, value.z);
}

void Builder::add_entities() {
  std::vector<formats::Entity> entities;
  entities.push_back({{{"classname", "worldspawn"}, {"message", "Made in code"}}});
  for (const LayoutEntity& placed : layout_.entities) {
    formats::Entity entity{{{"classname", placed.classname}, {"origin", format_vec3(placed.origin)}}};
    const std::string yaw = fmt::format("{}", placed.yaw_deg);
    const bool is_camera = entity.classname() == "info_intermission";
    entity.pairs.emplace_back(is_camera ? "mangle" : "angle", is_camera ? "20 " + yaw + " 0" : yaw);
    entities.push_back(std::move(entity));
  }
  // Angle -1: the door moves up.
  entities.push_back({{{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}}});
  for (const LayoutLight& light : layout_.lights) {
    entities.push_back({{{"classname", "light"},
                         {"origin", format_vec3(light.origin)},
                         {"light", fmt::format("{}", light.reach)},
                         {"style", fmt::format("{}", light.style)},
                         {"_color", format_vec3(light.color)}}});
  }
  bsp_.entities = formats::write_entities(entities);
}

std::uint32_t Builder::add_plane(std::size_t axis, float distance) {
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

std::uint32_t Builder::add_texinfo(Material material, const TextureProjection& projection) {
  const auto next = static_cast<std::uint32_t>(bsp_.texinfos.size());
  const auto [entry, is_new] = texinfos_.try_emplace({material, projection.s_axis, projection.t_axis}, next);
  if (is_new) {
    formats::BspTexinfo texinfo;
    texinfo.s_axis[static_cast<int>(projection.s_axis)] = projection.texels_per_unit;
    // T grows downward on walls, as in any texture.
    texinfo.t_axis[static_cast<int>(projection.t_axis)] = -projection.texels_per_unit;
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
  for (const LayoutBox& box : make_layout(options).boxes) boxes.push_back({box.bounds, box.contents});
  return boxes;
}

math::Bounds small_level_door(const SmallLevelOptions& options) {
  return make_layout(options).door;
}

}  // namespace temblor::artgen
