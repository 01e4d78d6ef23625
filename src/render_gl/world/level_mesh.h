// The faces of a level as vertices on the graphics card, made once for each level. A frame draws those that
// it chooses by their numbers: every face is a fan of triangles around its first corner.
#pragma once

#include <cstdint>
#include <vector>

#include "render/edges/face_outlines.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

class LevelMesh {
 public:
  LevelMesh() = default;  // no level
  // `outlines` must be those of the level.
  static base::Result<LevelMesh> make(const Functions& gl, const world::Level& level,
                                      const render::FaceOutlines& outlines);

  // The number of a face's first tile in the TileTable; its other tiles follow, row by row.
  std::uint32_t first_tile(world::FaceIndex face) const { return first_tile_[base::to_size(face)]; }
  // The tiles of all faces, or of those of a brush model.
  std::uint32_t tile_count() const { return first_tile_.back(); }
  std::uint32_t tile_count(const world::Model& model) const {
    return first_tile_[model.first_face + model.face_count] - first_tile_[model.first_face];
  }
  // Appends the vertices of a face's triangles.
  static void add_triangles(const render::FaceOutline& outline, std::vector<std::uint32_t>& io_indices);

  // The vertices' layout: position (location 0), texel from the face's first one (1), first tile, and columns
  // | rows << 16 of tiles (2).
  GLuint vertex_array() const { return vertex_array_.name(); }

 private:
  Buffer vertices_;
  VertexArray vertex_array_;
  std::vector<std::uint32_t> first_tile_;  // by face; one more at the end
};

}  // namespace temblor::render_gl
