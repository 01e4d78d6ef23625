// Zero overdraw: the spans of a frame cover every pixel exactly once, counted pixel by pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "render/renderer.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

// The numbers of pixels that were written 0 times, once, and more often.
using WriteCounts = std::array<std::size_t, 3>;

WriteCounts count_writes(const render::Renderer& renderer, std::size_t pixels) {
  std::vector<render::PixelFace> faces(pixels);
  std::vector<std::uint8_t> writes(pixels);
  renderer.pixel_faces(faces, writes);
  WriteCounts counts{};
  for (const std::uint8_t count : writes) ++counts[std::min<std::size_t>(count, 2)];
  return counts;
}

void expect_no_overdraw(const DrawableLevel& drawable, int views) {
  constexpr std::array<std::pair<int, int>, 4> kSizes = {{{320, 200}, {640, 480}, {333, 111}, {97, 512}}};
  render::Renderer renderer(drawable.palette, drawable.colormap);
  for (int view = 0; view < views; ++view) {
    Random random(static_cast<std::uint64_t>(view));
    Viewpoint viewpoint{.camera = random_camera(*drawable.level, random),
                        .brush_models = shown_brush_models(*drawable.level)};
    if (view % 2 == 1) displace(*drawable.level, viewpoint.brush_models, random);
    const auto [width, height] = kSizes[random.below(kSizes.size())];
    render::FrameBuffer frame(width, height, render::PixelFormat::kIndexed);
    renderer.render(viewpoint.scene(*drawable.level), {}, frame);
    ASSERT_EQ(count_writes(renderer, frame.pixel_count()), (WriteCounts{0, frame.pixel_count(), 0}))
        << drawable.name << ", view " << view << ", " << width << "x" << height;
  }
}

class OverdrawOfSmallLevel : public testing::TestWithParam<SmallLevelVariant> {};
TEST_P(OverdrawOfSmallLevel, IsZero) {
  expect_no_overdraw(small_level(GetParam().options, GetParam().name), effort(100, 5));
}
INSTANTIATE_TEST_SUITE_P(Variants, OverdrawOfSmallLevel, testing::ValuesIn(small_level_variants()),
                         [](const auto& test) { return test.param.name; });

class OverdrawOfStockLevel : public testing::TestWithParam<const char*> {};
TEST_P(OverdrawOfStockLevel, IsZero) {
  DATA_FOLDER_OR_SKIP(data);
  expect_no_overdraw(stock_level(data, GetParam()), effort(200, 5));
}
INSTANTIATE_TEST_SUITE_P(Levels, OverdrawOfStockLevel, testing::Values("start", "lq_e0m1", "lq_e1m2"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace temblor::test
