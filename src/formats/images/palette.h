// The palette and the colormap, which shades its colors.
//
//   gfx/palette.lmp, 768 bytes              256 colors of red, green, blue u8
//   gfx/colormap.lmp, 16384 or 16385 bytes  64 rows of 256 palette indices | number of fullbright colors u8
//
//                      color 0 ... 223              224 ... 255
//   row  0, brightest  about twice as bright        unchanged (fullbright: lamps, fire, eyes)
//   row 31             unchanged
//   row 63, darkest    black
//
// The 256-color renderer draws a texel as colormap[row of its light][texel], without any arithmetic on
// colors.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

using Palette = std::array<Rgb, 256>;

// `rows`: entry row * 256 + index is the index of the shaded color.
struct Colormap {
  static constexpr int kRows = 64;
  std::array<std::uint8_t, kRows * 256> rows{};
  int fullbrights = 32;  // the last indices, which are the same in every row
};

// Needs 768 bytes, and ignores those after them.
base::Result<Palette> read_palette(base::Bytes bytes);
base::ByteVector write_palette(const Palette& palette);

// Needs 16384 bytes. The next one, if present, is the number of fullbright colors; all others are ignored.
base::Result<Colormap> read_colormap(base::Bytes bytes);
base::ByteVector write_colormap(const Colormap& colormap);

// Computes the colormap of a palette the way the stock one was made: the nearest color (squared distance,
// ties to the lowest index, never index 255) to rgb * (63 - row) / 32, rounded and clamped to 255. The last
// 32 indices stay unchanged in every row.
Colormap make_colormap(const Palette& palette);

}  // namespace temblor::formats
