// The passes in which faces with textures and light are drawn over one another, as cards with one texture at
// a time had to: Abrash's "two-pass lighting" ("Surface Caching Revisited", with more passes for what comes
// on top), and GLQuake's way.
//
//   kLightPass   texture                        the texels, with depth
//                x light                        the picture times two times half of the light
//                = full-bright texels           where a texture has some
//                + fog                          where there is fog
//
//   kLightPolygons   light, half of it          with depth
//                    + polygons of lights       (polygon_method.h)
//                    x texture                  the picture times two times the texels
//                    = and + as above
//
// The picture keeps 8 bits between passes, where one pass rounds once: half of the light is rounded to 255
// steps, so the product is off by up to 1; the card multiplies it twice and adds (2 x picture x light), and
// each product may be off by a half. So channels of 255 differ by up to 2 from one pass, and fog adds a half.
//
// Faces with the same depth at a pixel, to the last bit, would be lit twice; levels have no such faces, but
// two instances of a brush model at one place do.
//
// Translucent faces are drawn in one pass: the picture below them would be lit, too. Tiles with marks have
// the CPU's blocks, as in all methods: marks are blended over texels before light, so they would be a pass
// between the two, with an image of its own for each marked tile.
#pragma once

#include <cstdint>
#include <span>

#include "render_gl/draw_options.h"
#include "render_gl/gl/functions.h"

namespace temblor::render_gl {

// The part of each pixel that a pass draws.
enum class LitPassKind : std::uint8_t {
  kWhole,    // the texel times its light, with fog
  kTexture,  // the texel
  kLight,    // half of the light, so that light up to twice the texel's color fits
  kBright,   // the full-bright texels; others are left out
  kFog,      // the fog, with its share as alpha
  kPolygons  // lights, as LitMethod::draw_polygons() draws them
};
constexpr std::size_t kLitPassKinds = 6;

// A pass, and how it is combined with the picture. The first one writes depth, also for faces without light,
// and later ones draw where depth is equal, or not hidden, as polygons are nearer than their faces.
struct LitPass {
  LitPassKind kind = LitPassKind::kWhole;
  bool is_first = true;
  GLenum source_factor = GL_ONE, target_factor = GL_ZERO;
};

// The passes of a method's opaque faces, in order. Those of blocks have one.
std::span<const LitPass> find_lit_passes(WorldMethod method);

// Begins a pass. After the last one, opaque faces can be drawn again when end_lit_passes() was called.
void begin_lit_pass(const Functions& gl, const LitPass& pass);
void end_lit_passes(const Functions& gl);

}  // namespace temblor::render_gl
