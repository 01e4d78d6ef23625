#include "render_gl/surfaces/tile_table.h"

#include <algorithm>

#include "render_gl/gl/texture_limits.h"

namespace temblor::render_gl {

namespace {

// Two texels of four 32-bit numbers each.
constexpr int kTexelsPerRecord = 2;
static_assert(sizeof(TileRecord) == kTexelsPerRecord * 16);

}  // namespace

base::Status TileTable::reserve(const Functions& gl, std::uint32_t count) {
  if (count <= records_.size()) return base::Ok{};
  const auto max_rows = static_cast<std::uint32_t>(find_texture_limits(gl).side);
  const std::uint32_t rows = std::min((count + kRecordsPerRow - 1) / kRecordsPerRow, max_rows);
  if (std::size_t{rows} * kRecordsPerRow <= records_.size()) return base::Ok{};
  TRY(texture_, make_texture(gl, GL_RGBA32UI,
                             {static_cast<int>(kRecordsPerRow) * kTexelsPerRecord, static_cast<int>(rows)}));
  records_.assign(std::size_t{rows} * kRecordsPerRow, TileRecord{});
  row_changed_.assign(rows, true);
  return base::Ok{};
}

void TileTable::set(std::uint32_t number, const TileRecord& record) {
  if (number >= records_.size() || records_[number] == record) return;
  records_[number] = record;
  row_changed_[number / kRecordsPerRow] = true;
}

void TileTable::upload(const Functions& gl) {
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (std::size_t row = 0; row < row_changed_.size(); ++row) {
    if (!row_changed_[row]) continue;
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row),
                     static_cast<GLsizei>(kRecordsPerRow) * kTexelsPerRecord, 1, GL_RGBA_INTEGER,
                     GL_UNSIGNED_INT, &records_[row * kRecordsPerRow]);
    row_changed_[row] = false;
  }
}

}  // namespace temblor::render_gl
