#include "artgen/level_script/rock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/hash.h"

namespace temblor::artgen {
namespace {

// A random number in [0, 1) for a grid point.
double noise_at(int x, int y, std::uint64_t seed) {
  const std::uint64_t bits =
      base::hash_with(base::hash_with(seed, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y));
  return static_cast<double>(bits >> 11) / 9007199254740992.0;
}

// The smoothstep polynomial.
double ease_fraction(double t) {
  return t * t * (3 - 2 * t);
}

// The parts of a space's side behind which other spaces are open, one unit deep.
std::vector<Box> find_openings(const Box& box, Side side, const std::vector<Space>& spaces) {
  Box behind = box;
  (is_upper(side) ? behind.low : behind.high)[side_axis(side)] = box.at(side);
  (is_upper(side) ? behind.high : behind.low)[side_axis(side)] = box.at(side) + (is_upper(side) ? 1 : -1);
  std::vector<Box> open;
  for (const Space& space : spaces) {
    const Box shared = intersect(space.box, behind);
    if (shared.has_volume()) open.push_back(shared);
  }
  return open;
}

// The axis perpendicular to a side, and the two axes in its plane.
struct SideAxes {
  int across = 0, u = 1, v = 2;
};
SideAxes find_side_axes(Side side) {
  const int across = side_axis(side);
  return {across, across == 0 ? 1 : 0, across == 2 ? 1 : 2};
}

// The distance in the plane of the side from a point to the nearest opening.
double distance_to(const std::vector<Box>& openings, const SideAxes& axes, Point point) {
  double nearest = 1e9;
  for (const Box& open : openings) {
    double squares = 0;
    for (const int axis : {axes.u, axes.v}) {
      const double off = std::max({open.low[axis] - point[axis], point[axis] - open.high[axis], 0});
      squares += off * off;
    }
    nearest = std::min(nearest, std::sqrt(squares));
  }
  return nearest;
}

// How far the rock protrudes at a point: two octaves of noise between 8 and `rough` units, and `push` (-1 to
// 1) times a third of that; less near openings.
int bulge_at(const RockFace& face, const std::vector<Box>& openings, const SideAxes& axes, Point point,
             double push) {
  const double scale = 1.0 / (2.0 * face.cell);
  const double u = point[axes.u] * scale, v = point[axes.v] * scale;
  const std::uint64_t seed = base::hash_with(face.seed, side_index(face.side));
  const double noise = 0.65 * smooth_noise(u, v, seed) + 0.35 * smooth_noise(2.3 * u, 2.3 * v, seed + 1);
  const double rough = std::clamp(noise + push / 3, 0.0, 1.0);
  const double least = std::min(8, face.rough);
  const double free = std::clamp(distance_to(openings, axes, point) / face.cell - 0.25, 0.0, 1.0);
  return static_cast<int>(std::lround((least + rough * (face.rough - least)) * free));
}

// Whether a cell of the grid overlaps an opening. Such cells are left out.
bool covers_any(const std::vector<Box>& openings, const SideAxes& axes, Point low, Point high) {
  return std::any_of(openings.begin(), openings.end(), [&](const Box& open) {
    return open.low[axes.u] < high[axes.u] && low[axes.u] < open.high[axes.u] &&
           open.low[axes.v] < high[axes.v] && low[axes.v] < open.high[axes.v];
  });
}

// The number of cells on an axis, so that their size is close to `cell`.
int steps_along(const Box& box, int axis, int cell) {
  return std::max(1, (box.size()[axis] + cell / 2) / cell);
}

}  // namespace

double smooth_noise(double x, double y, std::uint64_t seed) {
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const double s = ease_fraction(x - x0), t = ease_fraction(y - y0);
  const double low = noise_at(x0, y0, seed) * (1 - s) + noise_at(x0 + 1, y0, seed) * s;
  const double high = noise_at(x0, y0 + 1, seed) * (1 - s) + noise_at(x0 + 1, y0 + 1, seed) * s;
  return low * (1 - t) + high * t;
}

std::vector<Solid> make_rock(const RockFace& face, const std::vector<Space>& spaces) {
  const SideAxes axes = find_side_axes(face.side);
  const std::vector<Box> openings = find_openings(face.box, face.side, spaces);
  const bool is_layered = face.layer_height > 0 && axes.across != 2;
  const int columns = steps_along(face.box, axes.u, face.cell),
            rows = steps_along(face.box, axes.v, is_layered ? face.layer_height : face.cell);
  // A grid point on the wall, and the same point moved to the rock's front as a corner of a row's cell. A
  // layer keeps its bulge from bottom to top, as sediment does.
  const auto foot = [&](int column, double row) {
    Point point(0);
    point[axes.across] = face.box.at(face.side);
    point[axes.u] = face.box.low[axes.u] + face.box.size()[axes.u] * column / columns;
    point[axes.v] = face.box.low[axes.v] + static_cast<int>(face.box.size()[axes.v] * row / rows);
    return point;
  };
  const auto front = [&](int column, int row, int row_of_cell) {
    Point point = foot(column, row);
    const double push = is_layered ? 2 * noise_at(row_of_cell, 0, face.seed) - 1 : 0;
    const Point measured = is_layered ? foot(column, row_of_cell + 0.5) : point;
    const int bulge = bulge_at(face, openings, axes, measured, push);
    point[axes.across] += is_upper(face.side) ? -bulge : bulge;
    return point;
  };
  const auto make_looks = [&](int row) {
    Looks looks =
        make_uniform_looks(is_layered && row % 2 != 0 ? face.layer_texture : face.texture, face.box);
    looks[side_index(Side::kUp)].texture = face.ledge_texture;
    for (Look& look : looks) look.scale = math::Vec2d(face.scale);
    return looks;
  };
  std::vector<Solid> solids;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (covers_any(openings, axes, foot(column, row), foot(column + 1, row + 1))) continue;
      const std::array<std::pair<int, int>, 4> ring = {
          {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
      const auto add_prism = [&](std::span<const std::size_t> ring_corners) {
        std::vector<Point> corners;
        for (const std::size_t k : ring_corners) {
          const auto& [u, v] = ring[k % 4];
          corners.push_back(foot(u, v));
          corners.push_back(front(u, v, row));
        }
        if (!make_hull(corners).empty()) solids.push_back({std::move(corners), make_looks(row), face.line});
      };
      if (is_layered) {  // the front is flat
        add_prism(std::array<std::size_t, 4>{0, 1, 2, 3});
        continue;
      }
      // The diagonals of neighboring quads alternate, so that the rock shows no direction.
      const std::size_t from = static_cast<std::size_t>(row + column) % 2;
      for (const std::size_t k : {from, from + 2}) add_prism(std::array<std::size_t, 3>{k, k + 1, k + 2});
    }
  return solids;
}

std::vector<Solid> make_band(const Band& band, const std::vector<Space>& spaces) {
  Box strip = band.box;
  strip.low.z = band.low;
  strip.high.z = band.high;
  const int axis = side_axis(band.side);
  (is_upper(band.side) ? strip.low : strip.high)[axis] =
      band.box.at(band.side) + (is_upper(band.side) ? -band.depth : band.depth);
  std::vector<Box> open = find_openings(band.box, band.side, spaces);
  for (Box& hole : open) {
    hole.low[axis] = strip.low[axis];
    hole.high[axis] = strip.high[axis];
  }
  std::vector<Solid> solids;
  for (const Box& piece : subtract(strip, open)) {
    Box anchor = band.box;
    anchor.low.z = band.low;
    solids.push_back({list_corners(piece), make_uniform_looks(band.texture, anchor), band.line});
  }
  return solids;
}

}  // namespace temblor::artgen
