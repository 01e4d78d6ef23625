// Layers that use the heights and colors painted so far: shading by a light from the upper left, and the glow
// of lamps.
#include <algorithm>
#include <array>
#include <cmath>

#include "artgen/textures/layer.h"
#include "artgen/textures/soften.h"

namespace temblor::artgen {
namespace {

// A surface normal: x right, y down, z toward the viewer.
struct Normal {
  double x = 0, y = 0, z = 1;
};

Normal normalize_normal(Normal normal) {
  const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  return {normal.x / length, normal.y / length, normal.z / length};
}

double dot(const Normal& a, const Normal& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// relief 1 cavity=0.05 shine=0: shades slopes, darkens hollows (by `cavity` per texel of depth), and adds
// highlights, for metal. Slopes come from central differences of the heights. Highlights use the half-vector
// of Blinn's model, with exponent 12. A flat texel keeps its tone.
void paint_relief(Layer& layer, Surface& io_surface) {
  const double strength = layer.arguments.number(0, 8);
  const double cavity = layer.arguments.number("cavity", 0.05, 0, 1);
  const double shine = layer.arguments.number("shine", 0, 0, 2);
  const Normal light = normalize_normal({-0.5, -0.8, 0.9});
  const Normal halfway = normalize_normal({light.x, light.y, light.z + 1});
  const double flat = dot({0, 0, 1}, light), flat_gleam = std::pow(halfway.z, 12);
  const Cover heights = copy_heights(io_surface);
  const Cover soft = soften(heights, 3);
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      Texel& texel = io_surface.at(x, y);
      if (is_fullbright(texel.ramp)) continue;
      const double across = (heights.at(x + 1, y) - heights.at(x - 1, y)) / 2;
      const double down = (heights.at(x, y + 1) - heights.at(x, y - 1)) / 2;
      const Normal normal = normalize_normal({-across * strength, -down * strength, 1});
      const double lit = dot(normal, light) / flat - 1;
      const double gleam = std::pow(std::max(0.0, dot(normal, halfway)), 12) - flat_gleam;
      texel.tone = texel.tone * (1 + 0.6 * lit) + 0.1 * lit + shine * std::max(0.0, gleam);
      texel.tone -= cavity * (soft.at(x, y) - heights.at(x, y));
    }
}

// halo radius=8 by=0.3 ramp=gold: brightens the texels near full-bright ones, falling off with the square of
// the distance left. `ramp` changes the color of the brightest part.
void paint_halo(Layer& layer, Surface& io_surface) {
  const double radius = layer.arguments.number("radius", 8, 1, 64);
  const double by = layer.arguments.number("by", 0.3, 0, 1);
  const bool has_tint = layer.arguments.has("ramp");
  const Ramp tint = read_ramp(layer.arguments, "ramp", Ramp::kGold);
  Cover lamps(io_surface.width, io_surface.height);
  for (std::size_t i = 0; i < lamps.cells.size(); ++i)
    lamps.cells[i] = is_fullbright(io_surface.cells[i].ramp) && !io_surface.cells[i].hole ? 1 : 0;
  const auto reach = static_cast<std::int32_t>(radius);
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      Texel& texel = io_surface.at(x, y);
      if (is_fullbright(texel.ramp)) continue;
      double nearest = radius;
      for (std::int32_t dy = -reach; dy <= reach; ++dy)
        for (std::int32_t dx = -reach; dx <= reach; ++dx)
          if (lamps.at(x + dx, y + dy) > 0) nearest = std::min(nearest, std::sqrt(1.0 * (dx * dx + dy * dy)));
      const double light = 1 - nearest / radius;
      texel.tone += by * light * light;
      if (has_tint && light > 0.35) texel.ramp = tint;
    }
}

constexpr std::array<LayerKeyword, 2> kReliefKeywords = {{
    {"relief", paint_relief},
    {"halo", paint_halo},
}};

}  // namespace

std::span<const LayerKeyword> relief_keywords() {
  return kReliefKeywords;
}

}  // namespace temblor::artgen
