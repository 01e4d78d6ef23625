#include "formats/levels/bsp/repair_faces.h"

#include <algorithm>
#include <cstdlib>

#include "formats/levels/bsp/repair_ranges.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr std::uint32_t kMinEdges = 3;
constexpr std::int32_t kNoLightFlag = 1;

// The records of one lump that cannot be used, by number.
using Damage = std::vector<bool>;

std::size_t count_damaged(const Damage& damaged) {
  return static_cast<std::size_t>(std::ranges::count(damaged, true));
}

Damage repair_vertices(std::vector<math::Vec3>& io_vertices) {
  Damage damaged(io_vertices.size());
  for (std::size_t i = 0; i < io_vertices.size(); ++i) {
    if (is_sane(io_vertices[i])) continue;
    io_vertices[i] = math::Vec3(0.0f);
    damaged[i] = true;
  }
  return damaged;
}

Damage repair_edges(const Damage& damaged_vertices, std::vector<BspEdge>& io_edges) {
  Damage damaged(io_edges.size());
  for (std::size_t i = 0; i < io_edges.size(); ++i)
    for (const std::uint32_t vertex : io_edges[i].vertices)
      damaged[i] = damaged[i] || vertex >= damaged_vertices.size() || damaged_vertices[vertex];
  for (std::size_t i = 0; i < io_edges.size(); ++i)
    if (damaged[i]) io_edges[i] = BspEdge{};
  return damaged;
}

Damage repair_surfedges(const Damage& damaged_edges, std::vector<std::int32_t>& io_surfedges) {
  Damage damaged(io_surfedges.size());
  for (std::size_t i = 0; i < io_surfedges.size(); ++i) {
    const auto edge = static_cast<std::uint64_t>(std::abs(std::int64_t{io_surfedges[i]}));
    damaged[i] = edge >= damaged_edges.size() || damaged_edges[edge];
    if (damaged[i]) io_surfedges[i] = 0;
  }
  return damaged;
}

BspTexinfo make_unlit_texinfo() {
  BspTexinfo texinfo;
  texinfo.s_axis = {1, 0, 0};
  texinfo.t_axis = {0, 1, 0};
  texinfo.flags = kNoLightFlag;
  return texinfo;
}

Damage repair_axes(std::vector<BspTexinfo>& io_texinfos) {
  Damage damaged(io_texinfos.size());
  for (std::size_t i = 0; i < io_texinfos.size(); ++i) {
    if (is_sane(io_texinfos[i])) continue;
    const std::int32_t miptex = io_texinfos[i].miptex;
    io_texinfos[i] = make_unlit_texinfo();
    io_texinfos[i].miptex = miptex;
    damaged[i] = true;
  }
  return damaged;
}

// All texinfos without a texture get the same missing one.
std::size_t repair_textures(Bsp& io_bsp) {
  const std::size_t textures = io_bsp.miptexes.size();
  std::size_t changed = 0;
  for (BspTexinfo& texinfo : io_bsp.texinfos) {
    if (texinfo.miptex >= 0 && static_cast<std::size_t>(texinfo.miptex) < textures) continue;
    texinfo.miptex = static_cast<std::int32_t>(textures);
    ++changed;
  }
  if (changed > 0) io_bsp.miptexes.emplace_back();
  return changed;
}

bool has_damage(const Damage& damaged, std::uint32_t first, std::uint32_t count) {
  if (std::uint64_t{first} + count > damaged.size()) return true;
  const auto begin = damaged.begin() + first;
  return std::find(begin, begin + count, true) != begin + count;
}

// Faces that cannot be drawn. Others get a side of 0 or 1 and at least -1 as light offset, which counts in
// `io_changed`.
Damage find_damaged_faces(const Damage& texinfos, const Damage& surfedges, Bsp& io_bsp,
                          std::size_t& io_changed) {
  Damage damaged(io_bsp.faces.size());
  for (std::size_t i = 0; i < damaged.size(); ++i) {
    BspFace& face = io_bsp.faces[i];
    const bool has_edges = face.surfedge_count >= kMinEdges && face.surfedge_count <= kBspMaxFaceEdges;
    damaged[i] = !has_edges || face.plane >= io_bsp.planes.size() || face.texinfo >= texinfos.size() ||
                 texinfos[face.texinfo] || has_damage(surfedges, face.first_surfedge, face.surfedge_count);
    if (damaged[i]) {
      face = BspFace{};
      continue;
    }
    const BspFace before = face;
    face.side = face.side != 0;
    face.light_offset = std::max(face.light_offset, -1);
    io_changed += face != before;
  }
  return damaged;
}

