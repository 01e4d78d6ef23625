// Damaged copies of valid files. Each copy is a heap block of exactly its size, so that the address sanitizer
// detects the first byte that is read past its end.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include "base/bytes.h"
#include "support/random.h"

namespace temblor::test {

// Calls check(prefix) with the first 0, 1, ... size - 1 bytes.
template <typename Check>
void for_each_truncation(base::Bytes bytes, Check check) {
  for (std::size_t size = 0; size < bytes.size(); ++size)
    check(base::ByteVector(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
}

// Flips 1 to 8 random bits. `bytes` must not be empty.
inline base::ByteVector with_flipped_bits(base::Bytes bytes, Random& random) {
  base::ByteVector damaged(bytes.begin(), bytes.end());
  for (std::size_t flips = 1 + random.below(8); flips > 0; --flips)
    damaged[random.below(damaged.size())] ^= std::byte{1} << random.below(8);
  return damaged;
}

inline base::ByteVector random_bytes(Random& random, std::size_t size) {
  base::ByteVector bytes(size);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
  return bytes;
}

// Overwrites a little-endian number at `offset`.
template <typename T>
base::ByteVector with_number(base::Bytes bytes, std::size_t offset, T value) {
  base::ByteWriter writer;
  writer.bytes(bytes);
  writer.patch(offset, value);
  return std::move(writer).take();
}

inline base::ByteVector to_bytes(std::string_view text) {
  const base::Bytes bytes = base::as_bytes(text);
  return {bytes.begin(), bytes.end()};
}

}  // namespace temblor::test
