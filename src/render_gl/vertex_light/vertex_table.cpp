#include "render_gl/vertex_light/vertex_table.h"

#include <algorithm>

#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// The shader has the same number.
constexpr std::size_t kCornersPerRow = 1024;

}  // namespace

base::Status VertexTable::reserve(const Functions& gl, std::size_t count) {
  const auto max_rows = static_cast<std::size_t>(find_texture_limits(gl).side);
  const std::size_t rows = std::min((count + kCornersPerRow - 1) / kCornersPerRow, max_rows);
  if (rows <= row_changed_.size()) return base::Ok{};
  texels_.clear();
  row_changed_.clear();
  TRY(texture_, make_texture(gl, GL_RGB10_A2, {static_cast<int>(kCornersPerRow), static_cast<int>(rows)}));
  texels_.assign(rows * kCornersPerRow, 0);
  row_changed_.assign(rows, true);
  return base::Ok{};
}

void VertexTable::set(std::size_t first, std::span<const std::uint32_t> light) {
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (texels_[first + i] == light[i]) continue;
    texels_[first + i] = light[i];
    row_changed_[(first + i) / kCornersPerRow] = true;
  }
}

void VertexTable::upload(const Functions& gl, CacheCounts& io_counts) {
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t row = 0; row < row_changed_.size(); ++row) {
    if (!row_changed_[row]) continue;
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(kCornersPerRow), 1,
                     GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, &texels_[row * kCornersPerRow]);
    row_changed_[row] = false;
    ++io_counts.uploads;
    io_counts.bytes_uploaded += kCornersPerRow * sizeof(std::uint32_t);
  }
}

}  // namespace temblor::render_gl
