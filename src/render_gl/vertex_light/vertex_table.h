// The light of the corners of faces, as a texture that vertex shaders read. Corners of the world keep their
// place in it, and only rows with changes are uploaded. Those of brush models, which may be drawn several
// times in a frame, get places after them for the frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render_gl/cache_options.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

class VertexTable {
 public:
  // Makes room for `count` corners, or for as many as the card's largest texture has: two millions at least.
  // Nothing is left of what was there, if there was less room before. Fails if the card lacks the memory.
  base::Status reserve(const Functions& gl, std::size_t count);
  // The corners that there is room for.
  std::size_t capacity() const { return texels_.size(); }
  // Sets the light of corners (pack_light). They must fit.
  void set(std::size_t first, std::span<const std::uint32_t> light);
  // Uploads the rows that have changed, and counts them.
  void upload(const Functions& gl, CacheCounts& io_counts);

  GLuint texture() const { return texture_.name(); }
  std::size_t bytes() const { return texels_.size() * sizeof(std::uint32_t); }

 private:
  Texture texture_;
  std::vector<std::uint32_t> texels_;
  std::vector<bool> row_changed_;
};

}  // namespace temblor::render_gl
