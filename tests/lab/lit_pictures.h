// Pictures of scenes with dynamic lights, drawn with the engine or with a technique of light.
#pragma once

#include <gtest/gtest.h>

#include "lab/registry.h"
#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {

// A view near lights. In indexed frames they are white, because a tint belongs to surfaces.
inline Viewpoint make_lit_view(const world::Level& level, render::PixelFormat format, Random& io_random) {
  Viewpoint view{.camera = random_camera(level, io_random), .brush_models = shown_brush_models(level)};
  view.lights = random_lights(view.camera.origin_world, 4, io_random);
  if (format == render::PixelFormat::kIndexed)
    for (render::DynamicLight& light : view.lights) light.color = math::Vec3(1.0f);
  view.time_s = io_random.uniform(0, 10);
  return view;
}

class LitPictures {
 public:
  LitPictures(const DrawableLevel& drawable, const char* technique, render::PixelFormat format)
      : renderer_(drawable.palette, drawable.colormap), frame_(333, 203, format) {
    if (technique != nullptr) renderer_.replace_stages(lab::parse_choice(technique).value().make_stages());
  }
  FrameCopy draw(const render::Scene& scene, const render::Settings& settings) {
    renderer_.render(scene, settings, frame_);
    return copy_picture(frame_);
  }

 private:
  render::Renderer renderer_;
  render::FrameBuffer frame_;
};

// Draws the small level near lights with any number of threads and any height of bands.
inline void expect_same_for_any_threads(const char* technique) {
  const DrawableLevel drawable = small_level();
  Random random(1);
  const Viewpoint view = make_lit_view(*drawable.level, render::PixelFormat::kRgb, random);
  const render::Scene scene = view.scene(*drawable.level);
  LitPictures pictures(drawable, technique, render::PixelFormat::kRgb);
  const FrameCopy first = pictures.draw(scene, {});
  for (const int threads : {1, 2, 8})
    for (const int band_rows : {1, 7, 64})
      EXPECT_EQ(first, pictures.draw(scene, {.threads = threads,
                                             .job_backend = base::JobBackend::kStdThread,
                                             .band_rows = band_rows}))
          << technique << " " << threads << " " << band_rows;
}

inline void expect_no_allocations_in_a_warm_frame(const char* technique) {
  const DrawableLevel drawable = small_level();
  Random random(3);
  const Viewpoint view = make_lit_view(*drawable.level, render::PixelFormat::kRgb, random);
  const render::Scene scene = view.scene(*drawable.level);
  render::FrameBuffer frame(320, 200, render::PixelFormat::kRgb);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.replace_stages(lab::parse_choice(technique).value().make_stages());
  for (int i = 0; i < 3; ++i) renderer.render(scene, {}, frame);
  const std::size_t before = allocation_count();
  renderer.render(scene, {}, frame);
  EXPECT_EQ(allocation_count(), before) << technique;
}

}  // namespace temblor::test
