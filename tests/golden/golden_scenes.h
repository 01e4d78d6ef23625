// The scenes of the golden pictures: the small level and things in it, all made in code.
#pragma once

#include <ostream>
#include <span>

#include "golden/golden_picture.h"
#include "render/frame_buffer.h"

namespace temblor::test {

constexpr int kGoldenWidth = 320, kGoldenHeight = 200;

struct GoldenScene {
  const char* name;
  const char* shows;  // what to look for
  render::PixelFormat format;
  void (*draw)(render::FrameBuffer& io_frame);  // in the colors of artgen::make_palette()
  Tolerance tolerance = {};
};
inline void PrintTo(const GoldenScene& scene, std::ostream* out) {
  *out << scene.name;
}

std::span<const GoldenScene> golden_scenes();

// The level alone, and effects on its faces.
void draw_hall(render::FrameBuffer& io_frame);
void draw_court(render::FrameBuffer& io_frame);
void draw_dynamic_lights(render::FrameBuffer& io_frame);
void draw_marks(render::FrameBuffer& io_frame);
void draw_marks_on_mover(render::FrameBuffer& io_frame);
void draw_see_through(render::FrameBuffer& io_frame);
void draw_fog(render::FrameBuffer& io_frame);
void draw_skybox(render::FrameBuffer& io_frame);
void draw_under_water(render::FrameBuffer& io_frame);

// Things in the level, and what is drawn over the view.
void draw_models_near(render::FrameBuffer& io_frame);
void draw_models_far(render::FrameBuffer& io_frame);
void draw_weapon_wide(render::FrameBuffer& io_frame);
void draw_sprites(render::FrameBuffer& io_frame);
void draw_explosion(render::FrameBuffer& io_frame);
void draw_lightning(render::FrameBuffer& io_frame);
void draw_status_bar(render::FrameBuffer& io_frame);
void draw_intermission(render::FrameBuffer& io_frame);

}  // namespace temblor::test
