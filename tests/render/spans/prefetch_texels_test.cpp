// A prefetch changes no results, but it must terminate on faces of any size and position: the planes of a
// hostile level give infinite coordinates, or NaN. (A failure shows as a timeout or a sanitizer report.)
#include "render/spans/prefetch_texels.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::ScreenPlane;
using render::Span;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

ScreenPlane any_plane(Random& random) {
  const auto any_number = [&] {
    constexpr std::array kNumbers = {0.0,  -0.0, 1.0,   -1.0,      1e-320,     -1e-320,    1e-30,
                                     1e30, 1e38, 1e300, kInfinity, -kInfinity, kNotANumber};
    return kNumbers[random.below(kNumbers.size())];
  };
  const double at_origin = any_number(), dx = any_number(), dy = any_number();
  return {at_origin, dx, dy};
}

TEST(PrefetchTexels, EndsWhateverThePlanesAre) {
  constexpr int kWidth = 37, kHeight = 21;
  std::vector<std::byte> texels(kWidth * kHeight * 4 + render::kBlockPadding);
  const std::array<Span, 3> spans = {Span{0, 0, 1920}, Span{5, 1, 1}, Span{100, 500, 300}};
  Random random(1);
  for (int i = 0; i < effort(20000, 2000); ++i) {
    render::SurfaceDraw draw;
    draw.kind = render::SurfaceKind::kBlock;
    draw.depth = any_plane(random);
    draw.s = any_plane(random);
    draw.t = any_plane(random);
    draw.block = {texels.data(), {kWidth, kHeight}};
    render::prefetch_texels(draw, spans, random.chance(0.7), random.chance(0.5) ? 1 : 4);
  }
}

}  // namespace
}  // namespace temblor::test
