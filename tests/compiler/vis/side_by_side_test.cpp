// Every map of the game data, compiled and drawn next to the finished level that its makers ship: the same
// views of both, pixel by pixel. Rays (stock_maps_test.cpp) compare the faces; pictures show, in addition,
// that the tree's order, the visibility and the rounded corners in the file let all of them be seen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "compiler/compiled_maps.h"
#include "compiler/vis/sight_lines.h"
#include "math/angles.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"
#include "world/face_at.h"
#include "world/trace.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using math::Vec3;
using math::Vec3d;

constexpr int kWidth = 320, kHeight = 240;

// All texels have one value whose color is as bright as the light on it: light 128 leaves it at 128.
constexpr std::uint8_t kPaint = 1;
formats::Palette paint_palette() {
  formats::Palette palette{};
  palette[kPaint] = {128, 128, 128};
  return palette;
}

std::shared_ptr<const world::Level> painted_level(formats::Bsp bsp, const std::string& name) {
  for (formats::BspMiptex& texture : bsp.miptexes)
    for (std::vector<std::uint8_t>& mip : texture.mips) std::fill(mip.begin(), mip.end(), kPaint);
  return world::make_level(std::move(bsp), name).value();
}

// Draws one level, and knows what each pixel of the last picture shows.
class Painter {
 public:
  Painter(formats::Bsp bsp, const std::string& name)
      : level_(painted_level(std::move(bsp), name)),
        brush_models_(shown_brush_models(*level_)),
        renderer_(paint_palette(), formats::make_colormap(paint_palette())),
        frame_(kWidth, kHeight, render::PixelFormat::kRgb),
        faces_(frame_.pixel_count()),
        writes_(frame_.pixel_count()) {}

  const world::Level& level() const { return *level_; }

  void draw(const render::Camera& camera) {
    render::Settings settings;
    settings.colored_light = false;
    const render::FrameStats stats = renderer_.render(
        {.level = level_.get(), .camera = camera, .brush_models = brush_models_}, settings, frame_);
    faces_seen_ += stats.faces_seen;
    renderer_.pixel_faces(faces_, writes_);
  }

  // Over all pictures.
  std::uint64_t faces_seen() const { return faces_seen_; }

  // In the last picture. Null: background.
  const world::Face* face(std::size_t pixel) const {
    const render::PixelFace& seen = faces_[pixel];
    if (seen.instance == render::PixelFace::kNothing) return nullptr;
    return &level_->faces[seen.face];
  }
  world::FacePlane plane(std::size_t pixel) const {
    world::FacePlane plane = world::compute_face_plane(*level_, *face(pixel));
    const std::uint32_t instance = faces_[pixel].instance;
    if (instance > 0)
      plane.distance += glm::dot(Vec3d(plane.normal), Vec3d(brush_models_[instance - 1].origin_world));
    return plane;
  }
  std::string texture(std::size_t pixel) const {
    return base::to_lower(level_->texture(face(pixel)->texture).name);
  }
  int light(std::size_t pixel) const { return static_cast<int>(frame_.rgb()[pixel] & 0xff); }

 private:
  std::shared_ptr<const world::Level> level_;
  std::vector<render::BrushModelInstance> brush_models_;
  render::Renderer renderer_;
  render::FrameBuffer frame_;
  std::vector<render::PixelFace> faces_;
  std::vector<std::uint8_t> writes_;
  std::uint64_t faces_seen_ = 0;
};

// Item boxes have no inside, so they are viewed from outside.
render::Camera camera_around(const world::Level& level, Random& io_random) {
  const math::Bounds& bounds = level.world().bounds;
  const Vec3d middle = Vec3d(bounds.mins + bounds.maxs) / 2.0;
  const Vec3d toward = glm::normalize(Vec3d(io_random.in_cube(1)));
  const double away = glm::length(bounds.maxs - bounds.mins) * io_random.uniform(0.8, 3);
  render::Camera camera;
  camera.origin_world = Vec3(middle - toward * away);
  camera.angles_deg = Vec3(Vec3d(-std::asin(toward.z), std::atan2(toward.y, toward.x), 0) * 180.0 / M_PI);
  return camera;
}

bool is_open(const world::Level& level, const Vec3& point) {
  const world::Contents contents = world::point_contents(level, point);
  return contents != world::Contents::kSolid && contents != world::Contents::kSky;
}

// Weights leaves by volume, while random_camera gives all leaves the same chance.
Vec3 random_open_point(const world::Level& level, Random& io_random) {
  const math::Bounds& bounds = level.world().bounds;
  Vec3 point;
  do {
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float>(io_random.uniform(bounds.mins[axis], bounds.maxs[axis]));
  } while (!is_open(level, point));
  return point;
}

// The eye of a player who stands below a point in any open leaf. Nearer to walls than a player gets, the near
// plane would cut them.
render::Camera camera_within(const world::Level& level, Random& io_random) {
  constexpr float kFarDown = 1024, kOriginOverFloor = 24.25F, kEyeOverOrigin = 22;
  render::Camera camera;
  Vec3 player;
  do {
    const Vec3 place = io_random.chance(0.5) ? random_camera(level, io_random).origin_world
                                             : random_open_point(level, io_random);
    const Vec3 floor = world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint, place,
                                         place - Vec3(0, 0, kFarDown))
                           .end;
    player = floor + Vec3(0, 0, kOriginOverFloor);
    camera.origin_world = player + Vec3(0, 0, kEyeOverOrigin);
  } while (!is_open(level, camera.origin_world) ||
           world::hull_contents(level, world::ModelIndex{0}, world::Hull::kPlayer, player) ==
               world::Contents::kSolid);
  camera.angles_deg = Vec3(Vec3d(io_random.uniform(-20, 20), io_random.uniform(0, 360), 0));
  return camera;
}

