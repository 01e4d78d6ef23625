#include "formats/levels/bsp_validate.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "formats/levels/bsp/trees.h"

namespace temblor::formats {
namespace {

using Fault = std::optional<BspFault>;

template <typename... Args>
BspFault fault(BspLump lump, std::size_t record, fmt::format_string<Args...> reason, Args&&... args) {
  return {lump, record, fmt::format(reason, std::forward<Args>(args)...)};
}

bool is_sane_number(float value) {
  return std::abs(value) <= kBspMaxCoordinate;  // false for NaN
}

// Finds the first range [first, first + count) that exceeds an array of `size`, or makes the total of all
// counts exceed it. `Range` returns the {first, count} of a record.
template <typename Record, typename Range>
Fault check_ranges(const std::vector<Record>& records, BspLump lump, std::size_t size, const char* what,
                   Range range) {
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto [first, count] = range(records[i]);
    if (std::uint64_t{first} + count > size)
      return fault(lump, i, "{} {} and the {} after it are past the end ({})", what, first, count, size);
    total += count;
    if (total > size)
      return fault(lump, i, "{}s are referenced {} times up to here, but there are only {}", what, total,
                   size);
  }
  return std::nullopt;
}

Fault check_plane(const BspPlane& plane, std::size_t i) {
  constexpr BspLump kLump = BspLump::kPlanes;
  constexpr float kLengthSquaredTolerance = 0.02f;
  if (!is_sane(plane.normal) || !is_sane_number(plane.distance))
    return fault(kLump, i, "a number is not finite or too large");
  const float length_squared = glm::dot(plane.normal, plane.normal);
  if (std::abs(length_squared - 1) > kLengthSquaredTolerance)
    return fault(kLump, i, "the length of the normal is {}, not 1", std::sqrt(length_squared));
  if (plane.type < 0 || plane.type > 5) return fault(kLump, i, "type {} is not 0 to 5", plane.type);
  math::Vec3 axis(0.0f);
  axis[plane.type % 3] = 1;
  if (plane.type < 3 && plane.normal != axis)
    return fault(kLump, i, "type {} does not fit the normal {} {} {}", plane.type, plane.normal.x,
                 plane.normal.y, plane.normal.z);
  return std::nullopt;
}

Fault check_planes(const Bsp& bsp) {
  for (std::size_t i = 0; i < bsp.planes.size(); ++i)
    if (auto found = check_plane(bsp.planes[i], i)) return found;
  return std::nullopt;
}

Fault check_textures(const Bsp& bsp) {
  constexpr BspLump kLump = BspLump::kTextures;
  for (std::size_t i = 0; i < bsp.miptexes.size(); ++i) {
    const BspMiptex& texture = bsp.miptexes[i];
    if (!texture.present) {
      if (texture != BspMiptex{}) return fault(kLump, i, "the texture is marked absent but not empty");
      continue;
    }
    for (const std::uint32_t size : {texture.width, texture.height})
      if (size < 1 || size > kBspMaxTextureSize)
        return fault(kLump, i, "size {} is not within 1 to {}", size, kBspMaxTextureSize);
    if (texture.palette.size() > 256)
      return fault(kLump, i, "{} colors are over 256", texture.palette.size());
    if (texture.mips == BspMiptex{}.mips) continue;
    for (std::size_t mip = 0; mip < texture.mips.size(); ++mip)
      if (texture.mips[mip].size() != std::size_t{texture.width >> mip} * (texture.height >> mip))
        return fault(kLump, i, "mip level {} has {} texels", mip, texture.mips[mip].size());
  }
  return std::nullopt;
}

Fault check_vertices(const Bsp& bsp) {
  for (std::size_t i = 0; i < bsp.vertices.size(); ++i)
    if (!is_sane(bsp.vertices[i]))
      return fault(BspLump::kVertices, i, "a coordinate is not finite or too large");
  return std::nullopt;
}

Fault check_texinfos(const Bsp& bsp) {
  constexpr BspLump kLump = BspLump::kTexinfo;
  for (std::size_t i = 0; i < bsp.texinfos.size(); ++i) {
    const BspTexinfo& texinfo = bsp.texinfos[i];
    if (!is_sane(texinfo)) return fault(kLump, i, "a number is not finite or too large");
    if (texinfo.miptex < 0 || static_cast<std::size_t>(texinfo.miptex) >= bsp.miptexes.size())
      return fault(kLump, i, "texture {} is past the end ({})", texinfo.miptex, bsp.miptexes.size());
  }
  return std::nullopt;
}

Fault check_edges(const Bsp& bsp) {
  for (std::size_t i = 0; i < bsp.edges.size(); ++i)
    for (const std::uint32_t vertex : bsp.edges[i].vertices)
      if (vertex >= bsp.vertices.size())
        return fault(BspLump::kEdges, i, "vertex {} is past the end ({})", vertex, bsp.vertices.size());
  for (std::size_t i = 0; i < bsp.surfedges.size(); ++i)
    if (std::abs(std::int64_t{bsp.surfedges[i]}) >= static_cast<std::int64_t>(bsp.edges.size()))
      return fault(BspLump::kSurfedges, i, "edge {} is past the end ({})", bsp.surfedges[i],
                   bsp.edges.size());
  return std::nullopt;
}

// Returns the start and end vertex of a surfedge.
std::array<std::uint32_t, 2> surfedge_vertices(const Bsp& bsp, std::size_t surfedge) {
  const std::int32_t edge = bsp.surfedges[surfedge];
  const auto& vertices = bsp.edges[static_cast<std::size_t>(std::abs(edge))].vertices;
  if (edge >= 0) return vertices;
  return {vertices[1], vertices[0]};
}

// Checks that the edges form a loop. Requires that the surfedges are in range.
Fault check_loop(const Bsp& bsp, std::size_t face_number) {
  const BspFace& face = bsp.faces[face_number];
  std::uint32_t previous_end = surfedge_vertices(bsp, face.first_surfedge + face.surfedge_count - 1)[1];
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const auto [start, end] = surfedge_vertices(bsp, face.first_surfedge + i);
    if (start != previous_end)
      return fault(BspLump::kFaces, face_number,
                   "the edges do not form a loop: edge {} starts at vertex {}, the previous one ends at {}",
                   i, start, previous_end);
    previous_end = end;
  }
  return std::nullopt;
}

