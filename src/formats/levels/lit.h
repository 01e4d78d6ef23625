// .lit files: colored light samples for a level, three bytes for each gray one.
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

// Fails on another mark or version than QLIT 1, and on a number of bytes that is not a multiple of 3. Whether
// there are as many samples as the level has is for the level's loader to say.
base::Result<Lit> read_lit(base::Bytes bytes);
base::ByteVector write_lit(const Lit& lit);

}  // namespace temblor::formats
