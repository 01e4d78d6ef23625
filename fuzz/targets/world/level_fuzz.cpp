// Makes a world::Level from every BSP that can be read from arbitrary bytes. make_level() must return an
// error or a level that answers every query.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "formats/levels/bsp.h"
#include "fuzz/targets.h"
#include "world/animation.h"
#include "world/level.h"
#include "world/trace.h"
#include "world/visibility.h"

namespace {

using namespace temblor;

// Points inside the level and outside, on its planes and between.
std::vector<math::Vec3> probe_points(const world::Level& level) {
  std::vector<math::Vec3> points = {{0, 0, 0}, {1e7f, -1e7f, 3}, {-64.5f, 32, 1}};
  const math::Bounds& bounds = level.world().bounds;
  points.push_back(bounds.mins);
  points.push_back((bounds.mins + bounds.maxs) / 2.0f);
  for (std::size_t i = 0; i < level.vertices.size() && points.size() < 8; ++i)
    points.push_back(level.vertices[i]);
  return points;
}

void ask_leaves(const world::Level& level, const std::vector<math::Vec3>& points) {
  std::vector<std::uint8_t> row;
  for (const math::Vec3& point : points) {
    const world::LeafIndex leaf = world::find_leaf(level, point);
    CHECK(base::to_size(leaf) < level.leaves.size());
    world::decompress_pvs(level, leaf, row);
    CHECK(row.size() == (level.visible_leaf_count + 7) / 8);
  }
}

void ask_traces(const world::Level& level, const std::vector<math::Vec3>& points) {
  const std::size_t models = std::min<std::size_t>(level.models.size(), 4);
  for (std::size_t model = 0; model < models; ++model) {
    for (const auto hull : {world::Hull::kPoint, world::Hull::kPlayer, world::Hull::kLarge}) {
      for (std::size_t i = 1; i < points.size(); ++i) {
        const auto index = base::to_index<world::ModelIndex>(model);
        const world::Trace trace = world::trace_line(level, index, hull, points[i - 1], points[i]);
        CHECK(trace.fraction >= 0 && trace.fraction <= 1, "{}", trace.fraction);
        // A path that starts in open space must end in open space.
        if (!trace.start_solid && trace.fraction > 0)
          CHECK(world::hull_contents(level, index, hull, trace.end) != world::Contents::kSolid ||
                trace.fraction == 1);
      }
    }
  }
}

void check_faces(const world::Level& level) {
  for (const world::Face& face : level.faces) {
    CHECK(base::to_size(face.texture) < level.textures.size());
    if (face.light == world::kNoLight) continue;
    const auto [width, height] = level.light_size(face);
    CHECK(width >= 1 && height >= 1);
    const std::uint64_t samples =
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * face.style_count;
    CHECK(face.light + samples <= level.light.size());
  }
  for (std::size_t i = 0; i < level.textures.size(); ++i) {
    const auto shown =
        world::find_animated_texture(level, base::to_index<world::TextureIndex>(i), 12.3, i % 2);
    CHECK(base::to_size(shown) < level.textures.size());
  }
}

}  // namespace

int temblor::fuzz::fuzz_level(const std::uint8_t* data, std::size_t size) {
  auto bsp = temblor::formats::read_bsp(std::as_bytes(std::span(data, size)));
  if (!bsp.ok()) return 0;
  const auto level = temblor::world::make_level(std::move(bsp).value(), "fuzzed");
  if (!level.ok()) return 0;
  const std::vector<temblor::math::Vec3> points = probe_points(**level);
  ask_leaves(**level, points);
  ask_traces(**level, points);
  check_faces(**level);
  return 0;
}
