// Deferred faces against the edge scan: the same face drawn both ways.
#include "support/pictures/deferred_faces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "math/angles.h"
#include "render/color/blend_tables.h"
#include "render/edges/span_table.h"
#include "render/renderer.h"
#include "render/screen/tint_picture.h"
#include "render/view/face_opacity.h"
#include "render/view/visible_faces.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/pictures/frames.h"
#include "support/pictures/stage_parts.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using render::FaceOpacity;
using render::FrameBuffer;
using render::PixelFormat;

// ---- Which faces are deferred.

TEST(FaceOpacity, GoesByTheTexturesName) {
  world::Level level;
  const auto add = [&](const char* name, world::TextureKind kind) {
    level.textures.push_back({});
    level.textures.back().name = name;
    level.textures.back().kind = kind;
  };
  for (const char* name : {"*water1", "*LAVA2", "*slime", "*teleport", "*blood"})
    add(name, world::TextureKind::kLiquid);
  add("{fence", world::TextureKind::kCutout);
  add("sky4", world::TextureKind::kSky);
  add("brick", world::TextureKind::kOpaque);
  render::Scene scene;
  scene.level = &level;
  scene.liquid_alpha = {.water = 0.5f, .slime = 0.25f, .lava = 2.0f, .teleport = -1.0f};
  base::Arena arena;
  const std::span<const FaceOpacity> world = render::world_opacities(scene, arena);
  const float expected[] = {0.5f, 1, 0.25f, 0, 0.5f, 1, 1, 1};
  for (std::size_t i = 0; i < world.size(); ++i) {
    EXPECT_EQ(world[i].opacity, expected[i]) << level.textures[i].name;
    EXPECT_EQ(world[i].has_holes, i == 5);
  }
  const auto on_model = [&](std::uint32_t texture, float alpha) {
    return render::brush_face_opacity(world, level, world::TextureIndex{texture}, {.alpha = alpha});
  };
  EXPECT_EQ(on_model(0, 1).opacity, 0.5f);
  EXPECT_EQ(on_model(0, 0.75f).opacity, 0.75f);
  EXPECT_EQ(on_model(5, 0.75f).opacity, 0.75f);
  EXPECT_TRUE(on_model(5, 0.75f).has_holes);
  EXPECT_EQ(on_model(6, 0.75f).opacity, 1);
  EXPECT_EQ(on_model(7, 0).opacity, 0);
}

// ---- Coverage: the pixels that the edge scan gives them.

class Scanner {
 public:
  Scanner(const world::Level& level, const Viewpoint& viewpoint, int width, int height)
      : scene_(viewpoint.scene(level)), outlines_(render::make_face_outlines(level)) {
    view_ = render::make_view_frame(scene_, width, height);
    opacities_.resize(level.textures.size());
  }

  // How often each pixel is covered by these faces alone, row by row.
  std::vector<int> coverage(std::span<const render::VisibleFace> faces, bool deferred) {
    render::VisibleFaces visible;
    (deferred ? visible.deferred_faces : visible.faces) = faces;
    visible.opacities = opacities_;
    StageParts parts({.band_rows = deferred ? 7 : view_.height});
    scene_.brush_models = {};
    const render::FrameContext context = parts.context(scene_);
    const render::EdgeTable table = render::emit_edges(context, view_, visible, outlines_);
    const render::SpanTable spans = render::scan_edges(context, view_, table);
    std::vector<int> covered(static_cast<std::size_t>(view_.width * view_.height), 0);
    for (const render::Band& band : spans.bands)
      for (std::size_t position = 0; position < band.draws.size(); ++position) {
        if (band.draws[position] == 0) continue;  // the background
        for (const render::Span& span : band.spans_at(position))
          for (int x = span.x; x < span.x + span.count; ++x)
            ++covered[static_cast<std::size_t>(span.y * view_.width + x)];
      }
    return covered;
  }

  const render::ViewFrame& view() const { return view_; }

 private:
  render::Scene scene_;
  render::ViewFrame view_;
  render::FaceOutlines outlines_;
  std::vector<FaceOpacity> opacities_;
  base::Jobs jobs_{1};
};

Viewpoint make_plain_viewpoint(const world::Level& level, int number) {
  Random random(static_cast<std::uint64_t>(number));
  Viewpoint viewpoint{.camera = random_camera(level, random), .brush_models = shown_brush_models(level)};
  if (number % 4 == 3) viewpoint.camera.projection = render::Projection::kOrthographic;
  return viewpoint;
}

