// The two looks of a frame, as shaders draw them: colors, or palette indices, which are kept as index / 255
// in the red channel of textures and pictures. Indices cannot be blended by the card, so shaders look up
// what two of them become in the CPU's tables (render/color/blend_tables.h), and likewise for fog.
#pragma once

#include <string>

#include "render/frame_buffer.h"

namespace temblor::render_gl {

// kBlendedIndices: of translucent things, over a copy of what was drawn before.
enum class ShaderLook { kColors, kIndices, kBlendedIndices };

constexpr ShaderLook find_look(render::PixelFormat format) {
  return format == render::PixelFormat::kIndexed ? ShaderLook::kIndices : ShaderLook::kColors;
}

// Functions for a fragment shader. Tables have a column for each index.
inline constexpr const char* kIndexPart = R"(
uniform sampler2D fog_table;  // rows: 64ths of fog

int to_index(float value) { return int(value * 255.0 + 0.5); }
float fog_index(float index, float share) {
  return texelFetch(fog_table, ivec2(to_index(index), int(share * 64.0 + 0.5)), 0).r;
}
#ifdef BLENDED
uniform sampler2D below;        // the picture
uniform sampler2D blend_table;  // rows: the index in front
uniform sampler2D dim_table;    // the same
uniform int dim_column;         // of dim_table; negative: the index in front is not dimmed

float blend_index(float over) {
  int front = to_index(over);
  if (dim_column >= 0) front = to_index(texelFetch(dim_table, ivec2(dim_column, front), 0).r);
  return texelFetch(blend_table, ivec2(to_index(texelFetch(below, ivec2(gl_FragCoord.xy), 0).r), front), 0).r;
}
#endif
)";

// Precedes the source of a fragment shader.
inline std::string look_part(ShaderLook look) {
  if (look == ShaderLook::kColors) return {};
  return std::string(look == ShaderLook::kBlendedIndices ? "#define BLENDED\n" : "") + "#define INDEXED\n" +
         kIndexPart;
}

}  // namespace temblor::render_gl
