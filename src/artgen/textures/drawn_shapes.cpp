// Shapes with a position: rectangles, discs, lines, stripes, letters; and shapes that select pieces or joints
// of a structure. Each computes the distance from a texel to the edge of the shape, positive inside, like a
// signed distance field. Positions wrap around the texture's sides.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/scripts/noise.h"
#include "artgen/textures/layer.h"
#include "artgen/textures/letters.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// Calls depth(x, y) with the center of each texel.
template <typename Depth>
Cover make_cover(const Surface& surface, Depth depth) {
  Cover cover(surface.width, surface.height);
  for (std::int32_t y = 0; y < cover.height; ++y)
    for (std::int32_t x = 0; x < cover.width; ++x) cover.at(x, y) = depth(x + 0.5, y + 0.5);
  return cover;
}

// The offset from `from` to `to` around the tile in the shorter direction, at most half a period.
double shortest_offset(double from, double to, double period) {
  return wrap(to - from + period / 2, period) - period / 2;
}

// The distance to the nearest side of a box whose upper left corner is (0, 0) and whose corners have a radius
// of `round`.
double depth_in_box(double x, double y, double width, double height, double round) {
  const double dx = std::min(x, width - x), dy = std::min(y, height - y);
  if (dx >= round || dy >= round) return std::min(dx, dy);
  return round - std::sqrt((round - dx) * (round - dx) + (round - dy) * (round - dy));
}

// rect at=8,8 size=48x16 round=2: a rectangle. If it is as long as the surface, it has no edges at those
// sides, so that a band goes around the texture.
Cover cover_rect(Layer& layer, const Surface& surface) {
  const Point at = read_point(layer.arguments, "at", {});
  const Point size = read_extent(layer.arguments, "size", {surface.width * 1.0, surface.height * 1.0});
  const double round = layer.arguments.number("round", 0, 0, 64);
  constexpr double kEndless = 1e6;
  return make_cover(surface, [&](double x, double y) {
    const bool is_row = size.x >= surface.width, is_column = size.y >= surface.height;
    return depth_in_box(is_row ? kEndless : wrap(x - at.x, surface.width),
                        is_column ? kEndless : wrap(y - at.y, surface.height), is_row ? 2 * kEndless : size.x,
                        is_column ? 2 * kEndless : size.y, round);
  });
}

// disc at=32,32 radius=10 inner=6: a disc, or with `inner` a ring.
Cover cover_disc(Layer& layer, const Surface& surface) {
  const Point at = read_point(layer.arguments, "at", {surface.width / 2.0, surface.height / 2.0});
  const double radius = layer.arguments.number("radius", 8, 0.1, 1024);
  const double inner = layer.arguments.number("inner", 0, 0, 1024);
  return make_cover(surface, [&](double x, double y) {
    const double dx = shortest_offset(at.x, x, surface.width), dy = shortest_offset(at.y, y, surface.height);
    const double distance = std::sqrt(dx * dx + dy * dy);
    return inner > 0 ? std::min(radius - distance, distance - inner) : radius - distance;
  });
}

// diamond at=32,32 size=16x24
Cover cover_diamond(Layer& layer, const Surface& surface) {
  const Point at = read_point(layer.arguments, "at", {surface.width / 2.0, surface.height / 2.0});
  const Point size = read_extent(layer.arguments, "size", {16, 16});
  return make_cover(surface, [&](double x, double y) {
    const double dx = std::abs(shortest_offset(at.x, x, surface.width)),
                 dy = std::abs(shortest_offset(at.y, y, surface.height));
    const double shorter = std::min(size.x, size.y) / 2;
    return (1 - dx / (size.x / 2) - dy / (size.y / 2)) * shorter * 0.7;
  });
}

// arch at=16,8 size=32x56: a pointed window or doorway. Its curved part is 0.866 times as high as the arch is
// wide.
Cover cover_arch(Layer& layer, const Surface& surface) {
  const Point at = read_point(layer.arguments, "at", {});
  const Point size = read_extent(layer.arguments, "size", {32, 48});
  return make_cover(surface, [&](double x, double y) {
    const double across = wrap(x - at.x, surface.width), down = wrap(y - at.y, surface.height);
    const double sides = std::min({across, size.x - across, size.y - down});
    // Each side of the point is a circle around the foot of the opposite side, with the arch's width as its
    // radius. They meet at sqrt(3) / 2 of the width above the feet.
    const double foot = size.x * 0.866;
    if (down >= foot) return sides;
    const double rise = foot - down, far = std::max(across, size.x - across);
    return std::min(sides, size.x - std::sqrt(far * far + rise * rise));
  });
}

// line from=8,8 to=56,20 width=2: with round ends. Lines do not wrap around.
Cover cover_line(Layer& layer, const Surface& surface) {
  const Point from = read_point(layer.arguments, "from", {}), to = read_point(layer.arguments, "to", {});
  const double width = layer.arguments.number("width", 2, 0.1, 64);
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double square = std::max(dx * dx + dy * dy, 1e-9);
  return make_cover(surface, [&](double x, double y) {
    const double px = x - from.x, py = y - from.y;
    const double along = std::clamp((px * dx + py * dy) / square, 0.0, 1.0);
    const double ox = px - along * dx, oy = py - along * dy;
    return width / 2 - std::sqrt(ox * ox + oy * oy);
  });
}

