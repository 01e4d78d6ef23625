// Spans of surface blocks: SIMD against scalar kernels, bit for bit and on every instruction set; scalar
// kernels against the definition, the texel at floor(s / depth), floor(t / depth).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/kernel_cases.h"
#include "render/simd_targets.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::KernelDivide;
using render::KernelTarget;
using render::Span;
using render::SurfaceSpans;

constexpr KernelDivide kDivides[] = {KernelDivide::kEveryPixel, KernelDivide::kAffine, KernelDivide::kNone};
// Pixels between two divisions: of the engine, and of the laboratory.
constexpr std::array<std::int32_t, 5> kAffinePixels = {16, 1, 8, 32, 8192};

template <typename Texel>
struct Kernels;
template <>
struct Kernels<std::uint8_t> {
  static constexpr auto plain = render::draw_surface_spans_u8_scalar;
  static constexpr auto vector = render::draw_surface_spans_u8_simd;
};
template <>
struct Kernels<std::uint32_t> {
  static constexpr auto plain = render::draw_surface_spans_u32_scalar;
  static constexpr auto vector = render::draw_surface_spans_u32_simd;
};
template <typename Texel>
void draw_plain(const SurfaceSpans& job, Canvas<Texel>& io_canvas, bool with_depth = true) {
  Kernels<Texel>::plain(job, io_canvas.target(with_depth));
}
template <typename Texel>
void draw_vector(const SurfaceSpans& job, Canvas<Texel>& io_canvas, bool with_depth = true) {
  Kernels<Texel>::vector(job, io_canvas.target(with_depth));
}

enum class Walks {
  kAnywhere,  // also far past the texture, past the horizon, and along texels' borders
  kOrdinary,  // where the definition decides the texel, except for a few pixels
};

// A texture's size and the spans drawn from it; texels are the caller's.
struct SurfaceCase {
  int width, height;
  std::vector<Span> spans;
  SurfaceSpans job{};

  SurfaceCase(Random& random, KernelDivide divide, Walks walks) {
    const auto size = [&] { return static_cast<int>(random.log_uniform(1, 257)); };
    width = size();
    height = size();
    spans = random_spans(random);
    job.affine_pixels = kAffinePixels[random.below(kAffinePixels.size())];
    const bool anywhere = walks == Walks::kAnywhere;
    const CornerValues depth = random_depth(random, anywhere);
    const auto coordinate = [&](int texels) {
      const CornerValues corners = !anywhere             ? random_texels(random, texels, 1000)
                                   : random.chance(0.2)  ? one_whole_texel(random, texels)
                                   : random.chance(0.25) ? beside_an_end(random, texels)
                                                         : random_texels(random, texels, 1e5);
      return divide == KernelDivide::kNone ? plane_through(corners) : plane_over_z(corners, depth);
    };
    const render::KernelPlane s = coordinate(width), t = coordinate(height);
    job = {plane_through(depth), s, t, divide, nullptr, 0, 0, 0, spans.data(), spans.size()};
    set_size(width, height);
  }
  void set_size(int new_width, int new_height) {
    width = job.texels_per_row = new_width;
    height = new_height;
    job.last_s = width - 1;
    job.last_t = height - 1;
  }
  SurfaceCase(const SurfaceCase&) = delete;
  SurfaceCase& operator=(const SurfaceCase&) = delete;
};

template <typename Texel>
class SurfaceSpanKernels : public testing::Test {};
using Texels = testing::Types<std::uint8_t, std::uint32_t>;
TYPED_TEST_SUITE(SurfaceSpanKernels, Texels);

TYPED_TEST(SurfaceSpanKernels, SimdEqualsScalar) {
  for (const KernelDivide divide : kDivides)
    for (int seed = 0; seed < effort(10000, 60); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      SurfaceCase surface(random, divide, Walks::kAnywhere);
      const std::vector<TypeParam> texels = make_noise<TypeParam>(surface.width, surface.height, random);
      surface.job.texels = texels.data();
      const bool with_depth = random.chance(0.8);
      Canvas<TypeParam> plain;
      draw_plain(surface.job, plain, with_depth);
      for_each_simd_target([&] {
        Canvas<TypeParam> vector;
        draw_vector(surface.job, vector, with_depth);
        ASSERT_TRUE(plain == vector) << fmt::format("seed {}, divide {}, texture {}x{}", seed,
                                                    static_cast<int>(divide), surface.width, surface.height);
      });
      if (this->HasFatalFailure()) return;
    }
}