bool faces_eye(const world::Level& level, const render::ViewFrame& view, const world::Face& face) {
  const render::FacePlane plane = render::place_plane(level, face, {});
  return render::facing(view, plane.normal, plane.distance) >= render::kEdgeOn;
}

// Every face alone, both ways. And faces of one plane together, which share edges: no pixel between two of
// them is missed or belongs to both.
void expect_the_edge_lists_pixels(const world::Level& level) {
  std::size_t covered = 0;
  for (int number = 0; number < effort(30, 4); ++number) {
    SCOPED_TRACE(fmt::format("{}, view {}", level.name, number));
    Scanner scanner(level, make_plain_viewpoint(level, number), 97, 61);
    std::map<std::tuple<std::uint32_t, bool>, std::vector<render::VisibleFace>> by_plane;
    for (std::uint32_t i = 0; i < level.faces.size(); ++i) {
      const world::Face& face = level.faces[i];
      if (!faces_eye(level, scanner.view(), face)) continue;
      const render::VisibleFace visible{world::FaceIndex{i}, static_cast<render::SortKey>(i + 1)};
      const std::vector<int> listed = scanner.coverage({&visible, 1}, false);
      ASSERT_EQ(listed, scanner.coverage({&visible, 1}, true)) << "face " << i;
      if (i < level.world().face_count) by_plane[{face.plane, face.back_side}].push_back(visible);
      for (const int count : listed) covered += static_cast<std::size_t>(count);
    }
    for (const auto& [plane, faces] : by_plane)
      ASSERT_EQ(scanner.coverage(faces, false), scanner.coverage(faces, true)) << faces.size() << " faces";
  }
  EXPECT_GT(covered, 10000u);
}

TEST(DeferredFaces, CoverThePixelsThatTheEdgeListGivesThem) {
  expect_the_edge_lists_pixels(*small_level().level);
  expect_the_edge_lists_pixels(*small_level({.wide_faces = true}).level);
}

// ---- Pictures: composed from pictures without deferred faces.

struct Drawn {
  FrameBuffer frame;
  std::vector<render::PixelFace> faces;
};

Drawn draw(render::Renderer& io_renderer, const render::Scene& scene, PixelFormat format,
           const render::Settings& settings = {}) {
  Drawn drawn{FrameBuffer(160, 100, format), {}};
  fill_frame(drawn.frame, 0x5a);
  io_renderer.render(scene, settings, drawn.frame);
  drawn.faces.resize(drawn.frame.pixel_count());
  std::vector<std::uint8_t> writes(drawn.frame.pixel_count());
  io_renderer.pixel_faces(drawn.faces, writes);
  for (const std::uint8_t count : writes) EXPECT_EQ(count, 1);
  return drawn;
}

std::uint32_t frame_pixel(const FrameBuffer& frame, std::size_t i) {
  return frame.format() == PixelFormat::kRgb ? frame.rgb()[i] : frame.indexed()[i];
}

bool shows_liquid(const world::Level& level, const render::PixelFace& pixel) {
  return pixel.instance != render::PixelFace::kNothing &&
         level.faces[pixel.face].kind == world::FaceKind::kLiquid;
}

