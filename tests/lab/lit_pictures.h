// Pictures of scenes with dynamic lights, drawn with the engine or with a technique of light.
#pragma once

#include "lab/registry.h"
#include "render/renderer.h"
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

}  // namespace temblor::test
