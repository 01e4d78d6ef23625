// Random shapes: patches of moss, veins, streaks of rain, cracks, pebbles; and worn edges and hollows, which
// depend on the heights painted so far.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "artgen/scripts/noise.h"
#include "artgen/textures/layer.h"
#include "artgen/textures/soften.h"

namespace temblor::artgen {
namespace {

// Noise for every texel, in [0, 1).
Cover make_noise(const Surface& surface, const NoiseLumps& lumps, std::uint64_t seed) {
  Cover noise(surface.width, surface.height);
  for (std::int32_t y = 0; y < noise.height; ++y)
    for (std::int32_t x = 0; x < noise.width; ++x)
      noise.at(x, y) = tiling_noise((x + 0.5) / noise.width, (y + 0.5) / noise.height, lumps, seed);
  return noise;
}

// Keeps the highest values so that the fraction `cover` of all texels lies above 0. `scale` converts the
// values to a depth in texels. The threshold comes from the sorted values, so the covered area is exact
// whatever the noise is.
Cover keep_highest(Cover values, double cover, double scale) {
  std::vector<double> sorted = values.cells;
  std::sort(sorted.begin(), sorted.end());
  const auto below = static_cast<std::size_t>(std::lround((1 - cover) * static_cast<double>(sorted.size())));
  const double threshold = below < sorted.size() ? sorted[below] : sorted.back() + 1;
  for (double& value : values.cells) value = value >= threshold ? 0.01 + (value - threshold) * scale : 0;
  return values;
}

// patches cover=0.3 lump=16 low=0 bottom=0: covers the fraction `cover` of the surface in blotches. low=1
// prefers hollows, low=-1 heights, and bottom=1 the lower part of the texture.
Cover cover_patches(Layer& layer, const Surface& surface) {
  const double share = layer.arguments.number("cover", 0.3, 0, 1);
  const NoiseLumps lumps = read_lumps(layer.arguments, surface, {16, 16}, 4);
  const double low = layer.arguments.number("low", 0, -8, 8);
  const double bottom = layer.arguments.number("bottom", 0, -8, 8);
  Cover noise = make_noise(surface, lumps, layer.seed);
  const Cover heights = copy_heights(surface);
  const Cover soft = soften(heights, 3);
  for (std::int32_t y = 0; y < noise.height; ++y)
    for (std::int32_t x = 0; x < noise.width; ++x) {
      noise.at(x, y) += 0.2 * low * (soft.at(x, y) - heights.at(x, y));
      noise.at(x, y) += 0.5 * bottom * ((y + 0.5) / noise.height - 0.5);
    }
  return keep_highest(std::move(noise), share, 0.5 * surface.width / lumps.across);
}

// veins cover=0.1 lump=24: winding lines, where the noise is near its middle value.
Cover cover_veins(Layer& layer, const Surface& surface) {
  const double share = layer.arguments.number("cover", 0.1, 0, 1);
  const NoiseLumps lumps = read_lumps(layer.arguments, surface, {24, 24}, 3);
  Cover noise = make_noise(surface, lumps, layer.seed);
  for (double& value : noise.cells) value = -std::abs(value - 0.5);
  return keep_highest(std::move(noise), share, 2.0 * surface.width / lumps.across);
}

// runs count=8 length=8..40 width=1..3 at=0..64: streaks that run down from the rows `at`, become narrower,
// and fade.
Cover cover_runs(Layer& layer, const Surface& surface) {
  const std::int32_t count = layer.arguments.integer("count", 8, 0, 256);
  const auto [shortest, longest] = layer.arguments.range("length", {8, 32});
  const auto [thinnest, widest] = layer.arguments.range("width", {1, 3});
  const auto [highest_start, lowest_start] = layer.arguments.range("at", {0, surface.height});
  Cover cover(surface.width, surface.height);
  for (std::int32_t run = 0; run < count; ++run) {
    const auto random = [&](std::int32_t which, double from, double to) {
      return from + (to - from) * hash_noise(run, which, layer.seed);
    };
    const double x0 = random(0, 0, surface.width);
    const double y0 = random(1, highest_start, lowest_start);
    const double length = random(2, shortest, longest), width = random(3, thinnest, widest);
    for (std::int32_t step = 0; step < static_cast<std::int32_t>(length); ++step) {
      const double left = 1 - step / length;
      const auto y = static_cast<std::int32_t>(y0) + step;
      const double wander = hash_noise(run, 8 + step / 3, layer.seed) - 0.5;
      for (std::int32_t dx = -8; dx <= 8; ++dx) {
        const double depth = std::min(width / 2 * (0.4 + 0.6 * left) - std::abs(dx + wander), 1.0) + 0.5;
        double& texel = cover.at(static_cast<std::int32_t>(x0) + dx, y);
        if (depth > 0) texel = std::max(texel, std::min(depth, 1.0) * (0.15 + 0.85 * left));
      }
    }
  }
  return cover;
}

// cracks count=2 length=40: random walks that turn slightly with each texel and sometimes branch into walks
// of half the remaining length. At most 256 walks.
Cover cover_cracks(Layer& layer, const Surface& surface) {
  const std::int32_t count = layer.arguments.integer("count", 2, 0, 64);
  const std::int32_t length = layer.arguments.integer("length", 40, 1, 1024);
  Cover cover(surface.width, surface.height);
  struct Walk {
    double x, y, turn;
    std::int32_t left, number;
  };
  std::vector<Walk> walks;
  for (std::int32_t crack = 0; crack < count; ++crack)
    walks.push_back({hash_noise(crack, 0, layer.seed) * surface.width,
                     hash_noise(crack, 1, layer.seed) * surface.height,
                     hash_noise(crack, 2, layer.seed) * 2 * std::numbers::pi, length, crack});
  for (std::size_t next = 0; next < walks.size() && next < 256; ++next) {
    Walk walk = walks[next];
    for (; walk.left > 0; --walk.left) {
      walk.turn += 1.1 * (hash_noise(walk.number, 10 + walk.left, layer.seed) - 0.5);
      walk.x += std::cos(walk.turn);
      walk.y += std::sin(walk.turn);
      cover.at(static_cast<std::int32_t>(std::floor(walk.x)), static_cast<std::int32_t>(std::floor(walk.y))) =
          1;
      if (walk.left > 8 && hash_noise(walk.number, 2000 + walk.left, layer.seed) < 0.05)
        walks.push_back({walk.x, walk.y, walk.turn + (walk.left % 2 == 0 ? 0.9 : -0.9), walk.left / 2,
                         walk.number * 31 + walk.left});
    }
  }
  return cover;
}

// scatter count=20 radius=1..3: random discs. With a bevel as large as the radius they become domes.
Cover cover_scatter(Layer& layer, const Surface& surface) {
  const std::int32_t count = layer.arguments.integer("count", 20, 0, 4096);
  const auto [smallest, largest] = layer.arguments.range("radius", {1, 3});
  Cover cover(surface.width, surface.height);
  for (std::int32_t thing = 0; thing < count; ++thing) {
    const double x = hash_noise(thing, 0, layer.seed) * surface.width;
    const double y = hash_noise(thing, 1, layer.seed) * surface.height;
    const double radius = smallest + (largest - smallest) * hash_noise(thing, 2, layer.seed);
    const auto reach = static_cast<std::int32_t>(radius) + 1;
    const auto left = static_cast<std::int32_t>(x), top = static_cast<std::int32_t>(y);
    for (std::int32_t dy = -reach; dy <= reach; ++dy)
      for (std::int32_t dx = -reach; dx <= reach; ++dx) {
        const double ox = left + dx + 0.5 - x, oy = top + dy + 0.5 - y;
        double& depth = cover.at(left + dx, top + dy);
        depth = std::max(depth, radius - std::sqrt(ox * ox + oy * oy));
      }
  }
  return cover;
}

// strands count=4 width=2 sway=4: stems from top to bottom. They sway in whole sine waves, so that they meet
// themselves at the upper side.
Cover cover_strands(Layer& layer, const Surface& surface) {
  const std::int32_t count = layer.arguments.integer("count", 4, 1, 64);
  const double width = layer.arguments.number("width", 2, 0.5, 32);
  const double sway = layer.arguments.number("sway", 4, 0, 64);
  Cover cover(surface.width, surface.height);
  for (std::int32_t strand = 0; strand < count; ++strand) {
    const auto random = [&](std::int32_t which) { return hash_noise(strand, which, layer.seed); };
    const double middle = (strand + 0.2 + 0.6 * random(0)) * surface.width / count;
    for (std::int32_t y = 0; y < cover.height; ++y) {
      const double turn = 2 * std::numbers::pi * (y + 0.5) / cover.height;
      const double x = middle + sway * (0.7 * std::sin(turn + 6.3 * random(1)) +
                                        0.3 * std::sin(3 * turn + 6.3 * random(2)));
      for (std::int32_t dx = -16; dx <= 16; ++dx) {
        const double column = std::floor(x) + dx;
        double& depth = cover.at(static_cast<std::int32_t>(column), y);
        depth = std::max(depth, width / 2 - std::abs(column + 0.5 - x));
      }
    }
  }
  return cover;
}

// edges by=0.3 uneven=0.3: texels that are at least `by` higher than their surroundings, with noise. hollows:
// the same for lower ones, with `sign` -1.
Cover cover_bulges(Layer& layer, const Surface& surface, double sign) {
  const double by = layer.arguments.number("by", 0.3, 0, 16);
  const double uneven = layer.arguments.number("uneven", 0.3, 0, 4);
  const Cover heights = copy_heights(surface);
  const Cover soft = soften(heights, 2);
  const Cover noise = make_noise(surface, make_lumps(surface, {8, 8}, 3), layer.seed);
  Cover cover(surface.width, surface.height);
  for (std::size_t i = 0; i < cover.cells.size(); ++i)
    cover.cells[i] = sign * (heights.cells[i] - soft.cells[i]) - by + 2 * uneven * (noise.cells[i] - 0.5);
  return cover;
}
Cover cover_edges(Layer& layer, const Surface& surface) {
  return cover_bulges(layer, surface, 1);
}
Cover cover_hollows(Layer& layer, const Surface& surface) {
  return cover_bulges(layer, surface, -1);
}

constexpr std::array<ShapeKeyword, 8> kGrownShapes = {{
    {"patches", cover_patches},
    {"veins", cover_veins},
    {"runs", cover_runs},
    {"cracks", cover_cracks},
    {"scatter", cover_scatter},
    {"strands", cover_strands},
    {"edges", cover_edges},
    {"hollows", cover_hollows},
}};

}  // namespace

std::span<const ShapeKeyword> grown_keywords() {
  return kGrownShapes;
}

}  // namespace temblor::artgen
