// A minimal, independent reader of demo files, which returns their packets.
#pragma once

#include <cstddef>
#include <vector>

#include "base/bytes.h"
#include "base/check.h"

namespace temblor::test {

struct DemPacket {
  base::Bytes bytes;
  std::size_t offset = 0;  // in the file
};

// CHECKs that the file is complete.
inline std::vector<DemPacket> dem_packets(base::Bytes dem) {
  base::ByteReader file(dem);
  while (file.ok() && file.u8() != '\n') {
  }
  std::vector<DemPacket> packets;
  while (file.remaining() > 0) {
    const auto size = static_cast<std::size_t>(file.i32());
    file.take(3 * sizeof(float));  // view angles
    const std::size_t offset = file.offset();
    packets.push_back({file.take(size), offset});
    CHECK(file.ok());
  }
  return packets;
}

}  // namespace temblor::test
