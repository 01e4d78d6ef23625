#include "render/alias/draw_translucent_alias.h"

#include <limits>

#include "render/alias/fill_alias.h"

namespace temblor::render {

std::optional<AliasPicture> draw_alias_picture(const FrameContext& context, const ViewFrame& view,
                                               const AliasInstance& instance, AliasRole role) {
  base::Arena& arena = context.arena();
  const auto placement = place_alias(view, instance, role);
  if (!placement || placement->first_row >= placement->row_end ||
      placement->first_column >= placement->column_end)
    return std::nullopt;
  const PreparedAlias prepared = prepare_alias(context, view, *placement, arena);
  // Rows are as wide as the frame's, so that triangles need not be moved; only the rectangle is used.
  const auto stride = static_cast<std::size_t>(view.width);
  const std::size_t pixel_count =
      static_cast<std::size_t>(placement->row_end - placement->first_row) * stride;
  void* const pixels = context.is_indexed()
                           ? static_cast<void*>(arena.allocate<std::uint8_t>(pixel_count).data())
                           : arena.allocate<std::uint32_t>(pixel_count).data();
  float* const depth =
      arena.allocate_filled<float>(pixel_count, -std::numeric_limits<float>::infinity()).data();
  fill_alias(prepared, context.format, context.settings.simd_kernels,
             {pixels, depth, view.width, placement->first_row, placement->first_row, placement->row_end});
  const auto column = static_cast<std::size_t>(placement->first_column);
  return AliasPicture{placement->first_column,
                      placement->first_row,
                      placement->column_end - placement->first_column,
                      placement->row_end - placement->first_row,
                      context.is_indexed() ? static_cast<void*>(static_cast<std::uint8_t*>(pixels) + column)
                                           : static_cast<std::uint32_t*>(pixels) + column,
                      depth + column,
                      stride};
}

}  // namespace temblor::render
