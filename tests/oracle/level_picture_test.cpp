// The renderer's pictures of stock levels against the oracle: the face seen, its depth and its colour.
#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "oracle/comparison.h"
#include "oracle/stock_levels.h"
#include "oracle/viewpoints.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::oracle {
namespace {

constexpr int kPixelsPerView = 500;

struct PictureCase {
  const char* map_name;
  render::PixelFormat format;
};

std::string name_of(const testing::TestParamInfo<PictureCase>& info) {
  return std::string(info.param.map_name) +
         (info.param.format == render::PixelFormat::kIndexed ? "_indexed" : "_rgb");
}

// Every second view with its brush models moved; of both kinds, every second one with the PVS.
Viewpoint random_viewpoint(const world::Level& level, int number, test::Random& io_random) {
  Viewpoint viewpoint{.camera = random_camera(level, io_random),
                      .brush_models = shown_brush_models(level),
                      .time_s = io_random.uniform(0, 100)};
  if (number % 2 == 1) displace(viewpoint.brush_models, io_random);
  return viewpoint;
}

class LevelPicture : public testing::TestWithParam<PictureCase> {};

TEST_P(LevelPicture, IsWhatRaysSee) {
  DATA_FOLDER_OR_SKIP(data);
  const JudgedLevel judged = load_judged_level(data, GetParam().map_name);
  render::Renderer renderer(judged.look.palette, judged.look.colormap);
  render::FrameBuffer frame(640, 480, GetParam().format);
  std::vector<render::PixelFace> pixel_faces(frame.pixel_count());
  std::vector<std::uint8_t> writes(frame.pixel_count());
  Tally total;
  for (int number = 0; number < test::effort(200, 10); ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const Viewpoint viewpoint = random_viewpoint(*judged.level, number, random);
    const render::Scene scene = viewpoint.scene(*judged.level);
    const render::Settings settings{.force_mip = 0, .use_pvs = number % 4 < 2};
    renderer.render(scene, settings, frame);
    renderer.pixel_faces(pixel_faces, writes);
    const Comparison comparison(
        judged.prepared, scene,
        {frame, pixel_faces, judged.look.palette, judged.look.colormap, settings.use_pvs});
    Tally view;
    for (int i = 0; i < kPixelsPerView; ++i) {
      const auto x = static_cast<int>(random.below(640)), y = static_cast<int>(random.below(480));
      comparison.pixel(x, y, view);
    }
    if (view.wrong_face > 0)
      ADD_FAILURE() << "view " << number << ": " << view.summary()
                    << "\nwhole: " << comparison.whole_frame().summary();
    total.add(view);
  }
  std::cout << "[          ] " << total.summary() << "\n";
  EXPECT_GE(total.face_agreement(), 0.999);
  EXPECT_EQ(total.wrong_face, 0u);
  EXPECT_GE(total.colour_agreement(), 0.995);
  EXPECT_GE(total.depth_agreement(), 0.995);
}

INSTANTIATE_TEST_SUITE_P(Levels, LevelPicture,
                         testing::Values(PictureCase{"start", render::PixelFormat::kIndexed},
                                         PictureCase{"start", render::PixelFormat::kRgb},
                                         PictureCase{"lq_e0m1", render::PixelFormat::kIndexed},
                                         PictureCase{"lq_e0m1", render::PixelFormat::kRgb},
                                         PictureCase{"lq_e1m2", render::PixelFormat::kIndexed},
                                         PictureCase{"lq_e1m2", render::PixelFormat::kRgb}),
                         name_of);

}  // namespace
}  // namespace temblor::oracle
