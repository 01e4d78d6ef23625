// The renderer: draws a Scene into a FrameBuffer on the CPU, by the methods of stock Quake.
//
//   1. The BSP tree is walked front to back through the potentially visible set.
//   2. The edges of visible faces form one table; scanning it yields spans that cover every pixel once.
//   3. Spans are filled, in perspective, from surface blocks: texture times light, kept in a cache.
//   4. Alias models, sprites, and particles are drawn over that, tested against 1/z.
//
// docs/architecture.md describes the stages; render/frame/render_frame.cpp calls them in order. Public
// headers are those in src/render itself; the subfolders are private to this library.
//
// Unlike stock Quake it draws bands of rows on several threads, divides by z at every pixel, and has a 32-bit
// format with colored light.
//
// Method: Michael Abrash, "Graphics Programming Black Book" (1997), chapters 59 to 70.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "formats/images/palette.h"
#include "render/draw_list.h"
#include "render/frame_buffer.h"
#include "render/frame_stats.h"
#include "render/scene.h"
#include "render/settings.h"

namespace temblor::render {

// The face that a pixel shows, for tests.
struct PixelFace {
  std::uint32_t instance;  // 0: the world; i + 1: Scene::brush_models[i]; kNothing: the background
  std::uint32_t face;
  static constexpr std::uint32_t kNothing = 0xffffffff;
};

// Stages of a frame that can be replaced (render/frame/frame_stages.h).
struct FrameStages;

// A scene and the frame that shows it, for Renderer::render_views. Neither is null.
struct View {
  const Scene* scene;
  FrameBuffer* frame;
};

// Owns the caches that live longer than a frame. Not thread-safe, but it runs jobs of its own in parallel;
// several renderers can exist in one process.
class Renderer {
 public:
  Renderer(const formats::Palette& palette, const formats::Colormap& colormap);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  // Draws `scene` into every pixel of `io_frame`, whose width and height must be 1 to 8192 (CHECKed). Equal
  // scenes and settings make equal pixels, whatever was drawn before and for any number of threads.
  FrameStats render(const Scene& scene, const Settings& settings, FrameBuffer& io_frame);

  // Draws each view as render() does: the frames get the same pixels. But each thread draws whole views, so
  // that many small views use all threads, and surfaces that several views show are built once. All scenes
  // must have the same level, and all frames the same format (CHECKed).
  void render_views(std::span<const View> views, const Settings& settings);

  // Draws `list` over `io_frame`, command by command, and adds the time it takes to `io_stats`. CHECKs that
  // parts are inside their pictures; areas may be anywhere. Opacity is exact in rgb. Indexed frames round it
  // to a sixteenth and show the palette's nearest color.
  void draw_overlay(const DrawList& list, FrameBuffer& io_frame, FrameStats& io_stats) const;

  // The face of every pixel of the last frame, and how often the pixel was written. For tests: both spans
  // have one element for each pixel (CHECKed).
  void pixel_faces(std::span<PixelFace> out_faces, std::span<std::uint8_t> out_writes) const;

  // Computes the tables with which indexed frames blend, all at once (20 to 50 ms the first time). Otherwise
  // a frame computes each when it first needs it, so that a frame in which something fades is late.
  void make_blend_tables() const;

  // Makes render(), but not render_views(), use these stages. For the laboratory.
  void replace_stages(const FrameStages& stages);

  // Empties the surface cache: the next frame builds all of its surfaces.
  void drop_surfaces();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::render
