// Pictures of sprites on the graphics card, one texture for each. They are uploaded when they are first
// drawn, and stay as long as there is room.
//
// Pictures have no identity, and another one may have the memory of one that is gone. So their texels are
// compared with a copy of those that were uploaded: that costs less than an upload.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "formats/models/spr.h"
#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

class PictureTextures {
 public:
  // For frames of this format.
  explicit PictureTextures(render::PixelFormat format) : format_(format) {}

  // Drops all textures if they have become too large together. Textures live until the next call.
  void begin_frame();
  // Drops all textures.
  void clear();

  // A picture on the card, and its texels for each one of the picture along s and t: less than 1 if it is
  // larger than the card's textures.
  struct Found {
    GLuint texture;
    double scale_s, scale_t;
  };
  // The texture of the picture: colors in the order of the CPU's pictures, and alpha 0 where it is clear;
  // or indices, as they are.
  // Fails if the card lacks memory.
  base::Result<Found> find(const Functions& gl, const formats::SprPicture& picture,
                           const render::ColorTables& colors);

 private:
  struct Entry {
    Texture texture;
    double scale_s = 1, scale_t = 1;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> texels;
  };
  render::PixelFormat format_;
  // By the address of the texels.
  std::unordered_map<const std::uint8_t*, Entry> entries_;
  std::size_t texel_count_ = 0;
};

}  // namespace temblor::render_gl
