// Draws alias models. The CPU places and lights instances, by the stages of the CPU renderer; the graphics
// card blends poses, transforms vertices, and draws pixels. One draw call per instance.
//
//   place_alias, choose_light, light_normals -> uniforms         -> shaders -> target
//   ModelCache -> CardModel                  -> vertices, skins             or AliasLayer -> target
#pragma once

#include <cstdint>
#include <span>

#include "render/alias/light_alias.h"
#include "render/alias/place_alias.h"
#include "render/frame_stats.h"
#include "render_gl/gl/texel_blend.h"
#include "render_gl/models/alias_layer.h"
#include "render_gl/models/model_cache.h"
#include "render_gl/models/player_palettes.h"
#include "render_gl/world/world_pass.h"

namespace temblor::render_gl {

class AliasPass {
 public:
  static base::Result<AliasPass> make(const Functions& gl, const render::ColorTables& colors,
                                      render::PixelFormat format);

  // Draws the instances of the scene that are opaque, and the view weapon, after the opaque faces. Fails if
  // the card lacks memory for a model.
  base::Status draw_opaque(const Functions& gl, const FrameInput& input);
  // Draws a layer of the translucent order; nothing, unless it is a model or the view weapon. `io_target`
  // is the one that is drawn to. Fails like draw_opaque.
  base::Status draw_translucent(const Functions& gl, const FrameInput& input,
                                const render::TranslucentLayer& layer, Target& io_target);

  // Adds the counts of the last draw_opaque().
  void count(render::FrameStats& io_stats) const;

 private:
  // Locations of the shader's variables.
  struct Uniforms {
    GLint to_view, pose_blend, lights, projection, full_range;
    GLint skins, palettes, skin, palette, tint, fog_density, fog_color;
    GLint colormap, tints, tint_row;  // of indexed frames
  };

  AliasPass(const Functions& gl, Program program, PlayerPalettes palettes, AliasLayer layer);
  void set_program(const Functions& gl, Program program);
  base::Status set_blend(const Functions& gl, const FrameInput& input);
  void begin_draw(const Functions& gl, const FrameInput& input) const;
  void end_draw(const Functions& gl) const;
  base::Status draw(const Functions& gl, const FrameInput& input, const render::AliasPlacement& placement,
                    const CardModel& model) const;
  void set_vertex_uniforms(const Functions& gl, const FrameInput& input,
                           const render::AliasPlacement& placement) const;
  base::Status set_light(const Functions& gl, const FrameInput& input,
                         const render::AliasPlacement& placement) const;
  base::Status set_light_tables(const Functions& gl, const FrameInput& input,
                                const render::AliasLight& light) const;

  Program program_;
  TexelBlend blend_;  // of the program
  Uniforms uniforms_;
  IndexUniforms index_;
  PlayerPalettes palettes_;
  AliasLayer layer_;
  ModelCache models_;
  std::uint32_t instances_drawn_ = 0, triangles_drawn_ = 0;
};

}  // namespace temblor::render_gl
