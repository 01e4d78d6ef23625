// The kernels that light spans: SIMD against scalar, bit for bit and on every instruction set.
#include "lab/world_light/kernels/lit_kernels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/kernel_cases.h"
#include "render/simd_targets.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

template <typename Texel>
struct LitKernels;
template <>
struct LitKernels<std::uint8_t> {
  static constexpr auto grid_scalar = lab::draw_grid_lit_u8_scalar;
  static constexpr auto grid_simd = lab::draw_grid_lit_u8_simd;
  static constexpr auto line_scalar = lab::draw_line_lit_u8_scalar;
  static constexpr auto line_simd = lab::draw_line_lit_u8_simd;
  static constexpr auto pixel_scalar = lab::draw_pixel_lit_u8_scalar;
  static constexpr auto pixel_simd = lab::draw_pixel_lit_u8_simd;
  static constexpr int kMinLight = 64, kMaxLight = 16320;
};
template <>
struct LitKernels<std::uint32_t> {
  static constexpr auto grid_scalar = lab::draw_grid_lit_u32_scalar;
  static constexpr auto grid_simd = lab::draw_grid_lit_u32_simd;
  static constexpr auto line_scalar = lab::draw_line_lit_u32_scalar;
  static constexpr auto line_simd = lab::draw_line_lit_u32_simd;
  static constexpr auto pixel_scalar = lab::draw_pixel_lit_u32_scalar;
  static constexpr auto pixel_simd = lab::draw_pixel_lit_u32_simd;
  static constexpr int kMinLight = 0, kMaxLight = 32640;
};

// A tile of a texture of any size, anywhere on the canvas.
template <typename Texel>
struct LitCase {
  std::vector<render::Span> spans;
  std::vector<Texel> texels;
  std::vector<std::uint8_t> colormap;
  lab::LitSpans job{};
  int tile_width, tile_height;

  explicit LitCase(Random& random) : spans(random_spans(random)) {
    tile_width = 1 << random.below(9);
    tile_height = 1 << random.below(9);
    const auto side = [&] {
      return static_cast<std::int32_t>(random.chance(0.6) ? std::size_t{1} << random.below(9)
                                                          : 1 + random.below(300));
    };
    const std::int32_t width = side(), height = side();
    std::vector<Texel> tile = make_noise<Texel>(width, height, random);
    // Some texels are full-bright.
    if constexpr (sizeof(Texel) == 4)
      for (Texel& texel : tile)
        if (random.chance(0.2)) texel &= 0xffffffu;
    texels = make_texels<Texel>(width + lab::kMarginColumns, height + lab::kMarginRows, [&](int s, int t) {
      return tile[static_cast<std::size_t>(t % height * width + s % width)];
    });
    for (int i = 0; i < 64 * 256; ++i) colormap.push_back(static_cast<std::uint8_t>(random.bits()));
    const CornerValues depth = random_depth(random, true);
    job.perspective = random.chance(0.7);
    const auto coordinate = [&](int size) {
      const CornerValues corners =
          random.chance(0.25) ? one_whole_texel(random, size) : random_texels(random, size, 600);
      return job.perspective ? plane_over_z(corners, depth) : plane_through(corners);
    };
    job.depth = plane_through(depth);
    job.s = coordinate(tile_width);
    job.t = coordinate(tile_height);
    job.last_s = tile_width - 1;
    job.last_t = tile_height - 1;
    job.texture = {texels.data(), width, height};
    job.first_s = static_cast<std::int32_t>(random.below(static_cast<std::size_t>(width)));
    job.first_t = static_cast<std::int32_t>(random.below(static_cast<std::size_t>(height)));
    job.colormap = colormap.data();
    job.spans = spans.data();
    job.span_count = spans.size();
  }
  LitCase(const LitCase&) = delete;
  LitCase& operator=(const LitCase&) = delete;
};

template <typename Texel, typename Light>
void expect_equal(const LitCase<Texel>& lit, const Light& light, const auto scalar, const auto simd,
                  bool with_depth) {
  Canvas<Texel> plain;
  scalar(lit.job, light, plain.target(with_depth));
  for_each_simd_target([&] {
    Canvas<Texel> vector;
    simd(lit.job, light, vector.target(with_depth));
    ASSERT_TRUE(plain == vector);
  });
}

