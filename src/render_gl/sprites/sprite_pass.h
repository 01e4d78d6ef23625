// Draws sprites where the CPU's quads are (render/sprites/sprite_quad.h). All corners of a frame's sprites
// are one buffer; neighbors in the scene's order with the same picture are one draw call.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render_gl/frame/screen_space.h"
#include "render_gl/gl/texel_blend.h"
#include "render_gl/sprites/picture_textures.h"
#include "render_gl/world/world_pass.h"

namespace temblor::render_gl {

class SpritePass {
 public:
  static base::Result<SpritePass> make(const Functions& gl, render::PixelFormat format);

  // Brings the frame's pictures and corners to the graphics card. Fails if the card lacks memory.
  base::Status prepare(const Functions& gl, const FrameInput& input);
  // Draws the opaque sprites, with depth. prepare() comes first.
  void draw_opaque(const Functions& gl, const FrameInput& input) const;
  // Blends translucent sprite number `sprite` (TranslucentOrder::sprites) into the picture, tested against
  // depth. `io_target` is the one that is drawn to. Fails if the card lacks memory.
  base::Status draw_translucent(const Functions& gl, const FrameInput& input, std::uint32_t sprite,
                                Target& io_target) const;

 private:
  // The layout is that of the shader.
  struct Corner {
    float x, y, origin_x, origin_y;
    float depth[3], s[3], t[3];
    float opacity, affine;
  };
  // Corners of triangles with one texture.
  struct Batch {
    GLuint texture;
    std::size_t first, count;
  };

  // The second program is for translucent sprites of indexed frames.
  struct Programs {
    ScreenProgram program;
    std::optional<ScreenProgram> blended;
  };
  static base::Result<Programs> make_programs(const Functions& gl, render::PixelFormat format,
                                              const TexelBlend& blend);
  SpritePass(const Functions& gl, Programs programs, render::PixelFormat format);
  void add_corners(const render::SpriteQuad& quad, const PictureTextures::Found& found,
                   const render::ViewFrame& view);
  base::Result<Batch> add_sprite(const Functions& gl, const FrameInput& input,
                                 const render::SpriteQuad& quad);
  void begin_draw(const Functions& gl, const FrameInput& input, const ScreenProgram& program) const;
  void draw_batch(const Functions& gl, const Batch& batch) const;

  Programs programs_;
  TexelBlend blend_;  // of the programs
  VertexArray vertex_array_;
  Buffer buffer_;
  PictureTextures textures_;
  std::shared_ptr<const world::LevelIdentity> level_;
  std::vector<Corner> corners_;
  std::vector<Batch> opaque_, translucent_;
};

}  // namespace temblor::render_gl
