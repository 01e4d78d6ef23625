// Palette expansion, as vector code and as plain C++.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// out[i] = colours[indices[i]].
void expand_palette_plain(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colours,
                          std::uint32_t* out);
void expand_palette_vector(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colours,
                           std::uint32_t* out);

}  // namespace temblor::render
