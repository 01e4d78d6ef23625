// How the card draws the level: the player's filter, and methods that the laboratory compares.
#pragma once

#include <cstdint>

#include "render/view/frame_context.h"

namespace temblor::render_gl {

// How lit faces get their texels. Faces that only the CPU can compose (with marks, holes, glow, or waves)
// have blocks in every method.
enum class WorldMethod : std::uint8_t {
  kBlocks,          // the CPU lights surface blocks, as in VQuake
  kExpandedBlocks,  // the same in 256 colors, which the card expands (built/expanded_blocks.h)
  kLitTextures,     // each pixel is a texel times its light: two textures in one pass
  kCardBlocks,      // the card draws that product into surface blocks, and keeps them as those of the CPU
  kLightPass,       // the texture, and then its light over the picture, as in GLQuake (passes/lit_passes.h)
  kLightPolygons,   // the same in another order, with polygons for dynamic lights (passes/polygon_method.h)
  kGouraud,         // light at vertices (vertex_light/vertex_method.h)
  kStyleLayers      // the shader adds light maps and dynamic lights (styles/style_method.h)
};

// The programs of the level's faces depend on this. Blending filters need kLitTextures; blocks, and textures
// without light, are blended between four texels in all of them.
struct DrawOptions {
  WorldMethod method = WorldMethod::kBlocks;
  render::TextureFilter filter = render::TextureFilter::kNearest;
  bool sharp_texels = false;  // false if nothing is blended
  bool operator==(const DrawOptions&) const = default;
};

// The format of the surface blocks that the CPU builds for a frame.
render::PixelFormat find_block_format(const DrawOptions& options, const render::FrameContext& context);

// `method` is for frames whose texels are not blended. Palette indices never are, and they are lit by the
// CPU.
DrawOptions choose_options(WorldMethod method, const render::FrameContext& context);

}  // namespace temblor::render_gl
