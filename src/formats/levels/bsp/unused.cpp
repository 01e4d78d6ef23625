#include "formats/levels/bsp/unused.h"

#include <algorithm>
#include <cstdlib>

namespace temblor::formats::bsp_file {
namespace {

constexpr BspPlane kSomePlane{{1, 0, 0}, 0, 0};

bool is_plane_used(const Bsp& bsp, std::size_t plane) {
  const auto uses = [&](const auto& record) { return record.plane == plane; };
  return std::ranges::any_of(bsp.faces, uses) || std::ranges::any_of(bsp.nodes, uses) ||
         std::ranges::any_of(bsp.clipnodes, uses);
}

bool is_vertex_used(const Bsp& bsp, std::size_t vertex) {
  return std::ranges::any_of(bsp.edges, [&](const BspEdge& edge) {
    return edge.vertices[0] == vertex || edge.vertices[1] == vertex;
  });
}

bool is_edge_used(const Bsp& bsp, std::size_t edge) {
  return std::ranges::any_of(bsp.surfedges, [&](std::int32_t surfedge) {
    return std::abs(std::int64_t{surfedge}) == static_cast<std::int64_t>(edge);
  });
}

bool is_surfedge_used(const Bsp& bsp, std::size_t surfedge) {
  return std::ranges::any_of(bsp.faces, [&](const BspFace& face) {
    return surfedge >= face.first_surfedge && surfedge - face.first_surfedge < face.surfedge_count;
  });
}

bool is_texinfo_used(const Bsp& bsp, std::size_t texinfo) {
  return std::ranges::any_of(bsp.faces, [&](const BspFace& face) { return face.texinfo == texinfo; });
}

}  // namespace

bool reset_if_unused(Bsp& io_bsp, BspLump lump, std::size_t record) {
  switch (lump) {
    case BspLump::kPlanes:
      if (is_plane_used(io_bsp, record)) return false;
      io_bsp.planes[record] = kSomePlane;
      return true;
    case BspLump::kVertices:
      if (is_vertex_used(io_bsp, record)) return false;
      io_bsp.vertices[record] = math::Vec3(0.0f);
      return true;
    case BspLump::kTexinfo:
      // Without textures, no texinfo can be valid.
      if (is_texinfo_used(io_bsp, record) || io_bsp.miptexes.empty()) return false;
      io_bsp.texinfos[record] = BspTexinfo{};
      io_bsp.texinfos[record].miptex = 0;
      return true;
    case BspLump::kEdges:
      if (is_edge_used(io_bsp, record) || io_bsp.vertices.empty()) return false;
      io_bsp.edges[record] = BspEdge{};
      return true;
    case BspLump::kSurfedges:
      if (is_surfedge_used(io_bsp, record) || io_bsp.edges.empty()) return false;
      io_bsp.surfedges[record] = 0;
      return true;
    default:
      return false;
  }
}

}  // namespace temblor::formats::bsp_file