// Half-transparent water is the blend of the picture with water and the picture without it, and the picture
// without it elsewhere. Spans that begin elsewhere may round to another texel here and there.
void expect_half_water(const DrawableLevel& drawable, int views, std::size_t min_pixels) {
  const world::Level& level = *drawable.level;
  const render::PaletteMatch match(drawable.palette, 256 - drawable.colormap.fullbrights);
  const render::BlendTables tables(drawable.palette, match);
  std::size_t blended = 0, off = 0;
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    for (int number = 0; number < views; ++number) {
      const Viewpoint viewpoint = make_plain_viewpoint(level, number);
      render::Scene scene = viewpoint.scene(level);
      const Drawn opaque = draw(renderer, scene, format);
      scene.liquid_alpha = {0, 0, 0, 0};
      const Drawn without = draw(renderer, scene, format);
      scene.liquid_alpha = {0.5f, 0.5f, 0.5f, 0.5f};
      const Drawn half = draw(renderer, scene, format);
      for (std::size_t i = 0; i < half.frame.pixel_count(); ++i) {
        ASSERT_EQ(half.frame.depth()[i], without.frame.depth()[i]);
        // Another liquid may be behind a liquid: then there is more than one blend.
        const bool liquid = shows_liquid(level, opaque.faces[i]);
        const std::uint32_t over = frame_pixel(opaque.frame, i), under = frame_pixel(without.frame, i);
        std::uint32_t expected = under;
        if (liquid && format == PixelFormat::kRgb) expected = render::blend_rgb(over, under, 128);
        if (liquid && format == PixelFormat::kIndexed) expected = tables.table_for(0.5f)[over * 256 + under];
        blended += liquid;
        off += frame_pixel(half.frame, i) != expected;
        ASSERT_TRUE(liquid || frame_pixel(half.frame, i) == expected) << "view " << number << ", pixel " << i;
      }
    }
  }
  EXPECT_GT(blended, min_pixels);
  EXPECT_LE(off * 200, blended) << off << " of " << blended;
}

TEST(DeferredFaces, BlendWaterOnceWithWhatIsBehind) {
  expect_half_water(small_level(), effort(60, 8), 1000);
}

TEST(DeferredFaces, BlendTheWaterOfAStockLevel) {
  DATA_FOLDER_OR_SKIP(data);
  expect_half_water(stock_level(data, "lq_e0m1"), effort(60, 8), 100);
}

// Where a fence is visible, it has the texel of the same texture without holes; elsewhere, the picture behind
// shows.
TEST(DeferredFaces, ShowFencesAndWhatIsBehindThem) {
  const DrawableLevel fenced = with_fences(small_level());
  DrawableLevel solid = fenced, absent = fenced;
  const auto copy_level = [&](DrawableLevel& io_drawable, auto change) {
    auto level = std::make_shared<world::Level>(*fenced.level);
    level->identity = std::make_shared<const world::LevelIdentity>();
    for (world::Texture& texture : level->textures)
      if (texture.kind == world::TextureKind::kCutout) change(texture);
    io_drawable.level = level;
  };
  copy_level(solid, [](world::Texture& texture) { texture.kind = world::TextureKind::kOpaque; });
  copy_level(absent, [](world::Texture& texture) { texture.mips[0].assign(texture.mips[0].size(), 255); });
  const auto is_fence = [&](const render::PixelFace& pixel) {
    return pixel.instance != render::PixelFace::kNothing &&
           fenced.level->texture(fenced.level->faces[pixel.face].texture).kind == world::TextureKind::kCutout;
  };
  std::size_t of_fence = 0, through = 0, neither = 0;
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    render::Renderer with_holes(fenced.palette, fenced.colormap),
        without_holes(fenced.palette, fenced.colormap), without(fenced.palette, fenced.colormap);
    const render::Settings near{.force_mip = 0};
    for (int number = 0; number < effort(30, 4); ++number) {
      const Viewpoint viewpoint = make_plain_viewpoint(*fenced.level, number);
      const Drawn drawn = draw(with_holes, viewpoint.scene(*fenced.level), format, near);
      const Drawn all = draw(without_holes, viewpoint.scene(*solid.level), format, near);
      const Drawn behind = draw(without, viewpoint.scene(*absent.level), format, near);
      for (std::size_t i = 0; i < drawn.frame.pixel_count(); ++i) {
        const std::uint32_t pixel = frame_pixel(drawn.frame, i);
        // Another fence may be behind a fence.
        if (!is_fence(all.faces[i])) {
          ASSERT_EQ(pixel, frame_pixel(all.frame, i)) << "view " << number << ", pixel " << i;
          continue;
        }
        if (pixel == frame_pixel(all.frame, i) && drawn.frame.depth()[i] != behind.frame.depth()[i])
          ++of_fence;
        else if (pixel == frame_pixel(behind.frame, i))
          ++through;
        else
          ++neither;
      }
    }
  }
  EXPECT_GT(of_fence, 1000u);
  EXPECT_GT(through, 1000u);
  // Another fence, seen through a fence.
  EXPECT_LT(neither, of_fence + through);
}

