// Colored light for a level (.lit), next to the .bsp, whose gray light it replaces.
//
//    0  "QLIT"
//    4  version i32 (1)
//    8  red, green, blue u8 for each byte of the level's lighting lump, in the same order
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// `samples`: red, green, blue for each gray sample of the level, in the level's order. Size 3 x gray_samples.
struct Lit {
  std::vector<std::uint8_t> samples;
  bool operator==(const Lit&) const = default;
};

// Returns an error for another magic or version, or if the size of the samples is not a multiple of 3. The
// level loader checks that the number of samples matches the level.
base::Result<Lit> read_lit(base::Bytes bytes);
base::ByteVector write_lit(const Lit& lit);

// The same layout with other numbers for each sample, such as directions (formats/bspx/light_directions.h).
// `meaning`: what the file holds, for errors.
base::Result<std::vector<std::uint8_t>> read_light_samples(base::Bytes bytes, std::string_view meaning);
base::ByteVector write_light_samples(std::span<const std::uint8_t> samples);

}  // namespace temblor::formats
