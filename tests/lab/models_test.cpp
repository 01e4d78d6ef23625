// The laboratory's techniques that draw models: what their pictures must not depend on, and how far they are
// from exact ones.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/exact_models.h"
#include "lab/model_pictures.h"
#include "render/alias/alias_mesh.h"
#include "render/view/view_frame.h"
#include "support/allocation_counter.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

constexpr auto kModelTechniques = {"affine-models",
                                   "affine-models:subpixel=0",
                                   "affine-models:perspective=1",
                                   "subdivided-models",
                                   "subdivided-models:light=1",
                                   "vertex-boxes",
                                   "models-in-edges",
                                   "models-in-edges:tree=1",
                                   "triangle-masks",
                                   "model-sprites",
                                   "model-sprites:frames=3",
                                   "flood-fill",
                                   "models-in-leaves",
                                   "models-in-leaves:cut=0",
                                   "deltas",
                                   "deltas:seeds=1",
                                   "stack-meshes",
                                   "stack-meshes:group=0",
                                   "compiled-triangles",
                                   "compiled-triangles:code=1"};
constexpr auto kFormats = {PixelFormat::kIndexed, PixelFormat::kRgb};

TEST(ModelTechniques, AreTheSameForAnyThreadsAndBands) {
  const DrawableLevel drawable = small_level();
  for (const char* const technique : kModelTechniques)
    for (const PixelFormat format : kFormats) {
      Random random(1);
      ModelScene models(drawable, random, {.least = 15, .count = 6});
      models.scene.view_weapon = &models.weapon;
      models.scene.fog = {.density = 0.5f, .color = {0.4f, 0.3f, 0.2f}};
      // Each draws the same two frames: the second may reuse pictures.
      std::vector<FrameCopy> first;
      for (const int threads : {1, 2, 8})
        for (const int band_rows : {7, 64}) {
          ModelPictures pictures(drawable, technique, format);
          const render::Settings settings{
              .threads = threads, .job_backend = base::JobBackend::kStdThread, .band_rows = band_rows};
          std::vector<FrameCopy> drawn;
          for (int frame = 0; frame < 2; ++frame) drawn.push_back(pictures.copy(models.scene, settings));
          if (first.empty()) first = drawn;
          EXPECT_EQ(first, drawn) << technique << " " << threads << " " << band_rows;
        }
    }
}

TEST(ModelTechniques, AreTheSameWithoutSimd) {
  const DrawableLevel drawable = small_level();
  for (int seed = 0; seed < effort(3, 1); ++seed)
    for (const char* const technique : kModelTechniques)
      for (const PixelFormat format : kFormats) {
        Random random(static_cast<std::uint64_t>(seed));
        const ModelScene models(drawable, random, {.least = 15, .count = 6});
        ModelPictures simd(drawable, technique, format), scalar(drawable, technique, format);
        for (int frame = 0; frame < 2; ++frame)
          EXPECT_EQ(simd.copy(models.scene, {}), scalar.copy(models.scene, {.simd_kernels = false}))
              << technique << ", seed " << seed;
      }
}

TEST(ModelTechniques, ShowTheWorldWithoutModels) {
  const DrawableLevel drawable = small_level();
  Random random(3);
  ModelScene models(drawable, random, {});
  models.scene.alias_models = {};
  for (const char* const technique : kModelTechniques) {
    const bool is_painted = std::string_view(technique).starts_with("models-in-leaves");
    ModelPictures engine(drawable, is_painted ? "painter" : nullptr, PixelFormat::kRgb);
    ModelPictures lab(drawable, technique, PixelFormat::kRgb);
    EXPECT_EQ(engine.copy(models.scene, {}), lab.copy(models.scene, {})) << technique;
  }
}

TEST(ModelTechniques, AllocateNothingInAWarmFrame) {
  const DrawableLevel drawable = small_level();
  for (const char* const technique : kModelTechniques) {
    Random random(4);
    const ModelScene models(drawable, random, {.least = 15, .count = 6});
    ModelPictures pictures(drawable, technique, PixelFormat::kRgb);
    for (int i = 0; i < 8; ++i) pictures.draw(models.scene, {});
    const std::size_t before = allocation_count();
    for (int i = 0; i < 6; ++i) pictures.draw(models.scene, {});
    EXPECT_EQ(allocation_count(), before) << technique;
  }
}

