// Spans of repeating textures: still ones, liquids, and sky. SIMD against scalar kernels, bit for bit and on
// every instruction set; scalar kernels against the definition with the sine and the square root of <cmath>,
// in double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "render/kernel_cases.h"
#include "render/simd_targets.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::RepeatSpans;
using render::SkySpans;
using render::Span;

// The kernels approximate the sine by two parabolas and a correction.
constexpr double kSineError = 0.0012;
constexpr double kTurn_texels = 128;

template <typename Texel>
struct RepeatingKernels;
template <>
struct RepeatingKernels<std::uint8_t> {
  static constexpr auto repeat_scalar = render::draw_repeat_spans_u8_scalar;
  static constexpr auto repeat_simd = render::draw_repeat_spans_u8_simd;
  static constexpr auto sky_scalar = render::draw_sky_spans_u8_scalar;
  static constexpr auto sky_simd = render::draw_sky_spans_u8_simd;
};
template <>
struct RepeatingKernels<std::uint32_t> {
  static constexpr auto repeat_scalar = render::draw_repeat_spans_u32_scalar;
  static constexpr auto repeat_simd = render::draw_repeat_spans_u32_simd;
  static constexpr auto sky_scalar = render::draw_sky_spans_u32_scalar;
  static constexpr auto sky_simd = render::draw_sky_spans_u32_simd;
};

enum class RepeatingWalks { kAnywhere, kOrdinary };

struct RepeatCase {
  int width, height;
  std::vector<Span> spans;
  RepeatSpans job{};

  RepeatCase(Random& random, RepeatingWalks walks)
      : width(1 << random.below(9)), height(1 << random.below(9)) {
    spans = random_spans(random);
    const bool anywhere = walks == RepeatingWalks::kAnywhere;
    const CornerValues depth = random_depth(random, anywhere);
    job.divide = random.chance(0.7);
    const auto coordinate = [&](int texels) {
      const CornerValues corners = anywhere && random.chance(0.25)
                                       ? one_whole_texel(random, texels)
                                       : random_texels(random, texels, anywhere ? 1e10 : 2000);
      return job.divide ? plane_over_z(corners, depth) : plane_through(corners);
    };
    // Liquids with more texels than stock ones.
    job.turns_per_texel = 1.0f / static_cast<float>(kTurn_texels * (1 << random.below(4)));
    job.depth = plane_through(depth);
    job.s = coordinate(width);
    job.t = coordinate(height);
    job.amplitude = random.chance(0.6) ? 8.0f : 0.0f;
    job.phase = static_cast<float>(random.uniform(0, kTurn_texels));
    job.width = width;
    job.height = height;
    job.spans = spans.data();
    job.span_count = spans.size();
  }
  RepeatCase(const RepeatCase&) = delete;
  RepeatCase& operator=(const RepeatCase&) = delete;
};

struct SkyCase {
  int width, height;
  std::vector<Span> spans;
  SkySpans job{};

  explicit SkyCase(Random& random) : width(1 << random.below(9)), height(1 << random.below(9)) {
    spans = random_spans(random);
    job.depth = plane_through(random_depth(random, false));
    // Rays of a canvas in perspective; `forward` leads to pixel (0, 0). Sometimes all rays are parallel.
    const bool perspective = random.chance(0.8);
    const double pixels_per_unit = random.log_uniform(10, 1000);
    const math::Vec3d forward = glm::normalize(math::Vec3d(random.in_cube(1)) + math::Vec3d(0, 0, 1e-3));
    const math::Vec3d right = glm::normalize(glm::cross(forward, math::Vec3d(random.in_cube(1)) + 1e-3));
    const math::Vec3d down = glm::cross(forward, right);
    const double x = random.uniform(0, kCanvasWidth), y = random.uniform(-100, 100);
    for (int axis = 0; axis < 3; ++axis) {
      job.forward[axis] =
          perspective ? forward[axis] * pixels_per_unit - right[axis] * x - down[axis] * y : forward[axis];
      job.right[axis] = perspective ? right[axis] : 0;
      job.down[axis] = perspective ? down[axis] : 0;
    }
    job.scale = static_cast<float>(378.0 * width / 128);
    const auto scrolled = [&](int size) { return static_cast<float>(random.uniform(0, size)); };
    job.clouds_s = scrolled(width);
    job.clouds_t = scrolled(height);
    job.back_s = scrolled(width);
    job.back_t = scrolled(height);
    job.width = width;
    job.height = height;
    job.spans = spans.data();
    job.span_count = spans.size();
  }
  SkyCase(const SkyCase&) = delete;
  SkyCase& operator=(const SkyCase&) = delete;
};

