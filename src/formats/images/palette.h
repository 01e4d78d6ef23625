// gfx/palette.lmp and gfx/colormap.lmp.
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

// Row r of 64 maps a palette index to the one that looks like it under light row r: row 0 brightest (about
// twice), row 31 as it is, row 63 black. The last `fullbrights` indices are the same in every row.
struct Colormap {
  static constexpr int kRows = 64;
  std::array<std::uint8_t, kRows * 256> rows{};
  int fullbrights = 32;
};

base::Result<Palette> read_palette(base::Bytes bytes);
base::ByteVector write_palette(const Palette& palette);

// Accepts 16384 bytes, or 16385 with the number of full-bright colors at the end.
base::Result<Colormap> read_colormap(base::Bytes bytes);
base::ByteVector write_colormap(const Colormap& colormap);

// The colormap a palette asks for, as the stock one was made: the color nearest (squared distance; the
// lowest index where several are) to rgb * (63 - row) / 32, rounded and clamped to 255, never index 255. The
// last 32 indices stay as they are in every row.
Colormap make_colormap(const Palette& palette);

}  // namespace temblor::formats
