// Surface blocks of palette indices that the card expands as it stores them (WorldMethod::kExpandedBlocks):
// "downloading 8-bpp surfaces and having the accelerator expand them to 16-bpp surfaces as it stores them in
// texture memory" (Abrash, "Surface Caching Revisited"). The CPU builds blocks as for pictures of 256 colors,
// and uploads a byte for each texel; the card draws their colors into the atlas.
//
//   block (indices) --upload--> staging --palette--> BlockAtlas --> the programs of blocks
//
// Everything without surface blocks has its own colors, as in other methods.
#pragma once

#include <cstdint>
#include <vector>

#include "render_gl/built/atlas_painter.h"
#include "render_gl/lit/lit_method.h"

namespace temblor::render_gl {

class ExpandedBlocks final : public LitMethod {
 public:
  // Fails if the card lacks the memory, cannot draw into the atlas, or does not accept the shaders.
  static base::Result<std::unique_ptr<LitMethod>> make(const Functions& gl, const BlockAtlas& atlas);

  bool has_lit_faces() const override { return false; }
  // Every block.
  bool has_tile(const FrameInput& input, std::uint32_t draw) const override;
  // Empties the staging texture, whose blocks the last portion has stored.
  void begin_portion() override;
  std::optional<TileRecord> place(const Functions& gl, const FrameInput& input, std::uint32_t draw,
                                  BlockAtlas& io_atlas) override;
  // If there are blocks to expand, another framebuffer and viewport are bound then.
  void end_portion(const Functions& gl, const FrameInput& input, const BlockAtlas& atlas) override;
  void clear_light() override { staging_.clear(); }
  // The uploads of indices.
  CacheCounts light_counts() const override;
  std::size_t bytes() const override { return staging_.bytes(); }

 protected:
  base::Status set_level(const Functions& gl, const render::FrameContext& context) override;
  void begin_frame() override { staging_.begin_frame(); }
  bool can_light(const world::Level&, const render::BlockRequest&) const override { return false; }

 private:
  // One block to expand. The layout from `staged` on is that of the shader.
  struct Job {
    std::uint32_t layer;                // of the atlas
    std::uint32_t staged, staged_size;  // x | y << 16, width | height << 16
    std::uint32_t staged_layer;         // | has holes << 16
    std::uint32_t place, size;          // in the atlas
  };

  ExpandedBlocks(Program program, AtlasPainter painter, Texture palette, BlockAtlas staging);

  Program program_;
  AtlasPainter painter_;
  Texture palette_;
  BlockAtlas staging_;
  std::vector<Job> jobs_;
};

}  // namespace temblor::render_gl
