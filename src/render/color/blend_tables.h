// Translucency and fog for indexed pixels: tables that say which palette entry a blend of two entries looks
// like.
//
// A blend of two colors becomes the palette entry that PaletteMatch finds for their mean; it is full-bright
// only if one of the two is.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "formats/images/palette.h"
#include "math/vec.h"
#include "render/color/fog_curve.h"
#include "render/color/palette_match.h"

namespace temblor::render {

// Both pixel formats measure opacity in 256ths.
constexpr int kOpaque256 = 256;
constexpr int opacity_256(float opacity) {
  const float bounded = opacity > 0 ? (opacity < 1 ? opacity : 1.0f) : 0.0f;
  return static_cast<int>(bounded * 256.0f + 0.5f);
}
constexpr std::uint8_t blend_channel(int over, int under, int opacity_256) {
  return static_cast<std::uint8_t>((over * opacity_256 + under * (256 - opacity_256) + 128) >> 8);
}
constexpr formats::Rgb blend_colors(formats::Rgb over, formats::Rgb under, int opacity_256) {
  return {blend_channel(over.r, under.r, opacity_256), blend_channel(over.g, under.g, opacity_256),
          blend_channel(over.b, under.b, opacity_256)};
}
// 0xffRRGGBB; the alpha of both colors is ignored.
constexpr std::uint32_t blend_rgb(std::uint32_t over, std::uint32_t under, int opacity_256) {
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8)
    out |= std::uint32_t{blend_channel(static_cast<int>(over >> shift & 255),
                                       static_cast<int>(under >> shift & 255), opacity_256)}
           << shift;
  return out;
}

// Adds each channel, up to 255. 0xffRRGGBB.
constexpr std::uint32_t add_rgb(std::uint32_t over, std::uint32_t under) {
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8) {
    const std::uint32_t sum = (over >> shift & 255) + (under >> shift & 255);
    out |= (sum < 255 ? sum : 255) << shift;
  }
  return out;
}

// One table of 64 KiB for each sixteenth of opacity from 1 to 15, and one for sums. A table is computed when
// it is used for the first time, since that takes milliseconds and a single picture needs few.
class BlendTables {
 public:
  static constexpr int kSteps = 16;
  BlendTables(const formats::Palette& palette, const PaletteMatch& match);

  // The table for the step nearest to `opacity`: index `over` in front of index `under` is table[over * 256 +
  // under]. Never the step for clear or opaque, which callers need no table for. Thread-safe;
  // allocates only what `match` prepares. Tables keep their address when this object is moved.
  const std::uint8_t* table_for(float opacity) const;
  // The same for the sum of two colors, which is symmetric. Any entry except 255 may be a result: nothing
  // lights a sum.
  const std::uint8_t* sums() const;

  // Computes all tables that do not exist yet, which takes 20 to 50 ms. A program that plays calls it while
  // nobody watches, so that no frame waits for a table. Thread-safe.
  void make_all() const;

 private:
  struct Tables {
    Tables(const formats::Palette& source_palette, const PaletteMatch& source_match);
    void make_pair(int step);
    void make_sums();

    formats::Palette palette;
    PaletteMatch match;
    std::unique_ptr<std::uint8_t[]> bytes;  // table after table: for steps 1 to 15, and the sums
    // By step - 1: whether the tables of a step and of its mirror, kSteps - step, exist.
    std::array<std::once_flag, kSteps / 2> pair_is_made;
    std::once_flag sums_are_made;
  };
  std::unique_ptr<Tables> tables_;
};

// Maps each palette index to the index of its color in fog, by the fog's share of the pixel: `kRows` rows of
// 256, row r for a share of r / (kRows - 1). Index 255 stays, since it may stand for "clear".
class FogTables {
 public:
  static constexpr int kRows = kFogSteps + 1;

  // `color`: 0 to 1. Recomputed only if it differs from the last call's; that takes milliseconds.
  const std::uint8_t* rows_for(const math::Vec3& color, const formats::Palette& palette,
                               const PaletteMatch& match);
  const FogCurve& curve() const { return curve_; }

 private:
  FogCurve curve_ = make_fog_curve();
  std::optional<formats::Rgb> color_;
  std::array<std::uint8_t, kRows * 256> rows_{};
};

// Converts a color from 0 to 1 to 0 to 255; clamps.
formats::Rgb to_bytes(const math::Vec3& color);

}  // namespace temblor::render
