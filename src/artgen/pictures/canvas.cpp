#include "artgen/pictures/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "artgen/models/noise.h"

namespace temblor::artgen::pictures {
namespace {

using math::Vec2d;

// The direction toward the light.
constexpr Vec2d kLight{-0.6, -0.8};

Color mix(const Color& from, const Color& to, double share) {
  return from + (to - from) * share;
}

double noise(Vec2d position, double lump, std::uint64_t seed) {
  return lump_noise({position.x / lump, position.y / lump, 0.5}, seed);
}

// Paints a color over a sample ("over" of Porter and Duff, with colors that are not premultiplied).
void cover(Canvas::Sample& io_sample, const Color& color, double opacity) {
  const double together = opacity + io_sample.cover * (1 - opacity);
  if (together <= 0) return;
  io_sample.color = mix(io_sample.color, color, opacity / together);
  io_sample.cover = together;
}

// An outline in canvas coordinates. Distances scale with the placement.
struct PlacedOutline {
  const Outline& outline;
  const Placement& placement;
  double at(Vec2d position) const { return outline.distance(placement.to_local(position)) * placement.scale; }
  // The gradient of the distance by central differences: a unit vector that points away from the shape.
  Vec2d slope(Vec2d position, double step) const {
    return {(at(position + Vec2d{step, 0}) - at(position - Vec2d{step, 0})) / (2 * step),
            (at(position + Vec2d{0, step}) - at(position - Vec2d{0, step})) / (2 * step)};
  }
};

// The fraction of the way from the ink's first color to its second one.
double blend_share(const Outline& outline, Vec2d local, Blend blend) {
  const Vec2d size = glm::max(outline.maxs - outline.mins, Vec2d{1e-6, 1e-6});
  const Vec2d share = (local - outline.mins) / size;
  if (blend == Blend::kDown) return std::clamp(share.y, 0.0, 1.0);
  if (blend == Blend::kAcross) return std::clamp(share.x, 0.0, 1.0);
  return std::clamp(2 * glm::length(share - Vec2d{0.5, 0.5}), 0.0, 1.0);
}

// The brightness that the lit rim adds. The rim's slope is steepest at the edge and falls linearly to 0,
// `raise` pixels inside.
double relief(const PlacedOutline& shape, Vec2d position, double distance, const Ink& ink) {
  const double reach = std::abs(ink.raise);
  if (reach <= 0 || distance < -reach) return 0;
  const double steep = 1 + distance / reach;
  return (ink.raise > 0 ? 1 : -1) * ink.light * std::clamp(steep, 0.0, 1.0) *
         glm::dot(shape.slope(position, 0.2), kLight);
}

// The color of an ink at a position inside its shape: gradient, relief, grain, then stains.
Color shade_ink(const formats::Palette& palette, const PlacedOutline& shape, Vec2d position, double distance,
                const Ink& ink) {
  const double share = blend_share(shape.outline, shape.placement.to_local(position), ink.blend);
  const double by =
      relief(shape, position, distance, ink) + 2 * ink.grain * (noise(position, ink.lump, ink.seed) - 0.5);
  const auto lit = [&](const Tone& tone) { return look_up_color(palette, {tone.ramp, tone.tone + by}); };
  Color color = ink.color.ramp == ink.to.ramp
                    ? lit({ink.color.ramp, ink.color.tone + (ink.to.tone - ink.color.tone) * share})
                    : mix(lit(ink.color), lit(ink.to), share);
  if (!ink.stain) return color;
  constexpr double kSoft = 0.12;
  const double spot = noise(position, ink.stain_lump, ink.seed + 17) - (1 - ink.stained);
  return mix(color, lit(*ink.stain), std::clamp(spot / kSoft + 0.5, 0.0, 1.0));
}

}  // namespace

Color look_up_color(const formats::Palette& palette, const Tone& tone) {
  const double step = std::clamp(tone.tone, 0.0, 1.0) * (static_cast<double>(kRampColors) - 1);
  const auto first = static_cast<std::size_t>(std::floor(step));
  const auto at = [&](std::size_t i) {
    // The last color of the last ramp is the transparent one, which must not be used.
    std::size_t index = static_cast<std::size_t>(tone.ramp) * kRampColors + std::min(i, kRampColors - 1);
    index = std::min<std::size_t>(index, kTransparent - 1);
    return Color{palette[index].r / 255.0, palette[index].g / 255.0, palette[index].b / 255.0};
  };
  return mix(at(first), at(first + 1), step - std::floor(step));
}

Vec2d Placement::to_local(Vec2d position) const {
  const double angle = -turn_deg * std::numbers::pi / 180;
  const Vec2d there = (position - at) / scale;
  return {there.x * std::cos(angle) - there.y * std::sin(angle),
          there.x * std::sin(angle) + there.y * std::cos(angle)};
}

Vec2d Placement::to_canvas(Vec2d position) const {
  const double angle = turn_deg * std::numbers::pi / 180;
  const Vec2d turned{position.x * std::cos(angle) - position.y * std::sin(angle),
                     position.x * std::sin(angle) + position.y * std::cos(angle)};
  return turned * scale + at;
}

Canvas::Canvas(std::int32_t width, std::int32_t height, std::int32_t fineness)
    : width_(width),
      height_(height),
      fineness_(fineness),
      palette_(make_palette()),
      samples_(static_cast<std::size_t>(width * fineness) * static_cast<std::size_t>(height * fineness)) {}

Vec2d Canvas::sample_center(std::int32_t x, std::int32_t y) const {
  return Vec2d{x + 0.5, y + 0.5} / static_cast<double>(fineness_);
}

// The samples that a shape may change: the bounding box of its transformed corners, plus a margin for edge
// and glow.
Canvas::Area Canvas::find_area(const Outline& outline, const Placement& placement, double margin) const {
  Vec2d mins{1e9, 1e9}, maxs{-1e9, -1e9};
  for (const Vec2d& corner : {outline.mins, outline.maxs, Vec2d{outline.mins.x, outline.maxs.y},
                              Vec2d{outline.maxs.x, outline.mins.y}}) {
    mins = glm::min(mins, placement.to_canvas(corner));
    maxs = glm::max(maxs, placement.to_canvas(corner));
  }
  const auto sample = [&](double position, std::int32_t limit) {
    return static_cast<std::int32_t>(std::clamp(position, 0.0, static_cast<double>(limit)) * fineness_);
  };
  return {sample(mins.x - margin, width_), sample(mins.y - margin, height_),
          sample(maxs.x + margin + 1, width_), sample(maxs.y + margin + 1, height_)};
}

void Canvas::paint(const Outline& outline, const Placement& placement, const Ink& ink) {
  const PlacedOutline shape{outline, placement};
  const double margin =
      std::max({ink.edge ? ink.edge_width : 0.0, ink.glow ? ink.glow_reach : 0.0, ink.shadow});
  const Area area = find_area(outline, placement, margin);
  for (std::int32_t y = area.y0; y < area.y1; ++y) {
    for (std::int32_t x = area.x0; x < area.x1; ++x) {
      const Vec2d position = sample_center(x, y);
      Sample& sample = at(x, y);
      const double distance = shape.at(position);
      if (ink.erases) {
        if (distance < 0) sample = {};
        continue;
      }
      const bool is_inside =
          distance < 0 && (ink.holes <= 0 || noise(position, ink.lump, ink.seed + 29) >= ink.holes);
      if (is_inside) {
        cover(sample, shade_ink(palette_, shape, position, distance, ink), ink.opacity);
        sample.ramp = ink.keeps_ramp ? static_cast<std::int16_t>(ink.color.ramp) : std::int16_t{-1};
        continue;
      }
      if (ink.glow && distance < ink.glow_reach) {
        const double far = std::max(distance, 0.0) / ink.glow_reach;
        cover(sample, look_up_color(palette_, *ink.glow), ink.glow_strength * (1 - far) * (1 - far));
      }
      if (ink.shadow > 0 && shape.at(position - Vec2d{ink.shadow, ink.shadow}) < 0)
        cover(sample, Color{0.0}, 0.75 * ink.opacity);
      if (ink.edge && distance >= 0 && distance < ink.edge_width) {
        cover(sample, look_up_color(palette_, *ink.edge), ink.opacity);
        sample.ramp = -1;
      }
    }
  }
}

void Canvas::tint(const Tone& tone, double amount, bool rim) {
  const Color color = look_up_color(palette_, tone);
  const Vec2d middle = Vec2d{width_, height_} * 0.5;
  for (std::int32_t y = 0; y < height_ * fineness_; ++y)
    for (std::int32_t x = 0; x < width_ * fineness_; ++x) {
      const Vec2d out = (sample_center(x, y) - middle) / middle;
      const double share = rim ? std::min(1.0, glm::dot(out, out) / 2) : 1.0;
      at(x, y).color = mix(at(x, y).color, color, amount * share);
    }
}

void Canvas::shade(double by) {
  for (Sample& sample : samples_) sample.color = glm::min(sample.color * by, Color{1.0});
}

void Canvas::weather(double amount, double lump, std::uint64_t seed) {
  for (std::int32_t y = 0; y < height_ * fineness_; ++y)
    for (std::int32_t x = 0; x < width_ * fineness_; ++x) {
      const double by = 1 + 2 * amount * (noise(sample_center(x, y), lump, seed) - 0.5);
      at(x, y).color = glm::min(at(x, y).color * by, Color{1.0});
    }
}

Canvas::Sample Canvas::pixel(std::int32_t x, std::int32_t y) const {
  Sample mean;
  std::int32_t fixed_count = 0, seen_count = 0;
  for (std::int32_t j = y * fineness_; j < (y + 1) * fineness_; ++j)
    for (std::int32_t i = x * fineness_; i < (x + 1) * fineness_; ++i) {
      const Sample& sample =
          samples_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_ * fineness_) +
                   static_cast<std::size_t>(i)];
      mean.color += sample.color * sample.cover;
      mean.cover += sample.cover;
      seen_count += sample.cover > 0 ? 1 : 0;
      if (sample.ramp < 0) continue;
      ++fixed_count;
      mean.ramp = sample.ramp;
    }
  if (mean.cover > 0) mean.color /= mean.cover;
  mean.cover /= fineness_ * fineness_;
  // If only a minority of the samples is bound to a ramp, the pixel may use any.
  if (2 * fixed_count <= seen_count) mean.ramp = -1;
  return mean;
}

}  // namespace temblor::artgen::pictures