template <typename Texel>
class LitSpansKernels : public testing::Test {};
using LitTexels = testing::Types<std::uint8_t, std::uint32_t>;
TYPED_TEST_SUITE(LitSpansKernels, LitTexels);

TYPED_TEST(LitSpansKernels, LightFromAGridIsTheSame) {
  using Kernels = LitKernels<TypeParam>;
  for (int seed = 0; seed < effort(3000, 60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const LitCase<TypeParam> lit(random);
    lab::GridLight grid{};
    grid.channels = sizeof(TypeParam) == 4 && random.chance(0.5) ? 3 : 1;
    grid.texel_shift = static_cast<std::int32_t>(random.below(8));
    grid.is_nearest = random.chance(0.3);
    const int texels = 1 << grid.texel_shift;
    grid.columns = (lit.tile_width + texels - 1) / texels + 1;
    const int rows = (lit.tile_height + texels - 1) / texels + 1;
    const auto sample = [&] {
      return static_cast<std::uint32_t>(static_cast<std::size_t>(Kernels::kMinLight) +
                                        random.below(Kernels::kMaxLight - Kernels::kMinLight + 1));
    };
    std::vector<std::uint32_t> cells[lab::kMaxChannels];
    for (int channel = 0; channel < grid.channels; ++channel) {
      for (int i = 0; i < grid.columns * rows; ++i) {
        const std::uint32_t left = sample();
        cells[channel].push_back(left | sample() << 16);
      }
      cells[channel].insert(cells[channel].end(),
                            static_cast<std::size_t>(2 * grid.columns) + lab::kCellPadding, 0);
      grid.cells[channel] = cells[channel].data();
    }
    expect_equal(lit, grid, Kernels::grid_scalar, Kernels::grid_simd, random.chance(0.8));
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(LitSpansKernels, LightAlongALineIsTheSame) {
  using Kernels = LitKernels<TypeParam>;
  for (int seed = 0; seed < effort(3000, 60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const LitCase<TypeParam> lit(random);
    std::vector<lab::LineLight> lines(lit.spans.size());
    for (lab::LineLight& line : lines) {
      const render::Span& span = lit.spans[static_cast<std::size_t>(&line - lines.data())];
      line.pixels_before = static_cast<std::int32_t>(random.below(std::size_t{span.x} + 1));
      for (int channel = 0; channel < lab::kMaxChannels; ++channel) {
        const double first = random.uniform(Kernels::kMinLight, Kernels::kMaxLight);
        const double second = random.uniform(Kernels::kMinLight, Kernels::kMaxLight);
        line.base[channel] = static_cast<float>(random.uniform(-1000, 40000));
        line.step[channel] = static_cast<float>(random.uniform(-500, 500));
        line.least[channel] = static_cast<float>(std::min(first, second));
        line.most[channel] = static_cast<float>(std::max(first, second));
      }
    }
    const lab::LineLights lights{lines.data(), sizeof(TypeParam) == 4 && random.chance(0.5) ? 3 : 1,
                                 random.chance(0.5)};
    expect_equal(lit, lights, Kernels::line_scalar, Kernels::line_simd, random.chance(0.8));
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(LitSpansKernels, LightOfEachPixelIsTheSame) {
  using Kernels = LitKernels<TypeParam>;
  for (int seed = 0; seed < effort(3000, 60); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    LitCase<TypeParam> lit(random);
    lit.job.span_count = 1;
    std::vector<std::uint32_t> light(lit.spans.front().count + lab::kCellPadding);
    for (std::uint32_t& pixel : light)
      pixel = static_cast<std::uint32_t>(static_cast<std::size_t>(Kernels::kMinLight) +
                                         random.below(Kernels::kMaxLight - Kernels::kMinLight + 1));
    const std::size_t before = random.below(std::size_t{lit.spans.front().x} + 1);
    const lab::PixelLights lights{light.data(), static_cast<std::int32_t>(before)};
    expect_equal(lit, lights, Kernels::pixel_scalar, Kernels::pixel_simd, random.chance(0.8));
    if (this->HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace temblor::test
