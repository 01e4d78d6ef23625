// Any view of any level draws every pixel exactly once and does not crash: eyes in solid, outside, far away,
// and exactly on planes and vertices; all sizes and fields of view; brush models anywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

constexpr int kShards = effort(10, 1);  // tests run in parallel
constexpr int kViewsPerShard = effort(1000, 150);
constexpr double kMaxSide = effort(8192, 512);
// PixelFace and the write count take nine bytes per pixel, so they are checked only up to this size.
constexpr std::size_t kMaxPixelsCounted = std::size_t{1} << 21;

math::Vec3 random_point_in(const math::Bounds& bounds, Random& io_random) {
  math::Vec3 point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(io_random.uniform(bounds.mins[axis], bounds.maxs[axis]));
  return point;
}

math::Vec3 random_eye(const world::Level& level, Random& io_random) {
  switch (io_random.below(8)) {
    case 0:
      return io_random.in_cube(1e5);  // far outside
    case 1:
      return io_random.in_cube(10);
    case 2:
      return level.vertices[io_random.below(level.vertices.size())];
    case 3: {  // on a plane
      const world::Plane& plane = level.planes[io_random.below(level.planes.size())];
      const math::Vec3 point = random_point_in(level.world().bounds, io_random);
      return point - plane.normal * (glm::dot(point, plane.normal) - plane.distance);
    }
    case 4:
    case 5:
      return random_point_in(level.world().bounds, io_random);  // mostly in solid
    default:
      return random_camera(level, io_random).origin_world;
  }
}

math::Vec3 random_angles_deg(Random& io_random) {
  if (io_random.chance(0.3)) {  // along the axes, as most faces are: seen exactly edge-on
    const auto quarter_turn = [&] { return static_cast<float>(io_random.below(4)) * 90.0f; };
    const float pitch = quarter_turn(), yaw = quarter_turn(), roll = quarter_turn();
    return {pitch, yaw, roll};
  }
  return io_random.in_cube(180);
}

render::Camera any_camera(const world::Level& level, Random& io_random) {
  render::Camera camera;
  camera.origin_world = random_eye(level, io_random);
  camera.angles_deg = random_angles_deg(io_random);
  camera.fov_deg = static_cast<float>(io_random.uniform(10, 170));
  if (io_random.chance(0.2)) camera.projection = render::Projection::kOrthographic;
  if (io_random.chance(0.5)) camera.units_per_pixel = static_cast<float>(io_random.log_uniform(0.01, 100));
  return camera;
}

Viewpoint any_viewpoint(const world::Level& level, Random& io_random) {
  Viewpoint viewpoint{.camera = any_camera(level, io_random),
                      .brush_models = shown_brush_models(level),
                      .time_s = io_random.chance(0.1) ? 1e7 : io_random.uniform(0, 1000)};
  if (io_random.chance(0.5)) displace(level, viewpoint.brush_models, io_random);
  for (render::BrushModelInstance& instance : viewpoint.brush_models) {
    if (!io_random.chance(0.2)) continue;
    instance.origin_world = random_eye(level, io_random);
    instance.angles_deg = random_angles_deg(io_random);
    instance.frame = static_cast<int>(io_random.below(2));
  }
  return viewpoint;
}

render::Settings any_settings(Random& io_random) {
  constexpr std::size_t kCacheBytes[] = {0, 100000, std::size_t{64} << 20};
  constexpr int kBandRows[] = {0, 0, 1, 5, 64};
  return {.threads = io_random.chance(0.1) ? 2 : 1,
          .mip_rule = io_random.chance(0.5) ? render::MipRule::kStock : render::MipRule::kFootprint,
          .force_mip = static_cast<int>(io_random.below(5)) - 1,
          .perspective = io_random.chance(0.3) ? render::Perspective::kEvery16 : render::Perspective::kExact,
          .simd_kernels = io_random.chance(0.7),
          .surface_cache = io_random.chance(0.9),
          .cache_bytes = kCacheBytes[io_random.below(3)],
          .use_pvs = io_random.chance(0.7),
          .colored_light = io_random.chance(0.7),
          .band_rows = kBandRows[io_random.below(5)]};
}

