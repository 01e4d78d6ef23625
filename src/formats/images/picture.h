// LMP pictures, the 2D art of the game: gfx/*.lmp, and lumps of type kWadPicture in gfx.wad.
//
//    0  width i32
//    4  height i32
//    8  palette indices u8, row by row from the top; 255 is transparent
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMaxPictureSide = 1 << 14;  // pixels

// A picture in color that is shown in place of another one, at that one's size.
struct PictureDetail {
  std::uint32_t width = 0, height = 0;  // at least 1
  std::vector<std::uint32_t> colors;    // 0xAARRGGBB, row by row
  std::vector<std::uint8_t> indices;    // the nearest palette entries; 255 is transparent
};

struct Picture {
  std::uint32_t width = 0, height = 0;  // 1 to kMaxPictureSide
  std::vector<std::uint8_t> pixels;     // width x height palette indices, row by row; 255 is transparent
  std::shared_ptr<const PictureDetail> detail = nullptr;  // null: none
  bool operator==(const Picture&) const = default;
};

// Reads a picture. Ignores bytes after the pixels, as the original engine does.
base::Result<Picture> read_picture(base::Bytes bytes);
// Writes a picture. CHECKs the size and the number of pixels.
base::ByteVector write_picture(const Picture& picture);

// Reads the console font, lump "conchars" of gfx.wad: 128 x 128 pixels without a header, 16 rows of 16 glyphs
// of 8 x 8. Index 0 is transparent in the lump; the result has 255 there, like every other picture.
base::Result<Picture> read_conchars(base::Bytes lump);

}  // namespace temblor::formats
