// The projection of vertices to the card's clip space, which the level and models share: depths of equal
// points must be equal.
#pragma once

namespace temblor::render_gl {

// Precedes a vertex shader. project(at) takes a point of view space: right, up, forward.
inline constexpr const char* kProjectionPart = R"(
uniform vec4 projection;  // scale of x and y; near plane; 1 for perspective, 0 for parallel projection
uniform bool full_range;  // depth of the clip space begins at -1, not at 0

// Units that depth covers in parallel projection.
const float kDepthRange = 262144.0;

bool is_perspective() { return projection.w > 0.5; }

vec4 project(vec3 at) {
  float w = is_perspective() ? at.z : 1.0;
  // Over w: 1 at the near plane, and less behind it.
  float depth = is_perspective() ? projection.z : 1.0 - (at.z - projection.z) / kDepthRange;
  return vec4(at.x * projection.x, -at.y * projection.y, full_range ? 2.0 * depth - w : depth, w);
}

// The same place in the picture, but nearer by a share of its distance; by a fixed number of units in parallel
// projection.
// Without glClipControl, depth is rounded to 2^-25 of its range wherever it is, which far away is more than the
// share.
vec4 project_nearer(vec3 at, float share) {
  vec4 place = project(is_perspective() ? at * (1.0 - share) : at - vec3(0, 0, share * 4096.0));
  if (full_range && share > 0.0) place.z += place.w / 4194304.0;
  return place;
}
)";

}  // namespace temblor::render_gl
