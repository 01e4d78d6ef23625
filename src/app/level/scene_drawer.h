// Draws scenes with the renderer that the user has chosen (--renderer): on the CPU, or through OpenGL without
// a window.
#pragma once

#include <memory>
#include <optional>

#include "app/commands/options.h"
#include "platform/gl_context.h"
#include "render/renderer.h"
#include "render_gl/gl_renderer.h"

namespace temblor::app {

class SceneDrawer {
 public:
  // Fails with kUnsupported, and one line for a person, if OpenGL cannot be used.
  static base::Result<SceneDrawer> make(RendererKind kind, const formats::Palette& palette,
                                        const formats::Colormap& colormap);

  // Draws into every pixel of the frame.
  base::Result<render::FrameStats> draw(const render::Scene& scene, const render::Settings& settings,
                                        render::FrameBuffer& io_frame);
  // So that no indexed frame waits for them (Renderer::make_blend_tables).
  void make_blend_tables() const;
  // Draws overlays in both cases.
  render::Renderer& cpu() { return cpu_; }

 private:
  SceneDrawer(const formats::Palette& palette, const formats::Colormap& colormap) : cpu_(palette, colormap) {}

  render::Renderer cpu_;
  std::unique_ptr<platform::GlContext> context_;  // null: the CPU draws
  std::optional<render_gl::GlRenderer> gl_;       // destroyed before its context
};

}  // namespace temblor::app
