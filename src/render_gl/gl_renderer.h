// The renderer on the graphics card: draws a Scene through OpenGL, as the CPU's renderer would draw it.
//
//   CPU    view -> visible faces -> edges -> scan -> surfaces    render's own stages: visible tiles,
//            |                                        |          their mip levels, and their lit texels
//            v                                        v
//   card   vertices of the level, models   atlas of surface blocks -> pixels, tested against depth
//
// One source serves OpenGL ES 3.0 and OpenGL 3.3. The context belongs to the caller.
//
// Method: surfaces that the CPU builds and the card keeps, as in VQuake (Abrash, "Quake: A Post-Mortem and a
// Glimpse into the Future").
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "formats/images/palette.h"
#include "render/draw_list.h"
#include "render/frame_buffer.h"
#include "render/frame_stats.h"
#include "render/scene.h"
#include "render/settings.h"
#include "render_gl/cache_options.h"
#include "render_gl/draw_options.h"
#include "render_gl/screen/present_pass.h"

namespace temblor::render_gl {

// Owns everything that it has on the card. Its context must be current in every call, and when it is
// destroyed. Not thread-safe.
class GlRenderer {
 public:
  // `find_function` gives the address of a function of OpenGL by its name, or null. Fails with kUnsupported,
  // and one line for a person, if the driver is too old or does not accept our shaders, and with kIo if the
  // card lacks memory. `cache` limits what the card keeps of the level; the pictures do not depend on its
  // size.
  static base::Result<GlRenderer> make(const std::function<void*(const char* name)>& find_function,
                                       const formats::Palette& palette, const formats::Colormap& colormap,
                                       const CacheOptions& cache = {});
  ~GlRenderer();
  GlRenderer(GlRenderer&&) noexcept;
  GlRenderer& operator=(GlRenderer&&) noexcept;

  // How lit faces are drawn from the next frame on, unless the settings' filter needs another method.
  void set_method(WorldMethod method);

  // Draws `scene`, copies the picture to `io_frame`, and waits for it: draw() and read().
  base::Result<render::FrameStats> render(const render::Scene& scene, const render::Settings& settings,
                                          render::FrameBuffer& io_frame);

  // The steps of a frame that the card shows by itself. The picture stays on the card, and has the size and
  // the format of `io_frame`, whose depth and pixels are changed by debug views only. A
  // frame of another format than the last one makes everything again. All steps fail if the card lacks
  // memory, if the driver does not accept the shaders of the format, or if the context is lost; then the
  // picture is undefined.
  base::Result<render::FrameStats> draw(const render::Scene& scene, const render::Settings& settings,
                                        render::FrameBuffer& io_frame);
  // Begins a picture without a scene, which is black.
  base::Status clear(const render::FrameBuffer& frame);
  // Draws over the picture. Waits for the card, and changes the frame's pixels, only if `overlay` has
  // products of colors, or details of pictures, in an indexed frame.
  base::Status draw_overlay(const render::DrawList& overlay, render::FrameBuffer& io_frame);
  // Copies the picture to the frame, and waits for it. Fails with kUsage if there is no picture of the
  // frame's size and format.
  base::Status read(render::FrameBuffer& io_frame) const;
  // Draws the picture into the window of the current context.
  base::Status show(const Shown& shown);

  // Computes what indexed frames need for translucency (Renderer::make_blend_tables).
  void make_blend_tables() const;

  // How long the card drew one of the last frames, in seconds. Nothing if it has no timer, or has not
  // reported a frame of the current size yet.
  bool has_card_timer() const;
  std::optional<double> card_seconds() const;

  // How the last frame used the card's cache, and the memory that the cache takes.
  CacheCounts cache_counts() const;
  std::size_t cache_bytes() const;

  // Driver and version, for a person.
  std::string describe() const;

 private:
  struct State;
  explicit GlRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace temblor::render_gl
