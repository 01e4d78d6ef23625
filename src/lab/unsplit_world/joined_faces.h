// The faces that a compiler made from one face: it cuts faces at the planes of the BSP tree, and where their
// light maps would be too large. Parts have the same plane and the same texture at every point of it. Other
// faces in the plane that fit count as parts, too, because it makes no difference whether parts touch.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/edges/edge_table.h"

namespace temblor::lab {

// By face: the first face with the same plane and texture.
std::vector<world::FaceIndex> find_first_parts(const world::Level& level);

// An edge table with one surface for all parts of a face of the world. Pieces of brush models stay as they
// are.
struct JoinedTable {
  render::EdgeTable table;                         // without the edges between parts
  std::span<const render::SurfaceIndex> surfaces;  // by SurfaceIndex: the surface that stands for it
  std::span<const std::uint32_t> part_counts;      // by SurfaceIndex: 0 if another surface stands for it
  std::size_t edges_saved = 0;
};

// `first_parts` are those of the scene's level, or empty. The result lives in the frame's arena.
JoinedTable join_parts(const render::FrameContext& context, const render::EdgeTable& table,
                       std::span<const world::FaceIndex> first_parts);

}  // namespace temblor::lab
