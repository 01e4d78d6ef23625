// Colored light for a level (.lit), next to the .bsp, whose gray light it replaces.
//
//    0  "QLIT"
//    4  version i32 (1)
//    8  red, green, blue u8 for each byte of the level's lighting lump, in the same order
#pragma once

#include <cstdint>
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

}  // namespace temblor::formats
