#include "app/lab/errors/light_film.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "app/lab/errors/light_figures.h"
#include "formats/images/animated_png.h"
#include "formats/images/png.h"
#include "render/renderer.h"

namespace temblor::app {
namespace {

constexpr int kFramesPerMotion = 12, kFramesPerSecond = 10;
constexpr float kTurn_deg = 8, kRoll_deg = 20;

// First one turn to both sides and back, then one roll.
math::Vec3 find_rotation_deg(int frame) {
  const float phase = 2 * std::numbers::pi_v<float> * static_cast<float>(frame) / kFramesPerMotion;
  const float swing = std::sin(phase);
  return frame < kFramesPerMotion ? math::Vec3(0, kTurn_deg * swing, 0) : math::Vec3(0, 0, kRoll_deg * swing);
}

base::Result<base::ByteVector> join_side_by_side(const render::FrameBuffer& left,
                                                 const render::FrameBuffer& right) {
  const auto row_pixels = static_cast<std::size_t>(left.width());
  std::vector<std::uint32_t> joined;
  for (std::size_t row = 0; row < left.pixel_count(); row += row_pixels)
    for (const render::FrameBuffer* const frame : {&left, &right}) {
      const auto pixels = frame->rgb().subspan(row, row_pixels);
      joined.insert(joined.end(), pixels.begin(), pixels.end());
    }
  return formats::write_png(joined, 2 * left.width(), left.height());
}

}  // namespace

base::Result<base::ByteVector> make_light_film(const lab::Choice& choice, const render::Scene& scene,
                                               const render::Settings& asked, FrameSize size) {
  render::Settings settings = asked;
  settings.colored_light = false;
  render::Renderer of_engine(make_gray_palette(), make_gray_colormap());
  render::Renderer of_technique(make_gray_palette(), make_gray_colormap());
  of_technique.replace_stages(choice.make_stages());
  render::FrameBuffer engine(size.width, size.height, render::PixelFormat::kRgb);
  render::FrameBuffer technique(size.width, size.height, render::PixelFormat::kRgb);
  render::Scene moving = scene;
  std::vector<base::ByteVector> frames;
  for (int frame = 0; frame < 2 * kFramesPerMotion; ++frame) {
    moving.camera.angles_deg = scene.camera.angles_deg + find_rotation_deg(frame);
    of_engine.render(moving, settings, engine);
    of_technique.render(moving, settings, technique);
    TRY(base::ByteVector png, join_side_by_side(technique, engine));
    frames.push_back(std::move(png));
  }
  return formats::join_png_frames(frames, kFramesPerSecond);
}

}  // namespace temblor::app
