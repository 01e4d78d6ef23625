#include "oracle/judge_pictures.h"

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "support/pictures/viewpoints.h"

namespace temblor::oracle {
namespace {

constexpr int kPictureWidth = 640, kPictureHeight = 480, kPixelsPerView = 500;

test::Viewpoint viewpoint_number(const world::Level& level, render::Projection projection, int number,
                                 test::Random& io_random) {
  test::Viewpoint viewpoint{.camera = test::random_camera(level, io_random),
                            .brush_models = test::shown_brush_models(level),
                            .time_s = io_random.uniform(0, 100)};
  viewpoint.camera.projection = projection;
  viewpoint.camera.units_per_pixel = static_cast<float>(io_random.log_uniform(0.1, 5));
  if (number % 2 == 1) test::displace(level, viewpoint.brush_models, io_random);
  return viewpoint;
}

}  // namespace

Tally judge_pictures(const test::DrawableLevel& drawable, const Pictures& pictures) {
  const world::Level& level = *drawable.level;
  const PreparedLevel prepared(level);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  if (pictures.stages != nullptr) renderer.replace_stages(*pictures.stages);
  render::FrameBuffer frame(kPictureWidth, kPictureHeight, pictures.format);
  std::vector<render::PixelFace> pixel_faces(frame.pixel_count());
  std::vector<std::uint8_t> writes(frame.pixel_count());
  Tally total;
  for (int number = 0; number < pictures.views; ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const test::Viewpoint viewpoint = viewpoint_number(level, pictures.projection, number, random);
    const render::Scene scene = viewpoint.scene(level);
    const render::Settings settings{.force_mip = 0, .use_pvs = number % 4 < 2};
    renderer.render(scene, settings, frame);
    renderer.pixel_faces(pixel_faces, writes);
    const Comparison comparison(prepared, scene,
                                {frame, pixel_faces, drawable.palette, drawable.colormap, settings.use_pvs});
    Tally view;
    for (int i = 0; i < kPixelsPerView; ++i) {
      const auto x = static_cast<int>(random.below(kPictureWidth)),
                 y = static_cast<int>(random.below(kPictureHeight));
      comparison.pixel(x, y, view);
    }
    if (view.wrong_face > 0 && !pictures.may_be_wrong)
      ADD_FAILURE() << drawable.name << ", view " << number << ": " << view.summary()
                    << "\nwhole: " << comparison.whole_frame().summary();
    total.add(view);
  }
  std::cout << "[          ] " << drawable.name << ": " << total.summary() << "\n";
  return total;
}

void expect_right(const Tally& tally) {
  EXPECT_GE(tally.face_agreement(), 0.999);
  EXPECT_EQ(tally.wrong_face, 0u);
  EXPECT_GE(tally.color_agreement(), 0.995);
  EXPECT_GE(tally.depth_agreement(), 0.995);
}

}  // namespace temblor::oracle
