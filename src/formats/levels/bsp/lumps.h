// The header of a level file: the version, and the place of each lump. bsp.h shows the layout.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// The place of a lump in the file. read_header() guarantees that it is inside of the file, so a level takes
// at most a multiple of the file's size, although lumps may overlap.
struct LumpPlace {
  std::uint32_t offset = 0, size = 0;  // bytes
};

struct Header {
  BspVersion version = BspVersion::k29;
  std::array<LumpPlace, kBspLumpCount> lumps;
  std::string repairs;  // the first lump that was cut at the end of the file, or empty

  const LumpPlace& operator[](BspLump lump) const { return lumps[static_cast<std::size_t>(lump)]; }
};

constexpr std::size_t kHeaderBytes = 4 + kBspLumpCount * 8;

// Returns an error for an unknown version, or if records extend past the end of the file. Entities, textures,
// visibility, and light are cut there.
base::Result<Header> read_header(base::Bytes file);

// Writes a header with empty lumps; set_lump() fills each in after it was written.
void begin_header(base::ByteWriter& writer, BspVersion version);
void set_lump(base::ByteWriter& writer, BspLump lump, LumpPlace place);

// Returns the bytes of a lump, without a copy.
inline base::Bytes lump_bytes(base::Bytes file, const LumpPlace& place) {
  return file.subspan(place.offset, place.size);
}

}  // namespace temblor::formats::bsp_file
