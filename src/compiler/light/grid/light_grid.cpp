#include "compiler/light/grid/light_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "compiler/light/faces/light_bytes.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

constexpr std::size_t kMaxGridStyles = 4;

// The light of one style at one point, by the rules of light maps (faces/light_maps.h).
math::Vec3 join_layers(const LightSettings& settings, const FaceLight& light, std::uint8_t style,
                       std::size_t point) {
  const auto sample = [&](LayerKind kind) {
    const LightLayer* layer = light.find(style, kind);
    return layer != nullptr ? layer->samples[point] : math::Vec3(0.0f);
  };
  math::Vec3 sum = sample(LayerKind::kAdd);
  const math::Vec3 least = settings.min_light_color * settings.min_light;
  if (style == 0) sum = settings.adds_min_light ? sum + least : glm::max(sum, least);
  return glm::max(sum, sample(LayerKind::kRaise)) - sample(LayerKind::kSubtract);
}

// The lights that are stored for a point: the brightest styles, the lowest number first.
std::vector<formats::GridLight> pack_point(const LightSettings& settings, const FaceLight& light,
                                           std::size_t point) {
  std::vector<std::uint8_t> styles{0};
  for (const LightLayer& layer : light.layers) styles.push_back(layer.style);
  std::sort(styles.begin(), styles.end());
  styles.erase(std::unique(styles.begin(), styles.end()), styles.end());
  std::vector<formats::GridLight> packed;
  for (const std::uint8_t style : styles) {
    const math::Vec3 bytes = scale_to_bytes(settings, join_layers(settings, light, style, point));
    const formats::GridLight stored{style,
                                    {round_to_byte(bytes.x), round_to_byte(bytes.y), round_to_byte(bytes.z)}};
    if (stored.rgb != std::array<std::uint8_t, 3>{}) packed.push_back(stored);
  }
  if (packed.size() <= kMaxGridStyles) return packed;
  const auto brightness = [](const formats::GridLight& stored) {
    return stored.rgb[0] + stored.rgb[1] + stored.rgb[2];
  };
  std::stable_sort(packed.begin(), packed.end(),
                   [&](const auto& a, const auto& b) { return brightness(a) > brightness(b); });
  packed.resize(kMaxGridStyles);
  std::sort(packed.begin(), packed.end(), [](const auto& a, const auto& b) { return a.style < b.style; });
  return packed;
}

// Lights one block; `number` counts blocks, x first.
GridBlock light_block(const SpaceLightInput& input, const GridBlocks& grid, std::size_t number) {
  const std::array<std::size_t, 3> at = {
      number % static_cast<std::size_t>(grid.blocks[0]),
      number / static_cast<std::size_t>(grid.blocks[0]) % static_cast<std::size_t>(grid.blocks[1]),
      number / static_cast<std::size_t>(grid.blocks[0]) / static_cast<std::size_t>(grid.blocks[1])};
  SamplePoints places;
  std::vector<std::size_t> open;  // the numbers of the samples in `places`
  for (std::size_t i = 0; i < GridBlock::kSamples; ++i) {
    const std::array<std::size_t, 3> local = {i % kBlockSide, i / kBlockSide % kBlockSide,
                                              i / (kBlockSide * kBlockSide)};
    math::Vec3 place = grid.mins;
    bool is_inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t sample = at[axis] * kBlockSide + local[axis];
      is_inside = is_inside && sample < static_cast<std::size_t>(grid.size[axis]);
      place[static_cast<int>(axis)] += static_cast<float>(sample) * grid.step[static_cast<int>(axis)];
    }
    if (!is_inside) continue;
    const world::LeafIndex leaf = world::find_leaf(*input.lit.level, place);
    const world::Contents contents = input.lit.level->leaf(leaf).contents;
    if (contents == world::Contents::kSolid || contents == world::Contents::kSky) continue;
    places.points.push_back(place);
    places.leaves.push_back(leaf);
    open.push_back(i);
  }
  GridBlock block;
  if (open.empty()) return block;
  const FaceLight light = compute_space_light(input, places);
  block.samples.assign(GridBlock::kSamples, {0, formats::GridSample::kOccluded});
  for (std::size_t i = 0; i < open.size(); ++i) {
    const std::vector<formats::GridLight> lights = pack_point(input.settings, light, i);
    block.samples[open[i]] = {static_cast<std::uint32_t>(block.lights.size()),
                              static_cast<std::uint8_t>(lights.size())};
    block.lights.insert(block.lights.end(), lights.begin(), lights.end());
  }
  return block;
}

}  // namespace

std::optional<GridBlocks> lay_grid(const world::Level& level, const math::Vec3& step) {
  GridBlocks grid;
  grid.step = step;
  const math::Bounds& bounds = level.world().bounds;
  grid.mins = bounds.mins + step / 4.0f;
  double samples = 1, blocks = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double count = std::floor(double{bounds.maxs[axis] - grid.mins[axis]} / double{step[axis]}) + 1;
    const double count_blocks = std::ceil(count / kBlockSide);
    samples *= std::max(count, 1.0);
    blocks *= std::max(count_blocks, 1.0);
    if (!(samples <= kMaxGridSamples)) return std::nullopt;
    const auto i = static_cast<std::size_t>(axis);
    grid.size[i] = static_cast<std::int32_t>(std::max(count, 1.0));
    grid.blocks[i] = static_cast<std::int32_t>(std::max(count_blocks, 1.0));
  }
  grid.of_place.resize(static_cast<std::size_t>(blocks));
  return grid;
}

bool light_grid_blocks(const SpaceLightInput& input, base::Jobs& io_jobs, base::FunctionRef<bool()> make_step,
                       GridBlocks& io_grid) {
  std::atomic<bool> is_stopped{false};
  io_jobs.parallel_for(io_grid.of_place.size(), [&](std::size_t i) {
    if (is_stopped.load(std::memory_order_relaxed)) return;
    io_grid.of_place[i] = light_block(input, io_grid, i);
    if (!make_step()) is_stopped = true;
  });
  return !is_stopped;
}

}  // namespace temblor::compiler
