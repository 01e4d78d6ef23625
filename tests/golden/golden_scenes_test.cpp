// Compares whole pictures with the ones that a person approved.
#include "golden/golden_scenes.h"

#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "formats/images/png.h"
#include "render/present.h"

namespace temblor::test {
namespace {

class GoldenScenes : public ::testing::TestWithParam<GoldenScene> {};

TEST_P(GoldenScenes, LookAsTheyDid) {
  const GoldenScene& scene = GetParam();
  SCOPED_TRACE(scene.shows);
  render::FrameBuffer frame(kGoldenWidth, kGoldenHeight, scene.format);
  scene.draw(frame);
  const base::ByteVector png = scene.format == render::PixelFormat::kIndexed
                                   ? formats::write_png(frame.indexed(), kGoldenWidth, kGoldenHeight,
                                                        render::shown_palette(frame, artgen::make_palette()))
                                         .value()
                                   : formats::write_png(frame.rgb(), kGoldenWidth, kGoldenHeight).value();
  expect_golden(scene.name, png, scene.tolerance);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenScenes,
                         ::testing::ValuesIn(golden_scenes().begin(), golden_scenes().end()),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace temblor::test
