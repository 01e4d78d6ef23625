// The cached order of faces: against rays, and pictures against those of an empty cache.
#include "lab/hidden_surfaces/pair_orders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lab/registry.h"
#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::lab {
namespace {

struct RayHit {
  double distance;
  world::FaceIndex face;
};

// The faces of the world whose front a ray passes through, also hidden ones, from the nearest to the
// farthest.
std::vector<RayHit> find_hits(const world::Level& level, const math::Vec3d& eye, const math::Vec3d& ray) {
  std::vector<RayHit> hits;
  for (std::uint32_t number = 0; number < level.world().face_count; ++number) {
    const auto index = base::to_index<world::FaceIndex>(level.world().first_face + number);
    const world::Face& face = level.face(index);
    const world::Plane& plane = level.planes[face.plane];
    const double sign = face.back_side ? -1 : 1;
    const double height = sign * world::distance_to(plane, eye);
    const double fall = -sign * glm::dot(math::Vec3d(plane.normal), ray);
    if (height <= 0.1 || fall <= 0.01) continue;
    const math::Vec3d point = eye + ray * (height / fall);
    bool is_inside = true;
    const auto corner = [&](std::uint32_t i) {
      return math::Vec3d(
          level.vertices[level.surfedge_start(std::size_t{face.first_surfedge} + i % face.surfedge_count)]);
    };
    for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
      const math::Vec3d side = corner(i + 1) - corner(i);
      // Clockwise, so the inside is to the right.
      is_inside &= glm::dot(glm::cross(side, point - corner(i)), math::Vec3d(plane.normal) * sign) < 0;
    }
    if (is_inside) hits.push_back({height / fall, index});
  }
  std::ranges::sort(hits, {}, &RayHit::distance);
  return hits;
}

int count_checked_pairs(const world::Level& level, int eyes) {
  int checked = 0;
  for (int seed = 0; seed < eyes; ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const math::Vec3d eye(test::random_camera(level, random).origin_world);
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-0.5, 0.5);
    const std::vector<RayHit> hits = find_hits(level, eye, glm::normalize(math::Vec3d(x, y, z)));
    for (std::size_t far = 1; far < hits.size(); ++far)
      for (std::size_t near = 0; near < far; ++near) {
        if (hits[far].distance - hits[near].distance < 1) continue;
        const PairOrder order = order_faces(level, hits[near].face, hits[far].face);
        const PairOrder reversed = order_faces(level, hits[far].face, hits[near].face);
        if (order == PairOrder::kDepends) {
          EXPECT_EQ(reversed, PairOrder::kDepends);
          continue;
        }
        EXPECT_EQ(order, PairOrder::kFirst) << level.name << ", seed " << seed;
        EXPECT_EQ(reversed, PairOrder::kSecond) << level.name << ", seed " << seed;
        ++checked;
      }
  }
  return checked;
}

TEST(PairOrders, AreWhatRaysSee) {
  EXPECT_GT(count_checked_pairs(*test::small_level().level, test::effort(4000, 300)), 100);
}

TEST(PairOrders, AreWhatRaysSeeInAStockLevel) {
  DATA_FOLDER_OR_SKIP(data);
  const int eyes = test::effort(500, 20);
  EXPECT_GT(count_checked_pairs(*test::stock_level(data, "lq_e1m2").level, eyes), 2 * eyes);
}

TEST(PairOrders, AreFoundUntilAnotherPairTakesThePlace) {
  PairOrders pairs(2);
  const auto face = [](std::uint32_t number) { return base::to_index<world::FaceIndex>(number); };
  EXPECT_EQ(pairs.find(face(0), face(1)), PairOrder::kUnknown);
  pairs.store(face(0), face(1), PairOrder::kSecond);
  EXPECT_EQ(pairs.find(face(0), face(1)), PairOrder::kSecond);
  EXPECT_EQ(pairs.find(face(1), face(0)), PairOrder::kUnknown);
  int found = 0;
  for (std::uint32_t i = 2; i < 20; ++i) pairs.store(face(i), face(i + 1), PairOrder::kFirst);
  for (std::uint32_t i = 0; i < 20; ++i) found += pairs.find(face(i), face(i + 1)) != PairOrder::kUnknown;
  EXPECT_GE(found, 1);
  EXPECT_LE(found, 2);
}

TEST(PairOrders, BelongToOneLevel) {
  const test::DrawableLevel drawable = test::small_level();
  world::Level other = *drawable.level;
  other.identity = std::make_shared<const world::LevelIdentity>();
  PairOrders pairs(64);
  const world::FaceIndex first{3}, second{5};
  const auto is_kept = [&](const world::Level& level, bool keeps_pairs) {
    pairs.use_level(level, keeps_pairs);
    const bool is_known = pairs.find(first, second) != PairOrder::kUnknown;
    pairs.store(first, second, PairOrder::kFirst);
    return is_known;
  };
  EXPECT_FALSE(is_kept(*drawable.level, true));
  EXPECT_TRUE(is_kept(*drawable.level, true));
  EXPECT_FALSE(is_kept(*drawable.level, false));
  EXPECT_FALSE(is_kept(other, true));
  EXPECT_FALSE(is_kept(*drawable.level, true));
}

// Caches that have seen other views draw what new ones draw, on any number of threads.
TEST(PairOrders, DoNotDependOnEarlierFrames) {
  const test::DrawableLevel drawable = test::small_level();
  const world::Level& level = *drawable.level;
  const auto make_renderer = [&](const char* technique) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.replace_stages(parse_choice(technique).value().make_stages());
    return renderer;
  };
  render::Renderer kept = make_renderer("cached-order");
  render::Renderer tiny = make_renderer("cached-order:pairs=4");
  render::Renderer emptied = make_renderer("cached-order:keep=0");
  for (int number = 0; number < test::effort(60, 6); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    test::Viewpoint viewpoint{.camera = test::random_camera(level, random),
                              .brush_models = test::shown_brush_models(level)};
    if (number % 2 == 1) test::displace(level, viewpoint.brush_models, random);
    const render::Scene scene = viewpoint.scene(level);
    const auto draw = [&](render::Renderer& io_renderer, const render::Settings& settings) {
      render::FrameBuffer frame(320, 200, render::PixelFormat::kIndexed);
      io_renderer.render(scene, settings, frame);
      return test::copy_picture(frame);
    };
    render::Renderer fresh = make_renderer("cached-order");
    const test::FrameCopy wanted = draw(fresh, {});
    EXPECT_TRUE(draw(kept, {.threads = 2, .job_backend = base::JobBackend::kStdThread}) == wanted) << number;
    EXPECT_TRUE(draw(tiny, {.band_rows = 7}) == wanted) << number;
    EXPECT_TRUE(draw(emptied, {}) == wanted) << number;
  }
}

TEST(PairOrders, SpareComparisonsOfTheNextFrame) {
  const test::DrawableLevel drawable = test::small_level();
  test::Random random(1);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  render::FrameBuffer frame(320, 200, render::PixelFormat::kIndexed);
  Counter counter;
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.replace_stages(parse_choice("cached-order").value().make_stages(&counter));
  renderer.render(scene, {}, frame);
  const Counts first = counter.take();
  renderer.render(scene, {}, frame);
  const Counts second = counter.take();
  EXPECT_GT(second.cache_hits, first.cache_hits);
  EXPECT_LT(second.comparisons, first.comparisons);
  const std::size_t before = test::allocation_count();
  renderer.render(scene, {}, frame);
  EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace temblor::lab
