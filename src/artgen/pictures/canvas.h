// The painter's canvas: finer than the picture, in true color with coverage; shrunk to the picture at the
// end.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "artgen/palette.h"
#include "artgen/pictures/outline.h"
#include "formats/images/palette.h"
#include "math/vec.h"

namespace temblor::artgen::pictures {

// 0 to 1 each.
using Color = math::Vec3d;

// A place along a ramp of the palette, from 0 (dark) to 1; more and less count as the ends.
struct Tone {
  Ramp ramp = Ramp::kGray;
  double tone = 0.5;
};
Color color_of(const formats::Palette& palette, const Tone& tone);

// Moves, turns (clockwise) and scales what is drawn.
struct Placement {
  math::Vec2d at{0.0};
  double turn_deg = 0, scale = 1;

  math::Vec2d to_local(math::Vec2d place) const;
  math::Vec2d to_canvas(math::Vec2d place) const;
};

enum class Blend : std::uint8_t { kDown, kAcross, kOut };

struct Ink {
  Tone color, to;  // blended over the shape
  Blend blend = Blend::kDown;
  double opacity = 1;
  // The edge stands out (or, below 0, lies back) over so many pixels, lit from above and the left.
  double raise = 0, light = 0.35;
  double grain = 0, lump = 4;  // how far tones wander, in lumps of so many pixels
  std::optional<Tone> stain;   // spots of another color
  double stained = 0.4, stain_lump = 6;
  std::optional<Tone> edge;  // a line around the shape
  double edge_width = 1;
  std::optional<Tone> glow;  // light around the shape
  double glow_reach = 4, glow_strength = 0.8;
  double shadow = 0;        // so far to the right and down lies one
  double holes = 0;         // share of the shape that is not there, in lumps
  bool erases = false;      // nothing else than making it transparent
  bool keeps_ramp = false;  // quantized to no other ramp than its color's
  std::uint64_t seed = 1;
};

class Canvas {
 public:
  // `fineness` samples a pixel each way.
  Canvas(std::int32_t width, std::int32_t height, std::int32_t fineness);

  std::int32_t width() const { return width_; }
  std::int32_t height() const { return height_; }

  void paint(const Outline& outline, const Placement& placement, const Ink& ink);
  // All that is painted, blended towards a color by `amount`; with `rim`, only towards the borders.
  void tint(const Tone& tone, double amount, bool rim);
  // Tones of all that is painted, times `by`.
  void shade(double by);
  // Every sample's tone wanders; for what should look old.
  void weather(double amount, double lump, std::uint64_t seed);

  struct Sample {
    Color color{0.0};
    double cover = 0;
    std::int16_t ramp = -1;  // that it must stay in
  };
  // A pixel's mean; its ramp where most of it has one.
  Sample pixel(std::int32_t x, std::int32_t y) const;

 private:
  struct Area {
    std::int32_t x0, y0, x1, y1;  // samples, the last ones excluded
  };
  Area area_of(const Outline& outline, const Placement& placement, double margin) const;
  math::Vec2d middle_of(std::int32_t x, std::int32_t y) const;
  Sample& at(std::int32_t x, std::int32_t y) {
    return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ * fineness_) +
                    static_cast<std::size_t>(x)];
  }

  std::int32_t width_, height_, fineness_;
  formats::Palette palette_;
  std::vector<Sample> samples_;
};

struct Quantizing {
  double dither = 0;               // of a color step, from 0 to 1
  std::vector<Ramp> without = {};  // not used but where ink keeps its ramp
};
// Row by row; kTransparent where less than half of a pixel is covered.
std::vector<std::uint8_t> quantize(const Canvas& canvas, const Quantizing& how);

// 0xAARRGGBB, row by row.
std::vector<std::uint32_t> true_color(const Canvas& canvas);

}  // namespace temblor::artgen::pictures