struct Comparison {
  int pixels = 0, agree = 0, holes = 0;
  int lit = 0;  // agreeing pixels whose face is lit in both
  std::int64_t our_light = 0, their_light = 0;

  double agreement() const { return agree * 1.0 / pixels; }
};

bool same_seen(const Painter& ours, const Painter& theirs, std::size_t pixel) {
  if (!ours.face(pixel) || !theirs.face(pixel)) return !ours.face(pixel) && !theirs.face(pixel);
  const world::FacePlane a = ours.plane(pixel), b = theirs.plane(pixel);
  return glm::length(a.normal - b.normal) < 0.01F && std::abs(a.distance - b.distance) < 0.1 &&
         ours.texture(pixel) == theirs.texture(pixel);
}

Comparison compare(const Painter& ours, const Painter& theirs) {
  Comparison result;
  for (std::size_t pixel = 0; pixel < std::size_t{kWidth} * kHeight; ++pixel) {
    ++result.pixels;
    if (!ours.face(pixel) && theirs.face(pixel)) ++result.holes;
    if (!same_seen(ours, theirs, pixel)) continue;
    ++result.agree;
    if (!ours.face(pixel) || ours.face(pixel)->kind != world::FaceKind::kLit) continue;
    ++result.lit;
    result.our_light += ours.light(pixel);
    result.their_light += theirs.light(pixel);
  }
  return result;
}

// The makers' command-line options are unknown. Unless the map says otherwise, all of these levels agree with
// dirt and eight bounces, except for two that agree with three.
compiler::LightOptions read_light_options(const std::string& name, const formats::Map& map) {
  if (map.entities.front().fields.find("_bounce")) return {};
  const bool has_three = name == "lqdm11" || name == "lqdm12";
  return {.bounces = has_three ? 3 : 8, .dirt = true};
}

struct Totals {
  int views = 0, holes = 0;
  double agreement = 0, worst = 1;  // sum; least
  render::Camera worst_camera;
  Comparison pixels;

  void add(const Comparison& result, const render::Camera& camera) {
    ++views;
    holes += result.holes;
    agreement += result.agreement();
    pixels.lit += result.lit;
    pixels.our_light += result.our_light;
    pixels.their_light += result.their_light;
    if (result.agreement() >= worst) return;
    worst = result.agreement();
    worst_camera = camera;
  }
  double our_light() const { return static_cast<double>(pixels.our_light) / pixels.lit; }
  double their_light() const { return static_cast<double>(pixels.their_light) / pixels.lit; }
};

std::string describe(const render::Camera& camera) {
  const Vec3 &at = camera.origin_world, &angles = camera.angles_deg;
  return fmt::format("--pos {},{},{} --angles {},{},0", at.x, at.y, at.z, angles.x, angles.y);
}

class SideBySide : public ::testing::TestWithParam<const char*> {};

TEST_P(SideBySide, ShowsTheSameAsTheFinishedLevel) {
  DATA_FOLDER_OR_SKIP(data);
  const std::string name = GetParam();
  compiler::CompileOptions options;
  options.light = read_light_options(name, read_stock_map(data, name));
  CompiledMap compiled = compile_stock_map(data, name, options);
  Painter ours(std::move(compiled.level.bsp), "compiled");
  Painter theirs(compiler::finished_level(data, name), "finished");
  const bool is_box = name.starts_with("b_");  // an item box: nothing around it, and nowhere to start
  // Two maps have keys that no program reads, and lqdm5 has more entity text than the original engine reads.
  std::erase_if(compiled.warnings, [](const auto& warning) {
    return warning.kind == "unknown key" ||
           warning.kind.find("bytes of entity text exceed") != std::string::npos;
  });
  EXPECT_TRUE(is_box || (compiled.warnings.empty() && !compiled.leak));

  Random random(41);
  Totals totals;
  for (int view = 0; view < effort(60, 4); ++view) {
    const render::Camera camera =
        is_box ? camera_around(theirs.level(), random) : camera_within(theirs.level(), random);
    ours.draw(camera);
    theirs.draw(camera);
    const Comparison result = compare(ours, theirs);
    EXPECT_EQ(result.holes, 0) << describe(camera);
    totals.add(result, camera);
  }
  fmt::print("{:<8} {} views: {:.2f} % of pixels agree, {:.2f} % in the worst{}; light {:.1f} for {:.1f}\n",
             name, totals.views, totals.agreement / totals.views * 100, totals.worst * 100,
             totals.worst < 1 ? " (" + describe(totals.worst_camera) + ")" : "", totals.our_light(),
             totals.their_light());
  EXPECT_GE(totals.agreement / totals.views, 0.99);
  EXPECT_GT(theirs.faces_seen(), 3u * static_cast<unsigned>(totals.views)) << "views of nothing";
  EXPECT_NEAR(totals.our_light() / totals.their_light(), 1, 0.08);
}

INSTANTIATE_TEST_SUITE_P(All, SideBySide, ::testing::ValuesIn(stock_maps()),
                         [](const auto& map) { return std::string(map.param); });

}  // namespace
}  // namespace temblor::test
