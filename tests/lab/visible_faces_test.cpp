// The laboratory's ways to find visible faces, against the engine: every pixel, its depth, and its face are
// the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lab/registry.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"

namespace temblor::lab {
namespace {

constexpr int kFaceViewWidth = 333, kFaceViewHeight = 203;

class VisibleFaces : public testing::TestWithParam<const char*> {};

// Whether the line goes through solid space for more than a twentieth of a unit.
bool crosses_solid(const world::Level& level, world::Child child, const math::Vec3d& from,
                   const math::Vec3d& to) {
  if (child.is_leaf())
    return level.leaf(child.leaf()).contents == world::Contents::kSolid && glm::distance(from, to) > 0.05;
  const world::Node& node = level.node(child.node());
  const world::Plane& plane = level.planes[node.plane];
  const double from_height = world::distance_to(plane, from), to_height = world::distance_to(plane, to);
  const world::Child from_side = node.children[from_height >= 0 ? 0 : 1];
  const world::Child to_side = node.children[to_height >= 0 ? 0 : 1];
  if ((from_height >= 0) == (to_height >= 0)) return crosses_solid(level, from_side, from, to);
  const math::Vec3d middle = from + (to - from) * (from_height / (from_height - to_height));
  return crosses_solid(level, from_side, from, middle) || crosses_solid(level, to_side, middle, to);
}

// Draws the same scenes with the engine and a technique, one after another.
class TwoRenderers {
 public:
  TwoRenderers(const test::DrawableLevel& drawable, const char* technique)
      : engine_(drawable.palette, drawable.colormap),
        technique_(drawable.palette, drawable.colormap),
        wanted_(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed),
        drawn_(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed) {
    technique_.replace_stages(parse_choice(technique).value().make_stages());
    may_miss_behind_solid_ = std::string_view(technique).starts_with("portals");
  }

  // Portals see nothing through solid space. The engine does, where a level has a wall without a face, or
  // where the eye looks out of the level. All other pixels must be equal.
  void expect_equal(const render::Scene& scene, const render::Settings& settings) {
    engine_faces_drawn_ += engine_.render(scene, settings, wanted_).faces_drawn;
    faces_drawn_ += technique_.render(scene, settings, drawn_).faces_drawn;
    const std::vector<render::PixelFace> wanted_faces = find_faces(engine_, wanted_);
    const std::vector<render::PixelFace> faces = find_faces(technique_, drawn_);
    const render::ViewFrame view = render::make_view_frame(scene, kFaceViewWidth, kFaceViewHeight);
    int wrong = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const bool is_equal =
          faces[i].instance == wanted_faces[i].instance && faces[i].face == wanted_faces[i].face &&
          wanted_.indexed()[i] == drawn_.indexed()[i] && wanted_.depth()[i] == drawn_.depth()[i];
      if (is_equal) continue;
      const bool is_missed = may_miss_behind_solid_ && is_behind_solid(*scene.level, view, i);
      missed_ += is_missed;
      wrong += !is_missed;
    }
    pixels_ += faces.size();
    EXPECT_EQ(wrong, 0);
  }
  double share_missed() const { return static_cast<double>(missed_) / static_cast<double>(pixels_); }
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

  bool is_behind_solid(const world::Level& level, const render::ViewFrame& view, std::size_t pixel) const {
    if (!view.perspective || !(wanted_.depth()[pixel] > 0)) return false;
    const double z = 1.0 / static_cast<double>(wanted_.depth()[pixel]);
    const double x = static_cast<double>(pixel % kFaceViewWidth) - view.center_x;
    const double y = view.center_y - static_cast<double>(pixel / kFaceViewWidth);
    const math::Vec3d ray =
        view.axes.forward + (view.axes.right * x + view.axes.up * y) / view.pixels_per_unit;
    return crosses_solid(level, level.world().head, view.eye_world, view.eye_world + ray * (z * 0.999));
  }

  render::Renderer engine_, technique_;
  render::FrameBuffer wanted_, drawn_;
  bool may_miss_behind_solid_ = false;
  std::uint64_t faces_drawn_ = 0, engine_faces_drawn_ = 0, missed_ = 0, pixels_ = 0;
};

// Random eyes, with and without the PVS, with brush models at their places and moved, on one and two threads.
void expect_equal_views(const world::Level& level, TwoRenderers& io_renderers, int views) {
  for (int number = 0; number < views; ++number) {
    SCOPED_TRACE(testing::Message() << "view " << number << " of " << level.name);
    test::Random random(static_cast<std::uint64_t>(number));
    test::Viewpoint viewpoint{.camera = test::random_camera(level, random),
                              .brush_models = test::shown_brush_models(level)};
    if (number % 2 == 1) test::displace(level, viewpoint.brush_models, random);
    io_renderers.expect_equal(viewpoint.scene(level), {.threads = 1 + number % 3 / 2,
                                                       .job_backend = base::JobBackend::kStdThread,
                                                       .use_pvs = number % 4 < 2});
  }
}

TEST_P(VisibleFaces, ShowVariantsOfTheSmallLevelLikeTheEngine) {
  for (const test::SmallLevelVariant& variant : test::small_level_variants()) {
    const test::DrawableLevel drawable = test::small_level(variant.options, variant.name);
    TwoRenderers renderers(drawable, GetParam());
    expect_equal_views(*drawable.level, renderers, test::effort(8, 2));
    EXPECT_EQ(renderers.share_missed(), 0);
  }
}

TEST_P(VisibleFaces, ShowStockLevelsLikeTheEngine) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e0m1", "lq_e1m2", "lqdm1"}) {
    const test::DrawableLevel drawable = test::stock_level(data, name);
    TwoRenderers renderers(drawable, GetParam());
    expect_equal_views(*drawable.level, renderers, test::effort(40, 2));
    EXPECT_LT(renderers.share_missed(), 0.002);
    if (std::string_view(GetParam()) == "portals:pvs=1") {
      EXPECT_LT(renderers.faces_drawn(), renderers.engine_faces_drawn());
    }
  }
}

