// The tiles that a frame shows without surface blocks: a texture times its light (WorldMethod::kLitTextures).
#pragma once

#include <optional>
#include <vector>

#include "render/surfaces/surface_draws.h"
#include "render_gl/lit/light_grids.h"
#include "render_gl/lit/texture_arrays.h"
#include "render_gl/surfaces/tile_table.h"

namespace temblor::render_gl {

// The card's textures and light, and the frame's lit tiles.
class LitTiles {
 public:
  // Fails if the card lacks the memory.
  static base::Result<LitTiles> make(const Functions& gl);

  // Brings the level's textures to the card. Fails if the card lacks the memory.
  base::Status set_level(const Functions& gl, const world::Level& level, const render::ColorTables& colors);
  void set_filter(const Functions& gl, render::TextureFilter filter);

  // Takes the tiles that need no block out of the frame's requests, which must live as long as the frame.
  void take(const world::Level& level, render::SurfaceRequests& io_requests);
  // Uploads all light again.
  void clear_light() { light_.clear(); }
  void begin_portion() { light_.begin_portion(); }

  // Whether a draw (a number in SurfaceDraws) is one of the frame's lit tiles.
  bool contains(std::uint32_t draw) const { return draw < by_draw_.size() && by_draw_[draw] != nullptr; }
  // The request that take() found for a lit tile.
  const render::BlockRequest& request(std::uint32_t draw) const { return *by_draw_[draw]; }
  // The array that has its texture.
  std::uint16_t array(std::uint32_t draw) const;
  // The record of a lit tile, with its light on the card. Nothing if the portion is full.
  std::optional<TileRecord> place(const Functions& gl, const world::Level& level, std::uint32_t draw);

  GLuint array_texture(std::uint16_t array) const { return textures_.texture(array); }
  GLuint light_texture() const { return light_.texture(); }
  // The memory of the card, and how the last frame used that of light.
  std::size_t bytes() const { return textures_.bytes() + light_.bytes(); }
  const CacheCounts& light_counts() const { return light_.counts(); }

 private:
  explicit LitTiles(LightGrids light) : light_(std::move(light)) {}

  TextureArrays textures_;
  LightGrids light_;
  std::vector<const render::BlockRequest*> by_draw_;
};

}  // namespace temblor::render_gl
