// The tiles that a frame shows without surface blocks, and their textures (lit_method.h).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "render/surfaces/surface_draws.h"
#include "render_gl/lit/texture_arrays.h"
#include "render_gl/surfaces/tile_table.h"

namespace temblor::render_gl {

class LitTiles {
 public:
  // Brings the level's textures to the card. Fails if the card lacks the memory.
  base::Status set_level(const Functions& gl, const world::Level& level, const render::ColorTables& colors);
  void set_filter(const Functions& gl, render::TextureFilter filter);

  // Takes the tiles that need no block out of the frame's requests, which must live as long as the frame:
  // those whose texture is here, and whose light the card can have. Returns their requests, by draw.
  using CanLight = std::function<bool(const render::BlockRequest& request)>;
  std::span<render::BlockRequest> take(const world::Level& level, const CanLight& can_light,
                                       render::SurfaceRequests& io_requests);

  // Whether a draw (a number in SurfaceDraws) is one of the frame's lit tiles.
  bool contains(std::uint32_t draw) const { return draw < by_draw_.size() && by_draw_[draw] != nullptr; }
  // The request that take() found for a lit tile.
  const render::BlockRequest& request(std::uint32_t draw) const { return *by_draw_[draw]; }
  // The array that has its texture, and whether some of its texels are full-bright.
  std::uint16_t array(std::uint32_t draw) const { return place(draw).array; }
  bool has_bright(std::uint32_t draw) const { return place(draw).has_bright; }
  // The record of a lit tile, without the place of its light. `texels_power`: its samples of light are
  // 2^texels_power texels of its mip level apart.
  TileRecord make_record(const world::Level& level, std::uint32_t draw, int texels_power) const;

  GLuint array_texture(std::uint16_t array) const { return textures_.texture(array); }
  // The memory of the card.
  std::size_t bytes() const { return textures_.bytes(); }

 private:
  bool has_texture(const world::Level& level, const render::BlockRequest& request) const;
  TextureArrays::Place place(std::uint32_t draw) const {
    return *textures_.find(by_draw_[draw]->contents.texture);
  }

  TextureArrays textures_;
  std::vector<const render::BlockRequest*> by_draw_;
};

}  // namespace temblor::render_gl
