// Structure layers divide the surface into pieces (bricks, boards, cobbles) with joints between them. Each
// piece gets a number, a random tone, and a random tilt. Every structure only has to find the piece that a
// point belongs to; lay_pieces does the rest. Later layers use the pieces: `joints` and `some` select them,
// `grain` differs between them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "artgen/scripts/noise.h"
#include "artgen/textures/layer.h"

namespace temblor::artgen {
namespace {

// A point relative to the piece that contains it, in texels.
struct PiecePosition {
  std::int32_t piece = 0;
  // The distance to the piece's nearest edge.
  double edge = 0;
  // The offset from the piece's center.
  double across = 0, down = 0;
};

// The settings that all structures accept.
struct PieceSettings {
  // The width of the joints in texels.
  double joint = 1.5;
  // The height of a piece above the joints, and the distance over which it rises; texels.
  double raise = 2, bevel = 2;
  // How much the tones of pieces differ.
  double vary = 0.1;
  // The height difference in texels, ten texels from the center of a piece, of the strongest tilt.
  double tilt = 0;
  // How far edges deviate from straight lines, in texels, in waves that are `lump` texels long.
  double rough = 0;
  double lump = 8;
};

PieceSettings read_piece_settings(Arguments& arguments, const PieceSettings& fallback) {
  PieceSettings settings = fallback;
  settings.joint = arguments.number("joint", fallback.joint, 0, 16);
  settings.raise = arguments.number("raise", fallback.raise, -32, 32);
  settings.bevel = arguments.number("bevel", fallback.bevel, 0.1, 64);
  settings.vary = arguments.number("vary", fallback.vary, 0, 1);
  settings.tilt = arguments.number("tilt", fallback.tilt, 0, 16);
  settings.rough = arguments.number("rough", fallback.rough, 0, 16);
  settings.lump = arguments.number("lump", fallback.lump, 2, 256);
  return settings;
}

// A random number from -1 to 1 for a piece. `which` selects one of several independent numbers.
double signed_noise(std::int32_t number, std::int32_t which, std::uint64_t seed) {
  return 2 * hash_noise(number, which, seed) - 1;
}

// The height of a rounded edge: a quarter circle from 0 at the edge to 1 at `fraction` 1 and beyond.
double round_profile(double fraction) {
  const double rest = 1 - std::clamp(fraction, 0.0, 1.0);
  return std::sqrt(std::max(0.0, 1 - rest * rest));
}

// Assigns every texel to a piece. `locate(x, y)` returns the PiecePosition of a point. Noise moves the points
// first, which makes the edges uneven.
template <typename Locate>
void lay_pieces(const PieceSettings& settings, std::uint64_t seed, Surface& io_surface, Locate locate) {
  const std::int32_t lumps_across = std::max(1, static_cast<std::int32_t>(io_surface.width / settings.lump));
  const std::int32_t lumps_down = std::max(1, static_cast<std::int32_t>(io_surface.height / settings.lump));
  const NoiseLumps lumps{lumps_across, lumps_down, 2};
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      const double across = (x + 0.5) / io_surface.width, down = (y + 0.5) / io_surface.height;
      const double dx = settings.rough * (2 * tiling_noise(across, down, lumps, seed + 11) - 1);
      const double dy = settings.rough * (2 * tiling_noise(across, down, lumps, seed + 12) - 1);
      const PiecePosition position = locate(x + 0.5 + dx, y + 0.5 + dy);
      Texel& texel = io_surface.at(x, y);
      texel.piece = position.piece;
      texel.rim = position.edge - settings.joint / 2;
      if (texel.rim <= 0) continue;
      texel.tone += settings.vary * signed_noise(position.piece, 1, seed);
      const double lean = position.across * signed_noise(position.piece, 2, seed) +
                          position.down * signed_noise(position.piece, 3, seed);
      texel.height += settings.raise * round_profile(texel.rim / settings.bevel) + settings.tilt * lean / 10;
    }
}

std::int32_t to_int(double value) {
  return static_cast<std::int32_t>(value);
}

// The position in a rectangular piece; x and y are relative to its upper left corner.
PiecePosition locate_in_box(std::int32_t piece, double x, double y, double width, double height) {
  return {piece, std::min({x, y, width - x, height - y}), x - width / 2, y - height / 2};
}

// bricks width=32 height=16 shift=0.5: rows of equal bricks; each row is shifted by a part of a brick.
// shift=0 makes tiles. Sizes are rounded so that a whole number of bricks fits.
void paint_bricks(Layer& layer, Surface& io_surface) {
  const double width = layer.arguments.number("width", 32, 2, 1024);
  const double height = layer.arguments.number("height", 16, 2, 1024);
  const double shift = layer.arguments.number("shift", 0.5, 0, 1);
  const std::int32_t columns = count_repeats(io_surface.width, width);
  const std::int32_t rows = count_repeats(io_surface.height, height);
  const double brick_width = 1.0 * io_surface.width / columns, brick_height = 1.0 * io_surface.height / rows;
  lay_pieces(read_piece_settings(layer.arguments, {}), layer.seed, io_surface, [&](double x, double y) {
    const double down = wrap(y, io_surface.height);
    const std::int32_t row = std::min(to_int(down / brick_height), rows - 1);
    const double across = wrap(x + row * shift * brick_width, io_surface.width);
    const std::int32_t column = std::min(to_int(across / brick_width), columns - 1);
    return locate_in_box(row * columns + column, across - column * brick_width, down - row * brick_height,
                         brick_width, brick_height);
  });
}

// A row of stones or boards of different lengths. `starts` are the pieces' first edges along the row,
// ascending; the last piece wraps around to the first.
struct Course {
  double top = 0, height = 0;
  std::vector<double> starts;
};

// The course's pieces are numbered from `first_piece`. `along` and `across` are texels along the row and
// across all rows.
PiecePosition locate_in_course(const Course& course, std::int32_t first_piece, double along, double across,
                               double length) {
  const std::size_t count = course.starts.size();
  const double first = course.starts.front();
  const double from_first = wrap(along - first, length);
  std::size_t i = 0;
  while (i + 1 < count && course.starts[i + 1] - first <= from_first) ++i;
  const double end = i + 1 < count ? course.starts[i + 1] - first : length;
  const double start = course.starts[i] - first;
  return locate_in_box(first_piece + to_int(static_cast<double>(i)), from_first - start, across - course.top,
                       end - start, course.height);
}

// Makes `count` rows that fill `height`. Their heights and the positions of cuts differ at random by up to
// `uneven`; each row has a random number of pieces from the range.
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
        std::max(1, to_int(pieces.first + hash_noise(row, 11, seed) * (pieces.second - pieces.first + 1)));
    const double offset = hash_noise(row, 12, seed) * length;
    for (std::int32_t cut = 0; cut < cuts; ++cut)
      course.starts.push_back(offset +
                              (cut + 0.5 * uneven * signed_noise(row * 64 + cut, 13, seed)) * length / cuts);
    courses.push_back(std::move(course));
    top += courses.back().height;
  }
  return courses;
}

