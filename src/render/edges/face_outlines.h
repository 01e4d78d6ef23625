// What edge set-up asks of a level's faces, worked out once: everything about an outline in one place, so
// that a frame reads it in a row and not through surfedges, edges and vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "world/level.h"

namespace temblor::render {

// Lit faces are cut into surfaces of at most this many texels (of mip 0) each way.
constexpr int kTileTexels = 256;
struct TileGrid {
  std::uint16_t s = 1, t = 1;
};
// Whether a face is drawn from a surface of its own; if not, from its texture. Faces without light samples
// have surfaces too, for dynamic lights to fall on, unless they are wider than any compiler leaves them.
bool has_surface(const world::Face& face);
TileGrid tile_grid(const world::Face& face);

constexpr world::FaceIndex kNoNeighbor{0xffffffff};

// A corner, and the side that runs from it to the next one.
struct OutlineCorner {
  math::Vec3 position;        // model space
  world::FaceIndex neighbor;  // the only other face at this side, which walks it the other way
};

struct FaceOutline {
  std::uint32_t first_corner, corner_count;
  TileGrid tiles;
};

struct FaceOutlines {
  std::vector<FaceOutline> faces;      // by FaceIndex
  std::vector<OutlineCorner> corners;  // in the order of their faces, clockwise seen from the front
};

// A side has a neighbor when two different faces use its edge, once each and in opposite directions. Levels
// hold few others; those are not shared.
FaceOutlines make_face_outlines(const world::Level& level);

}  // namespace temblor::render