// Other engines use only the vertices at which the edges of a face start.
bool close_outline(Bsp& io_bsp, BspFace& io_face) {
  bool is_closed = true;
  std::vector<std::uint32_t> starts(io_face.surfedge_count);
  for (std::uint32_t i = 0; i < io_face.surfedge_count; ++i)
    starts[i] = find_start(io_bsp, io_face.first_surfedge + i);
  for (std::uint32_t i = 0; i < io_face.surfedge_count; ++i) {
    const std::int32_t edge = io_bsp.surfedges[io_face.first_surfedge + i];
    const auto& vertices = io_bsp.edges[static_cast<std::size_t>(std::abs(edge))].vertices;
    is_closed = is_closed && (edge >= 0 ? vertices[1] : vertices[0]) == starts[(i + 1) % starts.size()];
  }
  if (is_closed) return false;
  io_face.first_surfedge = static_cast<std::uint32_t>(io_bsp.surfedges.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    io_bsp.surfedges.push_back(static_cast<std::int32_t>(io_bsp.edges.size()));
    io_bsp.edges.push_back({{starts[i], starts[(i + 1) % starts.size()]}});
  }
  return true;
}

}  // namespace

std::uint32_t find_start(const Bsp& bsp, std::size_t surfedge) {
  const std::int32_t edge = bsp.surfedges[surfedge];
  const auto& vertices = bsp.edges[static_cast<std::size_t>(std::abs(edge))].vertices;
  return edge >= 0 ? vertices[0] : vertices[1];
}

// A face without area contains every point in the arithmetic of world/sample_light.h, which skips faces that
// are never lit.
void clear_faces(Bsp& io_bsp, const std::vector<bool>& is_cleared) {
  if (count_damaged(is_cleared) == 0) return;
  const auto edge = static_cast<std::int32_t>(io_bsp.edges.size());
  io_bsp.edges.emplace_back();  // from vertex 0 to vertex 0
  const auto texinfo = static_cast<std::uint32_t>(io_bsp.texinfos.size());
  io_bsp.texinfos.push_back(make_unlit_texinfo());
  if (io_bsp.miptexes.empty()) io_bsp.miptexes.emplace_back();
  for (std::size_t i = 0; i < is_cleared.size(); ++i) {
    if (!is_cleared[i]) continue;
    io_bsp.faces[i] = BspFace{};
    io_bsp.faces[i].texinfo = texinfo;
    io_bsp.faces[i].first_surfedge = static_cast<std::uint32_t>(io_bsp.surfedges.size());
    io_bsp.faces[i].surfedge_count = kMinEdges;
    io_bsp.surfedges.insert(io_bsp.surfedges.end(), kMinEdges, edge);
  }
}

std::size_t repair_faces(Bsp& io_bsp) {
  const Damage vertices = repair_vertices(io_bsp.vertices);
  const Damage edges = repair_edges(vertices, io_bsp.edges);
  const Damage surfedges = repair_surfedges(edges, io_bsp.surfedges);
  const Damage texinfos = repair_axes(io_bsp.texinfos);
  std::size_t changed = repair_textures(io_bsp);
  Damage faces = find_damaged_faces(texinfos, surfedges, io_bsp, changed);
  changed +=
      fit_ranges(io_bsp.faces, io_bsp.surfedges.size(), &BspFace::first_surfedge, &BspFace::surfedge_count);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (io_bsp.faces[i].surfedge_count < kMinEdges) faces[i] = true;
  clear_faces(io_bsp, faces);
  changed += count_damaged(faces);
  for (BspFace& face : io_bsp.faces) changed += close_outline(io_bsp, face);
  return changed;
}

}  // namespace temblor::formats::bsp_file
