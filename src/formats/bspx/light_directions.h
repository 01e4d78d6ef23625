// Directions of light, for engines that draw bumps and highlights: one unit vector for each gray sample of a
// level, in the same order. They are in a file (.lux) next to the .bsp, and in the BSPX lump LIGHTINGDIR.
//
//    0  "QLIT"            \ only in the file
//    4  version i32 (1)   /
//    8  x, y, z u8 for each gray sample: round(v * 127 + 128)
//
// A vector points from the face to its light: x along the direction in which the texture's s grows, y along
// that in which t grows (down, on a wall), z along the face's normal. Source: FTE's description of BSPX
// (specs/bspx.txt), which names the space of the face, but neither the sign of y nor the scale of a byte.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::formats {

inline constexpr const char* kLightDirectionsLump = "LIGHTINGDIR";

// Rounds a vector, whose parts are from -1 to 1; unpacking makes an error of at most 1/254 in each.
std::array<std::uint8_t, 3> pack_direction(const math::Vec3& direction);
math::Vec3 unpack_direction(std::span<const std::uint8_t, 3> packed);

// Returns the bytes of the lump, three for each gray sample; nothing if the level has none. Fails if there
// are not three for each gray sample.
base::Result<std::vector<std::uint8_t>> read_light_directions(const Bsp& bsp);
// Replaces the level's lump. Empty: only removes it.
void set_light_directions(std::span<const std::uint8_t> samples, Bsp& io_bsp);

// The same bytes in a .lux file. Reading fails for another magic or version, or if the bytes are not a
// multiple of 3.
base::Result<std::vector<std::uint8_t>> read_lux(base::Bytes bytes);
base::ByteVector write_lux(std::span<const std::uint8_t> samples);

}  // namespace temblor::formats
