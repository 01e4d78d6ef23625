// The scene's skybox on the graphics card: the six sides that the CPU has prepared, with their borders, as
// the layers of one array texture.
#pragma once

#include <cstdint>

#include "render/spans/span_sources.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

class SkyboxTexture {
 public:
  // All frames have one format. Uploads the skybox of the frame unless it is the one that is there, smaller
  // if the card's textures are smaller. Does nothing without a skybox. Fails if the card lacks memory.
  base::Status update(const Functions& gl, const render::SpanSources& sources);

  // Texels (size + 2) squared, in the order of SkyboxSpans. 0 before the first skybox.
  GLuint texture() const { return texture_.name(); }

 private:
  Texture texture_;
  std::int32_t size_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace temblor::render_gl
