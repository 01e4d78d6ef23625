// Layers that divide the surface into pieces (bricks, boards, cobbles) with joints between: each piece gets a
// number, a tone and a height of its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "artgen/scripts/noise.h"
#include "artgen/textures/layer.h"

namespace temblor::artgen {
namespace {

// Where a place lies in its piece.
struct PiecePlace {
  std::int32_t piece = 0;
  double edge = 0;              // texels to the nearest edge
  double across = 0, down = 0;  // from the piece's middle, texels
};

// What all structures know.
struct Laying {
  double joint = 1.5;  // texels between two pieces
  double raise = 2, bevel = 2;
  double vary = 0.1;  // tone
  double tilt = 0;    // texels of height at a place ten texels from the middle
  double rough = 0;   // texels by which edges wander
  double lump = 8;
};

Laying laying_of(Arguments& arguments, const Laying& otherwise) {
  Laying laying = otherwise;
  laying.joint = arguments.number("joint", otherwise.joint, 0, 16);
  laying.raise = arguments.number("raise", otherwise.raise, -32, 32);
  laying.bevel = arguments.number("bevel", otherwise.bevel, 0.1, 64);
  laying.vary = arguments.number("vary", otherwise.vary, 0, 1);
  laying.tilt = arguments.number("tilt", otherwise.tilt, 0, 16);
  laying.rough = arguments.number("rough", otherwise.rough, 0, 16);
  laying.lump = arguments.number("lump", otherwise.lump, 2, 256);
  return laying;
}

double signed_noise(std::int32_t number, std::int32_t which, std::uint64_t seed) {
  return 2 * hash_noise(number, which, seed) - 1;
}

// From 0 at a piece's edge to 1 where its face begins, rounded.
double rounded(double fraction) {
  const double rest = 1 - std::clamp(fraction, 0.0, 1.0);
  return std::sqrt(std::max(0.0, 1 - rest * rest));
}

// `place_of(x, y)` tells where a place lies.
template <typename PlaceOf>
void lay_pieces(const Laying& laying, std::uint64_t seed, Surface& io_surface, PlaceOf place_of) {
  const std::int32_t lumps_across = std::max(1, static_cast<std::int32_t>(io_surface.width / laying.lump));
  const std::int32_t lumps_down = std::max(1, static_cast<std::int32_t>(io_surface.height / laying.lump));
  const NoiseLumps lumps{lumps_across, lumps_down, 2};
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      const double across = (x + 0.5) / io_surface.width, down = (y + 0.5) / io_surface.height;
      const double dx = laying.rough * (2 * tiling_noise(across, down, lumps, seed + 11) - 1);
      const double dy = laying.rough * (2 * tiling_noise(across, down, lumps, seed + 12) - 1);
      const PiecePlace place = place_of(x + 0.5 + dx, y + 0.5 + dy);
      Texel& texel = io_surface.at(x, y);
      texel.piece = place.piece;
      texel.rim = place.edge - laying.joint / 2;
      if (texel.rim <= 0) continue;
      texel.tone += laying.vary * signed_noise(place.piece, 1, seed);
      const double lean =
          place.across * signed_noise(place.piece, 2, seed) + place.down * signed_noise(place.piece, 3, seed);
      texel.height += laying.raise * rounded(texel.rim / laying.bevel) + laying.tilt * lean / 10;
    }
}

std::int32_t whole(double value) {
  return static_cast<std::int32_t>(value);
}

PiecePlace place_in_box(std::int32_t piece, double x, double y, double width, double height) {
  return {piece, std::min({x, y, width - x, height - y}), x - width / 2, y - height / 2};
}

// bricks width=32 height=16 shift=0.5: courses of equal ones; shift=0 makes plates and tiles.
void paint_bricks(Layer& layer, Surface& io_surface) {
  const double width = layer.arguments.number("width", 32, 2, 1024);
  const double height = layer.arguments.number("height", 16, 2, 1024);
  const double shift = layer.arguments.number("shift", 0.5, 0, 1);
  const std::int32_t columns = times_in(io_surface.width, width);
  const std::int32_t rows = times_in(io_surface.height, height);
  const double brick_width = 1.0 * io_surface.width / columns, brick_height = 1.0 * io_surface.height / rows;
  lay_pieces(laying_of(layer.arguments, {}), layer.seed, io_surface, [&](double x, double y) {
    const double down = wrapped(y, io_surface.height);
    const std::int32_t row = std::min(whole(down / brick_height), rows - 1);
    const double across = wrapped(x + row * shift * brick_width, io_surface.width);
    const std::int32_t column = std::min(whole(across / brick_width), columns - 1);
    return place_in_box(row * columns + column, across - column * brick_width, down - row * brick_height,
                        brick_width, brick_height);
  });
}

// A row of stones or boards: where each begins, sorted, in texels; the last one goes round the edge.
struct Course {
  double top = 0, height = 0;
  std::vector<double> starts;
};

PiecePlace place_in_course(const Course& course, std::int32_t first_piece, double along, double across,
                           double length) {
  const std::size_t count = course.starts.size();
  const double first = course.starts.front();
  const double from_first = wrapped(along - first, length);
  std::size_t i = 0;
  while (i + 1 < count && course.starts[i + 1] - first <= from_first) ++i;
  const double end = i + 1 < count ? course.starts[i + 1] - first : length;
  const double start = course.starts[i] - first;
  return place_in_box(first_piece + whole(static_cast<double>(i)), from_first - start, across - course.top,
                      end - start, course.height);
}

// Courses of heights that differ by `uneven` of the mean, each cut into `count` pieces.
std::vector<Course> make_courses(std::int32_t count, std::pair<double, double> pieces, double uneven,
                                 double height, double length, std::uint64_t seed) {
  std::vector<double> shares;
  double sum = 0;
  for (std::int32_t row = 0; row < count; ++row) {
    shares.push_back(1 + uneven * signed_noise(row, 10, seed));
    sum += shares.back();
  }
  std::vector<Course> courses;
  double top = 0;
  for (std::int32_t row = 0; row < count; ++row) {
    Course course{top, shares[static_cast<std::size_t>(row)] / sum * height, {}};
    const std::int32_t cuts =
        std::max(1, whole(pieces.first + hash_noise(row, 11, seed) * (pieces.second - pieces.first + 1)));
    const double offset = hash_noise(row, 12, seed) * length;
    for (std::int32_t cut = 0; cut < cuts; ++cut)
      course.starts.push_back(offset +
                              (cut + 0.5 * uneven * signed_noise(row * 64 + cut, 13, seed)) * length / cuts);
    courses.push_back(std::move(course));
    top += courses.back().height;
  }
  return courses;
}

void paint_courses(Layer& layer, const Laying& otherwise, std::int32_t usual_rows, bool stands,
                   double usual_uneven, Surface& io_surface) {
  const std::int32_t rows = layer.arguments.integer("rows", usual_rows, 1, 64);
  const std::pair<double, double> pieces = layer.arguments.range("pieces", {1, stands ? 1 : 3});
  const double uneven = layer.arguments.number("uneven", usual_uneven, 0, 0.9);
  if (pieces.first < 1 || pieces.second < pieces.first || pieces.second > 32)
    layer.arguments.complain("pieces is a range within 1..32");
  const double length = stands ? io_surface.height : io_surface.width;
  const double height = stands ? io_surface.width : io_surface.height;
  const std::vector<Course> courses = make_courses(rows, pieces, uneven, height, length, layer.seed);
  lay_pieces(laying_of(layer.arguments, otherwise), layer.seed, io_surface, [&](double x, double y) {
    const double across = wrapped(stands ? x : y, height);
    std::size_t row = 0;
    while (row + 1 < courses.size() && courses[row + 1].top <= across) ++row;
    return place_in_course(courses[row], whole(static_cast<double>(row)) * 64, stands ? y : x, across,
                           length);
  });
}

// blocks rows=3 pieces=1..3 uneven=0.3: courses of stones of different sizes.
void paint_blocks(Layer& layer, Surface& io_surface) {
  paint_courses(layer, {}, 3, false, 0.3, io_surface);
}

// planks rows=4 along=y pieces=1: boards that stand (or lie: along=x).
void paint_planks(Layer& layer, Surface& io_surface) {
  const bool stands = layer.arguments.text("along", "y") != "x";
  paint_courses(layer, {1, 1.5, 1.2, 0.08, 0, 0, 8}, 4, stands, 0.1, io_surface);
}

struct Site {
  double x = 0, y = 0;
};

// cells columns=5 rows=5 uneven=0.8: round stones, scales or facets, each the places nearest to its middle.
void paint_cells(Layer& layer, Surface& io_surface) {
  const std::int32_t columns = layer.arguments.integer("columns", 5, 2, 32);
  const std::int32_t rows = layer.arguments.integer("rows", 5, 2, 32);
  const double uneven = layer.arguments.number("uneven", 0.8, 0, 1);
  const double cell_width = 1.0 * io_surface.width / columns, cell_height = 1.0 * io_surface.height / rows;
  const auto site = [&](std::int32_t column, std::int32_t row) {
    const std::int32_t piece =
        ((row % rows + rows) % rows) * columns + (column % columns + columns) % columns;
    const double stagger = row % 2 == 0 ? 0.0 : 0.5;
    return Site{(column + 0.5 + (rows % 2 == 0 ? stagger - 0.25 : 0) +
                 uneven / 2 * signed_noise(piece, 20, layer.seed)) *
                    cell_width,
                (row + 0.5 + uneven / 2 * signed_noise(piece, 21, layer.seed)) * cell_height};
  };
  lay_pieces(
      laying_of(layer.arguments, {1.5, 3, 6, 0.1, 0, 0, 8}), layer.seed, io_surface, [&](double x, double y) {
        const std::int32_t column = whole(std::floor(x / cell_width)),
                           row = whole(std::floor(y / cell_height));
        Site nearest;
        double best = std::numeric_limits<double>::max();
        std::int32_t piece = 0;
        const auto each_site = [&](auto visit) {
          for (std::int32_t dr = -2; dr <= 2; ++dr)
            for (std::int32_t dc = -2; dc <= 2; ++dc)
              visit(column + dc, row + dr, site(column + dc, row + dr));
        };
        each_site([&](std::int32_t at_column, std::int32_t at_row, const Site& place) {
          const double square = (place.x - x) * (place.x - x) + (place.y - y) * (place.y - y);
          if (square >= best) return;
          best = square;
          nearest = place;
          piece = ((at_row % rows + rows) % rows) * columns + (at_column % columns + columns) % columns;
        });
        double edge = std::numeric_limits<double>::max();
        each_site([&](std::int32_t, std::int32_t, const Site& place) {
          const double dx = place.x - nearest.x, dy = place.y - nearest.y;
          const double apart = std::sqrt(dx * dx + dy * dy);
          if (apart < 1e-6) return;
          const double square = (place.x - x) * (place.x - x) + (place.y - y) * (place.y - y);
          edge = std::min(edge, (square - best) / (2 * apart));
        });
        return PiecePlace{piece, edge, x - nearest.x, y - nearest.y};
      });
}

// ribs every=8 along=y raise=2: rods side by side, half round, without joints. along=y: they stand.
void paint_ribs(Layer& layer, Surface& io_surface) {
  const double every = layer.arguments.number("every", 8, 1, 1024);
  const double raise = layer.arguments.number("raise", every / 4, -64, 64);
  const bool stands = layer.arguments.text("along", "y") != "x";
  const std::int32_t side = stands ? io_surface.width : io_surface.height;
  const double period = 1.0 * side / times_in(side, every);
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      const double across = wrapped((stands ? x : y) + 0.5, period) / period * 2 - 1;
      Texel& texel = io_surface.at(x, y);
      texel.height += raise * std::sqrt(std::max(0.0, 1 - across * across));
      texel.piece = whole(((stands ? x : y) + 0.5) / period);
      texel.rim = (1 - std::abs(across)) * period / 2;
    }
}

constexpr std::array<LayerWord, 5> kStructureWords = {{
    {"bricks", paint_bricks},
    {"blocks", paint_blocks},
    {"planks", paint_planks},
    {"cells", paint_cells},
    {"ribs", paint_ribs},
}};

}  // namespace

std::span<const LayerWord> structure_words() {
  return kStructureWords;
}

}  // namespace temblor::artgen
