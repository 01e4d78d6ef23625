// Adds a row of an additive face (Half-Life's "rendermode" 5) to the picture where it is in front. Such faces
// are rare, so there is no SIMD version.
#pragma once

#include <cstdint>

#include "render/translucent/merge_kernels.h"

namespace temblor::render {

// Adds texel * opacity_256 / 256 to each channel, up to 255. Depth stays.
void merge_added_u32(const MergeRow& row);

// Replaces pixels by table[dimmed * 256 + pixel], where `row.table` is BlendTables::sums(), and `dimmed` is
// dims[texel * 256], or the texel if `dims` is null. Depth stays.
void merge_added_u8(const MergeRow& row, const std::uint8_t* dims);

}  // namespace temblor::render