// A wall that recedes from close to the eye, with coordinates close to an end of the texture all along it:
// rounding is worst here, and pixels that it carries past the end must still show the last texel.
TYPED_TEST(SurfaceSpanKernels, SimdEqualsScalarAlongTheTexturesEnds) {
  constexpr std::uint16_t kWidth = 1920;
  constexpr int kSize = 256;
  constexpr Span kRow{0, 0, kWidth};
  Random random(1);
  const std::vector<TypeParam> texels = make_noise<TypeParam>(kSize, kSize, random);
  for_each_simd_target([&] {
    std::vector<TypeParam> plain(kWidth), vector(kWidth);
    for (int i = 0; i < effort(1500, 300); ++i) {
      const double near = random.log_uniform(1, 16), far = random.log_uniform(1.0 / 8192, 1.0 / 512);
      const bool recedes = random.chance(0.5);
      const double depth = recedes ? near : far, depth_step = (recedes ? far - near : near - far) / kWidth;
      const auto beside_end = [&] {
        const double away = random.log_uniform(1e-3, 0.1), texel = random.chance(0.5) ? away : kSize - away;
        return render::KernelPlane{texel * depth, texel * depth_step, 0};
      };
      const render::KernelPlane s = beside_end(), t = beside_end();
      const SurfaceSpans job{{depth, depth_step, 0},
                             s,
                             t,
                             KernelDivide::kEveryPixel,
                             texels.data(),
                             kSize,
                             kSize - 1,
                             kSize - 1,
                             &kRow,
                             1};
      Kernels<TypeParam>::plain(job, {plain.data(), nullptr, kWidth});
      Kernels<TypeParam>::vector(job, {vector.data(), nullptr, kWidth});
      ASSERT_TRUE(plain == vector) << fmt::format("depth {}, step {}, s {}, t {}", depth, depth_step,
                                                  s.at_origin / depth, t.at_origin / depth);
    }
  });
}

// Spans of every length, from every alignment, with and without a neighbor that must stay unchanged.
TYPED_TEST(SurfaceSpanKernels, SimdEqualsScalarForEveryLengthAndPlace) {
  Random random(1);
  const std::vector<TypeParam> texels = make_noise<TypeParam>(64, 64, random);
  for_each_simd_target([&] {
    for (const KernelDivide divide : kDivides)
      for (int count = 1; count <= 300; count += count < 70 ? 1 : effort(7, 41))
        for (int x = 0; x < 17; x += effort(1, 4)) {
          SurfaceCase surface(random, divide, Walks::kOrdinary);
          surface.job.texels = texels.data();
          surface.set_size(64, 64);
          const Span span{static_cast<std::uint16_t>(x), 2, static_cast<std::uint16_t>(count)};
          surface.job.spans = &span;
          surface.job.span_count = 1;
          Canvas<TypeParam> plain, vector;
          draw_plain(surface.job, plain);
          draw_vector(surface.job, vector);
          ASSERT_TRUE(plain == vector) << count << " pixels from " << x;
        }
  });
}

TYPED_TEST(SurfaceSpanKernels, WriteNoPixelOutsideTheSpans) {
  for (const KernelDivide divide : kDivides)
    for (int seed = 0; seed < effort(300, 30); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      SurfaceCase surface(random, divide, Walks::kAnywhere);
      // No texel equals an untouched pixel.
      const std::vector<TypeParam> texels =
          make_texels<TypeParam>(surface.width, surface.height, [](int, int) { return 7; });
      surface.job.texels = texels.data();
      Canvas<TypeParam> drawn, expected;
      draw_plain(surface.job, drawn);
      for (const Span& span : surface.spans)
        for (int i = 0; i < span.count; ++i) {
          const std::size_t pixel = Canvas<TypeParam>::position(span, i);
          ASSERT_NE(drawn.depth[pixel], Canvas<TypeParam>::kUntouchedDepth);
          expected.pixels[pixel] = 7;
          expected.depth[pixel] = drawn.depth[pixel];
        }
      ASSERT_TRUE(drawn == expected) << "seed " << seed;
    }
}

TYPED_TEST(SurfaceSpanKernels, ShowTheSameWithoutDepth) {
  for (const KernelDivide divide : kDivides)
    for (int seed = 0; seed < effort(300, 30); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      SurfaceCase surface(random, divide, Walks::kAnywhere);
      const std::vector<TypeParam> texels = make_noise<TypeParam>(surface.width, surface.height, random);
      surface.job.texels = texels.data();
      Canvas<TypeParam> with, without;
      draw_plain(surface.job, with, true);
      draw_plain(surface.job, without, false);
      ASSERT_EQ(with.pixels, without.pixels);
      ASSERT_EQ(without.depth, Canvas<TypeParam>().depth);
    }
}

// A pixel's coordinate by the definition of each divide mode.
Coordinate defined_coordinate(const SurfaceSpans& job, const render::KernelPlane& plane, const Span& span,
                              int i) {
  const auto exact = [&](int pixel) {
    return quotient(RunValue(plane, span, pixel), RunValue(job.depth, span, pixel));
  };
  if (job.divide == KernelDivide::kEveryPixel) return exact(i);
  if (job.divide == KernelDivide::kNone) {
    const RunValue value(plane, span, i);
    return {value.value, value.tolerance};
  }
  // Exact at the first and last pixel of every part, linear in between.
  const int first = i / job.affine_pixels * job.affine_pixels;
  const int last = std::min(first + job.affine_pixels, int{span.count}) - 1;
  const Coordinate begin = exact(first), end = exact(last);
  const double along = last == first ? 0 : static_cast<double>(i - first) / (last - first);
  return {
      begin.value + (end.value - begin.value) * along,
      2 * (begin.tolerance + end.tolerance) + 8 * kRounding * (std::abs(begin.value) + std::abs(end.value))};
}

