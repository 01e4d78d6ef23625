// Shader parts for light at vertices (vertex_method.h).
#pragma once

namespace temblor::render_gl {

// For vertex shaders, which call light_vertex(). Follows kLightScalePart.
inline constexpr const char* kLightVertexPart = R"(
#define VERTEX_LIGHT
uniform sampler2D vertex_lights;
uniform uint first_light;  // of the model's corners, less that of the level's

out vec3 vertex_light;

void light_vertex() {
  uint number = uint(gl_VertexID) + first_light;
  vertex_light = texelFetch(vertex_lights, ivec2(number % 1024u, number / 1024u), 0).rgb * kLightScale;
}
)";

// For fragment shaders, in place of kGridLightPart.
inline constexpr const char* kVertexLightPart = R"(
in vec3 vertex_light;

vec3 find_light(LitTile tile, vec2 texel) { return vertex_light; }
)";

}  // namespace temblor::render_gl
