// The outlines of a level's faces: what edge setup needs, computed once per level. Corners lie in memory in
// the order in which a frame reads them; BSP files would require a lookup through surfedges, edges, and
// vertices for each corner. Neighbors are also found here, so faces can be projected in any order and in
// parallel. (Stock Quake finds shared edges while it draws, by caching the last projection of each edge.)
#pragma once

#include <cstdint>
#include <vector>

#include "world/level.h"

namespace temblor::render {

// Lit faces are cut into tiles of at most this many texels of mip 0 in each direction, so that one mip level
// per tile suffices (Abrash, "Quake's Lighting Model: Surface Caching", gives the same limit for stock
// Quake).
constexpr int kTileTexels = 256;
// Numbers of tiles along s and t.
struct TileGrid {
  std::uint16_t s = 1, t = 1;
};
// Whether a face is drawn from surface blocks; if not, it is drawn from its texture. Faces without light
// samples have blocks too, since dynamic lights may reach them, unless they are wider than any compiler
// leaves them. Liquids have blocks only if they have light samples.
bool has_surface(const world::Face& face);
// 1 x 1 for faces without surface blocks.
TileGrid tile_grid(const world::Face& face);

// No other face shares the side.
constexpr world::FaceIndex kNoNeighbor{0xffffffff};

// A corner, and the side from it to the next corner.
struct OutlineCorner {
  math::Vec3 position;  // model space
  // The only other face at this side, which has the side in the opposite direction.
  world::FaceIndex neighbor;
};

struct FaceOutline {
  std::uint32_t first_corner, corner_count;
  TileGrid tiles;
};

struct FaceOutlines {
  std::vector<FaceOutline> faces;      // by FaceIndex
  std::vector<OutlineCorner> corners;  // in the order of their faces, clockwise seen from the front
};

// A side has a neighbor if exactly two different faces use its edge, once each and in opposite directions.
// Other sides are rare; each face gets an edge of its own for them.
FaceOutlines make_face_outlines(const world::Level& level);

}  // namespace temblor::render