::testing::AssertionResult shows(int texel, const Coordinate& coordinate, int last) {
  const double low = std::clamp<double>(std::floor(coordinate.value - coordinate.tolerance), 0, last);
  const double high = std::clamp<double>(std::floor(coordinate.value + coordinate.tolerance), 0, last);
  if (low <= texel && texel <= high) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << fmt::format("texel {} shown at {} +- {}, of 0..{}", texel,
                                                      coordinate.value, coordinate.tolerance, last);
}

class SurfaceSpanDefinition : public testing::TestWithParam<KernelDivide> {};

TEST_P(SurfaceSpanDefinition, IsTheTexelAtTheQuotient) {
  int pixels = 0, clear = 0;
  for (int seed = 0; seed < effort(500, 40); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    SurfaceCase surface(random, GetParam(), Walks::kOrdinary);
    const std::vector<std::uint32_t> names =
        make_texels<std::uint32_t>(surface.width, surface.height, texel_name);
    surface.job.texels = names.data();
    Canvas<std::uint32_t> drawn;
    draw_plain(surface.job, drawn);
    for (const Span& span : surface.spans)
      for (int i = 0; i < span.count; ++i) {
        const std::uint32_t texel = drawn.pixels[drawn.position(span, i)];
        const Coordinate s = defined_coordinate(surface.job, surface.job.s, span, i);
        const Coordinate t = defined_coordinate(surface.job, surface.job.t, span, i);
        ASSERT_TRUE(shows(static_cast<int>(texel & 0xffff), s, surface.job.last_s)) << "s of pixel " << i;
        ASSERT_TRUE(shows(static_cast<int>(texel >> 16), t, surface.job.last_t)) << "t of pixel " << i;
        ++pixels;
        clear += s.is_clear() && t.is_clear();
      }
  }
  EXPECT_GT(clear, pixels / 100 * 95) << "the tolerance must leave something to check";
}

TEST_P(SurfaceSpanDefinition, DepthIsThePlane) {
  for (int seed = 0; seed < effort(500, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    SurfaceCase surface(random, GetParam(), Walks::kAnywhere);
    const std::vector<std::uint8_t> texels = make_noise<std::uint8_t>(surface.width, surface.height, random);
    surface.job.texels = texels.data();
    Canvas<std::uint8_t> drawn;
    draw_plain(surface.job, drawn);
    for (const Span& span : surface.spans)
      for (int i = 0; i < span.count; ++i) {
        const RunValue depth(surface.job.depth, span, i);
        ASSERT_NEAR(static_cast<double>(drawn.depth[drawn.position(span, i)]), depth.value, depth.tolerance)
            << "seed " << seed << " pixel " << i;
      }
  }
}

// Bytes are taken from the same texels as 32-bit colors.
TEST_P(SurfaceSpanDefinition, IsTheSameForBothFormats) {
  for (int seed = 0; seed < effort(500, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    SurfaceCase surface(random, GetParam(), Walks::kAnywhere);
    const std::vector<std::uint8_t> bytes = make_noise<std::uint8_t>(surface.width, surface.height, random);
    std::vector<std::uint32_t> words(bytes.begin(), bytes.end());
    Canvas<std::uint8_t> narrow;
    Canvas<std::uint32_t> wide;
    surface.job.texels = bytes.data();
    draw_plain(surface.job, narrow);
    surface.job.texels = words.data();
    draw_plain(surface.job, wide);
    for (const Span& span : surface.spans)
      for (int i = 0; i < span.count; ++i)
        ASSERT_EQ(narrow.pixels[narrow.position(span, i)], wide.pixels[wide.position(span, i)]);
  }
}

std::string divide_name(const testing::TestParamInfo<KernelDivide>& test) {
  switch (test.param) {
    case KernelDivide::kEveryPixel:
      return "EveryPixel";
    case KernelDivide::kAffine:
      return "Affine";
    case KernelDivide::kNone:
      return "None";
  }
  return "Unknown";
}
INSTANTIATE_TEST_SUITE_P(Divides, SurfaceSpanDefinition, testing::ValuesIn(kDivides), divide_name);

// Each instruction set has its own entry in a kernel's table, so none of the tests above ran one of them
// twice.
TEST(SimdTargets, AreAllDifferent) {
  const std::uint8_t index = 0;
  std::vector<std::size_t> places;
  for_each_simd_target([&] {
    Canvas<std::uint8_t> canvas;
    const SurfaceSpans nothing{{1, 0, 0}, {}, {}, KernelDivide::kNone, &index, 1, 0, 0, nullptr, 0};
    draw_vector(nothing, canvas);
    places.push_back(hwy::GetChosenTarget().GetIndex());
  });
  std::sort(places.begin(), places.end());
  EXPECT_FALSE(places.empty());
  EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end());
}

}  // namespace
}  // namespace temblor::test
