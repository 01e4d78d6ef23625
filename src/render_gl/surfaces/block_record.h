// The records of tiles that show an image of the atlas.
#pragma once

#include <cstdint>

#include "render_gl/surfaces/block_atlas.h"
#include "render_gl/surfaces/tile_table.h"

namespace temblor::render_gl {

// Where an image is, and how a tile gets texels from it, without holes and opaque.
void set_image(TileKind kind, const StoredImage& image, TileRecord& out_record);

// A face's block before it is stored: texels of its mip level, and the tile's place in the face.
struct TileBlock {
  render::SurfaceShape shape;
  std::int32_t mip;
  std::uint32_t tile_s, tile_t;
};
TileRecord make_block_record(const StoredImage& stored, const TileBlock& block);

}  // namespace temblor::render_gl