Fault check_face(const Bsp& bsp, std::size_t i) {
  constexpr BspLump kLump = BspLump::kFaces;
  const BspFace& face = bsp.faces[i];
  if (face.plane >= bsp.planes.size())
    return fault(kLump, i, "plane {} is past the end ({})", face.plane, bsp.planes.size());
  if (face.side != 0 && face.side != 1) return fault(kLump, i, "side {} is not 0 or 1", face.side);
  if (face.surfedge_count < 3 || face.surfedge_count > kBspMaxFaceEdges)
    return fault(kLump, i, "{} edges are not within 3 to {}", face.surfedge_count, kBspMaxFaceEdges);
  if (face.texinfo >= bsp.texinfos.size())
    return fault(kLump, i, "texinfo {} is past the end ({})", face.texinfo, bsp.texinfos.size());
  if (face.light_offset < -1) return fault(kLump, i, "light offset {} is below -1", face.light_offset);
  return std::nullopt;
}

Fault check_faces(const Bsp& bsp) {
  for (std::size_t i = 0; i < bsp.faces.size(); ++i)
    if (auto found = check_face(bsp, i)) return found;
  if (auto found = check_ranges(
          bsp.faces, BspLump::kFaces, bsp.surfedges.size(), "surfedge",
          [](const BspFace& face) { return std::pair(face.first_surfedge, face.surfedge_count); }))
    return found;
  for (std::size_t i = 0; i < bsp.faces.size(); ++i)
    if (auto found = check_loop(bsp, i)) return found;
  return std::nullopt;
}

Fault check_leaves(const Bsp& bsp) {
  constexpr BspLump kLump = BspLump::kLeaves;
  constexpr std::int32_t kSolid = -2;
  if (bsp.leaves.empty()) return BspFault{kLump, std::nullopt, "leaf 0 (solid) is missing"};
  if (bsp.leaves[0].contents != kSolid)
    return fault(kLump, 0, "contents {} are not solid ({})", bsp.leaves[0].contents, kSolid);
  for (std::size_t i = 0; i < bsp.leaves.size(); ++i) {
    const BspLeaf& leaf = bsp.leaves[i];
    if (!is_sane(leaf.mins) || !is_sane(leaf.maxs)) return fault(kLump, i, "a bound is not finite");
    if (leaf.contents < kBspMinContents || leaf.contents > -1)
      return fault(kLump, i, "contents {} are not within {} to -1", leaf.contents, kBspMinContents);
    const bool inside = leaf.visibility_offset >= 0 &&
                        static_cast<std::size_t>(leaf.visibility_offset) < bsp.visibility.size();
    if (leaf.visibility_offset != -1 && !inside)
      return fault(kLump, i, "visibility offset {} is past the end ({})", leaf.visibility_offset,
                   bsp.visibility.size());
  }
  return check_ranges(bsp.leaves, kLump, bsp.marksurfaces.size(), "marksurface", [](const BspLeaf& leaf) {
    return std::pair(leaf.first_marksurface, leaf.marksurface_count);
  });
}

Fault check_marksurfaces(const Bsp& bsp) {
  for (std::size_t i = 0; i < bsp.marksurfaces.size(); ++i)
    if (bsp.marksurfaces[i] >= bsp.faces.size())
      return fault(BspLump::kMarksurfaces, i, "face {} is past the end ({})", bsp.marksurfaces[i],
                   bsp.faces.size());
  return std::nullopt;
}

