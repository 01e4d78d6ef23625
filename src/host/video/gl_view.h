// Draws through OpenGL (`vid_renderer gl`), in one of two ways:
//
//   into the window   view, overlay, and tone on the card; nothing comes back, except for screenshots
//   without a window  the view comes back to the frame buffer, and takes the way of the CPU's pictures
//
// A context without a window lives on a thread of its own, because the window's thread may have a context of
// SDL's.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "assets/library.h"
#include "host/session/worker.h"
#include "platform/gl_context.h"
#include "platform/window.h"
#include "render_gl/gl_renderer.h"

namespace temblor::host {

using OpenGl = std::function<base::Result<std::unique_ptr<platform::GlContext>>()>;

// Whether OpenGL draws into the window if it can. kAuto: not if the driver is software, since it copies a
// picture in less time than it draws one into the window.
enum class GlWindowUse { kAuto, kOn, kOff };

// All functions that can fail do so if the card lacks memory or the context is lost. Then the object must not
// be used again.
class GlView {
 public:
  // Draws into `window` if it can and `use` allows it, else with a context of `open_gl`. Both, and `look`,
  // must outlive it; nothing else may draw into the window meanwhile. Fails with one line for a person if
  // OpenGL cannot be used.
  static base::Result<std::unique_ptr<GlView>> make(platform::Window& window, GlWindowUse use,
                                                    const OpenGl& open_gl, const assets::Look& look);
  ~GlView();
  GlView(const GlView&) = delete;
  GlView& operator=(const GlView&) = delete;

  // Why it does not draw into the window, if the player wants it to; else nothing.
  const std::optional<base::Error>& window_failure() const { return window_failure_; }
  bool draws_into_window() const { return window_context_ != nullptr; }

  // Draws the view. Without a window of its own, it writes every pixel of the frame; else see
  // GlRenderer::draw.
  base::Result<render::FrameStats> draw(const render::Scene& scene, const render::Settings& settings,
                                        render::FrameBuffer& io_frame);
  // So that no indexed frame waits for them (Renderer::make_blend_tables).
  void make_blend_tables() const;

  // For draws_into_window(): the steps of GlRenderer, and show() into the window.
  base::Status clear(const render::FrameBuffer& frame) { return renderer_->clear(frame); }
  base::Status draw_overlay(const render::DrawList& overlay, render::FrameBuffer& io_frame) {
    return renderer_->draw_overlay(overlay, io_frame);
  }
  base::Status read(render::FrameBuffer& io_frame) const { return renderer_->read(io_frame); }
  base::Status show(const render_gl::Shown& shown);
  // How long the card drew one of the last frames; see GlRenderer.
  bool has_card_timer() const { return renderer_->has_card_timer(); }
  std::optional<double> card_seconds() const { return renderer_->card_seconds(); }

 private:
  GlView() = default;
  base::Status open_in_window(platform::Window& window, GlWindowUse use, const assets::Look& look);
  base::Status open_alone(const OpenGl& open_gl, const assets::Look& look);
  // Runs the work where the context is current, and waits for it.
  void run(std::function<void()> work);

  std::optional<base::Error> window_failure_;
  std::optional<Worker> thread_;  // of a context without a window
  // One of the two.
  std::unique_ptr<platform::GlContext> context_;
  std::unique_ptr<platform::WindowGlContext> window_context_;
  std::optional<render_gl::GlRenderer> renderer_;
};

}  // namespace temblor::host