// A quarter of a model's color, or of one color for all of it, is added to what is behind it.
TEST(DeferredFaces, AddBrushModels) {
  constexpr formats::Rgb kColor{40, 200, 90};
  constexpr std::uint32_t kColorPixel = 0xff28c85a;
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  const render::PaletteMatch match(drawable.palette, 256 - drawable.colormap.fullbrights);
  const render::BlendTables tables(drawable.palette, match);
  const std::uint8_t black = match({0, 0, 0}, false);
  const auto find_sum = [&](PixelFormat format, std::uint32_t over, std::uint32_t under) -> std::uint32_t {
    if (format == PixelFormat::kRgb) return render::add_rgb(render::blend_rgb(over, 0, 64), under);
    return tables.sums()[tables.table_for(0.25f)[over * 256 + black] * 256u + under];
  };
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (const bool has_color : {false, true}) {
      std::size_t added = 0, off = 0;
      render::Renderer renderer(drawable.palette, drawable.colormap);
      for (int number = 0; number < 60; ++number) {
        Viewpoint viewpoint = make_plain_viewpoint(level, number);
        const auto with_alpha = [&](float alpha, bool is_additive) {
          for (render::BrushModelInstance& model : viewpoint.brush_models) {
            model.alpha = alpha;
            model.is_additive = is_additive;
            if (has_color) model.color = kColor;
          }
          return draw(renderer, viewpoint.scene(level), format);
        };
        const Drawn opaque = with_alpha(1, false), without = with_alpha(0, false),
                    quarter = with_alpha(0.25f, true);
        for (std::size_t i = 0; i < quarter.frame.pixel_count(); ++i) {
          // Faces of one color are not in the edge list, so depth tells where they are.
          const bool of_model = opaque.frame.depth()[i] != without.frame.depth()[i];
          const std::uint32_t over = frame_pixel(opaque.frame, i), under = frame_pixel(without.frame, i);
          if (of_model && has_color) {
            ASSERT_EQ(over, format == PixelFormat::kRgb ? kColorPixel : match(kColor, true));
          }
          added += of_model;
          off += frame_pixel(quarter.frame, i) != (of_model ? find_sum(format, over, under) : under);
          ASSERT_EQ(quarter.frame.depth()[i], without.frame.depth()[i]);
        }
      }
      EXPECT_GT(added, 1000u);
      EXPECT_LE(off * 50, added) << off << " of " << added;
    }
}

// A fence's opaque texels hide what is behind them, and a model's translucency is applied once.
TEST(DeferredFaces, BlendBrushModels) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  std::size_t blended = 0, off = 0;
  render::Renderer renderer(drawable.palette, drawable.colormap);
  for (int number = 0; number < effort(150, 20); ++number) {
    Viewpoint viewpoint = make_plain_viewpoint(level, number);
    const auto with_alpha = [&](float alpha) {
      for (render::BrushModelInstance& model : viewpoint.brush_models) model.alpha = alpha;
      return draw(renderer, viewpoint.scene(level), PixelFormat::kRgb);
    };
    const Drawn opaque = with_alpha(1), without = with_alpha(0), quarter = with_alpha(0.25f);
    for (std::size_t i = 0; i < quarter.frame.pixel_count(); ++i) {
      const bool of_model =
          opaque.faces[i].instance != 0 && opaque.faces[i].instance != render::PixelFace::kNothing;
      const std::uint32_t under = without.frame.rgb()[i];
      const std::uint32_t expected = of_model ? render::blend_rgb(opaque.frame.rgb()[i], under, 64) : under;
      blended += of_model;
      off += quarter.frame.rgb()[i] != expected;
      ASSERT_TRUE(of_model || quarter.frame.rgb()[i] == expected) << "view " << number << ", pixel " << i;
      ASSERT_EQ(quarter.frame.depth()[i], without.frame.depth()[i]);
    }
  }
  EXPECT_GT(blended, 1000u);
  EXPECT_LE(off * 100, blended) << off << " of " << blended;
}

