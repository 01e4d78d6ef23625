// How far the light of a technique is from the engine's, and how it shifts while the view turns.
//
// Both are read from pictures in which every texel has the same gray, so that a pixel's color is its light.
// The unit is a step of light: one row of the colormap. Pictures are rgb, without the colors of light.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/lab/errors/differences.h"
#include "app/lab/errors/screen_points.h"
#include "formats/images/palette.h"
#include "lab/technique.h"
#include "render/frame_buffer.h"
#include "render/renderer.h"

namespace temblor::app {

// For a renderer whose pictures show only light.
formats::Palette make_gray_palette();
formats::Colormap make_gray_colormap();

// In steps of light.
struct LightErrors {
  Differences error;  // from the engine's light, at all pixels
  // The change of light from a pixel to its neighbor, compared with the engine's: across borders of coplanar
  // faces where the engine's light is even (T-junctions show there), and where it jumps on one face
  // (shadows).
  Differences seams, shadow_edges;
  // From frame to frame, at points of the world that stay in sight. The camera turns to the side, or rolls.
  Differences turn, roll;
};

class LightViews {
 public:
  LightViews(const lab::Choice& choice, int width, int height);
  // Compares the view of a scene, which must have the world and opaque brush models only.
  void add(const render::Scene& scene, const render::Settings& settings);
  const LightErrors& figures() const { return figures_; }

 private:
  struct LitPoint {
    ScreenPoint point;
    double light;
  };
  void compare_with_engine(const world::Level& level);
  void compare_neighbors(const world::Level& level, std::size_t pixel, std::size_t neighbor);
  std::optional<double> find_light(math::Vec2d pixel, const render::PixelFace& face) const;
  std::vector<LitPoint> choose_lit_points(const render::Camera& camera) const;
  void follow(std::vector<LitPoint> points, const render::Scene& scene, const render::Settings& settings,
              math::Vec3 step_deg, Differences& io_difference);
  void draw(const render::Scene& scene, const render::Settings& settings);

  render::Renderer engine_, technique_;
  render::FrameBuffer right_, frame_;
  std::vector<render::PixelFace> faces_;
  std::vector<std::uint8_t> writes_;
  LightErrors figures_;
};

}  // namespace temblor::app