// Through the surfaces of liquids, in a level whose leaves all see each other.
TEST_P(VisibleFaces, ShowTranslucentLiquidsLikeTheEngine) {
  const test::DrawableLevel drawable = test::small_level({.pvs = false}, "small without a PVS");
  TwoRenderers renderers(drawable, GetParam());
  for (int number = 0; number < test::effort(60, 6); ++number) {
    SCOPED_TRACE(number);
    test::Random random(static_cast<std::uint64_t>(number));
    const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
    render::Scene scene = viewpoint.scene(*drawable.level);
    scene.liquid_alpha.water = scene.liquid_alpha.slime = scene.liquid_alpha.lava = 0.5f;
    renderers.expect_equal(scene, {});
  }
}

// Eyes in solid space, far outside, on planes of the tree, and at corners where several leaves meet.
TEST_P(VisibleFaces, ShowAnyEyeLikeTheEngine) {
  const test::DrawableLevel drawable = test::small_level();
  const world::Level& level = *drawable.level;
  TwoRenderers renderers(drawable, GetParam());
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
  TwoRenderers renderers(drawable, GetParam());
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
  TwoRenderers renderers(first, GetParam());
  for (int number = 0; number < 6; ++number) {
    const world::Level& level = number % 2 == 0 ? *first.level : *second.level;
    test::Random random(static_cast<std::uint64_t>(number));
    const test::Viewpoint viewpoint{.camera = test::random_camera(level, random)};
    renderers.expect_equal(viewpoint.scene(level), {});
  }
}

// Planes without direction, in the wrong place, or used twice; solid leaves that are open, and the reverse.
// No picture is right then, but every pixel is drawn.
TEST_P(VisibleFaces, DrawDamagedLevels) {
  const test::DrawableLevel drawable = test::small_level();
  for (int seed = 0; seed < test::effort(60, 6); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    world::Level level = *drawable.level;
    level.identity = std::make_shared<const world::LevelIdentity>();
    const test::Viewpoint viewpoint{.camera = test::random_camera(level, random)};
    for (int i = 0; i < 20; ++i) {
      world::Plane& plane = level.planes[random.below(level.planes.size())];
      if (random.chance(0.3)) plane = level.planes[random.below(level.planes.size())];
      if (random.chance(0.3)) plane.distance = static_cast<float>(random.uniform(-1e9, 1e9));
      if (random.chance(0.2)) plane.normal = math::Vec3(0.0f);
      world::Leaf& leaf = level.leaves[random.below(level.leaves.size())];
      leaf.contents = random.chance(0.5) ? world::Contents::kSolid : world::Contents::kWater;
    }
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.replace_stages(parse_choice(GetParam()).value().make_stages());
    render::FrameBuffer frame(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed);
    renderer.render(viewpoint.scene(level), {.use_pvs = seed % 2 == 0}, frame);
    std::vector<render::PixelFace> faces(frame.pixel_count());
    std::vector<std::uint8_t> writes(frame.pixel_count());
    renderer.pixel_faces(faces, writes);
    EXPECT_TRUE(std::ranges::all_of(writes, [](int count) { return count == 1; })) << seed;
  }
}

TEST_P(VisibleFaces, AllocateNothingInAWarmFrame) {
  const test::DrawableLevel drawable = test::small_level();
  test::Random random(1);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  render::FrameBuffer frame(kFaceViewWidth, kFaceViewHeight, render::PixelFormat::kIndexed);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.replace_stages(parse_choice(GetParam()).value().make_stages());
  for (int i = 0; i < 3; ++i) renderer.render(scene, {}, frame);
  const std::size_t before = test::allocation_count();
  renderer.render(scene, {}, frame);
  EXPECT_EQ(test::allocation_count(), before);
}

INSTANTIATE_TEST_SUITE_P(Techniques, VisibleFaces,
                         testing::Values("leaf-faces", "portals", "portals:octagon=1", "portals:pvs=1"),
                         [](const auto& test) {
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
