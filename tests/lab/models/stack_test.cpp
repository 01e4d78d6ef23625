// Meshes as commands for a stack of vertices, and their pictures against the engine's scan lines.
#include <gtest/gtest.h>

#include "lab/model_pictures.h"
#include "lab/models/stack/cache_misses.h"
#include "lab/models/stack/cache_simulator.h"
#include "lab/models/stack/stack_mesh.h"
#include "lab/models/stack/stack_meshes.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using lab::StackCommand;
using render::MeshTriangle;
using render::PixelFormat;

using Triangles = std::vector<MeshTriangle>;

constexpr std::size_t kStacks[] = {4, 5, 16, 33, 64};
constexpr auto kFinders = {lab::find_greedy_stream, lab::find_separated_stream};

// Executes the commands, and checks each.
void expect_each_triangle_once(const Triangles& triangles, const lab::CommandStream& stream,
                               std::size_t places, std::uint64_t seed) {
  std::vector<std::uint32_t> stack;
  std::vector<int> draws(triangles.size());
  std::size_t pushes = 0;
  for (const StackCommand& command : stream.commands) {
    switch (command.kind) {
      case StackCommand::Kind::kPush:
        stack.push_back(command.number);
        ++pushes;
        ASSERT_LE(stack.size(), places) << seed;
        break;
      case StackCommand::Kind::kPop:
        ASSERT_LE(command.number, stack.size()) << seed;
        stack.resize(stack.size() - command.number);
        break;
      case StackCommand::Kind::kDraw:
        ASSERT_LT(command.number, triangles.size()) << seed;
        ++draws[command.number];
        for (std::size_t corner = 0; corner < 3; ++corner) {
          ASSERT_LT(command.positions[corner], stack.size()) << seed;
          ASSERT_EQ(stack[command.positions[corner]], triangles[command.number][corner]) << seed;
        }
        break;
    }
  }
  EXPECT_EQ(pushes, stream.pushes);
  EXPECT_TRUE(std::ranges::all_of(draws, [](int count) { return count == 1; })) << seed << " " << places;
}

// Triangles between nearby numbers, among them equal ones, ones with a vertex twice, and separate parts.
Triangles random_mesh(Random& random, std::size_t vertex_count, std::size_t count) {
  Triangles triangles;
  const std::size_t reach = 1 + random.below(vertex_count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = random.below(vertex_count);
    MeshTriangle triangle{};
    for (std::uint32_t& vertex : triangle)
      vertex = static_cast<std::uint32_t>((first + random.below(reach)) % vertex_count);
    triangles.push_back(triangle);
    if (random.below(8) == 0) triangles.push_back(triangle);
  }
  return triangles;
}

TEST(CommandStreams, DrawEachTriangleOfRandomMeshesOnce) {
  for (int seed = 0; seed < effort(400, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const std::size_t vertex_count = 1 + random.below(90);
    const std::size_t count = random.below(200);
    const Triangles triangles = random_mesh(random, vertex_count, count);
    for (const std::size_t places : kStacks)
      for (const auto find : kFinders)
        expect_each_triangle_once(triangles, find(triangles, vertex_count, places), places,
                                  static_cast<std::uint64_t>(seed));
  }
}

TEST(CommandStreams, OfNothingAreEmpty) {
  for (const auto find : kFinders) {
    EXPECT_TRUE(find({}, 0, 16).commands.empty());
    EXPECT_TRUE(find({}, 7, 16).commands.empty());
  }
}

// A fan around one vertex, equal triangles, and triangles that are points.
TEST(CommandStreams, OfDegenerateMeshesEnd) {
  const std::uint32_t count = static_cast<std::uint32_t>(effort(5000, 500));
  Triangles fan, equal(count, MeshTriangle{0, 1, 2}), points;
  for (std::uint32_t i = 0; i < count; ++i) {
    fan.push_back({0, i + 1, i + 2});
    points.push_back({i, i, i});
  }
  for (const Triangles& mesh : {fan, equal, points})
    for (const std::size_t places : kStacks)
      for (const auto find : kFinders)
        expect_each_triangle_once(mesh, find(mesh, count + 2, places), places, 0);
  EXPECT_EQ(lab::find_command_stream(equal, count + 2, 4).pushes, 3u);
}

// A grid of squares, each of two triangles.
Triangles grid_mesh(std::uint32_t side) {
  Triangles triangles;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t at = y * (side + 1) + x;
      triangles.push_back({at, at + 1, at + side + 1});
      triangles.push_back({at + 1, at + side + 2, at + side + 1});
    }
  return triangles;
}

