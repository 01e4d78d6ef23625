// The picture of one model whose inside is flooded from its outline and its vertices.
#pragma once

#include "lab/models/flood/outline.h"
#include "render/frame_buffer.h"

namespace temblor::lab {

// Pixels and depth are those of pixel (left, top) of the frame, and rows are `stride` apart. Where the model
// is not, depth is minus infinity.
struct FloodedPicture {
  int left = 0, top = 0, width = 0, height = 0;
  std::int64_t stride = 0;
  const void* pixels = nullptr;
  const float* depth = nullptr;
};

// The picture encloses all vertices of front triangles. Empty if there are none. It lives in `arena`;
// `scratch` is for temporary memory.
FloodedPicture flood_model(const render::TriangleJob& job, const MeshEdges& edges, render::PixelFormat format,
                           base::Arena& arena, base::Arena& scratch);

}  // namespace temblor::lab
