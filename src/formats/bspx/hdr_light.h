// BSPX LIGHTING_E5BGR9: colored light without an upper limit, one u32 for each gray sample of the level, in
// the same order:
//
//   bits 31-27 exponent e | 26-18 blue | 17-9 green | 8-0 red        a channel's value: number * 2^(e - 24)
//
// This is the OpenGL format RGB9_E5 (EXT_texture_shared_exponent). A value of 1 shows a texture as it is; the
// gray sample 255 corresponds to 2. Layout: FTE's description of BSPX (specs/bspx.txt).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::formats {

inline constexpr const char* kHdrLightLump = "LIGHTING_E5BGR9";

// The light that corresponds to one step of a gray sample.
constexpr float kHdrPerGrayStep = 2.0f / 255;

// Rounds to the nearest number that the format has: 9 bits for the brightest channel. Negative channels
// become 0; the largest value is 65408.
std::uint32_t pack_e5bgr9(const math::Vec3& light);
math::Vec3 unpack_e5bgr9(std::uint32_t packed);

// Returns the samples; nothing if the level has no such lump. Fails if there is not one for each gray sample.
base::Result<std::vector<std::uint32_t>> read_hdr_light(const Bsp& bsp);

// Replaces the level's lump. Empty: only removes it.
void set_hdr_light(std::span<const std::uint32_t> samples, Bsp& io_bsp);

}  // namespace temblor::formats
