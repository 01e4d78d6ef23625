// LMP pictures: the game's 2-D art (gfx/*.lmp, pictures in gfx.wad).
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMaxPictureSide = 1 << 14;  // pixels

struct Picture {
  std::uint32_t width = 0, height = 0;  // 1 to kMaxPictureSide
  std::vector<std::uint8_t> pixels;     // width x height palette indices, row by row; 255 is transparent
  bool operator==(const Picture&) const = default;
};

// Bytes past the pixels are ignored, as the original does.
base::Result<Picture> read_picture(base::Bytes bytes);
// CHECKs that the sides are in range and that the pixels are as many as they say.
base::ByteVector write_picture(const Picture& picture);

// The console's characters, lump "conchars" of gfx.wad: 128 x 128 pixels without a header, 16 rows of 16
// glyphs of 8 x 8. Index 0 is transparent there; the picture returned has 255 in its place, as any other.
base::Result<Picture> read_conchars(base::Bytes lump);

}  // namespace temblor::formats
