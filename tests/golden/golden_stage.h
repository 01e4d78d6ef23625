// The small level with the contents of a golden picture, and a renderer.
#pragma once

#include <vector>

#include "render/renderer.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {

class GoldenStage {
 public:
  explicit GoldenStage(DrawableLevel drawable = small_level({.colored_light = true}))
      : drawable_(std::move(drawable)),
        brush_models_(shown_brush_models(*drawable_.level)),
        renderer_(drawable_.palette, drawable_.colormap) {}

  const world::Level& level() const { return *drawable_.level; }
  const render::BrushModelInstance& door() const { return brush_models_.front(); }
  render::Renderer& renderer() { return renderer_; }

  // One second after the level began.
  render::Scene scene(const render::Camera& camera) const {
    render::Scene scene;
    scene.level = drawable_.level.get();
    scene.camera = camera;
    scene.brush_models = brush_models_;
    scene.time_s = 1;
    return scene;
  }
  void draw(const render::Scene& scene, render::FrameBuffer& io_frame,
            const render::Settings& settings = {}) {
    renderer_.render(scene, settings, io_frame);
  }

 private:
  DrawableLevel drawable_;
  std::vector<render::BrushModelInstance> brush_models_;
  render::Renderer renderer_;
};

}  // namespace temblor::test
