// Colored light for indexed pixels: tables that say which palette entry a color looks like in colored light.
//
// The colormap has one ramp of brightness for each entry, and none of hue. A pixel that the colormap has lit
// passes through a second table, which multiplies it by the color of the light, as far as that light
// dominates, and finds the nearest entry:
//
//   row 0: white light, every entry stays as it is     row kTintRows - 1: nothing but colored light
//
// Full-bright entries ignore light, and 255 may stand for "clear": both stay. A color never turns
// full-bright.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>

#include "formats/images/palette.h"
#include "render/color/blend_tables.h"

namespace temblor::render {

constexpr int kTintRows = 32;

// One table of kTintRows rows of 256 for each color, made when it is used for the first time: that takes a
// fraction of a millisecond.
class TintTables {
 public:
  TintTables(const formats::Palette& palette, const PaletteMatch& match);

  // The table for light of this color: red, green, and blue, from 0; only their ratio counts, in eighths of
  // the largest. Black counts as white. Thread-safe. Tables keep their address when this object is moved.
  const std::uint8_t* rows_for(const std::array<float, 3>& color) const;

 private:
  static constexpr int kSteps = 8;  // of each channel
  using Rows = std::array<std::uint8_t, std::size_t{kTintRows} * 256>;
  // By channel, in steps.
  using Color = std::array<int, 3>;
  struct Tables {
    Rows make_rows(const Color& color) const;

    formats::Palette palette;
    PaletteMatch match;
    std::mutex mutex;
    std::array<std::unique_ptr<const Rows>, std::size_t{kSteps + 1} * (kSteps + 1) * (kSteps + 1)> made;
  };
  std::unique_ptr<Tables> tables_;
};

}  // namespace temblor::render