// More places need fewer pushes: n(1 + c/k).
TEST(CommandStreams, NeedFewerPushesWithMorePlaces) {
  const std::uint32_t side = static_cast<std::uint32_t>(effort(70, 20));
  const Triangles triangles = grid_mesh(side);
  const std::size_t vertices = (side + 1) * (side + 1);
  double before = 6;
  for (const std::size_t places : {4, 8, 16, 32, 64}) {
    const double pushes = static_cast<double>(lab::find_command_stream(triangles, vertices, places).pushes) /
                          static_cast<double>(vertices);
    EXPECT_LT(pushes, before) << places;
    EXPECT_LT(pushes, 1 + 12.0 / static_cast<double>(places)) << places;
    before = pushes;
  }
}

// Parts whose separators fit the stack need one push for each vertex.
TEST(CommandStreams, NeedEachVertexOnceWithEnoughPlaces) {
  const Triangles triangles = grid_mesh(14);
  EXPECT_EQ(lab::find_separated_stream(triangles, 15 * 15, 64).pushes, 15u * 15u);
  EXPECT_GT(lab::find_greedy_stream(triangles, 15 * 15, 64).pushes, 15u * 15u);
  EXPECT_EQ(lab::find_command_stream(triangles, 15 * 15, 64).pushes, 15u * 15u);
}

// The model with its triangles in the order of the stream.
formats::Mdl in_stream_order(const formats::Mdl& mdl, std::size_t places) {
  const auto model = small_model(mdl);
  formats::Mdl ordered = mdl;
  ordered.triangles.clear();
  for (const StackCommand& command :
       lab::find_command_stream(model->triangles, model->vertex_count, places).commands)
    if (command.kind == StackCommand::Kind::kDraw) ordered.triangles.push_back(mdl.triangles[command.number]);
  return ordered;
}

// The engine, with the same order of triangles, must show the same picture, bit for bit.
TEST(StackMeshes, AreTheEnginesScanLines) {
  const DrawableLevel drawable = small_level();
  for (const char* const technique :
       {"stack-meshes", "stack-meshes:group=0", "stack-meshes:stack=4,group=16", "stack-meshes:stack=64"}) {
    const lab::Choice choice = lab::parse_choice(technique).value();
    for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
      for (int seed = 0; seed < effort(6, 2); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        ModelScene models(drawable, random, {.least = 15, .most = 600, .spread = 0.8, .count = 12});
        models.scene.view_weapon = &models.weapon;
        ModelPictures engine(drawable, nullptr, format), stacked(drawable, technique, format);
        // Groups that touch no row of a band are skipped.
        const FrameCopy drawn = stacked.copy(models.scene, {.band_rows = seed % 2 == 0 ? 8 : 0});
        std::vector<std::shared_ptr<const render::AliasModel>> ordered;
        const auto places = static_cast<std::size_t>(choice.values[0]);
        for (const formats::Mdl& mdl :
             {sphere_mdl(), box_mdl(), many_pose_mdl(), flat_mdl(true), flat_mdl(false)})
          ordered.push_back(small_model(in_stream_order(mdl, places)));
        const auto replace = [&](render::AliasInstance& io_instance) {
          const auto found = std::ranges::find(models.models, io_instance.model,
                                               [](const auto& model) { return model.get(); });
          io_instance.model = ordered[static_cast<std::size_t>(found - models.models.begin())].get();
        };
        std::ranges::for_each(models.instances, replace);
        replace(models.weapon);
        EXPECT_EQ(drawn, engine.copy(models.scene, {.alias_raster = render::AliasRaster::kAffine}))
            << technique << " " << seed;
      }
  }
}