// The errors of a picture against the exact one, over pixels of models.
struct PictureErrors {
  double covered = 0, missing = 0, extra = 0, far_texels = 0;
};

PictureErrors find_errors(const ModelScene& models, const DrawableLevel& drawable, const char* technique) {
  render::Scene scene = models.scene;
  std::vector<render::AliasInstance> instances = models.instances;
  std::vector<std::shared_ptr<const render::AliasModel>> coded;
  for (render::AliasInstance& instance : instances) {
    coded.push_back(lab::make_coordinate_model(*instance.model, 0));
    instance.model = coded.back().get();
  }
  scene.alias_models = instances;
  ModelPictures pictures(drawable.palette, lab::make_unlit_colormap(), technique, PixelFormat::kIndexed);
  const render::FrameBuffer& frame = pictures.draw(scene, kModelsAlone);
  const auto exact = lab::draw_exact_models(scene, ModelPictures::kWidth, ModelPictures::kHeight);
  PictureErrors errors;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const bool is_drawn = frame.depth()[i] > 0;
    errors.covered += exact[i].hit;
    errors.missing += exact[i].hit && !is_drawn;
    errors.extra += !exact[i].hit && is_drawn;
    if (exact[i].hit && is_drawn)
      errors.far_texels += std::abs(std::remainder(frame.indexed()[i] + 0.5 - exact[i].s, 256)) > 1;
  }
  return errors;
}

