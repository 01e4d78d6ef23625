// Translucency and fog for pixels that are palette indices: what lies over what looks like, as tables.
//
// A blend of two colors is the palette entry nearest to their mean. Full-bright entries come of full-bright
// ones only, else light would spring from two dark colors; 255, which stands for "clear" in pictures, never
// does.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"
#include "math/vec.h"
#include "render/color/fog_curve.h"

namespace temblor::render {

// How both formats weigh what lies over a pixel: in 256ths.
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
// 0xffRRGGBB, the alpha of both ignored.
constexpr std::uint32_t blend_rgb(std::uint32_t over, std::uint32_t under, int opacity_256) {
  std::uint32_t out = 0xff000000u;
  for (int shift = 0; shift < 24; shift += 8)
    out |= std::uint32_t{blend_channel(static_cast<int>(over >> shift & 255),
                                       static_cast<int>(under >> shift & 255), opacity_256)}
           << shift;
  return out;
}

// The entry that looks most like a color, under the rule above.
class PaletteMatch {
 public:
  PaletteMatch(const formats::Palette& palette, int first_fullbright);

  // `fullbright`: whether a full-bright entry took part in the color.
  std::uint8_t operator()(formats::Rgb color, bool fullbright) const {
    return (fullbright ? any_ : lit_).find(color);
  }
  bool is_fullbright(std::size_t index) const { return static_cast<int>(index) >= first_fullbright_; }

 private:
  int first_fullbright_;
  formats::NearestColor lit_, any_;
};

// A table for each sixteenth of opacity, 1 to 15: 64 KiB each, worked out when it is first asked for, since
// that takes milliseconds and few are ever needed.
class BlendTables {
 public:
  static constexpr int kSteps = 16;
  BlendTables(const formats::Palette& palette, const PaletteMatch& match);

  // What shows of index `over`, at that opacity, before index `under`: table[over * 256 + under]. The
  // nearest of the steps; never wholly clear or opaque, which callers need no table for. Several threads may
  // ask at once; no heap is used. Tables stay where they are, also when this is moved.
  const std::uint8_t* table_for(float opacity) const;

 private:
  struct Tables {
    Tables(const formats::Palette& of_palette, const PaletteMatch& of_match);
    void make_pair(int step);

    formats::Palette palette;
    PaletteMatch match;
    std::unique_ptr<std::uint8_t[]> bytes;                // one after another
    std::array<std::once_flag, kSteps / 2> pair_is_made;  // of a step, from 1, and its mirror
  };
  std::unique_ptr<Tables> tables_;
};

// What fog leaves of each color, by its share of the pixel: `kRows` rows of 256, row r for r / (kRows - 1).
// 255 stays: it may stand for "clear".
class FogTables {
 public:
  static constexpr int kRows = kFogSteps + 1;

  // `color`: 0 to 1. Worked out when it is not that of the last call.
  const std::uint8_t* rows_for(const math::Vec3& color, const formats::Palette& palette,
                               const PaletteMatch& match);
  const FogCurve& curve() const { return curve_; }

 private:
  FogCurve curve_ = make_fog_curve();
  std::optional<formats::Rgb> color_;
  std::array<std::uint8_t, kRows * 256> rows_{};
};

// A color from 0 to 1 as one of 0 to 255.
formats::Rgb to_bytes(const math::Vec3& color);

}  // namespace temblor::render
