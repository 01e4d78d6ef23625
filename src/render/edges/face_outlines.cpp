#include "render/edges/face_outlines.h"

#include <algorithm>
#include <span>

namespace temblor::render {

namespace {

// The faces that use an edge of the level: those that run along it from start to end, and those that run
// back.
struct EdgeUsers {
  std::uint32_t forward_count = 0, backward_count = 0;
  world::FaceIndex forward{}, backward{};  // the last ones
};

std::span<const std::int32_t> face_surfedges(const world::Level& level, const world::Face& face) {
  return std::span(level.surfedges).subspan(face.first_surfedge, face.surfedge_count);
}

std::size_t edge_index(std::int32_t surfedge) {
  return static_cast<std::size_t>(surfedge < 0 ? -surfedge : surfedge);
}

std::vector<EdgeUsers> find_users(const world::Level& level) {
  std::vector<EdgeUsers> users(level.edges.size());
  for (std::size_t i = 0; i < level.faces.size(); ++i)
    for (const std::int32_t surfedge : face_surfedges(level, level.faces[i])) {
      EdgeUsers& edge = users[edge_index(surfedge)];
      ++(surfedge < 0 ? edge.backward_count : edge.forward_count);
      (surfedge < 0 ? edge.backward : edge.forward) = base::to_index<world::FaceIndex>(i);
    }
  return users;
}

world::FaceIndex neighbor_at(const EdgeUsers& users, bool backward) {
  const bool between_two =
      users.forward_count == 1 && users.backward_count == 1 && users.forward != users.backward;
  if (!between_two) return kNoNeighbor;
  return backward ? users.forward : users.backward;
}

}  // namespace

bool has_surface(const world::Face& face) {
  // Light samples bound the large faces by the size of the file. Those without samples have no such bound.
  if (face.kind == world::FaceKind::kLiquid) return face.light != world::kNoLight;
  return face.kind == world::FaceKind::kLit && (face.light != world::kNoLight || !face.is_large());
}

TileGrid tile_grid(const world::Face& face) {
  if (!has_surface(face)) return {};
  const auto across = [](std::int32_t extent) {
    return static_cast<std::uint16_t>(std::max(1, (extent + kTileTexels - 1) / kTileTexels));
  };
  return {across(face.texture_extents[0]), across(face.texture_extents[1])};
}

FaceOutlines make_face_outlines(const world::Level& level) {
  const std::vector<EdgeUsers> users = find_users(level);
  FaceOutlines outlines;
  outlines.faces.reserve(level.faces.size());
  outlines.corners.reserve(level.surfedges.size());
  for (const world::Face& face : level.faces) {
    outlines.faces.push_back(
        {static_cast<std::uint32_t>(outlines.corners.size()), face.surfedge_count, tile_grid(face)});
    for (std::uint32_t i = face.first_surfedge; i < face.first_surfedge + face.surfedge_count; ++i)
      outlines.corners.push_back(
          {level.vertices[level.surfedge_start(i)],
           neighbor_at(users[edge_index(level.surfedges[i])], level.surfedges[i] < 0)});
  }
  return outlines;
}

}  // namespace temblor::render
