// The beginning of every vertex shader of the level's faces: the vertices of LevelMesh, and the view.
#pragma once

namespace temblor::render_gl {

// Follows kProjectionPart. `records` is the texture of TileTable.
inline constexpr const char* kFaceVertexPart = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texel;
layout(location = 2) in uvec2 tiles;  // the first tile; columns | rows << 16

uniform usampler2D records;
uniform mat3 model_axes;    // columns: the model's axes in the world
uniform vec3 model_origin;
uniform uint first_record;  // of the model's tiles, less that of the world's tiles
uniform float nearer;       // share of the distance by which a brush model comes nearer
uniform vec3 eye;
uniform mat3 view_axes;     // from the world to right, up, forward

// From the eye, in the world's axes.
vec3 find_ray() { return model_axes * position + (model_origin - eye); }

// The texel of `records` with the first half of the record of the face's first tile; the second half follows.
ivec2 find_record() {
  uint number = tiles.x + first_record;
  return ivec2(number % 512u * 2u, number / 512u);
}
)";

}  // namespace temblor::render_gl
