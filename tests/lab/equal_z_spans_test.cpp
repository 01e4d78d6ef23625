// Textures along lines of equal z: against the engine's own pictures, and the error by its definition.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lab/lit_pictures.h"
#include "lab/perspective/z_lines.h"
#include "render/kernel_cases.h"
#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

// 1/z on the canvas: its lines are steep, level, or in between.
CornerValues random_slope(Random& random) {
  CornerValues depth = random_depth(random, false);
  if (random.chance(0.2)) return depth;  // nearly level, since the canvas is low
  if (random.chance(0.2)) depth[1] = depth[0];
  const double down = (depth[1] - depth[0]) * kCanvasRows / kCanvasWidth;
  const double turn = random.log_uniform(0.2, 5);
  depth[2] = depth[0] + down * (random.chance(0.5) ? turn : -turn);
  return depth;
}

// Spans over a table of lines. Those that are too short or too far off are left out.
template <typename Texel>
struct LineCase {
  std::vector<Texel> texels;
  std::vector<lab::LineSpan> spans;
  std::vector<float> z;
  lab::LineSpans job{};

  explicit LineCase(Random& random) {
    const int width = 1 << random.below(9);
    const int height = 1 << random.below(9);
    texels = make_noise<Texel>(width, height, random);
    const CornerValues depth = random_slope(random);
    job.surface.depth = plane_through(depth);
    job.surface.s = plane_over_z(random_texels(random, width, 600), depth);
    job.surface.t = plane_over_z(random_texels(random, height, 600), depth);
    job.surface.texels = texels.data();
    job.surface.texels_per_row = width;
    job.surface.last_s = width - 1;
    job.surface.last_t = height - 1;
    const double texel_error = random.log_uniform(0.01, 16);
    render::SurfaceDraw draw;
    draw.depth = {job.surface.depth.at_origin, job.surface.depth.dx, job.surface.depth.dy};
    draw.block.shape.width = width;
    draw.block.shape.height = height;
    const lab::SurfaceLines lines(draw, texel_error);
    lab::ZLines table = lines.plane();
    table.first = -40 * lab::kLineGroup;
    table.count = 80 * lab::kLineGroup;
    z.resize(static_cast<std::size_t>(table.count));
    lab::fill_z_lines_scalar(table, z.data());
    for (const render::Span& span : random_spans(random)) {
      if (!lines.has_lines_for(span)) continue;
      const double place = lines.find_line(span.x, span.y), whole = std::floor(place);
      spans.push_back({span, static_cast<std::int32_t>(whole), static_cast<float>(place - whole)});
    }
    job.spans = spans.data();
    job.span_count = spans.size();
    job.z = z.data();
    job.first_line = table.first;
    job.lines_per_pixel = static_cast<float>(lines.lines_per_pixel());
  }
  LineCase(const LineCase&) = delete;
  LineCase& operator=(const LineCase&) = delete;
};

