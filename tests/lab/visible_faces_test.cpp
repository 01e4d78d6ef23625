// The laboratory's ways to find visible faces, against the engine: every pixel, its depth, and its face are
// the same.
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

constexpr int kFaceViewWidth = 333, kFaceViewHeight = 203;

class VisibleFaces : public testing::TestWithParam<const char*> {
 protected:
  render::FrameStages make_stages(Counter* counter = nullptr) const {
    return parse_choice(GetParam()).value().make_stages(counter);
  }
};

// Draws the same scenes with the engine and a technique, one after another.
class TwoRenderers {
 public:
  TwoRenderers(const test::DrawableLevel& drawable, const render::FrameStages& stages)
      : engine_(drawable.palette, drawable.colormap), technique_(drawable.palette, drawable.colormap) {
    technique_.replace_stages(stages);
  }

  void expect_equal(const render::Scene& scene, const render::Settings& settings) {
    render::FrameBuffer wanted(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed);
    render::FrameBuffer drawn(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed);
    const render::FrameStats wanted_stats = engine_.render(scene, settings, wanted);
    stats_ = technique_.render(scene, settings, drawn);
    faces_drawn_ += stats_.faces_drawn;
    engine_faces_drawn_ += wanted_stats.faces_drawn;
    EXPECT_LE(stats_.faces_drawn, wanted_stats.faces_drawn);
    EXPECT_EQ(differing_pixels(test::copy_picture(wanted), test::copy_picture(drawn)), 0u);
    const std::vector<render::PixelFace> wanted_faces = find_faces(engine_, wanted);
    const std::vector<render::PixelFace> faces = find_faces(technique_, drawn);
    EXPECT_TRUE(std::ranges::equal(faces, wanted_faces, [](const auto& a, const auto& b) {
      return a.instance == b.instance && a.face == b.face;
    }));
  }
  std::uint64_t faces_drawn() const { return faces_drawn_; }
  std::uint64_t engine_faces_drawn() const { return engine_faces_drawn_; }

 private:
  static std::vector<render::PixelFace> find_faces(const render::Renderer& renderer,
                                                   const render::FrameBuffer& frame) {
    std::vector<render::PixelFace> faces(frame.pixel_count());
    std::vector<std::uint8_t> writes(frame.pixel_count());
    renderer.pixel_faces(faces, writes);
    return faces;
  }

  render::Renderer engine_, technique_;
  render::FrameStats stats_;
  std::uint64_t faces_drawn_ = 0, engine_faces_drawn_ = 0;
};

// Random eyes, with and without the PVS, with brush models at their places and moved, on one and two threads.
void expect_equal_views(const test::DrawableLevel& drawable, const render::FrameStages& stages, int views) {
  const world::Level& level = *drawable.level;
  TwoRenderers renderers(drawable, stages);
  for (int number = 0; number < views; ++number) {
    SCOPED_TRACE(testing::Message() << "view " << number << " of " << drawable.name);
    test::Random random(static_cast<std::uint64_t>(number));
    test::Viewpoint viewpoint{.camera = test::random_camera(level, random),
                              .brush_models = test::shown_brush_models(level)};
    if (number % 2 == 1) test::displace(level, viewpoint.brush_models, random);
    renderers.expect_equal(viewpoint.scene(level), {.threads = 1 + number % 3 / 2,
                                                    .job_backend = base::JobBackend::kStdThread,
                                                    .use_pvs = number % 4 < 2});
  }
}

TEST_P(VisibleFaces, ShowVariantsOfTheSmallLevelLikeTheEngine) {
  for (const test::SmallLevelVariant& variant : test::small_level_variants())
    expect_equal_views(test::small_level(variant.options, variant.name), make_stages(), test::effort(8, 2));
}

TEST_P(VisibleFaces, ShowStockLevelsLikeTheEngine) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e0m1", "lq_e1m2", "lqdm1"})
    expect_equal_views(test::stock_level(data, name), make_stages(), test::effort(40, 2));
}

