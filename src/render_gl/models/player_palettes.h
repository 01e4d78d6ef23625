// The colors of palette indices as models show them: the game's palette, and a copy of it for each pair of a
// player's shirt and pants colors. All are rows of one texture that never changes.
#pragma once

#include <optional>

#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

class PlayerPalettes {
 public:
  static base::Result<PlayerPalettes> make(const Functions& gl, const render::ColorTables& colors,
                                           render::PixelFormat format);

  // The row with these colors; none: the game's palette.
  static int row(const std::optional<render::PlayerColors>& colors);
  // 256 texels per row, as ColorTables::surface_rgb has them: alpha is 0 for full-bright colors. Indexed:
  // the indices that show instead of those of the skin.
  GLuint texture() const { return texture_.name(); }

 private:
  explicit PlayerPalettes(Texture texture) : texture_(std::move(texture)) {}
  Texture texture_;
};

}  // namespace temblor::render_gl
