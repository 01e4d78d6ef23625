// Surface blocks that the card builds (WorldMethod::kCardBlocks): it draws a tile's texture times its grid of
// light into a rectangle of the atlas, where the block stays as those of the CPU do. Blocks are known by all
// that determines their texels, so a surface is drawn once, and again when its light changes.
//
//   texture (TextureArrays) x light (LightGrids) --> BlockAtlas --> the programs of blocks
//
// Tiles with marks have the CPU's blocks, as with WorldMethod::kLitTextures.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render_gl/built/atlas_painter.h"
#include "render_gl/lit/grid_method.h"

namespace temblor::render_gl {

class CardBlocks final : public GridMethod {
 public:
  // Fails if the card cannot draw into the atlas, or does not accept the shaders.
  static base::Result<std::unique_ptr<LitMethod>> make(const Functions& gl, const BlockAtlas& atlas);

  bool has_lit_faces() const override { return false; }
  // The record of a lit tile, whose block is in the atlas after end_portion(). Nothing if the portion of the
  // atlas or of the light is full.
  std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                  BlockAtlas& io_atlas) override;
  // Draws the blocks that place() did not find. If there are any, another framebuffer and viewport are bound
  // then.
  void end_portion(const Functions& gl, const FrameInput& input, const BlockAtlas& atlas) override;

 private:
  // One block to draw. The layout from `lit` on is that of the shader.
  struct Job {
    std::uint16_t layer, array;        // of the atlas; of the texture
    std::array<std::uint32_t, 4> lit;  // the first four numbers of the tile's record of kLit
    std::uint32_t mapping;             // the record's bits in scale_t
    std::uint32_t place, size;         // in the atlas: x | y << 16, width | height << 16
  };

  CardBlocks(LightGrids light, Program program, AtlasPainter painter);
  void bind(const Functions& gl, const BlockAtlas& atlas) const;

  Program program_;
  AtlasPainter painter_;
  std::vector<Job> jobs_;
};

}  // namespace temblor::render_gl