// Eyes in solid space, far outside, on planes of the tree, and at corners where several leaves meet.
TEST_P(VisibleFaces, ShowAnyEyeLikeTheEngine) {
  const test::DrawableLevel drawable = test::small_level();
  const world::Level& level = *drawable.level;
  TwoRenderers renderers(drawable, make_stages());
  for (int number = 0; number < test::effort(200, 20); ++number) {
    SCOPED_TRACE(number);
    test::Random random(static_cast<std::uint64_t>(number));
    test::Viewpoint viewpoint{.camera = test::random_camera(level, random)};
    math::Vec3& eye = viewpoint.camera.origin_world;
    const world::Leaf& leaf = level.leaves[1 + random.below(level.leaves.size() - 1)];
    switch (number % 5) {
      case 0:
        eye += math::Vec3(3000.0f, 0.0f, 40.0f);
        break;
      case 1:
        eye.z = -1e6f;
        break;
      case 2:
        eye = leaf.bounds.mins;
        break;
      case 3:
        eye = (leaf.bounds.mins + leaf.bounds.maxs) * 0.5f;
        break;
      default: {
        const world::Plane& plane = level.planes[random.below(level.planes.size())];
        eye -= plane.normal * static_cast<float>(world::distance_to(plane, math::Vec3d(eye)));
      }
    }
    renderers.expect_equal(viewpoint.scene(level), {.use_pvs = random.chance(0.5)});
  }
}

TEST_P(VisibleFaces, ShowOtherProjectionsAndEmptyWorldsLikeTheEngine) {
  const test::DrawableLevel drawable = test::small_level();
  TwoRenderers renderers(drawable, make_stages());
  test::Random random(7);
  test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random),
                            .brush_models = test::shown_brush_models(*drawable.level)};
  render::Scene scene = viewpoint.scene(*drawable.level);
  renderers.expect_equal(scene, {.draw_world = false});
  for (const float fov_deg : {10.0f, 170.0f}) {
    scene.camera.fov_deg = fov_deg;
    renderers.expect_equal(scene, {});
  }
  scene.camera.projection = render::Projection::kOrthographic;
  scene.camera.units_per_pixel = 2;
  renderers.expect_equal(scene, {});
  scene.is_overview = true;
  renderers.expect_equal(scene, {});
}

TEST_P(VisibleFaces, ShowLevelsThatAlternateLikeTheEngine) {
  const test::DrawableLevel first = test::small_level();
  const test::SmallLevelVariant variant = test::small_level_variants().back();
  const test::DrawableLevel second = test::small_level(variant.options, variant.name);
  TwoRenderers renderers(first, make_stages());
  for (int number = 0; number < 6; ++number) {
    const world::Level& level = number % 2 == 0 ? *first.level : *second.level;
    test::Random random(static_cast<std::uint64_t>(number));
    const test::Viewpoint viewpoint{.camera = test::random_camera(level, random)};
    renderers.expect_equal(viewpoint.scene(level), {});
  }
}

TEST_P(VisibleFaces, AllocateNothingInAWarmFrame) {
  const test::DrawableLevel drawable = test::small_level();
  test::Random random(1);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  render::FrameBuffer frame(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.replace_stages(make_stages());
  for (int i = 0; i < 3; ++i) renderer.render(scene, {}, frame);
  const std::size_t before = test::allocation_count();
  renderer.render(scene, {}, frame);
  EXPECT_EQ(test::allocation_count(), before);
}

INSTANTIATE_TEST_SUITE_P(Techniques, VisibleFaces, testing::Values("leaf-faces"), [](const auto& test) {
  std::string name(test.param);
  std::ranges::replace_if(
      name, [](char c) { return c == '-' || c == ':' || c == '='; }, '_');
  return name;
});

// A view from above of the whole level reaches every leaf, so that each face is tested once.
TEST(VisibleFaces, AreTestedOnceForEachNodeOrFace) {
  const test::DrawableLevel drawable = test::small_level();
  const math::Bounds& bounds = drawable.level->world().bounds;
  render::Scene scene{.level = drawable.level.get()};
  scene.camera.projection = render::Projection::kOrthographic;
  scene.camera.origin_world = (bounds.mins + bounds.maxs) * 0.5f;
  scene.camera.origin_world.z = bounds.maxs.z + 100;
  scene.camera.angles_deg = {90, 0, 0};
  render::FrameStats stats;
  const auto count = [&](const char* technique) {
    Counter counter;
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.replace_stages(parse_choice(technique).value().make_stages(&counter));
    render::FrameBuffer frame(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed);
    stats = renderer.render(scene, {}, frame);
    return counter.take().planes_tested;
  };
  const std::uint64_t of_nodes = count("bsp-edges");
  EXPECT_GT(of_nodes, 10u);
  EXPECT_LE(of_nodes, drawable.level->nodes.size());
  EXPECT_EQ(count("leaf-faces"), of_nodes + stats.faces_in_pvs);
}

}  // namespace
}  // namespace temblor::lab