// Blocks and planks. `is_vertical`: the rows are columns, so x and y are exchanged. Rows are 64 piece numbers
// apart.
void paint_courses(Layer& layer, const PieceSettings& fallback, std::int32_t default_rows, bool is_vertical,
                   double default_uneven, Surface& io_surface) {
  const std::int32_t rows = layer.arguments.integer("rows", default_rows, 1, 64);
  const std::pair<double, double> pieces = layer.arguments.range("pieces", {1, is_vertical ? 1 : 3});
  const double uneven = layer.arguments.number("uneven", default_uneven, 0, 0.9);
  if (pieces.first < 1 || pieces.second < pieces.first || pieces.second > 32)
    layer.arguments.set_error("pieces= must be a range within 1..32");
  const double length = is_vertical ? io_surface.height : io_surface.width;
  const double height = is_vertical ? io_surface.width : io_surface.height;
  const std::vector<Course> courses = make_courses(rows, pieces, uneven, height, length, layer.seed);
  lay_pieces(read_piece_settings(layer.arguments, fallback), layer.seed, io_surface, [&](double x, double y) {
    const double across = wrap(is_vertical ? x : y, height);
    std::size_t row = 0;
    while (row + 1 < courses.size() && courses[row + 1].top <= across) ++row;
    return locate_in_course(courses[row], to_int(static_cast<double>(row)) * 64, is_vertical ? y : x, across,
                            length);
  });
}

