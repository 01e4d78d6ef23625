// A level's light maps on the card, as they are stored: one grid of samples for each style of a face. They
// are uploaded once, and shaders add the styles.
//
//   samples   a texture, row by row: the samples in the order of Level::light, blue, green, red, and gray
//   faces     a texture, kFacesPerRow faces in a row, five texels for each (style_shaders.h):
//
//     number of the first sample | samples per row, rows | the four styles, a byte each | their count
//     normal, distance        the plane in model space
//     s axis, offset          texels from the face's first one
//     t axis, offset
//     units per texel along s and t, on the plane | 0 | 0
#pragma once

#include <cstddef>

#include "render_gl/gl/objects.h"
#include "world/level.h"

namespace temblor::render_gl {

class StyleSamples {
 public:
  StyleSamples() = default;  // no level
  // Fails if the card lacks the memory.
  static base::Result<StyleSamples> make(const Functions& gl, const world::Level& level);

  // Whether the face's light is here: light maps that are not stock are not, and those beyond the size of the
  // card's textures.
  bool contains(const world::Face& face, std::size_t number) const;
  GLuint sample_texture() const { return samples_.name(); }
  GLuint face_texture() const { return faces_.name(); }
  // The memory of the card, all of which was uploaded when it was made.
  std::size_t bytes() const { return bytes_; }

 private:
  base::Status upload_samples(const Functions& gl, const world::Level& level);
  base::Status upload_faces(const Functions& gl, const world::Level& level);

  Texture samples_, faces_;
  std::size_t sample_count_ = 0, face_count_ = 0, bytes_ = 0;
};

}  // namespace temblor::render_gl
