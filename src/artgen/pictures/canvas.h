// The canvas that pictures are painted on. It has several samples per pixel in true color with coverage, and
// is reduced to the picture's pixels and palette at the end.
//
//   lines of a drawing -> Outline, Placement, Ink -> Canvas::paint -> samples -> quantize or to_true_color
//
// Sources: shapes from outline.h, noise from models/noise.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "artgen/palette.h"
#include "artgen/pictures/outline.h"
#include "formats/images/palette.h"
#include "math/vec.h"

namespace temblor::artgen::pictures {

// Red, green, and blue from 0 to 1.
using Color = math::Vec3d;

// A position on a palette ramp, from 0 (dark) to 1; values outside are clamped. Colors between two palette
// colors are interpolated.
struct Tone {
  Ramp ramp = Ramp::kGray;
  double tone = 0.5;
};
Color look_up_color(const formats::Palette& palette, const Tone& tone);

// A similarity transform: scales, rotates clockwise, then moves. Groups in a drawing combine placements.
struct Placement {
  math::Vec2d at{0.0};
  double turn_deg = 0, scale = 1;

  // From canvas to shape coordinates, and back.
  math::Vec2d to_local(math::Vec2d position) const;
  math::Vec2d to_canvas(math::Vec2d position) const;
};

// The direction in which an ink blends from `color` to `to` over its shape: downward, to the right, or from
// the center outward.
enum class Blend : std::uint8_t { kDown, kAcross, kOut };

// How a shape is painted. The defaults paint a plain shape of `color`.
struct Ink {
  // Blended over the shape's bounding box.
  Tone color, to;
  Blend blend = Blend::kDown;
  double opacity = 1;
  // The rim rises over so many pixels (below 0: it sinks), lit from the upper left with this strength.
  double raise = 0, light = 0.35;
  // Noise added to the tones, and the size of its lumps in pixels.
  double grain = 0, lump = 4;
  // A second color in spots, which cover the fraction `stained` and are `stain_lump` pixels large.
  std::optional<Tone> stain;
  double stained = 0.4, stain_lump = 6;
  // A line of `edge_width` pixels around the shape.
  std::optional<Tone> edge;
  double edge_width = 1;
  // Light around the shape that fades over `glow_reach` pixels.
  std::optional<Tone> glow;
  double glow_reach = 4, glow_strength = 0.8;
  // A black shadow, moved right and down by so many pixels.
  double shadow = 0;
  // The fraction of the shape that is missing, in lumps.
  double holes = 0;
  // Makes the canvas transparent instead of painting.
  bool erases = false;
  // Quantizes to the ramp of `color` only, for parts that the game recolors.
  bool keeps_ramp = false;
  // The seed of all noise in this ink.
  std::uint64_t seed = 1;
};

// Starts transparent.
class Canvas {
 public:
  // `fineness`: samples per pixel on each axis.
  Canvas(std::int32_t width, std::int32_t height, std::int32_t fineness);

  std::int32_t width() const { return width_; }
  std::int32_t height() const { return height_; }

  // Paints over the samples; glow, shadow, and edge lie outside the shape.
  void paint(const Outline& outline, const Placement& placement, const Ink& ink);
  // Blends everything painted so far toward a color by `amount`. `rim`: only near the border of the canvas.
  void tint(const Tone& tone, double amount, bool rim);
  // Multiplies all colors by a factor.
  void shade(double by);
  // Multiplies colors by noise of up to +-`amount`, so that the picture looks old. `lump`: its size in
  // pixels.
  void weather(double amount, double lump, std::uint64_t seed);

  // One sample of the canvas, or the average of a pixel.
  struct Sample {
    Color color{0.0};
    // Opacity, 0 to 1.
    double cover = 0;
    // The only ramp that the color may be quantized to; -1: any.
    std::int16_t ramp = -1;
  };
  // The average of a pixel's samples. It is bound to a ramp if most of its painted samples are.
  Sample pixel(std::int32_t x, std::int32_t y) const;

 private:
  // A rectangle of samples.
  struct Area {
    // x1 and y1 are excluded.
    std::int32_t x0, y0, x1, y1;
  };
  Area find_area(const Outline& outline, const Placement& placement, double margin) const;
  math::Vec2d sample_center(std::int32_t x, std::int32_t y) const;
  Sample& at(std::int32_t x, std::int32_t y) {
    return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ * fineness_) +
                    static_cast<std::size_t>(x)];
  }

  std::int32_t width_, height_, fineness_;
  formats::Palette palette_;
  std::vector<Sample> samples_;
};

// How colors are reduced to the palette.
struct QuantizeOptions {
  // The strength of ordered dithering; 1 spreads about one step of a ramp.
  double dither = 0;
  // Ramps that only ink with keeps_ramp may use.
  std::vector<Ramp> without = {};
};
// Palette indices, row by row. A pixel that is covered by less than half becomes kTransparent.
std::vector<std::uint8_t> quantize(const Canvas& canvas, const QuantizeOptions& options);

// 0xAARRGGBB, row by row.
std::vector<std::uint32_t> to_true_color(const Canvas& canvas);

}  // namespace temblor::artgen::pictures
