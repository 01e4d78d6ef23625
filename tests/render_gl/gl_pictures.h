// Pictures of the renderer on the graphics card next to those of the CPU's, the reference.
#pragma once

#include <string>

#include "platform/gl_context.h"
#include "render/renderer.h"
#include "render_gl/gl_renderer.h"
#include "support/levels/drawable_level.h"

namespace temblor::render_gl {

// Whether the renderer may use glClipControl, which many drivers lack.
enum class ClipControl { kIfSupported, kNo };

// Both renderers for one palette, and the context of the second.
class RendererPair {
 public:
  // Fails on machines without OpenGL.
  static base::Result<std::unique_ptr<RendererPair>> make(
      const test::DrawableLevel& look, ClipControl clip_control = ClipControl::kIfSupported,
      const CacheOptions& cache = {});

  // Draws the scene with both, and returns the share of pixels whose channels differ by at most `tolerance`;
  // of indexed frames, that of equal indices. If the driver rounds vertices coarsely, a pixel may also equal
  // one beside it.
  // CHECKs that the card draws. Writes the pictures and their difference if the test run asks for pictures.
  double compare(const render::Scene& scene, const render::Settings& settings, int tolerance = 2);

  // The format of the frames from now on; rgb at first.
  void set_format(render::PixelFormat format);

  // Makes its context current.
  GlRenderer& gl();
  const render::FrameBuffer& cpu_frame() const { return cpu_frame_; }
  const render::FrameBuffer& gl_frame() const { return gl_frame_; }

 private:
  RendererPair(const test::DrawableLevel& look);
  double equal_indices() const;

  std::string name_;
  bool rounds_coarsely_ = false;
  formats::Palette palette_;
  int picture_count_ = 0;
  render::Renderer cpu_;
  std::unique_ptr<platform::GlContext> context_;
  std::optional<GlRenderer> gl_;  // destroyed before its context
  render::FrameBuffer cpu_frame_, gl_frame_;
};

}  // namespace temblor::render_gl

// Declares `variable` as the pair that RendererPair::make returns, or skips the test with the driver's
// message.
#define RENDERER_PAIR_OR_SKIP(variable, ...)                                                    \
  const auto variable##_result = ::temblor::render_gl::RendererPair::make(__VA_ARGS__);         \
  if (!variable##_result.ok()) GTEST_SKIP() << "no OpenGL: " << variable##_result.error().what; \
  ::temblor::render_gl::RendererPair& variable = **variable##_result