// Half of the texels are clear.
template <typename Texel>
std::vector<Texel> make_clouds(int width, int height, Random& random) {
  return make_texels<Texel>(width, height,
                            [&](int, int) { return random.chance(0.5) ? 0 : random.bits() | 1; });
}

template <typename Texel>
class RepeatingSpans : public testing::Test {};
using RepeatingTexels = testing::Types<std::uint8_t, std::uint32_t>;
TYPED_TEST_SUITE(RepeatingSpans, RepeatingTexels);

TYPED_TEST(RepeatingSpans, SimdEqualsScalar) {
  for (int seed = 0; seed < effort(3000, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    RepeatCase repeat(random, RepeatingWalks::kAnywhere);
    const std::vector<TypeParam> texels = make_noise<TypeParam>(repeat.width, repeat.height, random);
    repeat.job.texels = texels.data();
    const bool with_depth = random.chance(0.8);
    Canvas<TypeParam> plain;
    RepeatingKernels<TypeParam>::repeat_scalar(repeat.job, plain.target(with_depth));
    for_each_simd_target([&] {
      Canvas<TypeParam> vector;
      RepeatingKernels<TypeParam>::repeat_simd(repeat.job, vector.target(with_depth));
      ASSERT_TRUE(plain == vector) << fmt::format("seed {}, texture {}x{}, amplitude {}, divide {}", seed,
                                                  repeat.width, repeat.height, repeat.job.amplitude,
                                                  repeat.job.divide);
    });
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(RepeatingSpans, SimdEqualsScalarForSky) {
  for (int seed = 0; seed < effort(3000, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    SkyCase sky(random);
    const std::vector<TypeParam> clouds = make_clouds<TypeParam>(sky.width, sky.height, random);
    const std::vector<TypeParam> back = make_noise<TypeParam>(sky.width, sky.height, random);
    sky.job.clouds = clouds.data();
    sky.job.back = back.data();
    const bool with_depth = random.chance(0.8);
    Canvas<TypeParam> plain;
    RepeatingKernels<TypeParam>::sky_scalar(sky.job, plain.target(with_depth));
    for_each_simd_target([&] {
      Canvas<TypeParam> vector;
      RepeatingKernels<TypeParam>::sky_simd(sky.job, vector.target(with_depth));
      ASSERT_TRUE(plain == vector) << fmt::format("seed {}, layers {}x{}", seed, sky.width, sky.height);
    });
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(RepeatingSpans, WriteNoPixelOutsideTheSpans) {
  for (int seed = 0; seed < effort(300, 30); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    RepeatCase repeat(random, RepeatingWalks::kAnywhere);
    SkyCase sky(random);
    const auto seven = [](int, int) { return 7; };
    const std::vector<TypeParam> texels = make_texels<TypeParam>(256, 256, seven);
    repeat.job.texels = sky.job.clouds = sky.job.back = texels.data();
    Canvas<TypeParam> still, heavens;
    RepeatingKernels<TypeParam>::repeat_scalar(repeat.job, still.target());
    RepeatingKernels<TypeParam>::sky_scalar(sky.job, heavens.target());
    const auto expect_only = [](const std::vector<Span>& spans, const Canvas<TypeParam>& drawn) {
      Canvas<TypeParam> expected;
      for (const Span& span : spans)
        for (int i = 0; i < span.count; ++i) {
          const std::size_t pixel = drawn.position(span, i);
          ASSERT_NE(drawn.depth[pixel], Canvas<TypeParam>::kUntouchedDepth);
          expected.pixels[pixel] = 7;
          expected.depth[pixel] = drawn.depth[pixel];
        }
      ASSERT_TRUE(drawn == expected);
    };
    expect_only(repeat.spans, still);
    expect_only(sky.spans, heavens);
  }
}

// Whether the texel belongs to the coordinate, in a texture that repeats every `size` texels.
bool repeats_at(int texel, const Coordinate& coordinate, int size) {
  const double low = std::floor(coordinate.value - coordinate.tolerance);
  const double high = std::floor(coordinate.value + coordinate.tolerance);
  for (double whole = low; whole <= high; ++whole)
    if (whole - size * std::floor(whole / size) == texel) return true;
  return false;
}

struct TexelPlace {
  Coordinate s, t;

  bool is_clear() const { return s.is_clear() && t.is_clear(); }
  bool may_be(std::uint32_t name, int width, int height) const {
    return repeats_at(static_cast<int>(name & 0xffff), s, width) &&
           repeats_at(static_cast<int>(name >> 16), t, height);
  }
};

// One coordinate, displaced by the sine of the other.
Coordinate swayed(const Coordinate& moved, const Coordinate& by, const RepeatSpans& job) {
  const double amplitude = static_cast<double>(job.amplitude);
  if (amplitude == 0) return moved;
  const double turns_per_texel = static_cast<double>(job.turns_per_texel);
  const double turns = (by.value + static_cast<double>(job.phase)) * turns_per_texel;
  const double value = moved.value + amplitude * (1 + std::sin(2 * std::numbers::pi * turns));
  // The sine inherits the other coordinate's error, and that of a few roundings of the sum.
  const double argument = by.tolerance + 4 * kRounding * (std::abs(by.value) + 1 / turns_per_texel);
  return {value, moved.tolerance +
                     amplitude * (kSineError + 2 * std::numbers::pi * turns_per_texel * argument) +
                     4 * kRounding * (std::abs(moved.value) + 2 * amplitude)};
}

TexelPlace defined_place(const RepeatSpans& job, const Span& span, int i) {
  const RunValue depth(job.depth, span, i), s_over_z(job.s, span, i), t_over_z(job.t, span, i);
  const auto coordinate = [&](const RunValue& over_z) {
    return job.divide ? quotient(over_z, depth) : Coordinate{over_z.value, over_z.tolerance};
  };
  const Coordinate s = coordinate(s_over_z), t = coordinate(t_over_z);
  return {swayed(s, t, job), swayed(t, s, job)};
}

TEST(RepeatingSpanDefinition, IsTheTexelAtTheWarpedQuotient) {
  int pixels = 0, clear = 0;
  for (int seed = 0; seed < effort(1000, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    RepeatCase repeat(random, RepeatingWalks::kOrdinary);
    const auto names = make_texels<std::uint32_t>(repeat.width, repeat.height, texel_name);
    repeat.job.texels = names.data();
    Canvas<std::uint32_t> drawn;
    render::draw_repeat_spans_u32_scalar(repeat.job, drawn.target());
    for (const Span& span : repeat.spans)
      for (int i = 0; i < span.count; ++i) {
        const std::size_t pixel = drawn.position(span, i);
        const TexelPlace place = defined_place(repeat.job, span, i);
        ASSERT_TRUE(place.may_be(drawn.pixels[pixel], repeat.width, repeat.height)) << fmt::format(
            "seed {}, pixel {} of row {}: texel {:#x} at {} +- {}, {} +- {}", seed, i, span.y,
            drawn.pixels[pixel], place.s.value, place.s.tolerance, place.t.value, place.t.tolerance);
        const RunValue depth(repeat.job.depth, span, i);
        ASSERT_NEAR(static_cast<double>(drawn.depth[pixel]), depth.value, depth.tolerance);
        ++pixels;
        clear += place.is_clear();
      }
  }
  EXPECT_GT(clear, pixels / 10 * 9) << "the tolerance must leave something to check";
}

// The position where the ray's direction, with z stretched threefold, meets a layer that has scrolled.
struct SkyDirection {
  double x, y, tolerance;

  SkyDirection(const SkySpans& job, const Span& span, int i) {
    double ray[3], error = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double at_span = job.forward[axis] + job.right[axis] * span.x + job.down[axis] * span.y;
      const double stretch = axis == 2 ? 3 : 1;
      ray[axis] = stretch * (at_span + job.right[axis] * i);
      error += stretch * 5 * kRounding * (std::abs(at_span) + std::abs(job.right[axis] * i));
    }
    const double length = std::hypot(ray[0], ray[1], ray[2]);
    const double scale = static_cast<double>(job.scale);
    x = scale * ray[0] / length;
    y = scale * ray[1] / length;
    tolerance = scale * (2 * error / length + 10 * kRounding);
  }
  TexelPlace in_layer(float s, float t) const {
    const auto scrolled = [&](double along, float by) {
      const double value = along + static_cast<double>(by);
      return Coordinate{value, tolerance + 2 * kRounding * std::abs(value)};
    };
    return {scrolled(x, s), scrolled(y, t)};
  }
};

constexpr std::uint32_t kCloud = 0x80000000u, kBack = 0x40000000u;

TEST(SkySpanDefinition, ShowsTheBackgroundBehindClearClouds) {
  int pixels = 0, clear = 0, clouds_seen = 0;
  for (int seed = 0; seed < effort(1000, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    SkyCase sky(random);
    std::vector<std::uint32_t> is_cloud = make_texels<std::uint32_t>(
        sky.width, sky.height, [&](int, int) { return random.chance(0.5) ? 1 : 0; });
    const auto is_cloud_at = [&](int column, int row) {
      return is_cloud[static_cast<std::size_t>(row * sky.width + column)] == 1;
    };
    const auto clouds = make_texels<std::uint32_t>(sky.width, sky.height, [&](int column, int row) {
      return is_cloud_at(column, row) ? kCloud | texel_name(column, row) : 0;
    });
    const auto back = make_texels<std::uint32_t>(
        sky.width, sky.height, [](int column, int row) { return kBack | texel_name(column, row); });
    sky.job.clouds = clouds.data();
    sky.job.back = back.data();
    Canvas<std::uint32_t> drawn;
    render::draw_sky_spans_u32_scalar(sky.job, drawn.target());
    for (const Span& span : sky.spans)
      for (int i = 0; i < span.count; ++i) {
        const std::uint32_t shown = drawn.pixels[drawn.position(span, i)];
        const SkyDirection direction(sky.job, span, i);
        const TexelPlace cloud = direction.in_layer(sky.job.clouds_s, sky.job.clouds_t);
        const TexelPlace behind = direction.in_layer(sky.job.back_s, sky.job.back_t);
        const bool shows_cloud = (shown & kCloud) != 0;
        ASSERT_TRUE((shows_cloud ? cloud : behind).may_be(shown & 0x3fffffffu, sky.width, sky.height))
            << fmt::format("seed {}, pixel {} of row {}: {:#x}", seed, i, span.y, shown);
        ++pixels;
        clouds_seen += shows_cloud;
        if (!cloud.is_clear()) continue;
        ++clear;
        const auto whole = [](const Coordinate& at, int size) {
          const double texel = std::floor(at.value);
          return static_cast<int>(texel - size * std::floor(texel / size));
        };
        ASSERT_EQ(shows_cloud, is_cloud_at(whole(cloud.s, sky.width), whole(cloud.t, sky.height)));
      }
  }
  EXPECT_GT(clear, pixels / 10 * 9) << "the tolerance must leave something to check";
  EXPECT_GT(clouds_seen, pixels / 4);
  EXPECT_LT(clouds_seen, pixels / 4 * 3);
}

}  // namespace
}  // namespace temblor::test
