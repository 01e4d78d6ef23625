// How far the texels of a technique are from the exact ones, and how they shift while the view turns.
//
// Both are read from indexed pictures of a level whose texels show their own position on the texture instead
// of its picture, by a colormap that no light changes. Only faces of the world are looked at.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/lab/errors/differences.h"
#include "app/lab/errors/screen_points.h"
#include "lab/technique.h"
#include "render/frame_buffer.h"
#include "render/renderer.h"

namespace temblor::app {

// In texels of mip 0, along s or t, whichever is more. Errors of more than 8 texels look smaller, since
// positions repeat every 16.
struct TexelErrors {
  // From the exact position at the pixel's center to the texel that shows it; 0: the right texel.
  Differences error;
  // The change of a point's position, from frame to frame, while the camera turns to the side, or rolls. It
  // is the mean of the four texels around the point, so rounding to whole texels remains, in the engine too.
  Differences turn, roll;
};

class TexelViews {
 public:
  TexelViews(const lab::Choice& choice, int width, int height);
  // Adds the view of a scene, which must have the world and opaque brush models only.
  void add(const render::Scene& scene, const render::Settings& settings);
  const TexelErrors& figures() const { return figures_; }

 private:
  struct TexelPoint {
    ScreenPoint point;
    math::Vec2d shift;
  };
  void use_level(const world::Level& level);
  math::Vec2d find_shift(const render::Camera& camera, std::size_t pixel) const;
  std::optional<math::Vec2d> find_mean_shift(const render::Camera& camera, math::Vec2d pixel,
                                             const render::PixelFace& face) const;
  void follow(std::vector<TexelPoint> points, const render::Scene& scene, const render::Settings& settings,
              math::Vec3 step_deg, Differences& io_difference);
  void draw(const render::Scene& scene, const render::Settings& settings);

  render::Renderer renderer_;
  render::FrameBuffer frame_;
  std::vector<render::PixelFace> faces_;
  std::vector<std::uint8_t> writes_;
  std::shared_ptr<const world::LevelIdentity> original_;
  world::Level level_;  // a copy whose texels are positions
  TexelErrors figures_;
};

}  // namespace temblor::app
