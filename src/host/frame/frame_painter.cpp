#include "host/frame/frame_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/frame/host_parts.h"
#include "lab/registry.h"
#include "render/present.h"

namespace temblor::host {
namespace {

constexpr std::uint8_t kBlack = 0;

// Null unless OpenGL draws into the window.
GlView* find_window_view(const GameData& data) {
  return data.gl_view && data.gl_view->draws_into_window() ? data.gl_view.get() : nullptr;
}

// The next frame drops the object, which must not be used again.
void keep_failure(GameData& io_data, const base::Status& status) {
  if (!status.ok() && !io_data.gl_failure) io_data.gl_failure = status.error();
}

// The first view of a session appears after a level has loaded, so nobody notices this wait.
void make_blend_tables(const GameData& data) {
  data.renderer.make_blend_tables();
  if (data.gl_view) data.gl_view->make_blend_tables();
}

}  // namespace

void update_technique(Host& io_host) {
  if (!has_view(io_host)) return;
  GameData& data = *io_host.game.data;
  const world::Level& level = *data.presentation.scene().level;
  std::size_t technique = io_host.variables.technique();
  if (technique == data.technique && level.identity == data.technique_level) return;
  data.technique_level = level.identity;
  if (const base::Status status = lab::make_default_choice(technique).check_level(level); !status.ok()) {
    print_if_error(io_host, status);
    technique = 0;
    const std::string engine(lab::list_techniques()[technique].name);
    print_if_error(io_host, io_host.variables.variables().set("r_technique", engine));
  }
  if (technique == data.technique) return;
  data.technique = technique;
  data.renderer.replace_stages(lab::make_default_choice(technique).make_stages());
}

void update_renderer(Host& io_host) {
  GameData& data = *io_host.game.data;
  if (!io_host.variables.uses_gl() || data.technique != 0) {
    data.gl_view.reset();
    data.gl_failure.reset();
    return;
  }
  const GlWindowUse use = io_host.variables.gl_window();
  if (use != data.gl_window_use) data.gl_view.reset();
  if (!data.gl_view && !data.gl_failure) {
    data.gl_window_use = use;
    auto made = GlView::make(io_host.services.window, use, io_host.services.open_gl, data.look);
    if (!made.ok()) {
      data.gl_failure = made.error();
    } else {
      data.gl_view = std::move(made).value();
      if (const auto& failure = data.gl_view->window_failure())
        print_line(io_host, fmt::format("OpenGL's picture is copied to the window: {}", failure->message()));
    }
  }
  if (!data.gl_failure) return;
  print_line(io_host, fmt::format("{}; the CPU draws", data.gl_failure->message()));
  print_if_error(io_host, io_host.variables.variables().set("vid_renderer", "cpu"));
  data.gl_view.reset();
  data.gl_failure.reset();
}

render::FrameStats paint_view(Host& io_host, const render::Settings& settings,
                              render::FrameBuffer& io_frame) {
  GameData& data = *io_host.game.data;
  const render::Scene& scene = data.presentation.scene();
  if (io_frame.format() == render::PixelFormat::kIndexed) make_blend_tables(data);
  if (!data.gl_view) return data.renderer.render(scene, settings, io_frame);
  const base::Result<render::FrameStats> drawn = data.gl_view->draw(scene, settings, io_frame);
  if (drawn.ok()) return *drawn;
  data.gl_failure = drawn.error();
  return find_window_view(data) != nullptr ? render::FrameStats{}
                                           : data.renderer.render(scene, settings, io_frame);
}

void paint_nothing(Host& io_host, render::FrameBuffer& io_frame) {
  GameData& data = *io_host.game.data;
  io_frame.set_palette_tint({});
  if (GlView* const view = find_window_view(data)) return keep_failure(data, view->clear(io_frame));
  render::FrameStats stats;
  const render::DrawCommand black{.area = {0, 0, io_frame.width(), io_frame.height()}, .fill = kBlack};
  data.renderer.draw_overlay({{black}}, io_frame, stats);
}

bool read_view(Host& io_host, render::FrameBuffer& io_frame) {
  GameData& data = *io_host.game.data;
  GlView* const view = find_window_view(data);
  if (view == nullptr) return true;
  if (!data.gl_failure) keep_failure(data, view->read(io_frame));
  return !data.gl_failure;
}

void paint_overlay(Host& io_host, const render::DrawList& overlay, render::FrameBuffer& io_frame,
                   render::FrameStats& io_stats) {
  GameData& data = *io_host.game.data;
  GlView* const view = find_window_view(data);
  if (view == nullptr) return data.renderer.draw_overlay(overlay, io_frame, io_stats);
  if (!data.gl_failure) keep_failure(data, view->draw_overlay(overlay, io_frame));
}

std::optional<double> find_drawing_time_s(const Host& host, double cpu_s) {
  const GlView* const view = find_window_view(*host.game.data);
  if (view == nullptr || !view->has_card_timer()) return cpu_s;
  const std::optional<double> card_s = view->card_seconds();
  return card_s ? std::optional(std::max(cpu_s, *card_s)) : std::nullopt;
}

base::Status show_frame(Host& io_host, const ScreenSettings& settings) {
  GameData& data = *io_host.game.data;
  Screen& screen = io_host.video.screen;
  platform::Window& window = io_host.services.window;
  const formats::Palette& palette = data.look.palette;
  GlView* const view = find_window_view(data);
  if (view == nullptr) return screen.show(palette, settings.tone, window);
  screen.forget_pixels();  // those of an older frame
  if (data.gl_failure) return base::Ok{};
  const ToneTable tone = make_tone_table(settings.tone);
  const platform::PixelSize size = window.size();
  keep_failure(data, view->show({.width = size.width,
                                 .height = size.height,
                                 .palette = apply_tone(tone, render::shown_palette(screen.frame(), palette)),
                                 .tone = settings.tone.is_neutral() ? nullptr : &tone}));
  return base::Ok{};
}

base::Result<std::span<const std::uint32_t>> find_shown_pixels(Host& io_host) {
  GameData& data = *io_host.game.data;
  Screen& screen = io_host.video.screen;
  if (const GlView* const view = find_window_view(data); view != nullptr && !data.gl_failure) {
    TRY_STATUS(view->read(screen.frame()));
    screen.finish(data.look.palette, io_host.variables.screen().tone);
  }
  if (screen.pixels().empty()) return base::error(base::ErrorCode::kUsage, "nothing has been drawn yet");
  return screen.pixels();
}

}  // namespace temblor::host
