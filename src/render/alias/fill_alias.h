// Fills the triangles of a prepared instance, with the rasterizer and the kernels that were chosen for it.
#pragma once

#include "render/alias/prepare_alias.h"

namespace temblor::render {

// `target` must have pixels of format `format`.
void fill_alias(const PreparedAlias& alias, PixelFormat format, bool simd_kernels,
                const TriangleTarget& target);

}  // namespace temblor::render
