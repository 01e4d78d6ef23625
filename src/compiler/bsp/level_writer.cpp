#include "compiler/bsp/level_writer.h"

#include <algorithm>

namespace temblor::compiler {
namespace {

// GLQuake and its descendants draw skies and liquids from buffers of 64 vertices, and crash if a face has
// more.
constexpr std::size_t kMaxFaceVertices = 60;

// The contents of a leaf as a .bsp numbers them.
std::int32_t to_contents(Fill fill) {
  switch (fill) {
    // CONTENTS_WATER to CONTENTS_SKY of the game; below, CONTENTS_SOLID and CONTENTS_EMPTY.
    case Fill::kWater:
      return -3;
    case Fill::kSlime:
      return -4;
    case Fill::kLava:
      return -5;
    case Fill::kSky:
      return -6;
    default:
      return is_blocked(fill) ? -2 : -1;
  }
}

// Extends a box by another one.
void join(Box& io_box, const Box& other) {
  if (other.is_empty()) return;
  io_box.add(other.mins);
  io_box.add(other.maxs);
}

// Empty boxes become points: lumps have no empty box.
math::Vec3 box_mins(const Box& box) {
  return box.is_empty() ? math::Vec3(0.0f) : math::Vec3(box.mins);
}
math::Vec3 box_maxs(const Box& box) {
  return box.is_empty() ? math::Vec3(0.0f) : math::Vec3(box.maxs);
}

// The number of a leaf that is a child.
std::size_t number(std::int32_t leaf_child) {
  return static_cast<std::size_t>(~leaf_child);
}

}  // namespace

LevelWriter::LevelWriter(const PlaneSet& planes) : planes_(planes) {
  formats::BspLeaf solid;
  solid.contents = to_contents(Fill::kSolid);
  bsp_.leaves.push_back(solid);
  bsp_.edges.push_back({});  // edge 0 is never used: -0 could not mean the other direction
}

// Leaves get their numbers before faces and nodes, which refer to them.
std::vector<std::uint32_t> LevelWriter::add_model(const Tree& tree, std::span<const LeafPortal> portals,
                                                  std::span<const TreeFace> faces, const Box& box) {
  ModelParts parts{
      tree, std::vector<Box>(tree.leaves.size()), std::vector<std::uint32_t>(tree.leaves.size(), 0),
      std::vector<std::pair<std::uint32_t, std::uint32_t>>(tree.nodes.size()), bsp_.leaves.size()};
  for (const LeafPortal& portal : portals)
    for (const std::uint32_t leaf : portal.leaves) parts.leaf_boxes[leaf].add(portal.winding);
  formats::BspModel model;
  model.mins = box_mins(box);
  model.maxs = box_maxs(box);
  model.first_face = static_cast<std::uint32_t>(bsp_.faces.size());
  add_leaves(tree.root, parts);
  model.visible_leaves = static_cast<std::int32_t>(bsp_.leaves.size() - parts.first_leaf);
  add_faces(faces, parts);
  model.face_count = static_cast<std::uint32_t>(bsp_.faces.size()) - model.first_face;
  model.head_nodes = {add_node(tree.root, parts).first, -1, -1, -1};
  // Engines would read a leaf's number here as contents, so a model that is a single leaf still gets a node.
  if (tree.is_leaf(tree.root)) {
    formats::BspNode node;
    node.plane = plane_number(PlaneIndex{0});
    node.children = {model.head_nodes[0], model.head_nodes[0]};
    model.head_nodes[0] = static_cast<std::int32_t>(bsp_.nodes.size());
    bsp_.nodes.push_back(node);
  }
  bsp_.models.push_back(model);
  return std::move(parts.leaf_numbers);
}

// Numbers the open leaves in the order of the tree.
void LevelWriter::add_leaves(std::int32_t child, ModelParts& io_parts) {
  if (child >= 0) {
    for (const std::int32_t below : io_parts.tree.nodes[static_cast<std::size_t>(child)].children)
      add_leaves(below, io_parts);
    return;
  }
  const TreeLeaf& from = io_parts.tree.leaves[number(child)];
  if (is_blocked(from.fill)) return;
  formats::BspLeaf leaf;
  leaf.contents = to_contents(from.fill);
  leaf.mins = box_mins(io_parts.leaf_boxes[number(child)]);
  leaf.maxs = box_maxs(io_parts.leaf_boxes[number(child)]);
  io_parts.leaf_numbers[number(child)] = static_cast<std::uint32_t>(bsp_.leaves.size());
  bsp_.leaves.push_back(leaf);
}

// Turns windings into loops of shared vertices and edges, and lists each face in the leaves that see it.
// Faces that only solid leaves see are dropped.
void LevelWriter::add_faces(std::span<const TreeFace> faces, ModelParts& io_parts) {
  std::vector<FaceLoop> loops;
  for (const TreeFace& face : faces) {
    FaceLoop loop;
    for (const math::Vec3d& point : face.winding) loop.push_back(vertices_.find_or_add(point));
    loops.push_back(std::move(loop));
  }
  close_t_junctions(loops, vertices_);
  open_edges_.clear();  // models share no edges
  std::vector<std::vector<std::uint32_t>> marked(bsp_.leaves.size() - io_parts.first_leaf);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const TreeFace& face = faces[i];
    const auto in_sight = [&](std::uint32_t leaf) { return io_parts.leaf_numbers[leaf] != 0; };
    if (loops[i].size() < 3 || std::none_of(face.leaves.begin(), face.leaves.end(), in_sight)) continue;
    for (const FaceLoop& loop : split_long_loop(std::move(loops[i]), kMaxFaceVertices, vertices_)) {
      const std::uint32_t index = add_face(face, loop);
      auto& [first, count] = io_parts.first_face_and_count[face.node];
      if (count++ == 0) first = index;
      for (const std::uint32_t leaf : face.leaves)
        if (in_sight(leaf)) marked[io_parts.leaf_numbers[leaf] - io_parts.first_leaf].push_back(index);
    }
  }
  for (std::size_t i = bsp_.vertices.size(); i < vertices_.points().size(); ++i)
    bsp_.vertices.push_back(math::Vec3(vertices_.points()[i]));
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i].empty()) continue;
    formats::BspLeaf& leaf = bsp_.leaves[io_parts.first_leaf + i];
    leaf.first_marksurface = static_cast<std::uint32_t>(bsp_.marksurfaces.size());
    leaf.marksurface_count = static_cast<std::uint32_t>(marked[i].size());
    bsp_.marksurfaces.insert(bsp_.marksurfaces.end(), marked[i].begin(), marked[i].end());
  }
}