template <typename Texel>
void expect_same_kernels(auto scalar, auto simd) {
  int level = 0, across = 0, steep = 0;
  for (int seed = 0; seed < effort(3000, 60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const LineCase<Texel> lines(random);
    const bool with_depth = random.chance(0.8);
    Canvas<Texel> plain;
    scalar(lines.job, plain.target(with_depth));
    for_each_simd_target([&] {
      Canvas<Texel> vector;
      simd(lines.job, vector.target(with_depth));
      ASSERT_TRUE(plain == vector);
    });
    if (testing::Test::HasFatalFailure()) return;
    for (const lab::LineSpan& span : lines.spans)
      (std::abs(lines.job.lines_per_pixel) * span.span.count <= lab::kLevelShare ? level
       : lines.job.lines_per_pixel == 1                                          ? across
                                                                                 : steep) += 1;
  }
  EXPECT_GT(level, 0);
  EXPECT_GT(across, 0);
  EXPECT_GT(steep, 0);
}

TEST(LineSpans, KernelsAreTheSame) {
  expect_same_kernels<std::uint8_t>(lab::draw_line_spans_u8_scalar, lab::draw_line_spans_u8_simd);
  expect_same_kernels<std::uint32_t>(lab::draw_line_spans_u32_scalar, lab::draw_line_spans_u32_simd);
}

TEST(LineSpans, TablesAreTheSame) {
  for (int seed = 0; seed < effort(1000, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    lab::ZLines lines{};
    lines.at_origin = random.uniform(-0.1, 0.3);
    lines.change = random.uniform(-0.01, 0.01);
    lines.first = lab::kLineGroup * (static_cast<std::int32_t>(random.below(80)) - 40);
    lines.count = lab::kLineGroup * (1 + static_cast<std::int32_t>(random.below(9)));
    std::vector<float> plain(static_cast<std::size_t>(lines.count));
    lab::fill_z_lines_scalar(lines, plain.data());
    for_each_simd_target([&] {
      std::vector<float> vector(static_cast<std::size_t>(lines.count));
      lab::fill_z_lines_simd(lines, vector.data());
      ASSERT_EQ(plain, vector) << seed;
    });
    for (int i = 0; i < lines.count; ++i) {
      const double exact = lines.at_origin + lines.change * (lines.first + i);
      if (exact > 0.001) {
        ASSERT_NEAR(plain[static_cast<std::size_t>(i)] * exact, 1, 1e-4) << seed;
      }
    }
  }
}

struct CountedPicture {
  FrameCopy picture;
  lab::Counts counts;
};

class CountedPictures {
 public:
  CountedPictures(const DrawableLevel& drawable, const std::string& technique, PixelFormat format)
      : renderer_(drawable.palette, drawable.colormap), frame_(333, 203, format) {
    if (!technique.empty())
      renderer_.replace_stages(lab::parse_choice(technique).value().make_stages(&counter_));
  }
  CountedPicture draw(const render::Scene& scene, const render::Settings& settings) {
    renderer_.render(scene, settings, frame_);
    return {copy_picture(frame_), counter_.take()};
  }

 private:
  render::Renderer renderer_;
  render::FrameBuffer frame_;
  lab::Counter counter_;
};

void expect_small_errors(const DrawableLevel& drawable, int views) {
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    CountedPictures engine(drawable, "", format), exact(drawable, "equal-z-spans:texels=0", format),
        lines(drawable, "equal-z-spans", format), far(drawable, "equal-z-spans:texels=4", format);
    lab::Counts sum, far_sum;
    std::size_t differing = 0;
    for (int seed = 0; seed < views; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      Viewpoint view = make_lit_view(*drawable.level, format, random);
      if (random.chance(0.5)) view.camera.angles_deg.z = static_cast<float>(random.uniform(-180, 180));
      const render::Scene scene = view.scene(*drawable.level);
      render::Settings settings{.force_mip = random.chance(0.3) ? 0 : -1};
      settings.simd_kernels = random.chance(0.8);
      const FrameCopy expected = engine.draw(scene, settings).picture;
      EXPECT_EQ(expected, exact.draw(scene, settings).picture) << drawable.name << ", seed " << seed;
      const CountedPicture shown = lines.draw(scene, settings), shown_far = far.draw(scene, settings);
      differing += differing_pixels(expected, shown.picture);
      sum += shown.counts;
      far_sum += shown_far.counts;
    }
    // Coordinates in float may cross a texel's border although those in double do not.
    const auto pixels = static_cast<std::size_t>(views) * 333 * 203;
    EXPECT_LE(differing, sum.pixels_off + pixels / 500) << drawable.name;
    EXPECT_GT(sum.pixels_off, 0u);
    EXPECT_LE(sum.max_texel_error, 0.125 + 0.01);
    EXPECT_GE(far_sum.max_texel_error, sum.max_texel_error);
    EXPECT_LE(far_sum.max_texel_error, 4 + 0.01);
  }
}

TEST(EqualZSpans, AreAsExactAsTheyShould) {
  expect_small_errors(small_level(), effort(40, 6));
}

TEST(EqualZSpans, AreAsExactInStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e1m2"})
    expect_small_errors(stock_level(data, name), effort(25, 3));
}

TEST(EqualZSpans, AreTheEnginesInParallelProjection) {
  const DrawableLevel drawable = small_level();
  CountedPictures engine(drawable, "", PixelFormat::kRgb),
      lines(drawable, "equal-z-spans", PixelFormat::kRgb);
  Random random(5);
  const Viewpoint view = make_lit_view(*drawable.level, PixelFormat::kRgb, random);
  render::Scene scene = view.scene(*drawable.level);
  scene.camera.projection = render::Projection::kOrthographic;
  scene.camera.units_per_pixel = 1.5;
  EXPECT_EQ(engine.draw(scene, {}).picture, lines.draw(scene, {}).picture);
}

TEST(EqualZSpans, AreTheSameForAnyThreadsAndBands) {
  for (const char* const technique : {"equal-z-spans", "equal-z-spans:texels=16"})
    expect_same_for_any_threads(technique);
}

TEST(EqualZSpans, AllocateNothingInAWarmFrame) {
  expect_no_allocations_in_a_warm_frame("equal-z-spans");
}

}  // namespace
}  // namespace temblor::test
