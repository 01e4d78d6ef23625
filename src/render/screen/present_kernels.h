// Palette expansion, as vector code and as plain C++.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// out[i] = colors[indices[i]].
void expand_palette_scalar(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colors,
                           std::uint32_t* out);
void expand_palette_simd(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colors,
                         std::uint32_t* out);

}  // namespace temblor::render