// Writes one face, and returns its number.
std::uint32_t LevelWriter::add_face(const TreeFace& face, std::span<const std::uint32_t> loop) {
  formats::BspFace out;
  out.plane = plane_number(stored(face.plane));
  out.side = is_flipped(face.plane) ? 1 : 0;
  out.first_surfedge = static_cast<std::uint32_t>(bsp_.surfedges.size());
  out.surfedge_count = static_cast<std::uint32_t>(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
    bsp_.surfedges.push_back(surfedge(loop[k], loop[(k + 1) % loop.size()]));
  bsp_.faces.push_back(out);
  surface_of_face_.push_back(face.surface);
  return static_cast<std::uint32_t>(bsp_.faces.size() - 1);
}

// Writes a subtree, parents before children. Returns its child number and the box around its open leaves.
std::pair<std::int32_t, Box> LevelWriter::add_node(std::int32_t child, const ModelParts& parts) {
  if (child < 0) {
    const Fill fill = parts.tree.leaves[number(child)].fill;
    const bool is_seen = !is_blocked(fill) || fill == Fill::kFence;  // one looks into fences
    return {-static_cast<std::int32_t>(parts.leaf_numbers[number(child)]) - 1,
            is_seen ? parts.leaf_boxes[number(child)] : Box{}};
  }
  const TreeNode& from = parts.tree.nodes[static_cast<std::size_t>(child)];
  const std::size_t index = bsp_.nodes.size();
  bsp_.nodes.emplace_back();
  formats::BspNode node;
  node.plane = plane_number(from.plane);
  std::tie(node.first_face, node.face_count) = parts.first_face_and_count[static_cast<std::size_t>(child)];
  Box box;
  for (const std::size_t side : {0, 1}) {
    const auto [number_below, box_below] = add_node(from.children[side], parts);
    node.children[side] = number_below;
    join(box, box_below);
  }
  node.mins = box_mins(box);
  node.maxs = box_maxs(box);
  if (node.children == std::array<std::int32_t, 2>{-1, -1}) between_solids_.push_back(index);
  bsp_.nodes[index] = node;
  return {static_cast<std::int32_t>(index), box};
}

void LevelWriter::set_hull(std::size_t hull, const Tree& tree) {
  bsp_.models.back().head_nodes[hull] = add_clipnode(tree, tree.root);
}

// Writes a subtree of a clip hull, whose leaves are contents instead of numbers.
std::int32_t LevelWriter::add_clipnode(const Tree& tree, std::int32_t child) {
  if (child < 0) return to_contents(tree.leaves[number(child)].fill);
  const TreeNode& from = tree.nodes[static_cast<std::size_t>(child)];
  const std::size_t index = bsp_.clipnodes.size();
  bsp_.clipnodes.push_back({plane_number(from.plane), {}});
  for (const std::size_t side : {0, 1}) {
    const std::int32_t below = add_clipnode(tree, from.children[side]);
    bsp_.clipnodes[index].children[side] = below;
  }
  return static_cast<std::int32_t>(index);
}

// The number of a plane in the level. Planes that nothing uses are not written.
std::uint32_t LevelWriter::plane_number(PlaneIndex plane) {
  const auto [known, is_new] =
      plane_numbers_.try_emplace(plane, static_cast<std::uint32_t>(bsp_.planes.size()));
  if (is_new) {
    const Plane& from = planes_[plane];
    std::int32_t dominant = 0;
    for (std::int32_t axis : {1, 2})
      if (std::abs(from.normal[axis]) > std::abs(from.normal[dominant])) dominant = axis;
    bsp_.planes.push_back({math::Vec3(from.normal), static_cast<float>(from.distance),
                           from.axis < 3 ? from.axis : 3 + dominant});
  }
  return known->second;
}

// An edge that a neighbor already uses in the other direction is reused with a negative sign.
std::int32_t LevelWriter::surfedge(std::uint32_t from, std::uint32_t to) {
  if (const auto open = open_edges_.find({to, from}); open != open_edges_.end()) {
    const auto edge = static_cast<std::int32_t>(open->second);
    open_edges_.erase(open);
    return -edge;
  }
  const auto edge = static_cast<std::uint32_t>(bsp_.edges.size());
  bsp_.edges.push_back({{from, to}});
  open_edges_.insert_or_assign({from, to}, edge);
  return static_cast<std::int32_t>(edge);
}

formats::Bsp LevelWriter::take() && {
  if (!between_solids_.empty()) {
    // After all leaves that can be seen, so that it is in no PVS.
    for (const std::size_t node : between_solids_)
      bsp_.nodes[node].children[1] = -static_cast<std::int32_t>(bsp_.leaves.size()) - 1;
    bsp_.leaves.push_back(bsp_.leaves.front());
  }
  if (bsp_.vertices.empty()) bsp_.vertices.emplace_back();  // edge 0 needs one even if nothing is drawn
  return std::move(bsp_);
}

}  // namespace temblor::compiler
