#include "render_gl/world/level_mesh.h"

#include <cstddef>

namespace temblor::render_gl {

namespace {

struct Vertex {
  math::Vec3 position;  // model space
  float s, t;           // texels of mip 0 from the face's first texel
  std::uint32_t first_tile;
  std::uint32_t tile_grid;  // columns | rows << 16
};

std::vector<std::uint32_t> number_tiles(const render::FaceOutlines& outlines) {
  std::vector<std::uint32_t> first{0};
  for (const render::FaceOutline& outline : outlines.faces)
    first.push_back(first.back() + std::uint32_t{outline.tiles.s} * outline.tiles.t);
  return first;
}

// In double, since texture coordinates may be far from 0.
Vertex make_vertex(const world::Level& level, const world::Face& face, const math::Vec3& position) {
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const auto coordinate = [&](const math::Vec3& axis, float offset, std::int32_t first) {
    return static_cast<float>(glm::dot(math::Vec3d(axis), math::Vec3d(position)) + double{offset} - first);
  };
  return {position, coordinate(axes.s_axis, axes.s_offset, face.texture_mins[0]),
          coordinate(axes.t_axis, axes.t_offset, face.texture_mins[1]), 0, 0};
}

const void* at_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

}  // namespace

base::Result<LevelMesh> LevelMesh::make(const Functions& gl, const world::Level& level,
                                        const render::FaceOutlines& outlines) {
  LevelMesh mesh;
  mesh.first_tile_ = number_tiles(outlines);
  std::vector<Vertex> vertices;
  vertices.reserve(outlines.corners.size());
  for (std::size_t number = 0; number < outlines.faces.size(); ++number) {
    const render::FaceOutline& outline = outlines.faces[number];
    for (std::uint32_t i = 0; i < outline.corner_count; ++i) {
      Vertex vertex =
          make_vertex(level, level.faces[number], outlines.corners[outline.first_corner + i].position);
      vertex.first_tile = mesh.first_tile_[number];
      vertex.tile_grid = outline.tiles.s | std::uint32_t{outline.tiles.t} << 16;
      vertices.push_back(vertex);
    }
  }
  mesh.vertex_array_ = make_vertex_array(gl);
  mesh.vertices_ = make_buffer(gl);
  gl.BindVertexArray(mesh.vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                GL_STATIC_DRAW);
  constexpr GLsizei kStride = sizeof(Vertex);
  for (GLuint location = 0; location < 3; ++location) gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at_offset(offsetof(Vertex, position)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, at_offset(offsetof(Vertex, s)));
  gl.VertexAttribIPointer(2, 2, GL_UNSIGNED_INT, kStride, at_offset(offsetof(Vertex, first_tile)));
  gl.BindVertexArray(0);
  TRY_STATUS(gl.check("loading the level"));
  return mesh;
}

void LevelMesh::add_triangles(const render::FaceOutline& outline, std::vector<std::uint32_t>& io_indices) {
  for (std::uint32_t i = 2; i < outline.corner_count; ++i)
    io_indices.insert(io_indices.end(),
                      {outline.first_corner, outline.first_corner + i - 1, outline.first_corner + i});
}

}  // namespace temblor::render_gl
