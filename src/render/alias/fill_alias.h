// A prepared instance's triangles, filled by the rasterizer and the kernels that were chosen for it.
#pragma once

#include "render/alias/prepare_alias.h"

namespace temblor::render {

// `target` has pixels of that format.
void fill_alias(const PreparedAlias& alias, PixelFormat format, bool vector_kernels,
                const TriangleTarget& target);

}  // namespace temblor::render
