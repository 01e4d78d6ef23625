// The light of visible tiles on the card: samples every 16 texels, between which the card interpolates. The
// CPU sums a tile's styles and dynamic lights (render/surfaces/light), as for its own surface blocks, but
// uploads a number of samples that is 256 times smaller than that of texels.
//
// Grids are known by everything that determines them. So they are valid for all mip levels, and as long as
// the light stays the same.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/arena.h"
#include "render/surfaces/build_surface.h"
#include "render_gl/surfaces/block_atlas.h"

namespace temblor::render_gl {

class LightGrids {
 public:
  // Fails if the card lacks the memory.
  static base::Result<LightGrids> make(const Functions& gl);

  void begin_frame() { atlas_.begin_frame(); }
  void begin_portion() { atlas_.begin_portion(); }
  void clear() { atlas_.clear(); }

  struct Grid {
    AtlasPlace place;
    int texels_power;  // the samples are 2^texels_power texels of the request's mip level apart
  };
  // Identifies the light of a tile: tiles with the same key have the same samples.
  static AtlasKey find_key(const world::Level& level, const render::BlockRequest& request);
  // The light of a tile, after uploading it if it is missing. Nothing if the portion is full.
  std::optional<Grid> place(const Functions& gl, const world::Level& level,
                            const render::BlockRequest& request);

  // Samples are blue, green, red from 0 to 1, which stands for nearly twice a texel's color (lit_shaders.h).
  // They are read with linear interpolation, from their centers.
  GLuint texture() const { return atlas_.texture(); }
  // The memory of the card, and counts of the last frame.
  std::size_t bytes() const { return atlas_.bytes(); }
  const CacheCounts& counts() const { return atlas_.counts(); }

 private:
  explicit LightGrids(BlockAtlas atlas) : atlas_(std::move(atlas)) {}

  BlockAtlas atlas_;
  base::Arena scratch_;
  std::vector<std::uint32_t> packed_;  // scratch
};

}  // namespace temblor::render_gl
