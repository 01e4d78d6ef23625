// A .vis file with one patch, written from the format's description (formats/levels/vis_patch.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/bytes.h"

namespace temblor::test {

// `level`: at most 32 characters. All fields of the leaves but the offsets are zero.
inline base::ByteVector vis_patch_bytes(std::string_view level, const std::vector<std::uint8_t>& visibility,
                                        const std::vector<std::int32_t>& leaf_offsets) {
  std::array<char, 32> name{};
  std::ranges::copy(level, name.begin());
  const auto leaves_size = static_cast<std::int32_t>(28 * leaf_offsets.size());
  const auto visibility_size = static_cast<std::int32_t>(visibility.size());
  base::ByteWriter writer;
  writer.bytes(std::as_bytes(std::span(name)));
  writer.i32(4 + visibility_size + 4 + leaves_size);
  writer.i32(visibility_size);
  writer.bytes(std::as_bytes(std::span(visibility)));
  writer.i32(leaves_size);
  for (const std::int32_t offset : leaf_offsets) {
    writer.i32(0);
    writer.i32(offset);
    writer.bytes(base::ByteVector(20));
  }
  return std::move(writer).take();
}

}  // namespace temblor::test
