#include "render/alias/fill_alias.h"

namespace temblor::render {

void fill_alias(const PreparedAlias& alias, PixelFormat format, bool simd_kernels,
                const TriangleTarget& target) {
  if (alias.by_subdivision)
    format == PixelFormat::kIndexed ? subdivide_triangles_u8(alias.job, target)
                                    : subdivide_triangles_u32(alias.job, target);
  else if (format == PixelFormat::kIndexed)
    simd_kernels ? draw_triangles_u8_simd(alias.job, target) : draw_triangles_u8_scalar(alias.job, target);
  else
    simd_kernels ? draw_triangles_u32_simd(alias.job, target) : draw_triangles_u32_scalar(alias.job, target);
}

}  // namespace temblor::render
