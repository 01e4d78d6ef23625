// Makes the record of a tile, from which the shaders draw it (tile_table.h): it shows a surface block or a
// texture.
#pragma once

#include <optional>

#include "render_gl/surfaces/block_atlas.h"
#include "render_gl/surfaces/tile_table.h"
#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

// A surface block is known by its address, until the CPU builds another one there.
AtlasKey block_key(const render::SurfaceBlock& block);

// Brings the images of a draw (a number in SurfaceBlocks::draws, not hidden) to the atlas. The record is
// opaque. Nothing if the atlas' portion is full.
std::optional<TileRecord> place_tile(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                     BlockAtlas& io_atlas);

// Makes a record that of a face with this opacity.
void set_opacity(const render::FrameContext& context, const render::FaceOpacity& opacity,
                 TileRecord& io_record);

}  // namespace temblor::render_gl