// Through the holes of a translucent model, the picture behind shows, whatever the fog.
TEST(DeferredFaces, StayClearInFog) {
  const DrawableLevel fenced = with_fences(small_level());
  auto solid = std::make_shared<world::Level>(*fenced.level);
  solid->identity = std::make_shared<const world::LevelIdentity>();
  for (world::Texture& texture : solid->textures)
    if (texture.kind == world::TextureKind::kCutout) texture.kind = world::TextureKind::kOpaque;
  std::size_t holes = 0;
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    render::Renderer renderer(fenced.palette, fenced.colormap), of_solid(fenced.palette, fenced.colormap);
    for (int number = 0; number < effort(60, 10); ++number) {
      Viewpoint viewpoint = make_plain_viewpoint(*fenced.level, number);
      const auto with_alpha = [&](render::Renderer& io_renderer, const world::Level& level, float alpha) {
        for (render::BrushModelInstance& model : viewpoint.brush_models) model.alpha = alpha;
        render::Scene scene = viewpoint.scene(level);
        scene.fog = {2, {0.9f, 0.1f, 0.5f}};
        return draw(io_renderer, scene, format, {.force_mip = 0});
      };
      const Drawn filled = with_alpha(of_solid, *solid, 1), opaque = with_alpha(renderer, *fenced.level, 1),
                  without = with_alpha(renderer, *fenced.level, 0),
                  half = with_alpha(renderer, *fenced.level, 0.5f);
      for (std::size_t i = 0; i < half.frame.pixel_count(); ++i) {
        if (opaque.frame.depth()[i] != without.frame.depth()[i]) continue;
        holes += filled.frame.depth()[i] != without.frame.depth()[i];
        ASSERT_EQ(frame_pixel(half.frame, i), frame_pixel(without.frame, i))
            << "view " << number << ", " << i;
      }
    }
  }
  EXPECT_GT(holes, 300u);
}

// A translucent ball above the water is blended over it, and one in the water under it. Each pixel is
// composed from pictures of the water and of the ball alone.
TEST(DeferredFaces, AreBlendedWithModelsFromBackToFront) {
  const DrawableLevel drawable = small_level();
  const world::Level& level = *drawable.level;
  const auto ball = small_model(sphere_mdl(), 16);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  std::size_t over = 0, under = 0, off = 0;
  for (int number = 0; number < effort(200, 60); ++number) {
    Random random(static_cast<std::uint64_t>(number));
    const auto face = static_cast<std::size_t>(
        std::find_if(level.faces.begin(), level.faces.end(),
                     [](const world::Face& any) { return any.kind == world::FaceKind::kLiquid; }) -
        level.faces.begin());
    const math::Vec3 corner = level.vertices[level.surfedge_start(level.faces[face].first_surfedge)];
    render::AliasInstance instance;
    instance.model = ball.get();
    instance.full_bright = true;
    // A ball that crosses the surface would have parts on both sides.
    const float height = static_cast<float>(random.uniform(12, 30)) * (random.chance(0.5) ? 1.0f : -1.0f);
    instance.origin_world = corner + math::Vec3(static_cast<float>(random.uniform(-60, 60)),
                                                static_cast<float>(random.uniform(-60, 60)), height);
    // Models are sorted by the leaf of their origin, which is not a wall.
    if (world::point_contents(level, instance.origin_world) == world::Contents::kSolid) continue;
    Viewpoint viewpoint = make_plain_viewpoint(level, 0);
    viewpoint.camera.projection = render::Projection::kPerspective;
    viewpoint.camera.origin_world =
        instance.origin_world + math::Vec3(static_cast<float>(random.uniform(-40, 40)),
                                           static_cast<float>(random.uniform(-40, 40)), 90 - height);
    viewpoint.camera.angles_deg = {80, static_cast<float>(random.uniform(0, 360)), 0};
    const auto picture = [&](float water_alpha, float ball_alpha) {
      render::Scene scene = viewpoint.scene(level);
      scene.liquid_alpha = {water_alpha, water_alpha, water_alpha, water_alpha};
      instance.alpha = ball_alpha;
      scene.alias_models = {&instance, 1};
      return draw(renderer, scene, PixelFormat::kRgb);
    };
    const Drawn nothing = picture(0, 0), water = picture(1, 0), alone = picture(0, 1),
                both = picture(0.5f, 0.5f);
    for (std::size_t i = 0; i < both.frame.pixel_count(); ++i) {
      const bool has_ball = alone.frame.depth()[i] > nothing.frame.depth()[i];
      if (!has_ball || !shows_liquid(level, water.faces[i])) continue;
      const std::uint32_t n = nothing.frame.rgb()[i], w = water.frame.rgb()[i], b = alone.frame.rgb()[i];
      const bool is_over = alone.frame.depth()[i] > water.frame.depth()[i];
      const std::uint32_t expected = is_over ? render::blend_rgb(b, render::blend_rgb(w, n, 128), 128)
                                             : render::blend_rgb(w, render::blend_rgb(b, n, 128), 128);
      ++(is_over ? over : under);
      off += both.frame.rgb()[i] != expected;
    }
  }
  EXPECT_GT(over, 300u);
  EXPECT_GT(under, 300u);
  EXPECT_LE(off * 50, over + under) << off << " of " << over + under;
}