// The sum over scenes whose models cross the near plane and the screen's edges.
PictureErrors sum_errors(const char* technique, const CrowdPlace& place) {
  const DrawableLevel drawable = small_level();
  PictureErrors sum;
  for (int seed = 0; seed < effort(12, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ModelScene models(drawable, random, place);
    const PictureErrors errors = find_errors(models, drawable, technique);
    sum.covered += errors.covered;
    sum.missing += errors.missing;
    sum.extra += errors.extra;
    sum.far_texels += errors.far_texels;
  }
  return sum;
}

// Corners are rounded to 1/256 pixel, so pixels at edges may show either side.
TEST(AffineModels, InPerspectiveAreExact) {
  for (const CrowdPlace& place : {CrowdPlace{.least = 8, .most = 60}, CrowdPlace{.least = 30}}) {
    const PictureErrors errors = sum_errors("affine-models:perspective=1", place);
    EXPECT_GT(errors.covered, 10000);
    EXPECT_LT(errors.missing, 0.001 * errors.covered);
    EXPECT_LT(errors.extra, 0.001 * errors.covered);
    EXPECT_LT(errors.far_texels, 0.002 * errors.covered);
  }
}

TEST(AffineModels, BendTexturesNearTheEye) {
  const PictureErrors near = sum_errors("affine-models", {.least = 2, .most = 60});
  EXPECT_LT(near.missing + near.extra, 0.002 * near.covered);
  EXPECT_GT(near.far_texels, 0.1 * near.covered);
  const PictureErrors far = sum_errors("affine-models", {.least = 300, .most = 900});
  EXPECT_LT(far.far_texels / far.covered, 0.5 * near.far_texels / near.covered);
}

TEST(AffineModels, AtWholePixelsAreOffAtTheirOutline) {
  const CrowdPlace place{.least = 100, .most = 600};
  const PictureErrors whole = sum_errors("affine-models:subpixel=0", place);
  const PictureErrors exact = sum_errors("affine-models", place);
  EXPECT_GT(whole.missing + whole.extra, 10 * (exact.missing + exact.extra));
  EXPECT_LT(whole.missing + whole.extra, 0.1 * whole.covered);
}

// The engine's own subdivision, forced, is the reference for models inside the screen. Without light, split
// light makes no difference, and such a picture is drawn by the laboratory's own loop.
TEST(SubdividedModels, AreTheEnginesInsideTheScreen) {
  const DrawableLevel drawable = small_level();
  for (const PixelFormat format : kFormats)
    for (int seed = 0; seed < effort(12, 3); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const ModelScene models(drawable, random, {.least = 200, .spread = 0.3});
      const auto unlit = lab::make_unlit_colormap();
      const render::Settings forced{.draw_world = false, .alias_raster = render::AliasRaster::kSubdivision};
      ModelPictures engine(drawable.palette, unlit, nullptr, format);
      for (const char* const technique : {"subdivided-models", "subdivided-models:light=1"}) {
        if (format == PixelFormat::kRgb && technique != std::string_view("subdivided-models")) continue;
        ModelPictures lab(drawable.palette, unlit, technique, format);
        EXPECT_EQ(engine.copy(models.scene, forced), lab.copy(models.scene, kModelsAlone)) << seed;
      }
    }
}

// Around the eye, triangles are too large to be split.
TEST(SubdividedModels, FillTheirShape) {
  for (const CrowdPlace& place : {CrowdPlace{.least = 28, .most = 36, .count = 3},
                                  CrowdPlace{.least = 8, .most = 60}, CrowdPlace{.least = 30}}) {
    const PictureErrors errors = sum_errors("subdivided-models", place);
    EXPECT_GT(errors.covered, 10000);
    EXPECT_LT(errors.missing, 0.02 * errors.covered);
    EXPECT_LT(errors.extra, 0.1 * errors.covered);
  }
}

TEST(SubdividedModels, SplitLight) {
  const DrawableLevel drawable = small_level();
  Random random(5);
  const ModelScene models(drawable, random, {.least = 60, .most = 90});
  ModelPictures flat(drawable, "subdivided-models", PixelFormat::kRgb);
  ModelPictures split(drawable, "subdivided-models:light=1", PixelFormat::kRgb);
  EXPECT_NE(flat.copy(models.scene, kModelsAlone).rgb, split.copy(models.scene, kModelsAlone).rgb);
}

// Outlines lie at the nearest pixels, half of a pixel too far on average. Colors are those of the nearest
// edge or vertex.
TEST(FloodFill, FillsTheOutlineWithWrongTexels) {
  for (const CrowdPlace& place : {CrowdPlace{.least = 60}, CrowdPlace{.least = 300, .most = 900}}) {
    const PictureErrors errors = sum_errors("flood-fill", place);
    EXPECT_GT(errors.covered, 5000);
    EXPECT_LT(errors.missing, 0.01 * errors.covered);
    EXPECT_LT(errors.extra, 0.2 * errors.covered);
    EXPECT_GT(errors.extra, 0);
    EXPECT_GT(errors.far_texels, 0.05 * errors.covered);
  }
}

// The same triangles by scan lines are the reference. Texels are computed in another order, so a few round
// differently.
TEST(TriangleMasks, DrawTheTrianglesOfScanLines) {
  const DrawableLevel drawable = small_level();
  for (int seed = 0; seed < effort(12, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ModelScene models(drawable, random, {.least = 100, .most = 1500, .spread = 0.8, .count = 20});
    ModelPictures scan_lines(drawable, "affine-models:subpixel=0", PixelFormat::kIndexed);
    ModelPictures masks(drawable, "triangle-masks", PixelFormat::kIndexed);
    const FrameCopy right = scan_lines.copy(models.scene, kModelsAlone);
    const FrameCopy drawn = masks.copy(models.scene, kModelsAlone);
    std::size_t covered = 0, different = 0;
    for (std::size_t i = 0; i < right.depth_bits.size(); ++i) {
      const float depth = std::bit_cast<float>(right.depth_bits[i]);
      covered += depth > 0;
      EXPECT_NEAR(depth, std::bit_cast<float>(drawn.depth_bits[i]), 1e-5f) << seed;
      different += right.indexed[i] != drawn.indexed[i];
    }
    EXPECT_LT(different, covered / 100 + 2) << seed;
  }
}

// Coverage is that of the depth buffer. Only triangles that pierce each other are wrong, for a part of a
// span.
TEST(ModelsInEdges, AreTheEnginesModels) {
  const DrawableLevel drawable = small_level();
  for (const PixelFormat format : kFormats)
    for (int seed = 0; seed < effort(12, 3); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      ModelScene models(drawable, random, {.least = 100, .most = 600, .spread = 0.8, .count = 20});
      models.scene.view_weapon = &models.weapon;
      const render::Settings affine{.alias_raster = render::AliasRaster::kAffine};
      ModelPictures engine(drawable, nullptr, format), list(drawable, "models-in-edges", format);
      ModelPictures tree(drawable, "models-in-edges:tree=1", format);
      const FrameCopy right = engine.copy(models.scene, affine), drawn = list.copy(models.scene, {});
      EXPECT_LT(differing_pixels(right, drawn), right.depth_bits.size() / 50) << seed;
      EXPECT_EQ(drawn, tree.copy(models.scene, {})) << seed;
    }
}

TEST(ModelsInEdges, AreExactWhereNothingPierces) {
  const DrawableLevel drawable = small_level();
  for (int seed = 0; seed < effort(12, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ModelScene models(drawable, random, {.least = 30, .most = 200, .count = 1});
    const render::Settings affine{.draw_world = false, .alias_raster = render::AliasRaster::kAffine};
    ModelPictures engine(drawable, nullptr, PixelFormat::kIndexed);
    ModelPictures edges(drawable, "models-in-edges", PixelFormat::kIndexed);
    EXPECT_EQ(differing_pixels(engine.copy(models.scene, affine), edges.copy(models.scene, kModelsAlone)), 0u)
        << seed;
  }
}

TEST(ModelsInEdges, RefuseScenesWithManyTriangles) {
  const DrawableLevel drawable = small_level();
  Random random(1);
  const ModelScene models(drawable, random, {.count = 1});
  const lab::Choice few = lab::parse_choice("models-in-edges:triangles=10").value();
  EXPECT_FALSE(few.check_scene(models.scene).ok());
  EXPECT_TRUE(lab::parse_choice("models-in-edges").value().check_scene(models.scene).ok());
  ModelPictures engine(drawable, nullptr, PixelFormat::kRgb);
  ModelPictures refused(drawable, "models-in-edges:triangles=10", PixelFormat::kRgb);
  EXPECT_EQ(engine.copy(models.scene, {}), refused.copy(models.scene, {}));
}

// Every vertex before the eye has its box, and no pixel is drawn that belongs to none.
TEST(VertexBoxes, AreAtTheVertices) {
  const DrawableLevel drawable = small_level();
  for (int seed = 0; seed < effort(12, 3); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    ModelScene models(drawable, random, {.least = 100, .spread = 0.8, .count = 1});
    const render::AliasInstance& instance = models.instances.front();
    const render::ViewFrame view =
        render::make_view_frame(models.scene, ModelPictures::kWidth, ModelPictures::kHeight);
    ModelPictures pictures(drawable, "vertex-boxes", PixelFormat::kIndexed);
    const render::FrameBuffer& frame = pictures.draw(models.scene, kModelsAlone);
    std::vector<bool> is_near_a_vertex(frame.pixel_count());
    const render::AliasModel& model = *instance.model;
    const math::Basis turn =
        math::basis_from_angles({-instance.angles_deg.x, instance.angles_deg.y, instance.angles_deg.z});
    const render::PoseBytes from = model.pose(instance.from_pose), to = model.pose(instance.to_pose);
    const auto mix = [&](std::uint8_t a, std::uint8_t b) { return a + (b - a) * double{instance.blend}; };
    int boxes = 0;
    for (std::size_t i = 0; i < model.vertex_count; ++i) {
      const math::Vec3d element(mix(from.x[i], to.x[i]), mix(from.y[i], to.y[i]), mix(from.z[i], to.z[i]));
      const math::Vec3d p = element * math::Vec3d(model.scale) + math::Vec3d(model.origin);
      const math::Vec2d screen = view.to_screen(view.to_view(
          math::Vec3d(instance.origin_world) + turn.forward * p.x - turn.right * p.y + turn.up * p.z));
      for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
          const double distance = std::max(std::abs(x - screen.x), std::abs(y - screen.y));
          const std::size_t at = static_cast<std::size_t>(y * frame.width() + x);
          if (distance < 1.01) is_near_a_vertex[at] = true;
          if (distance < 0.49) {
            ++boxes;
            EXPECT_GT(frame.depth()[at], 0) << seed;
          }
        }
    }
    EXPECT_GT(boxes, 0) << seed;
    for (std::size_t at = 0; at < frame.pixel_count(); ++at)
      if (frame.depth()[at] > 0) {
        EXPECT_TRUE(is_near_a_vertex[at]) << seed;
      }
  }
}

}  // namespace
}  // namespace temblor::test
