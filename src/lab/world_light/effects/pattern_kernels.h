// Inner loop of procedural texels: changes one row of a surface block by a pattern, as SIMD and as the scalar
// reference with the same results, bit for bit. Plain types only, because the SIMD file is compiled for
// several processors.
//
// The pattern at texel x is 0 to 255:
//
//   (sum of octaves at x) >> 7, plus (bias_first + x * bias_step) >> 12
//
// An octave has a node every `1 << shift` texels; between two nodes a and b, n texels apart, it is
// a + ((b - a) * i >> shift) at texel i of n.
#pragma once

#include <cstdint>

namespace temblor::lab {

constexpr std::int32_t kPatternOctaves = 3;
constexpr std::int32_t kNodePadding = 17;
// Patterns that the tables of indexed pixels tell apart.
constexpr std::int32_t kIndexedPatterns = 32;

struct OctaveRow {
  // 0 to 32767 in all octaves together; readable up to kNodePadding past the node of the last texel.
  const std::int32_t* nodes;
  std::int32_t first;  // texels from nodes[0] to the first texel of the row
  std::int32_t shift;  // 0 to 9
};

struct PatternRow {
  OctaveRow octaves[kPatternOctaves];
  std::int32_t bias_first, bias_step;  // 12 bits of fraction; up to 100,000 on the row
  std::int32_t count;                  // texels of the row
  // By pattern: 0xKKRRGGBB. A channel c of a color becomes c * (KK + 1) / 256 + RR, GG, or BB, at most 255.
  // Clear texels (alpha 0) stay clear.
  const std::uint32_t* inks;
  // kIndexedPatterns rows of 256 palette indices, and 3 bytes more. `clear`: an index that stays; 256: none.
  const std::uint8_t* indices;
  std::int32_t clear;
};

void change_row_u8_scalar(const PatternRow& row, std::uint8_t* io_texels);
void change_row_u32_scalar(const PatternRow& row, std::uint32_t* io_texels);
void change_row_u8_simd(const PatternRow& row, std::uint8_t* io_texels);
void change_row_u32_simd(const PatternRow& row, std::uint32_t* io_texels);

}  // namespace temblor::lab
