// Models that are painted leaf by leaf, against the engine's depth buffer.
#include "lab/models/leaves/models_in_leaves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lab/model_pictures.h"
#include "lab/models/leaves/leaf_order.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

// The places of the leaves in the frame of a scene, by order.
std::vector<std::pair<lab::LeafPlace, world::LeafIndex>> list_places(const lab::LeafOrder& order,
                                                                     const world::Level& level) {
  std::vector<std::pair<lab::LeafPlace, world::LeafIndex>> places;
  for (std::uint32_t node = 0; node < level.nodes.size(); ++node)
    for (const std::size_t side : {0, 1}) {
      const world::Child child = level.nodes[node].children[side];
      if (child.is_leaf()) places.push_back({order.find(world::NodeIndex{node}, side), child.leaf()});
    }
  std::ranges::sort(places, {}, [](const auto& place) { return place.first.order; });
  return places;
}

// Leaves and faces have one sequence of keys, so the engine's own keys are the reference.
void expect_engines_order(const DrawableLevel& drawable, int views) {
  for (int seed = 0; seed < views; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Viewpoint view{.camera = random_camera(*drawable.level, random)};
    render::Renderer renderer(drawable.palette, drawable.colormap);
    render::FrameStages stages;
    int visible_leaves = 0;
    stages.find_visible_faces = [&](const render::FrameContext& context, const render::ViewFrame& frame_view,
                                    const render::LevelTables& tables) {
      const render::VisibleFaces visible = render::find_visible_faces(context, frame_view, tables);
      const world::Level& level = context.level();
      const lab::LeafOrder order(level, frame_view.eye_world, visible, context.arena());
      render::SortKey before = lab::kBehindAll;
      for (const auto& [place, leaf] : list_places(order, level)) {
        if (place.order == 0 && place.behind == lab::kBehindAll && leaf == world::LeafIndex{0}) continue;
        EXPECT_LE(place.behind, before) << seed;
        before = place.behind;
        const render::SortKey key = visible.leaf_keys[base::to_size(leaf)];
        if (key == render::kNotVisited) continue;
        ++visible_leaves;
        EXPECT_EQ(place.behind, key) << seed;
      }
      return visible;
    };
    renderer.replace_stages(stages);
    render::FrameBuffer frame(160, 100, render::PixelFormat::kIndexed);
    renderer.render(view.scene(*drawable.level), {}, frame);
    EXPECT_GT(visible_leaves, 0) << seed;
  }
}

TEST(LeafOrder, IsTheEngines) {
  expect_engines_order(small_level(), effort(30, 5));
}

TEST(LeafOrder, IsTheEnginesInStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  expect_engines_order(stock_level(data, "lq_e1m2"), effort(20, 3));
}

struct PaintErrors {
  std::size_t wrong = 0, shown = 0;
};

// Counts pixels with a wrong depth. `changed`: pixels that the models change.
PaintErrors paint(const DrawableLevel& drawable, const char* technique, std::size_t model, int views) {
  PaintErrors errors;
  for (int seed = 0; seed < views; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    ModelScene models(drawable, random, {.least = 40, .most = 300, .count = 1});
    for (render::AliasInstance& instance : models.instances) {
      instance.model = models.models[model].get();
      instance.from_pose = instance.to_pose = render::pose_at(*instance.model, 0, 0);
    }
    const render::Settings affine{.alias_raster = render::AliasRaster::kAffine};
    ModelPictures engine(drawable, nullptr, render::PixelFormat::kIndexed);
    ModelPictures painted(drawable, technique, render::PixelFormat::kIndexed);
    ModelPictures empty(drawable, nullptr, render::PixelFormat::kIndexed);
    const FrameCopy right = engine.copy(models.scene, affine), drawn = painted.copy(models.scene, affine);
    models.scene.alias_models = {};
    const FrameCopy world = empty.copy(models.scene, affine);
    for (std::size_t i = 0; i < right.depth_bits.size(); ++i) {
      const auto is_near = [](std::uint32_t a, std::uint32_t b) {
        const float first = std::bit_cast<float>(a), second = std::bit_cast<float>(b);
        return std::abs(first - second) <= 0.01f * std::abs(first);
      };
      errors.shown += !is_near(right.depth_bits[i], world.depth_bits[i]);
      errors.wrong += !is_near(right.depth_bits[i], drawn.depth_bits[i]);
    }
  }
  return errors;
}

// Front triangles of a convex model do not hide each other, so only corners of parts, which are rounded,
// differ.
TEST(ModelsInLeaves, ShowConvexModelsBetweenWalls) {
  const PaintErrors cut = paint(small_level(), "models-in-leaves", 0, effort(60, 12));
  EXPECT_GT(cut.shown, 5000u);
  EXPECT_LT(cut.wrong, cut.shown / 100);
  const PaintErrors whole = paint(small_level(), "models-in-leaves:cut=0", 0, effort(60, 12));
  EXPECT_GT(whole.wrong, 4 * cut.wrong + 20);
}

TEST(ModelsInLeaves, ShowConvexModelsInStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  const PaintErrors cut = paint(stock_level(data, "lq_e1m2"), "models-in-leaves", 0, effort(40, 10));
  EXPECT_GT(cut.shown, 1000u);
  EXPECT_LT(cut.wrong, cut.shown / 50);
}

}  // namespace
}  // namespace temblor::test
