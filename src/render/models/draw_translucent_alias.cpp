// Method: the instance is drawn opaque into memory of its own, so that only its nearest parts are left; these
// are then blended. Parts that lie behind one another do not shine through, as they would if each triangle
// were blended by itself, in whatever order the mesh has them.
#include "render/models/draw_translucent_alias.h"

#include <algorithm>
#include <limits>

#include "render/models/fill_alias.h"

namespace temblor::render {

namespace {

std::uint8_t blended(const AliasBlend& blend, std::uint8_t over, std::uint8_t under) {
  return blend.table != nullptr ? blend.table[over * 256u + under] : over;
}

std::uint32_t blended(const AliasBlend& blend, std::uint32_t over, std::uint32_t under) {
  const auto opacity = static_cast<std::uint32_t>(std::clamp(blend.opacity_256, 0, 256));
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8)
    out |= ((over >> shift & 255) * opacity + (under >> shift & 255) * (256 - opacity) + 128) >> 8 << shift;
  return out;
}

template <typename Pixel>
void blend_picture(const AliasPicture& picture, const AliasBlend& blend, std::span<Pixel> pixels,
                   std::span<const float> depth, std::size_t width) {
  for (int row = 0; row < picture.height; ++row) {
    const std::size_t from = static_cast<std::size_t>(row) * picture.stride;
    const std::size_t to =
        static_cast<std::size_t>(picture.y + row) * width + static_cast<std::size_t>(picture.x);
    for (std::size_t i = 0; i < static_cast<std::size_t>(picture.width); ++i)
      if (picture.depth[from + i] >= depth[to + i])
        pixels[to + i] = blended(blend, static_cast<const Pixel*>(picture.pixels)[from + i], pixels[to + i]);
  }
}

}  // namespace

std::optional<AliasPicture> draw_alias_alone(const Scene& scene, const Settings& settings,
                                             const ViewFrame& view, const AliasInstance& instance,
                                             AliasRole role, const ColourTables& tables, PixelFormat format,
                                             base::Arena& arena) {
  const auto placement = place_alias(view, instance, role);
  if (!placement || placement->first_row >= placement->row_end ||
      placement->first_column >= placement->column_end)
    return std::nullopt;
  const PreparedAlias prepared = prepare_alias(scene, settings, view, *placement, tables, format, arena);
  // Rows as wide as the frame's, so that triangles need not be moved; only the rectangle of them is used.
  const auto stride = static_cast<std::size_t>(view.width);
  const std::size_t pixel_count =
      static_cast<std::size_t>(placement->row_end - placement->first_row) * stride;
  void* const pixels = format == PixelFormat::kIndexed
                           ? static_cast<void*>(arena.allocate<std::uint8_t>(pixel_count).data())
                           : arena.allocate<std::uint32_t>(pixel_count).data();
  float* const depth =
      arena.allocate_filled<float>(pixel_count, -std::numeric_limits<float>::infinity()).data();
  fill_alias(prepared, format, settings.vector_kernels,
             {pixels, depth, view.width, placement->first_row, placement->first_row, placement->row_end});
  const auto column = static_cast<std::size_t>(placement->first_column);
  return AliasPicture{placement->first_column,
                      placement->first_row,
                      placement->column_end - placement->first_column,
                      placement->row_end - placement->first_row,
                      format == PixelFormat::kIndexed
                          ? static_cast<void*>(static_cast<std::uint8_t*>(pixels) + column)
                          : static_cast<std::uint32_t*>(pixels) + column,
                      depth + column,
                      stride};
}

void draw_alias_instance(const Scene& scene, const Settings& settings, const ViewFrame& view,
                         const AliasInstance& instance, AliasRole role, const AliasBlend& blend,
                         const ColourTables& tables, base::Arena& arena, FrameBuffer& io_frame) {
  const auto picture =
      draw_alias_alone(scene, settings, view, instance, role, tables, io_frame.format(), arena);
  if (!picture) return;
  const auto width = static_cast<std::size_t>(io_frame.width());
  if (io_frame.format() == PixelFormat::kIndexed)
    blend_picture(*picture, blend, io_frame.indexed(), io_frame.depth(), width);
  else
    blend_picture(*picture, blend, io_frame.rgb(), io_frame.depth(), width);
}

}  // namespace temblor::render
