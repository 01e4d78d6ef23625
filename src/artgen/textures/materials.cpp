// Texel layers that change the tone or the height everywhere: the material of a wall before it has a
// structure.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "artgen/scripts/noise.h"
#include "artgen/textures/layer.h"

namespace temblor::artgen {
namespace {

// Calls `change(texel, noise)` for every texel; noise is about -1 to 1.
template <typename Change>
void change_with_noise(const NoiseLumps& lumps, std::uint64_t seed, Surface& io_surface, Change change) {
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      const double noise =
          tiling_noise((x + 0.5) / io_surface.width, (y + 0.5) / io_surface.height, lumps, seed);
      change(io_surface.at(x, y), 2 * noise - 1);
    }
}

// fill RAMP TONE: a uniform color. Removes holes.
void paint_fill(Layer& layer, Surface& io_surface) {
  const std::string name = layer.arguments.text();
  const std::optional<Ramp> ramp = find_ramp(name);
  if (!ramp) layer.arguments.set_error("a fill needs a ramp of the palette and a tone: fill slate 0.4");
  const double tone = layer.arguments.number(0, 1);
  for (Texel& texel : io_surface.cells) {
    texel.ramp = ramp.value_or(Ramp::kGray);
    texel.tone = tone;
    texel.hole = false;
  }
}

// noise by=0.15 lump=16 octaves=3: lighter and darker lumps. `lump` is their size in texels, or WxH.
void paint_noise(Layer& layer, Surface& io_surface) {
  const double by = layer.arguments.number("by", 0.15, -2, 2);
  change_with_noise(read_lumps(layer.arguments, io_surface, {16, 16}, 3), layer.seed, io_surface,
                    [&](Texel& texel, double noise) { texel.tone += by * noise; });
}

// bumps by=1 lump=8 octaves=3: lumps of height, in texels.
void paint_bumps(Layer& layer, Surface& io_surface) {
  const double by = layer.arguments.number("by", 1, -32, 32);
  change_with_noise(read_lumps(layer.arguments, io_surface, {8, 8}, 3), layer.seed, io_surface,
                    [&](Texel& texel, double noise) { texel.height += by * noise; });
}

// speckle chance=0.1 by=0.1: random single texels that are lighter or darker.
void paint_speckle(Layer& layer, Surface& io_surface) {
  const double chance = layer.arguments.number("chance", 0.1, 0, 1);
  const double by = layer.arguments.number("by", 0.1, -1, 1);
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x)
      if (hash_noise(x, y, layer.seed) < chance)
        io_surface.at(x, y).tone += by * (2 * hash_noise(x, y, layer.seed + 1) - 1);
}

// grain by=0.1 lump=3x48 bend=2: wood fibers, bent by so many texels. Each piece, such as a board, has its
// own pattern. The fibers run along the longer side of a lump.
void paint_grain(Layer& layer, Surface& io_surface) {
  const double by = layer.arguments.number("by", 0.1, -1, 1);
  const double bend = layer.arguments.number("bend", 2, 0, 16);
  NoiseLumps lumps = read_lumps(layer.arguments, io_surface, {3, 48}, 3);
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      Texel& texel = io_surface.at(x, y);
      const std::uint64_t seed = layer.seed + static_cast<std::uint64_t>(texel.piece) * 977;
      const double across = (x + 0.5) / io_surface.width, down = (y + 0.5) / io_surface.height;
      const double bent = tiling_noise(across, down, {3, 3, 2}, seed + 31) - 0.5;
      const bool is_horizontal = lumps.across < lumps.down;
      const double noise = is_horizontal
                               ? tiling_noise(across, down + bend * bent / io_surface.height, lumps, seed)
                               : tiling_noise(across + bend * bent / io_surface.width, down, lumps, seed);
      texel.tone += by * (2 * noise - 1);
    }
}

// gradient from=0.1 to=-0.1 along=y: adds a tone that changes from top to bottom; along=x: from left to
// right.
void paint_gradient(Layer& layer, Surface& io_surface) {
  const double from = layer.arguments.number("from", 0, -1, 1);
  const double to = layer.arguments.number("to", 0, -1, 1);
  const bool is_across = layer.arguments.text("along", "y") == "x";
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      const double fraction = is_across ? (x + 0.5) / io_surface.width : (y + 0.5) / io_surface.height;
      io_surface.at(x, y).tone += from + (to - from) * fraction;
    }
}

// waves by=0.1 count=3 most=4: adds sine waves in random directions. Each has a whole number of crests along
// both sides, at most `most`, so that the texture tiles.
void paint_waves(Layer& layer, Surface& io_surface) {
  const double by = layer.arguments.number("by", 0.1, -1, 1);
  const std::int32_t count = layer.arguments.integer("count", 3, 1, 8);
  const std::int32_t max_crests = layer.arguments.integer("most", 4, 1, 32);
  for (std::int32_t wave = 0; wave < count; ++wave) {
    const auto times = [&](std::int32_t axis) {
      return std::floor((2 * hash_noise(wave, axis, layer.seed) - 1) * max_crests + 0.5);
    };
    const double across = times(0), down = times(1) == 0 ? 1 : times(1);
    const double start = hash_noise(wave, 2, layer.seed);
    for (std::int32_t y = 0; y < io_surface.height; ++y)
      for (std::int32_t x = 0; x < io_surface.width; ++x) {
        const double turns =
            start + across * (x + 0.5) / io_surface.width + down * (y + 0.5) / io_surface.height;
        io_surface.at(x, y).tone += by * std::sin(2 * std::numbers::pi * turns);
      }
  }
}

// tones keep=0.2..0.8: clamps the tones to a range.
void paint_tones(Layer& layer, Surface& io_surface) {
  const auto [lowest, highest] = layer.arguments.range("keep", {0, 1});
  for (Texel& texel : io_surface.cells) texel.tone = std::min(std::max(texel.tone, lowest), highest);
}

// shift by=0,16: moves everything painted so far; it wraps around.
void paint_shift(Layer& layer, Surface& io_surface) {
  const Point by = read_point(layer.arguments, "by", {});
  const auto across = static_cast<std::int32_t>(by.x), down = static_cast<std::int32_t>(by.y);
  const Surface before = io_surface;
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) io_surface.at(x, y) = before.at(x - across, y - down);
}

constexpr std::array<LayerKeyword, 9> kMaterialKeywords = {{
    {"fill", paint_fill},
    {"noise", paint_noise},
    {"bumps", paint_bumps},
    {"speckle", paint_speckle},
    {"grain", paint_grain},
    {"gradient", paint_gradient},
    {"waves", paint_waves},
    {"tones", paint_tones},
    {"shift", paint_shift},
}};

}  // namespace

std::span<const LayerKeyword> material_keywords() {
  return kMaterialKeywords;
}

}  // namespace temblor::artgen