Fault check_nodes(const Bsp& bsp) {
  constexpr BspLump kLump = BspLump::kNodes;
  for (std::size_t i = 0; i < bsp.nodes.size(); ++i) {
    const BspNode& node = bsp.nodes[i];
    if (node.plane >= bsp.planes.size())
      return fault(kLump, i, "plane {} is past the end ({})", node.plane, bsp.planes.size());
    if (!is_sane(node.mins) || !is_sane(node.maxs)) return fault(kLump, i, "a bound is not finite");
    for (const std::int32_t child : node.children)
      if (!is_node_or_leaf(bsp, child))
        return fault(kLump, i, "child {} is neither one of {} nodes nor of {} leaves", child,
                     bsp.nodes.size(), bsp.leaves.size());
  }
  return check_ranges(bsp.nodes, kLump, bsp.faces.size(), "face",
                      [](const BspNode& node) { return std::pair(node.first_face, node.face_count); });
}

Fault check_clipnodes(const Bsp& bsp) {
  constexpr BspLump kLump = BspLump::kClipnodes;
  for (std::size_t i = 0; i < bsp.clipnodes.size(); ++i) {
    const BspClipnode& clipnode = bsp.clipnodes[i];
    if (clipnode.plane >= bsp.planes.size())
      return fault(kLump, i, "plane {} is past the end ({})", clipnode.plane, bsp.planes.size());
    for (const std::int32_t child : clipnode.children)
      if (!is_clipnode_or_contents(bsp, child))
        return fault(kLump, i, "child {} is neither one of {} clipnodes nor contents", child,
                     bsp.clipnodes.size());
  }
  return std::nullopt;
}

Fault check_models(const Bsp& bsp) {
  constexpr BspLump kLump = BspLump::kModels;
  if (bsp.models.empty()) return BspFault{kLump, std::nullopt, "model 0 (the world) is missing"};
  for (std::size_t i = 0; i < bsp.models.size(); ++i) {
    const BspModel& model = bsp.models[i];
    if (!is_sane(model.mins) || !is_sane(model.maxs) || !is_sane(model.origin))
      return fault(kLump, i, "a coordinate is not finite or too large");
    if (!is_node_or_leaf(bsp, model.head_nodes[0]))
      return fault(kLump, i, "head {} of hull 0 is neither one of {} nodes nor of {} leaves",
                   model.head_nodes[0], bsp.nodes.size(), bsp.leaves.size());
    for (std::size_t hull = 1; hull < model.head_nodes.size(); ++hull)
      if (!is_clipnode_or_contents(bsp, model.head_nodes[hull]))
        return fault(kLump, i, "head {} of hull {} is neither one of {} clipnodes nor contents",
                     model.head_nodes[hull], hull, bsp.clipnodes.size());
    if (model.visible_leaves < 0 || static_cast<std::size_t>(model.visible_leaves) >= bsp.leaves.size())
      return fault(kLump, i, "{} visible leaves are not fewer than all {}", model.visible_leaves,
                   bsp.leaves.size());
  }
  return check_ranges(bsp.models, kLump, bsp.faces.size(), "face",
                      [](const BspModel& model) { return std::pair(model.first_face, model.face_count); });
}

}  // namespace

std::optional<BspFault> find_fault(const Bsp& bsp) {
  // Each check may rely on the ones before it: ranges first, then loops and trees that follow references.
  for (auto* check : {check_planes, check_textures, check_vertices, check_texinfos, check_edges, check_faces,
                      check_leaves, check_marksurfaces, check_nodes, check_clipnodes, check_models,
                      bsp_file::check_node_trees, bsp_file::check_clipnode_trees})
    if (auto found = check(bsp)) return found;
  return std::nullopt;
}

bool is_sane(const math::Vec3& vector) {
  return is_sane_number(vector.x) && is_sane_number(vector.y) && is_sane_number(vector.z);
}

bool is_sane(const BspTexinfo& texinfo) {
  return is_sane(texinfo.s_axis) && is_sane(texinfo.t_axis) && is_sane_number(texinfo.s_offset) &&
         is_sane_number(texinfo.t_offset);
}

bool is_valid_plane(const BspPlane& plane) {
  return !check_plane(plane, 0).has_value();
}

std::int32_t find_plane_type(const math::Vec3& normal) {
  const math::Vec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  math::Vec3 unit(0.0f);
  unit[axis] = 1;
  return normal == unit ? axis : 3 + axis;
}

bool is_node_or_leaf(const Bsp& bsp, std::int32_t child) {
  return child >= 0 ? static_cast<std::size_t>(child) < bsp.nodes.size()
                    : static_cast<std::size_t>(~child) < bsp.leaves.size();
}

bool is_clipnode_or_contents(const Bsp& bsp, std::int32_t child) {
  return child >= 0 ? static_cast<std::size_t>(child) < bsp.clipnodes.size() : child >= kBspMinContents;
}

}  // namespace temblor::formats