// Everything translucent is drawn before the tint: water alone, or water behind a ball.
TEST(DeferredFaces, AreTintedWithEverythingElse) {
  const DrawableLevel drawable = with_fences(small_level());
  const auto ball = small_model(sphere_mdl(), 16);
  const render::Tint tint{{255, 40, 0}, 0.4f};
  base::Jobs jobs(1);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  int balls_seen = 0;
  constexpr PixelFormat format = PixelFormat::kRgb;
  for (int number = 0; number < effort(20, 6); ++number)
    for (const bool has_ball : {false, true}) {
      Viewpoint viewpoint = make_plain_viewpoint(*drawable.level, number);
      render::Scene scene = viewpoint.scene(*drawable.level);
      scene.liquid_alpha = {0.5f, 0.25f, 0.75f, 0.9f};
      render::AliasInstance instance;
      instance.model = ball.get();
      instance.alpha = 0.5f;
      const math::Vec3 forward(math::basis_from_angles(viewpoint.camera.angles_deg).forward);
      instance.origin_world = viewpoint.camera.origin_world + 24.0f * forward;
      FrameBuffer expected = std::move(draw(renderer, scene, format).frame);
      if (has_ball) {
        scene.alias_models = {&instance, 1};
        const FrameCopy without = copy_picture(expected);
        expected = std::move(draw(renderer, scene, format).frame);
        balls_seen += copy_picture(expected) != without;
      }
      render::tint_picture(render::PictureTint(tint, format, true), jobs, expected);
      scene.tint = tint;
      const Drawn drawn = draw(renderer, scene, format);
      ASSERT_EQ(copy_picture(drawn.frame), copy_picture(expected))
          << "view " << number << ", ball " << has_ball;
    }
  EXPECT_GT(balls_seen, 3);
}

// ---- Independence of threads, kernels, bands, and history.

// Water, fences, translucent models, fog, the underwater warp, and a tint together.
render::Scene everything(const Viewpoint& viewpoint, const world::Level& level) {
  render::Scene scene = viewpoint.scene(level);
  scene.liquid_alpha = {0.5f, 0.25f, 0.75f, 0.9f};
  scene.fog = {0.3f, {0.4f, 0.5f, 0.6f}};
  scene.underwater = true;
  scene.tint = {{130, 80, 50}, 0.3f};
  return scene;
}

TEST(DeferredFaces, AreTheSameForAnyThreadsKernelsBandsAndHistory) {
  const DrawableLevel drawable = with_fences(small_level({.wide_faces = true, .colored_light = true}));
  const std::vector<render::Settings> all = {
      {.threads = 2, .job_backend = base::JobBackend::kStdThread},
      {.threads = 8, .job_backend = base::JobBackend::kStdThread},
      {.simd_kernels = false},
      {.surface_cache = false},
      {.band_rows = 7},
      {.threads = 3, .job_backend = base::JobBackend::kStdThread, .simd_kernels = false, .band_rows = 1}};
  std::vector<render::Renderer> renderers;
  for (std::size_t i = 0; i < all.size(); ++i) renderers.emplace_back(drawable.palette, drawable.colormap);
  for (int number = 0; number < effort(12, 3); ++number) {
    Viewpoint viewpoint = make_plain_viewpoint(*drawable.level, number);
    for (render::BrushModelInstance& model : viewpoint.brush_models) model.alpha = 0.6f;
    const render::Scene scene = everything(viewpoint, *drawable.level);
    for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
      render::Renderer cold(drawable.palette, drawable.colormap);
      const FrameCopy expected = copy_picture(draw(cold, scene, format).frame);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const FrameCopy drawn = copy_picture(draw(renderers[i], scene, format, all[i]).frame);
        EXPECT_TRUE(drawn == expected)
            << "view " << number << ", settings " << i << ": " << differing_pixels(drawn, expected);
      }
    }
  }
}

}  // namespace
}  // namespace temblor::test
