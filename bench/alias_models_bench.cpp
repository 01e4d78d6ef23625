// Draws a hundred alias models that fill a fifth of a 1920 x 1080 picture: MDL files of 400 triangles, and
// MD5 models of 1500 that are between two frames. Measures the whole stage, from poses to pixels.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "math/angles.h"
#include "render/alias/draw_alias_models.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/pictures/stage_parts.h"
#include "support/random.h"

namespace temblor::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kBandRows = 64;  // as in whole frames
constexpr int kColumns = 10, kRows = 10;
// The triangles of a ball end inside its circle, but its near side looks larger than its center. Both effects
// together fill a fifth.
constexpr double kShareOfCircles = 0.158;
constexpr std::int64_t kFifthSide = 91;

// Side by side in front of the camera, each turned differently, none in front of another.
std::vector<render::AliasInstance> hundred_models(const render::AliasModel& model,
                                                  const render::Camera& camera, double share, float size) {
  test::Random random(1);
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  const double focal_px = kHeight * 4 / 3.0 / 2;  // 90 degrees
  const double radius_px = std::sqrt(double{kWidth} * kHeight * share / (kColumns * kRows) / 3.14159);
  const double distance = size / 2 * focal_px / radius_px;
  std::vector<render::AliasInstance> instances;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      render::AliasInstance instance;
      instance.model = &model;
      const double x = ((column + 0.5) / kColumns - 0.5) * kWidth * 0.95;
      const double y = ((row + 0.5) / kRows - 0.5) * kHeight * 0.9;
      instance.origin_world =
          camera.origin_world +
          math::Vec3((axes.forward + axes.right * (x / focal_px) + axes.up * (y / focal_px)) * distance);
      instance.angles_deg = random.in_cube(180);
      instance.full_bright = false;
      instance.min_light = 80;
      instance.from_pose = render::pose_at(model, static_cast<std::uint32_t>(row), 0);
      instance.to_pose = render::pose_at(model, static_cast<std::uint32_t>(row) + 1, 0);
      instance.blend = 0.5f;
      instances.push_back(instance);
    }
  return instances;
}

// A model, and its size in units.
struct BenchModel {
  std::shared_ptr<const render::AliasModel> model;
  float size;
};

BenchModel make_ball() {
  constexpr float kSize = 64;
  return {test::small_model(test::sphere_mdl(20, 11), kSize), kSize};
}

// 1500 triangles, with a skin as large as those of the release.
BenchModel make_column() {
  constexpr std::uint32_t kSkinSide = 512;
  constexpr float kColumnHeight = 96;
  const test::Md5Sample sample = test::bending_column(30, 25, 20, "column");
  auto posed = formats::pose_md5(formats::read_md5_model(sample.mesh).value(),
                                 formats::read_md5_animation(sample.animation).value())
                   .value();
  formats::Picture skin{kSkinSide, kSkinSide, {}};
  for (std::uint32_t i = 0; i < kSkinSide * kSkinSide; ++i)
    skin.pixels.push_back(static_cast<std::uint8_t>(i / 16 % 224));
  posed.skins = {{{{skin}}, {}}};
  return {render::make_alias_model(posed, "column").value(), kColumnHeight};
}

void draw_models(benchmark::State& state, const BenchModel& bench_model, render::PixelFormat format,
                 render::Settings settings, double share) {
  const test::DrawableLevel drawable = test::small_level({.tiny = true});
  render::Scene scene;
  scene.level = drawable.level.get();
  scene.camera.origin_world = {0, 0, 100000};
  const auto instances = hundred_models(*bench_model.model, scene.camera, share, bench_model.size);
  scene.alias_models = instances;
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  render::FrameBuffer frame(kWidth, kHeight, format);
  std::fill(frame.depth().begin(), frame.depth().end(), 0.0f);
  const render::ViewFrame view = render::make_view_frame(scene, kWidth, kHeight);
  test::StageParts parts(settings);
  // A model that is drawn again has the same depth as before, and so its pixels pass the depth test.
  for (auto _ : state) {
    parts.arenas.frame.reset();
    const std::span<const render::PreparedAlias> models =
        render::prepare_alias_models(parts.context(scene, format, tables), view);
    for (int row = 0; row < kHeight; row += kBandRows)
      render::draw_alias_models(models, settings.simd_kernels, {row, std::min(row + kBandRows, kHeight)},
                                frame);
    benchmark::ClobberMemory();
  }
  const auto pixels =
      std::count_if(frame.depth().begin(), frame.depth().end(), [](float depth) { return depth > 0; });
  state.counters["share"] = static_cast<double>(pixels) / static_cast<double>(frame.pixel_count());
}

// The argument is the mean length of the triangles' sides in tenths of a pixel. At 91, they fill a fifth of
// the picture.
void register_all() {
  const auto add = [](const char* name, render::PixelFormat format, render::AliasRaster raster,
                      bool vectors) {
    benchmark::RegisterBenchmark(name,
                                 [=](benchmark::State& state) {
                                   const double side = static_cast<double>(state.range(0)) / kFifthSide;
                                   draw_models(state, make_ball(), format,
                                               {.simd_kernels = vectors, .alias_raster = raster},
                                               kShareOfCircles * side * side);
                                 })
        ->Unit(benchmark::kMillisecond)
        ->ArgsProduct({{5, 7, 10, 15, 20, 30, 60, kFifthSide}});
  };
  using render::AliasRaster, render::PixelFormat;
  add("models/indexed/affine", PixelFormat::kIndexed, AliasRaster::kAffine, true);
  add("models/indexed/affine/plain", PixelFormat::kIndexed, AliasRaster::kAffine, false);
  add("models/indexed/subdivision", PixelFormat::kIndexed, AliasRaster::kSubdivision, true);
  add("models/rgb/affine", PixelFormat::kRgb, AliasRaster::kAffine, true);
  add("models/rgb/affine/plain", PixelFormat::kRgb, AliasRaster::kAffine, false);
  add("models/rgb/subdivision", PixelFormat::kRgb, AliasRaster::kSubdivision, true);
  // The argument is the percentage of the picture that circles around the models cover together.
  for (const auto& [name, format] : {std::pair("models/indexed/md5", PixelFormat::kIndexed),
                                     std::pair("models/rgb/md5", PixelFormat::kRgb)})
    benchmark::RegisterBenchmark(name,
                                 [=](benchmark::State& state) {
                                   draw_models(state, make_column(), format, {},
                                               static_cast<double>(state.range(0)) / 100);
                                 })
        ->Unit(benchmark::kMillisecond)
        ->ArgsProduct({{2, 5, 15, 50}});
}

const bool kRegistered = (register_all(), true);

}  // namespace
}  // namespace temblor::bench
