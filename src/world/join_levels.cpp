#include "world/join_levels.h"

#include <algorithm>

namespace temblor::world {
namespace {

std::uint32_t count(std::size_t size) {
  return static_cast<std::uint32_t>(size);
}

// The sizes of the lists before a level is added: what must be added to its indices.
struct Offsets {
  std::uint32_t planes, nodes, leaves, clipnodes, faces, marked_faces, vertices, edges, surfedges, axes,
      textures, light, light_map_grids;
  explicit Offsets(const Level& level)
      : planes(count(level.planes.size())),
        nodes(count(level.nodes.size())),
        leaves(count(level.leaves.size())),
        clipnodes(count(level.clipnodes.size())),
        faces(count(level.faces.size())),
        marked_faces(count(level.marked_faces.size())),
        vertices(count(level.vertices.size())),
        edges(count(level.edges.size())),
        surfedges(count(level.surfedges.size())),
        axes(count(level.texture_axes.size())),
        textures(count(level.textures.size())),
        light(count(level.light.size())),
        light_map_grids(count(level.light_map_grids.size())) {}

  // Leaves are stored as ~index, so the offset is added to the index, not to the stored value.
  Child moved(Child child) const {
    const auto nodes_before = static_cast<std::int32_t>(nodes),
               leaves_before = static_cast<std::int32_t>(leaves);
    return {child.is_leaf() ? ~(~child.value + leaves_before) : child.value + nodes_before};
  }
  TextureIndex moved(TextureIndex texture) const {
    return base::to_index<TextureIndex>(base::to_size(texture) + textures);
  }
  // Negative values are contents, which stay.
  std::int32_t moved_clipnode(std::int32_t clipnode) const {
    return clipnode < 0 ? clipnode : clipnode + static_cast<std::int32_t>(clipnodes);
  }
};

void add_trees(const Level& other, const Offsets& offsets, Level& io_level) {
  for (Node node : other.nodes) {
    node.plane += offsets.planes;
    for (Child& child : node.children) child = offsets.moved(child);
    node.first_face += offsets.faces;
    io_level.nodes.push_back(node);
  }
  for (Leaf leaf : other.leaves) {
    leaf.visibility_offset = -1;  // the other level's PVS is not used
    leaf.first_marked_face += offsets.marked_faces;
    io_level.leaves.push_back(leaf);
  }
  for (Clipnode node : other.clipnodes) {
    node.plane += offsets.planes;
    for (std::int32_t& child : node.children) child = offsets.moved_clipnode(child);
    io_level.clipnodes.push_back(node);
  }
  for (Model model : other.models) {
    model.head = offsets.moved(model.head);
    for (std::int32_t& head : model.clip_heads) head = offsets.moved_clipnode(head);
    model.first_face += offsets.faces;
    io_level.models.push_back(model);
  }
}

void add_faces(const Level& other, const Offsets& offsets, Level& io_level) {
  for (Face face : other.faces) {
    face.plane += offsets.planes;
    face.first_surfedge += offsets.surfedges;
    face.axes += offsets.axes;
    face.texture = offsets.moved(face.texture);
    if (face.light != kNoLight) face.light += offsets.light;
    if (face.light_map_grid != kStockGrid) face.light_map_grid += offsets.light_map_grids;
    io_level.faces.push_back(face);
  }
  for (const FaceIndex face : other.marked_faces)
    io_level.marked_faces.push_back(base::to_index<FaceIndex>(base::to_size(face) + offsets.faces));
  for (formats::BspEdge edge : other.edges) {
    for (auto& vertex : edge.vertices) vertex += offsets.vertices;
    io_level.edges.push_back(edge);
  }
  const auto edges_before = static_cast<std::int32_t>(offsets.edges);
  for (const std::int32_t surfedge : other.surfedges)
    io_level.surfedges.push_back(surfedge < 0 ? surfedge - edges_before : surfedge + edges_before);
  for (Texture texture : other.textures) {
    for (TextureIndex& frame : texture.frames) frame = offsets.moved(frame);
    for (TextureIndex& frame : texture.alternate_frames) frame = offsets.moved(frame);
    io_level.textures.push_back(std::move(texture));
  }
}

// Returns the level's colored light, or its gray light with equal channels.
std::vector<std::uint8_t> make_colored_light(const Level& level) {
  if (!level.light_rgb.empty()) return level.light_rgb;
  std::vector<std::uint8_t> rgb;
  rgb.reserve(level.light.size() * 3);
  for (const std::uint8_t gray : level.light) rgb.insert(rgb.end(), 3, gray);
  return rgb;
}

template <typename T>
void append(const std::vector<T>& from, std::vector<T>& io_to) {
  io_to.insert(io_to.end(), from.begin(), from.end());
}

void add_light(const Level& other, Level& io_level) {
  // A level has colors for all of its light or for none of it.
  if (!io_level.light_rgb.empty() || !other.light_rgb.empty()) {
    io_level.light_rgb = make_colored_light(io_level);
    append(make_colored_light(other), io_level.light_rgb);
  }
  append(other.light, io_level.light);
  append(other.light_map_grids, io_level.light_map_grids);
}

}  // namespace

JoinedLevel join_levels(const std::shared_ptr<const Level>& base,
                        std::span<const std::shared_ptr<const Level>> others) {
  if (others.empty()) return {base, {}};
  auto level = std::make_shared<Level>(*base);
  // Caches must not mix up the joined level with its base.
  level->identity = std::make_shared<const LevelIdentity>();
  JoinedLevel joined;
  for (const std::shared_ptr<const Level>& other : others) {
    const Offsets offsets(*level);
    joined.models.push_back(base::to_index<ModelIndex>(level->models.size()));
    add_trees(*other, offsets, *level);
    add_faces(*other, offsets, *level);
    add_light(*other, *level);
    append(other->planes, level->planes);
    append(other->vertices, level->vertices);
    append(other->texture_axes, level->texture_axes);
  }
  joined.level = std::move(level);
  return joined;
}

}  // namespace temblor::world
