// Draws a DrawList over the picture, in the order of its commands: menus, status bar, console. Its pixels are
// those of render/screen/draw_overlay.cpp, except for the rounding of colors that the card blends.
//
//   DrawList -> OverlayQuads (rectangles, colors), OverlayTextures (pictures) -> one draw call for each run
//   of commands with the same picture
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render_gl/frame/index_tables.h"
#include "render_gl/overlay/overlay_quads.h"
#include "render_gl/overlay/overlay_textures.h"

namespace temblor::render_gl {

class OverlayPass {
 public:
  static base::Result<OverlayPass> make(const Functions& gl, render::PixelFormat format);

  // Draws all commands, or none: then the result is false, since only the CPU can draw products, and details
  // of pictures, in indexed frames. Fails if the card lacks memory.
  base::Result<bool> draw(const Functions& gl, const render::DrawList& list,
                          const render::ColorTables& tables, IndexTables& io_index_tables, Target& io_target);

 private:
  struct OverlayProgram {
    OverlayProgram(const Functions& gl, Program program);
    Program program;
    GLint pixel_size, picture, colors, below, product;
    IndexUniforms index;
  };
  enum class Kind : std::uint8_t { kFill, kPicture, kDetail };
  // Commands that one draw call draws.
  struct Batch {
    std::size_t first, count;
    Kind kind;
    GLuint texture;                       // 0: fills
    const render::DrawCommand* combined;  // null: the card combines colors
  };

  OverlayPass(const Functions& gl, render::PixelFormat format);
  bool can_draw(const render::DrawCommand& command, const Target& target) const;
  // Takes commands until there is no room for their colors. Returns how many.
  base::Result<std::size_t> collect(const Functions& gl, std::span<const render::DrawCommand> commands,
                                    const render::ColorTables& tables, const Target& target);
  void add_batch(const Batch& batch);
  base::Status upload(const Functions& gl);
  base::Status draw_batch(const Functions& gl, const Batch& batch, const render::ColorTables& tables,
                          IndexTables& io_index_tables, Target& io_target) const;

  render::PixelFormat format_;
  // By Batch::combined, and kind. Indexed frames have none for details.
  std::array<std::array<std::optional<OverlayProgram>, 3>, 2> programs_;
  VertexArray vertex_array_;
  Buffer buffer_;
  Texture color_texture_;
  std::size_t color_rows_ = 0;
  std::vector<std::uint32_t> uploaded_colors_;
  OverlayTextures textures_;
  OverlayColors colors_;
  std::vector<OverlayQuad> quads_;
  std::vector<Batch> batches_;
};

}  // namespace temblor::render_gl