// In the order of the file, only pixels with equal depths may differ.
TEST(StackMeshes, DifferFromTheEngineOnlyAtEqualDepths) {
  const DrawableLevel drawable = small_level();
  for (int seed = 0; seed < effort(20, 4); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ModelScene models(drawable, random, {.least = 15, .most = 600, .spread = 0.8, .count = 12});
    ModelPictures engine(drawable, nullptr, PixelFormat::kRgb);
    ModelPictures stacked(drawable, "stack-meshes", PixelFormat::kRgb);
    const FrameCopy right = engine.copy(models.scene, {.alias_raster = render::AliasRaster::kAffine});
    const FrameCopy drawn = stacked.copy(models.scene, {});
    EXPECT_EQ(right.depth_bits, drawn.depth_bits) << seed;
    EXPECT_LT(differing_pixels(right, drawn), 8u) << seed;
  }
}

// A stage keeps meshes by their address. Another model at the same one must be noticed.
TEST(StackMeshes, NoticeOtherModels) {
  render::AliasModel model = *small_model(sphere_mdl());
  const lab::StackMesh own(model, {});
  EXPECT_TRUE(own.match(model));
  model.texels[3].s += 1;
  EXPECT_FALSE(own.match(model));
  model.texels[3].s -= 1;
  ++model.poses[5];
  EXPECT_FALSE(own.match(model));
}

// Sixteen bits for each element, as MD3 and MD5 files have.
render::AliasModel widen(const render::AliasModel& model) {
  render::AliasModel wide = model;
  wide.wide_poses.assign(model.poses.begin(), model.poses.end());
  wide.poses.clear();
  return wide;
}

TEST(StackMeshes, DrawWidePoses) {
  const DrawableLevel drawable = small_level();
  for (const char* const technique : {"stack-meshes", "stack-meshes:group=0"}) {
    Random random(7);
    ModelScene models(drawable, random, {.least = 30, .count = 10});
    ModelPictures bytes(drawable, technique, PixelFormat::kRgb), wide(drawable, technique, PixelFormat::kRgb);
    const FrameCopy right = bytes.copy(models.scene, {});
    std::vector<render::AliasModel> widened;
    for (const auto& model : models.models) widened.push_back(widen(*model));
    for (std::size_t i = 0; i < models.instances.size(); ++i)
      models.instances[i].model = &widened[i % widened.size()];
    EXPECT_EQ(right, wide.copy(models.scene, {})) << technique;
  }
}

// One line in each set and way: what fits is missed once. In order of use, the oldest line makes room.
TEST(CacheSimulator, CountsLinesThatAreMissing) {
  lab::CacheSimulator cache({1024, 2, 32});
  for (int pass = 0; pass < 3; ++pass)
    for (std::uint64_t at = 0; at < 1024; at += 4) cache.touch(at, 4);
  EXPECT_EQ(cache.misses(), 32u);
  cache.touch(30, 4);  // in two lines, which are there
  EXPECT_EQ(cache.misses(), 32u);
  // Three lines of one set take turns in two ways.
  lab::CacheSimulator set({1024, 2, 32});
  for (int pass = 0; pass < 5; ++pass)
    for (const std::uint64_t at : {0, 512, 1024}) set.touch(at, 4);
  EXPECT_EQ(set.misses(), 15u);
  set.touch(1024, 4);
  set.touch(512, 4);
  EXPECT_EQ(set.misses(), 15u);
  set.touch(0, 4);  // replaces 1024
  set.touch(512, 4);
  EXPECT_EQ(set.misses(), 16u);
  set.touch(1024, 4);
  EXPECT_EQ(set.misses(), 17u);
}

// A list of vertices that is larger than the cache is read again and again; the stack stays.
TEST(CacheMisses, AreFewerWithAStack) {
  const auto model = small_model(sphere_mdl(70, 71));
  const lab::StackMesh mesh(*model, {});
  const lab::Counts counts = lab::count_vertex_work(*model, mesh);
  EXPECT_EQ(counts.model_triangles, model->triangles.size());
  EXPECT_GE(counts.vertex_loads, counts.vertices);
  EXPECT_LT(counts.stack_misses, counts.list_misses);
  // All that is read once, and the stack's own lines.
  const std::size_t once = mesh.push_row() * 2 * 4 + mesh.push_row() * 8 + model->triangles.size() * 12;
  EXPECT_GT(counts.stack_misses * 32, once);
  EXPECT_LT(counts.stack_misses * 32, 2 * once);
}

}  // namespace
}  // namespace temblor::test
