// Draws the view through OpenGL (`vid_renderer gl`), in a context without a window: the picture comes back to
// the frame buffer, and takes the way of the CPU's pictures to the window. So any window can show it, and the
// player can change the renderer in the middle of a game.
//
// The context lives on a thread of its own, because the window's thread may have a context of SDL's.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "assets/library.h"
#include "host/session/worker.h"
#include "platform/gl_context.h"
#include "render_gl/gl_renderer.h"

namespace temblor::host {

using OpenGl = std::function<base::Result<std::unique_ptr<platform::GlContext>>()>;

class GlView {
 public:
  // `look` must outlive it. Fails with one line for a person if OpenGL cannot be used.
  static base::Result<std::unique_ptr<GlView>> make(const OpenGl& open_gl, const assets::Look& look);
  ~GlView();
  GlView(const GlView&) = delete;
  GlView& operator=(const GlView&) = delete;

  // Draws into every pixel of the frame. Fails if the card lacks memory or the context is
  // lost; then this object must not be used again.
  base::Result<render::FrameStats> draw(const render::Scene& scene, const render::Settings& settings,
                                        render::FrameBuffer& io_frame);
  // So that no indexed frame waits for them (Renderer::make_blend_tables).
  void make_blend_tables() const;

 private:
  GlView() = default;
  // Runs the work on the context's thread and waits for it.
  void run(std::function<void()> work);

  Worker thread_;
  std::unique_ptr<platform::GlContext> context_;
  std::optional<render_gl::GlRenderer> renderer_;
};

}  // namespace temblor::host