// blocks rows=3 pieces=1..3 uneven=0.3: courses of stones of different sizes.
void paint_blocks(Layer& layer, Surface& io_surface) {
  paint_courses(layer, {}, 3, false, 0.3, io_surface);
}

// planks rows=4 pieces=1 along=y: upright boards; along=x makes them horizontal.
void paint_planks(Layer& layer, Surface& io_surface) {
  const bool is_vertical = layer.arguments.text("along", "y") != "x";
  paint_courses(layer, {1, 1.5, 1.2, 0.08, 0, 0, 8}, 4, is_vertical, 0.1, io_surface);
}

// The center of a cell.
struct Site {
  double x = 0, y = 0;
};

// cells columns=5 rows=5 uneven=0.8: round stones, scales, or facets. The pieces are the Voronoi cells of a
// grid of points that are moved at random; `uneven` is how far. Two passes over the neighboring points: the
// first finds the nearest one, the second the nearest edge, which lies halfway to another point.
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
      read_piece_settings(layer.arguments, {1.5, 3, 6, 0.1, 0, 0, 8}), layer.seed, io_surface,
      [&](double x, double y) {
        const std::int32_t column = to_int(std::floor(x / cell_width)),
                           row = to_int(std::floor(y / cell_height));
        Site nearest;
        double best = std::numeric_limits<double>::max();
        std::int32_t piece = 0;
        const auto each_site = [&](auto visit) {
          for (std::int32_t dr = -2; dr <= 2; ++dr)
            for (std::int32_t dc = -2; dc <= 2; ++dc)
              visit(column + dc, row + dr, site(column + dc, row + dr));
        };
        each_site([&](std::int32_t at_column, std::int32_t at_row, const Site& position) {
          const double square = (position.x - x) * (position.x - x) + (position.y - y) * (position.y - y);
          if (square >= best) return;
          best = square;
          nearest = position;
          piece = ((at_row % rows + rows) % rows) * columns + (at_column % columns + columns) % columns;
        });
        double edge = std::numeric_limits<double>::max();
        each_site([&](std::int32_t, std::int32_t, const Site& position) {
          const double dx = position.x - nearest.x, dy = position.y - nearest.y;
          const double apart = std::sqrt(dx * dx + dy * dy);
          if (apart < 1e-6) return;
          const double square = (position.x - x) * (position.x - x) + (position.y - y) * (position.y - y);
          edge = std::min(edge, (square - best) / (2 * apart));
        });
        return PiecePosition{piece, edge, x - nearest.x, y - nearest.y};
      });
}

// ribs every=8 along=y raise=2: parallel rods with a round profile and without joints; along=y: upright.
void paint_ribs(Layer& layer, Surface& io_surface) {
  const double every = layer.arguments.number("every", 8, 1, 1024);
  const double raise = layer.arguments.number("raise", every / 4, -64, 64);
  const bool is_vertical = layer.arguments.text("along", "y") != "x";
  const std::int32_t side = is_vertical ? io_surface.width : io_surface.height;
  const double period = 1.0 * side / count_repeats(side, every);
  for (std::int32_t y = 0; y < io_surface.height; ++y)
    for (std::int32_t x = 0; x < io_surface.width; ++x) {
      const double across = wrap((is_vertical ? x : y) + 0.5, period) / period * 2 - 1;
      Texel& texel = io_surface.at(x, y);
      texel.height += raise * std::sqrt(std::max(0.0, 1 - across * across));
      texel.piece = to_int(((is_vertical ? x : y) + 0.5) / period);
      texel.rim = (1 - std::abs(across)) * period / 2;
    }
}

constexpr std::array<LayerKeyword, 5> kStructureKeywords = {{
    {"bricks", paint_bricks},
    {"blocks", paint_blocks},
    {"planks", paint_planks},
    {"cells", paint_cells},
    {"ribs", paint_ribs},
}};

}  // namespace

std::span<const LayerKeyword> structure_keywords() {
  return kStructureKeywords;
}

}  // namespace temblor::artgen
