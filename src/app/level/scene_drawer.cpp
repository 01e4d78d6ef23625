#include "app/level/scene_drawer.h"

#include "platform/egl/offscreen_context.h"

namespace temblor::app {

base::Result<SceneDrawer> SceneDrawer::make(RendererKind kind, const formats::Palette& palette,
                                            const formats::Colormap& colormap) {
  SceneDrawer drawer(palette, colormap);
  if (kind == RendererKind::kCpu) return drawer;
  TRY(drawer.context_, platform::egl::make_offscreen_context());
  const auto find_function = [context = drawer.context_.get()](const char* name) {
    return context->find_function(name);
  };
  TRY(drawer.gl_, render_gl::GlRenderer::make(find_function, palette, colormap));
  return drawer;
}

base::Result<render::FrameStats> SceneDrawer::draw(const render::Scene& scene,
                                                   const render::Settings& settings,
                                                   render::FrameBuffer& io_frame) {
  if (!gl_) return cpu_.render(scene, settings, io_frame);
  TRY_STATUS(context_->make_current());
  return gl_->render(scene, settings, io_frame);
}

void SceneDrawer::make_blend_tables() const {
  gl_ ? gl_->make_blend_tables() : cpu_.make_blend_tables();
}

}  // namespace temblor::app
