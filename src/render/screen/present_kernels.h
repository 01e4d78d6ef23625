// Expands palette indices to colors, as SIMD and as the scalar reference. Plain types only, because the SIMD
// file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// out[i] = colors[indices[i]], for `count` pixels; `colors` has 256 elements.
void expand_palette_scalar(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colors,
                           std::uint32_t* out);
void expand_palette_simd(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colors,
                         std::uint32_t* out);

}  // namespace temblor::render
