#include "render/surfaces/light/caustics.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "base/hash.h"
#include "render/view/model_view.h"

namespace temblor::render {
namespace {

constexpr std::uint32_t kStepsPerSecond = 15;
// The distance of samples at mip 0. The net's lines are about three samples wide.
constexpr std::int32_t kCausticTexels = 4;

constexpr std::uint32_t kTileSide = 128;  // samples of the tile: a power of two
constexpr double kUnitsPerTileSample = 4;
constexpr std::uint32_t kCells = 12;  // along a side; cells are about 43 units wide
constexpr float kCell = static_cast<float>(kTileSide) / static_cast<float>(kCells);
constexpr float kLineWidth = 3.2f;  // of tile samples, on each side of a border

// Light in the gaps, and how much the brightest lines add, times 256.
constexpr std::uint32_t kGapLight_q8 = 176, kLineLight_q8 = 320;

using Tile = std::array<std::uint8_t, kTileSide * kTileSide>;

// By cell: its point, in tile samples from the cell's corner.
using CellPoints = std::array<math::Vec2, kCells * kCells>;
CellPoints scatter_points() {
  CellPoints points{};
  for (std::uint64_t cell = 0; cell < points.size(); ++cell) {
    const std::uint64_t hash = base::mix_bits(cell + 1);
    const auto fraction = [](std::uint64_t bits) { return static_cast<float>(bits & 0xffff) / 65536.0f; };
    points[cell] = math::Vec2(fraction(hash), fraction(hash >> 16)) * kCell;
  }
  return points;
}

// Bright where the nearest two points are equally far away. Cells repeat with the tile.
std::uint8_t tile_brightness(const CellPoints& points, math::Vec2 position) {
  const auto column = static_cast<std::uint32_t>(position.x / kCell);
  const auto row = static_cast<std::uint32_t>(position.y / kCell);
  const math::Vec2 in_cell = position - math::Vec2(column, row) * kCell;
  float nearest_squared = static_cast<float>(kTileSide * kTileSide), second_squared = nearest_squared;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      const std::uint32_t cell_x = (column + kCells + static_cast<std::uint32_t>(x)) % kCells;
      const std::uint32_t cell_y = (row + kCells + static_cast<std::uint32_t>(y)) % kCells;
      const math::Vec2 away = points[cell_y * kCells + cell_x] + math::Vec2(x, y) * kCell - in_cell;
      const float squared = glm::dot(away, away);
      second_squared = std::min(second_squared, std::max(nearest_squared, squared));
      nearest_squared = std::min(nearest_squared, squared);
    }
  const float difference = std::sqrt(second_squared) - std::sqrt(nearest_squared);
  const float line = std::max(0.0f, 1 - difference / (2 * kLineWidth));
  return static_cast<std::uint8_t>(line * line * 255);
}

const Tile& caustic_tile() {
  static const Tile tile = [] {
    const CellPoints points = scatter_points();
    Tile made{};
    for (std::uint32_t y = 0; y < kTileSide; ++y)
      for (std::uint32_t x = 0; x < kTileSide; ++x)
        made[y * kTileSide + x] = tile_brightness(points, math::Vec2(x, y));
    return made;
  }();
  return tile;
}

// A position in the tile, in 16.16 fixed point. Integers wrap around, as the tile does.
struct TilePosition {
  std::uint32_t x, y;
  TilePosition operator+(TilePosition other) const { return {x + other.x, y + other.y}; }
};

TilePosition to_tile_position(math::Vec2d units) {
  const auto wrapped = [](double value) {
    if (!std::isfinite(value)) value = 0;
    return static_cast<std::uint32_t>(
        static_cast<std::int64_t>(std::fmod(value / kUnitsPerTileSample, double{kTileSide}) * 65536));
  };
  return {wrapped(units.x), wrapped(units.y)};
}

// Interpolates between four samples of the tile: 0 to 255.
std::uint32_t read_tile(const Tile& tile, TilePosition at) {
  const auto sample = [&](std::uint32_t x, std::uint32_t y) {
    return std::uint32_t{tile[y % kTileSide * kTileSide + x % kTileSide]};
  };
  const std::uint32_t x = at.x >> 16, y = at.y >> 16, right = at.x >> 8 & 255, down = at.y >> 8 & 255;
  const std::uint32_t above = sample(x, y) * (256 - right) + sample(x + 1, y) * right;
  const std::uint32_t below = sample(x, y + 1) * (256 - right) + sample(x + 1, y + 1) * right;
  return (above * (256 - down) + below * down) >> 16;
}

// One drifting layer of the net on a face, by sample of its grid.
class Layer {
 public:
  // `scale`: of the tile, smaller for larger cells. `drift`: in units.
  Layer(const FacePlacement& placed, const TexelSteps& steps, const SampleGrid& grid, double scale,
        math::Vec2d drift) {
    const math::Vec3d on_plane = placed.normal * placed.distance;
    const math::Vec3d first_texel = on_plane -
                                    steps.s * (glm::dot(placed.s_axis, on_plane) + placed.s_offset) -
                                    steps.t * (glm::dot(placed.t_axis, on_plane) + placed.t_offset);
    const double texels = grid.texels;
    right_ = to_tile_position(along_light(steps.s) * (texels * scale));
    down_ = to_tile_position(along_light(steps.t) * (texels * scale));
    const math::Vec3d first_sample =
        first_texel + steps.s * (grid.first_column * texels) + steps.t * (grid.first_row * texels);
    row_ = to_tile_position(along_light(first_sample) * scale + drift);
  }
  TilePosition row() const { return row_; }
  TilePosition right() const { return right_; }
  void next_row() { row_ = row_ + down_; }

