#include "app/lab/card/card_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "app/lab/lab_picture.h"
#include "platform/egl/offscreen_context.h"
#include "render/renderer.h"
#include "render_gl/gl_renderer.h"

namespace temblor::app {
namespace {

// The sum of the differences of all channels.
std::uint64_t compute_difference(const render::FrameBuffer& a, const render::FrameBuffer& b) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.pixel_count(); ++i)
    for (int shift = 0; shift < 24; shift += 8)
      sum += static_cast<std::uint64_t>(std::abs(static_cast<int>(a.rgb()[i] >> shift & 255) -
                                                 static_cast<int>(b.rgb()[i] >> shift & 255)));
  return sum;
}

// Both renderers, and their frames.
struct CardPainter {
  CardPainter(render_gl::GlRenderer renderer, const assets::Look& look, FrameSize size)
      : gl(std::move(renderer)),
        cpu(look.palette, look.colormap),
        drawn(size.width, size.height, render::PixelFormat::kRgb),
        reference(size.width, size.height, render::PixelFormat::kRgb) {}

  // Draws the scene with both. Card and CPU may need a frame to fill their caches, which changes no picture.
  base::Status draw(const render::Scene& scene, const render::Settings& settings,
                    render_gl::WorldMethod method) {
    gl.set_method(method);
    TRY_STATUS(gl.render(scene, settings, drawn));
    cpu.render(scene, settings, reference);
    return base::Ok{};
  }

  render_gl::GlRenderer gl;
  render::Renderer cpu;
  render::FrameBuffer drawn, reference;
};

base::Result<std::size_t> find_picture_scene(const LabScenes& scenes, const render::Settings& settings,
                                             CardPainter& io_painter) {
  std::size_t number = 0, best = 0;
  std::uint64_t largest = 0;
  base::Status drawn = base::Ok{};
  TRY_STATUS(scenes.for_each_picture([&](const render::Scene& scene) {
    if (drawn.ok()) drawn = io_painter.draw(scene, settings, render_gl::WorldMethod::kGouraud);
    const std::uint64_t difference = compute_difference(io_painter.drawn, io_painter.reference);
    if (difference > largest) {
      largest = difference;
      best = number;
    }
    ++number;
  }));
  TRY_STATUS(drawn);
  return best;
}

}  // namespace

std::string card_picture_name(const CardMethod& method) {
  std::string name = fmt::format("card-{}.png", method.name);
  std::erase(name, '\'');
  std::ranges::replace(name, ' ', '-');
  return name;
}

base::Result<std::vector<render_gl::WorldMethod>> write_card_pictures(const std::filesystem::path& folder,
                                                                      const LabScenes& scenes, FrameSize size,
                                                                      const render::Settings& settings) {
  TRY(const std::unique_ptr<platform::GlContext> context, platform::egl::make_offscreen_context());
  TRY_STATUS(context->make_current());
  const assets::Look& look = scenes.look();
  const auto find = [&](const char* name) { return context->find_function(name); };
  TRY(render_gl::GlRenderer gl, render_gl::GlRenderer::make(find, look.palette, look.colormap));
  CardPainter painter(std::move(gl), look, size);
  TRY(const std::size_t wanted, find_picture_scene(scenes, settings, painter));
  std::vector<render_gl::WorldMethod> shown;
  std::size_t number = 0;
  base::Status written = base::Ok{};
  TRY_STATUS(scenes.for_each_picture([&](const render::Scene& scene) {
    if (number++ != wanted) return;
    for (const CardMethod& method : list_card_methods()) {
      if (!written.ok() || !painter.draw(scene, settings, method.method).ok()) continue;
      written = write_lab_picture((folder / card_picture_name(method)).string(), painter.drawn,
                                  painter.reference, look.palette);
      shown.push_back(method.method);
    }
  }));
  TRY_STATUS(written);
  return shown;
}

}  // namespace temblor::app
