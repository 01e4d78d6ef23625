// Where a level's lumps lie in its file.
#pragma once

#include <array>
#include <cstdint>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// Lies inside the file, when from read_header.
struct LumpPlace {
  std::uint32_t offset = 0, size = 0;  // bytes
};

struct Header {
  BspVersion version = BspVersion::k29;
  std::array<LumpPlace, kBspLumpCount> lumps;

  const LumpPlace& operator[](BspLump lump) const { return lumps[static_cast<std::size_t>(lump)]; }
};

constexpr std::size_t kHeaderBytes = 4 + kBspLumpCount * 8;

// Fails on an unknown version, on a lump outside the file, and on lumps that overlap so much that together
// they are larger than the file (which bounds the memory that reading takes).
base::Result<Header> read_header(base::Bytes file);

// Room for the header of `version`, all lumps empty; set_lump fills them in once they have been written.
void begin_header(base::ByteWriter& writer, BspVersion version);
void set_lump(base::ByteWriter& writer, BspLump lump, LumpPlace place);

inline base::Bytes lump_bytes(base::Bytes file, const LumpPlace& place) {
  return file.subspan(place.offset, place.size);
}

}  // namespace temblor::formats::bsp_file