 private:
  // Where light that falls steeply through a point meets the ground.
  static math::Vec2d along_light(const math::Vec3d& point) {
    return math::Vec2d(point.x, point.y) + math::Vec2d(0.5, 0.35) * point.z;
  }
  TilePosition row_{}, right_{}, down_{};
};

// Bilinear interpolation of sums whose samples are `factor` times as far apart as those of `refined`.
std::span<std::uint32_t> refine(const LightSums& light, const SampleGrid& grid, const SampleGrid& refined,
                                base::Arena& arena) {
  const std::size_t channels = light.channels, row_values = static_cast<std::size_t>(grid.columns) * channels;
  // A power of two, like both distances of samples.
  const auto factor = static_cast<std::uint32_t>(grid.texels / refined.texels);
  const int shift = 2 * std::countr_zero(factor);
  const auto columns = static_cast<std::size_t>(refined.columns),
             rows = static_cast<std::size_t>(refined.rows);
  const std::span<std::uint32_t> sums = arena.allocate<std::uint32_t>(columns * rows * channels);
  std::uint32_t* out = sums.data();
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint64_t below = row % factor, above = factor - below;
    for (std::size_t column = 0; column < columns; ++column)
      for (std::size_t channel = 0; channel < channels; ++channel) {
        const std::uint64_t right = column % factor, left = factor - right;
        const std::uint32_t* upper =
            &light.values[row / factor * row_values + column / factor * channels + channel];
        // The samples at the end of the grid have none after them, and need none.
        const std::uint32_t* lower = below > 0 ? upper + row_values : upper;
        const std::size_t next = right > 0 ? channels : 0;
        const std::uint64_t sum =
            (upper[0] * left + upper[next] * right) * above + (lower[0] * left + lower[next] * right) * below;
        *out++ = static_cast<std::uint32_t>(sum >> shift);
      }
  }
  return sums;
}

}  // namespace

WaterFaces::WaterFaces(const world::Level& level) : is_under_water_(level.faces.size(), false) {
  for (const world::Leaf& leaf : level.leaves) {
    if (leaf.contents != world::Contents::kWater) continue;
    for (std::uint32_t i = 0; i < leaf.marked_face_count; ++i) {
      const world::FaceIndex face = level.marked_faces[leaf.first_marked_face + i];
      is_under_water_[base::to_size(face)] = level.face(face).kind == world::FaceKind::kLit;
    }
  }
}

std::uint32_t find_caustic_step(world::FaceIndex face, double time_s) {
  const double turn = static_cast<double>(base::mix_bits(base::to_size(face)) & 0xff) / 256;
  return static_cast<std::uint32_t>(std::fmod(std::max(time_s, 0.0) * kStepsPerSecond + turn, 0x1p31)) + 1;
}

SampleGrid refine_for_caustics(const SampleGrid& grid, int mip) {
  const std::int32_t texels =
      std::min(grid.texels, std::max(kCausticTexels, std::int32_t{1} << std::max(mip, 0)));
  const std::int32_t factor = grid.texels / texels;
  return {grid.first_column * factor, grid.first_row * factor, (grid.columns - 1) * factor + 1,
          (grid.rows - 1) * factor + 1, texels};
}

LightSums add_caustics(const world::Level& level, const world::Face& face, std::uint32_t step,
                       const LightSums& light, const SampleGrid& grid, const SampleGrid& refined,
                       base::Arena& arena) {
  const std::span<std::uint32_t> sums = refine(light, grid, refined, arena);
  const FacePlacement placed = place_face(level, face, ModelView{});
  const std::optional<TexelSteps> steps = find_texel_steps(placed);
  // Full strength on floors, half on walls.
  const double strength = std::clamp(0.5 + placed.normal.z, 0.0, 1.0);
  if (!steps || !(strength > 0)) return {sums, light.channels};
  const auto gap_q8 = static_cast<std::uint32_t>(256 - (256 - kGapLight_q8) * strength);
  const auto line_q8 = static_cast<std::uint32_t>(kLineLight_q8 * strength);

  const double time_s = static_cast<double>(step) / kStepsPerSecond;
  Layer first(placed, *steps, refined, 1, math::Vec2d(9, 5) * time_s);
  Layer second(placed, *steps, refined, 0.83, math::Vec2d(-7, 8) * time_s);
  const Tile& tile = caustic_tile();
  std::uint32_t* sum = sums.data();
  for (std::int32_t row = 0; row < refined.rows; ++row, first.next_row(), second.next_row()) {
    TilePosition in_first = first.row(), in_second = second.row();
    for (std::int32_t column = 0; column < refined.columns; ++column) {
      const std::uint32_t line = std::min(read_tile(tile, in_first), read_tile(tile, in_second));
      const std::uint32_t factor_q8 = gap_q8 + (line_q8 * line >> 8);
      for (std::size_t channel = 0; channel < light.channels; ++channel, ++sum)
        *sum = static_cast<std::uint32_t>(std::uint64_t{*sum} * factor_q8 >> 8);
      in_first = in_first + first.right();
      in_second = in_second + second.right();
    }
  }
  return {sums, light.channels};
}

}  // namespace temblor::render
