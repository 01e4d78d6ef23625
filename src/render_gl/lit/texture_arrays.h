// The level's textures on the card, unlit, with all of their mip levels: one array texture for each size, so
// that faces with different textures are drawn by one call. They stay there until the level changes.
//
// Textures that the CPU must compose with are not among them: those with holes, glow, waves, and those that
// are larger than the card's textures.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/color/color_tables.h"
#include "render_gl/draw_options.h"
#include "render_gl/gl/objects.h"
#include "world/level.h"

namespace temblor::render_gl {

class TextureArrays {
 public:
  TextureArrays() = default;  // no textures
  // Fails if the card lacks the memory.
  static base::Result<TextureArrays> make(const Functions& gl, const world::Level& level,
                                          const render::ColorTables& colors);

  // Where a texture is. The array's level 0 is the texture's mip `finest_mip`.
  struct Place {
    std::uint16_t array = 0, layer = 0;
    std::int8_t finest_mip = 0, levels = 1;
    bool has_bright = false;  // some texels are full-bright
  };
  // Nothing if the texture is not here.
  std::optional<Place> find(world::TextureIndex texture) const;

  // How shaders' texture() blends texels from now on; texelFetch() does not change.
  void set_filter(const Functions& gl, render::TextureFilter filter);
  GLuint texture(std::uint16_t array) const { return arrays_[array].texture.name(); }
  // Memory of the card.
  std::size_t bytes() const { return bytes_; }

 private:
  struct Array {
    Texture texture;
    int width, height, finest_mip, levels, layers;
  };
  // Room for a texture, in an array of its size.
  std::optional<Place> add(const world::Texture& texture, int max_side, int max_layers);
  base::Status allocate(const Functions& gl);

  std::vector<Array> arrays_;
  std::vector<std::optional<Place>> places_;  // by texture
  std::size_t bytes_ = 0;
};

}  // namespace temblor::render_gl