std::vector<DrawableLevel> all_levels() {
  std::vector<DrawableLevel> levels;
  for (const SmallLevelVariant& variant : small_level_variants())
    levels.push_back(small_level(variant.options, variant.name));
  if (const auto data = data_folder())
    for (const char* name : {"start", "lq_e0m1", "lq_e1m2"}) levels.push_back(stock_level(*data, name));
  return levels;
}

std::string describe(const DrawableLevel& drawable, const render::Camera& camera, int width, int height) {
  return fmt::format("{} --pos {},{},{} --angles {},{},{} fov {} {}x{}{}", drawable.name,
                     camera.origin_world.x, camera.origin_world.y, camera.origin_world.z, camera.angles_deg.x,
                     camera.angles_deg.y, camera.angles_deg.z, camera.fov_deg, width, height,
                     camera.projection == render::Projection::kOrthographic ? " orthographic" : "");
}

bool every_pixel_written_once(const render::Renderer& renderer, std::size_t pixels) {
  std::vector<render::PixelFace> faces(pixels);
  std::vector<std::uint8_t> writes(pixels);
  renderer.pixel_faces(faces, writes);
  return std::count(writes.begin(), writes.end(), 1) == static_cast<std::ptrdiff_t>(pixels);
}

bool has_no_nan(std::span<const float> depths) {
  return std::none_of(depths.begin(), depths.end(), [](float depth) { return std::isnan(depth); });
}

class AnyView : public testing::TestWithParam<int> {};

// If a pixel is not written, two frames that were filled differently before drawing differ.
TEST_P(AnyView, DrawsEveryPixelOnce) {
  const std::vector<DrawableLevel> levels = all_levels();
  // One level after another: a renderer keeps the memory that its largest frame needed.
  std::optional<render::Renderer> renderer;
  std::size_t rendered_level = levels.size();
  for (int view = 0; view < kViewsPerShard; ++view) {
    const int seed = GetParam() * kViewsPerShard + view;
    Random random(static_cast<std::uint64_t>(seed));
    const std::size_t choice = levels.size() * static_cast<std::size_t>(view) / kViewsPerShard;
    if (std::exchange(rendered_level, choice) != choice)
      renderer.emplace(levels[choice].palette, levels[choice].colormap);
    const world::Level& level = *levels[choice].level;
    const Viewpoint viewpoint = any_viewpoint(level, random);
    const int width = static_cast<int>(random.log_uniform(1, kMaxSide + 1));
    const int height = static_cast<int>(random.log_uniform(1, kMaxSide + 1));
    const bool indexed = random.chance(0.5);
    const render::Settings settings = any_settings(random);
    SCOPED_TRACE(describe(levels[choice], viewpoint.camera, width, height) + fmt::format(" seed {}", seed));

    render::FrameBuffer frame(width, height,
                              indexed ? render::PixelFormat::kIndexed : render::PixelFormat::kRgb);
    const render::Scene scene = viewpoint.scene(level);
    fill_frame(frame, 0x55);
    renderer->render(scene, settings, frame);
    const std::uint64_t first = compute_hash(frame);
    fill_frame(frame, 0xaa);
    renderer->render(scene, settings, frame);
    ASSERT_EQ(compute_hash(frame), first) << "a pixel was left unwritten";
    ASSERT_TRUE(has_no_nan(frame.depth()));
    if (frame.pixel_count() <= kMaxPixelsCounted) {
      ASSERT_TRUE(every_pixel_written_once(*renderer, frame.pixel_count()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shards, AnyView, testing::Range(0, kShards));

TEST(AnySize, IncludesTheLargestPicture) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  Random random(1);
  const Viewpoint viewpoint{.camera = random_camera(*drawable.level, random),
                            .brush_models = shown_brush_models(*drawable.level)};
  for (const auto& [width, height] : {std::pair(8192, 8192), std::pair(8192, 1), std::pair(1, 8192)}) {
    render::FrameBuffer frame(width, height, render::PixelFormat::kIndexed);
    fill_frame(frame, 0x55);
    renderer.render(viewpoint.scene(*drawable.level), {}, frame);
    const std::uint64_t first = compute_hash(frame);
    fill_frame(frame, 0xaa);
    renderer.render(viewpoint.scene(*drawable.level), {}, frame);
    EXPECT_EQ(compute_hash(frame), first) << width << "x" << height;
  }
}

}  // namespace
}  // namespace temblor::test