// stripes every=16 width=8 at=0 slant=1 along=y: slant=0 is upright, slant=1 runs down to the left at 45
// degrees. The distance is rounded so that the stripes repeat with the texture.
Cover cover_stripes(Layer& layer, const Surface& surface) {
  const double every = layer.arguments.number("every", 16, 1, 1024);
  const double width = layer.arguments.number("width", every / 2, 0.1, 1024);
  const double start = layer.arguments.number("at", 0, -1024, 1024);
  const double slant = layer.arguments.number("slant", 0, -8, 8);
  const bool is_horizontal = layer.arguments.text("along", "y") == "x";
  const std::int32_t side = is_horizontal ? surface.height : surface.width;
  const double period = 1.0 * side / count_repeats(side, every);
  return make_cover(surface, [&](double x, double y) {
    const double across = wrap((is_horizontal ? y + slant * x : x + slant * y) - start, period);
    return std::min(across, width - across);
  });
}

// dots every=16x16 at=4,4 radius=1.5: a grid of dots, such as rivets or holes.
Cover cover_dots(Layer& layer, const Surface& surface) {
  const Point every = read_extent(layer.arguments, "every", {16, 16});
  const Point at = read_point(layer.arguments, "at", {every.x / 2, every.y / 2});
  const double radius = layer.arguments.number("radius", 1.5, 0.1, 64);
  return make_cover(surface, [&](double x, double y) {
    const double dx = shortest_offset(at.x, x, every.x), dy = shortest_offset(at.y, y, every.y);
    return radius - std::sqrt(dx * dx + dy * dy);
  });
}

// text "TO THE PIT" at=4,20 scale=2: letters of 5 x 7 texels with a column between them; centered without
// `at`.
Cover cover_text(Layer& layer, const Surface& surface) {
  const std::string text = layer.arguments.text();
  const std::int32_t scale = layer.arguments.integer("scale", 1, 1, 16);
  const std::int32_t width = measure_letters(text) * scale, height = kLetterHeight * scale;
  for (const char letter : text)
    if (!has_letter(letter))
      layer.arguments.set_error(
          fmt::format("'{}' cannot be written: signs have no such letter", base::quotable({&letter, 1})));
  const Point at =
      read_point(layer.arguments, "at",
                 {std::floor((surface.width - width) / 2.0), std::floor((surface.height - height) / 2.0)});
  return make_cover(surface, [&](double x, double y) {
    const auto column = static_cast<std::int32_t>(std::floor((x - at.x) / scale));
    const auto row = static_cast<std::int32_t>(std::floor((y - at.y) / scale));
    return has_ink(text, column, row) ? 1.0 : 0.0;
  });
}

// trace at=0,32 size=64x20 beats=3 shakes=5 shift=0 width=1.5: a seismograph trace that is quiet and then
// shaken, `beats` times. `shift` moves it sideways, for animations.
Cover cover_trace(Layer& layer, const Surface& surface) {
  const Point at = read_point(layer.arguments, "at", {0, surface.height / 2.0});
  const Point size = read_extent(layer.arguments, "size", {surface.width * 1.0, surface.height / 3.0});
  const std::int32_t beats = layer.arguments.integer("beats", 2, 1, 32);
  const std::int32_t shakes = layer.arguments.integer("shakes", 5, 1, 64);
  const double shift = layer.arguments.number("shift", 0, -1024, 1024);
  const double width = layer.arguments.number("width", 1.5, 0.5, 16);
  const auto height_at = [&](double x) {
    const double along = wrap((x - at.x - shift) / size.x, 1.0);
    const double beat = wrap(along * beats, 1.0);
    const double shaken = std::exp(-18 * (beat - 0.45) * (beat - 0.45));
    return at.y + size.y / 2 * shaken * std::sin(2 * std::numbers::pi * shakes * beat);
  };
  return make_cover(surface, [&](double x, double y) {
    if (x < at.x || x > at.x + size.x) return 0.0;
    // The distance to the curve, sampled two texels to both sides.
    double nearest = 1e9;
    for (double step = -2; step <= 2; step += 0.125) {
      const double dy = y - height_at(x + step);
      nearest = std::min(nearest, std::sqrt(step * step + dy * dy));
    }
    return width / 2 - nearest;
  });
}

// joints wider=1: the gaps between pieces and so many texels of the pieces themselves.
Cover cover_joints(Layer& layer, const Surface& surface) {
  const double wider = layer.arguments.number("wider", 0, -16, 16);
  Cover cover(surface.width, surface.height);
  for (std::size_t i = 0; i < cover.cells.size(); ++i)
    cover.cells[i] = surface.cells[i].rim <= wider ? 1 + wider - surface.cells[i].rim : 0;
  return cover;
}

// some chance=0.3: random whole pieces.
Cover cover_some(Layer& layer, const Surface& surface) {
  const double chance = layer.arguments.number("chance", 0.3, 0, 1);
  Cover cover(surface.width, surface.height);
  for (std::size_t i = 0; i < cover.cells.size(); ++i) {
    const Texel& texel = surface.cells[i];
    cover.cells[i] = hash_noise(texel.piece, 0, layer.seed) < chance ? std::max(texel.rim, 0.0) : 0;
  }
  return cover;
}

constexpr std::array<ShapeKeyword, 11> kDrawnShapes = {{
    {"rect", cover_rect},
    {"disc", cover_disc},
    {"diamond", cover_diamond},
    {"arch", cover_arch},
    {"line", cover_line},
    {"stripes", cover_stripes},
    {"dots", cover_dots},
    {"text", cover_text},
    {"trace", cover_trace},
    {"joints", cover_joints},
    {"some", cover_some},
}};

}  // namespace

std::span<const ShapeKeyword> drawn_keywords() {
  return kDrawnShapes;
}

}  // namespace temblor::artgen
