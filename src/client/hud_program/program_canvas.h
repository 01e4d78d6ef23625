// The pictures, rectangles, and letters that a HUD program draws in a frame, at virtual pixels, as a
// render::DrawList. A virtual pixel is as large as one of the built-in HUD, so a letter of 8 x 8 has the size
// of the status bar's.
//
// Colors are factors (1 1 1 leaves a picture as it is). In `rgb` frames they are exact to 1/15 in each
// channel, in `indexed` frames the nearest colors of the palette.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "base/result.h"
#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"
#include "math/vec.h"
#include "render/draw_list.h"

namespace temblor::client {

// The color and the opacity (0 to 1) of something that is drawn. kAdd adds the color times the opacity.
struct ProgramColor {
  math::Vec3 rgb{1.0f};
  float alpha = 1;
  render::DrawMode mode = render::DrawMode::kBlend;
};

// A rectangle in virtual pixels, and the part of a picture: 0 to 1 from left to right and from top to bottom.
struct VirtualRect {
  math::Vec2 corner{0.0f}, size{0.0f};
};

class ProgramCanvas {
 public:
  // Limits of one frame, which keep a wrong program from stopping the game: commands, and the frame's area
  // times this.
  static constexpr std::size_t kMaxCommands = 32768;
  static constexpr double kMaxCoverage = 48;

  explicit ProgramCanvas(const formats::Palette& palette);

  // Starts a frame of this size in pixels, of which `scale` make a virtual one.
  void begin(int width, int height, int scale);
  math::Vec2 virtual_size() const;
  // The point after the mouse has moved it by these pixels, inside of the frame.
  math::Vec2 move_point(const math::Vec2& point, float right_px, float down_px) const;
  // Forgets what was drawn so far: the view covers it.
  void clear() { list_.clear(); }

  // Each fails with kTooLarge above the limits of a frame.
  base::Status fill(const VirtualRect& area, const ProgramColor& color);
  // `part` is limited to the picture.
  base::Status draw_picture(const formats::Picture& picture, const VirtualRect& area, const VirtualRect& part,
                            const ProgramColor& color);
  base::Status draw_line(float width, const math::Vec2& from, const math::Vec2& to,
                         const ProgramColor& color);
  // Nothing is drawn outside of it.
  void set_clip(const VirtualRect& area);
  void reset_clip() { clip_.reset(); }

  // Valid until the next begin().
  const render::DrawList& list() const { return list_; }

 private:
  base::Status add(render::DrawCommand command, const ProgramColor& color);
  render::ScreenRect to_pixels(const VirtualRect& area) const;
  const render::ColorTint& find_tint(const math::Vec3& rgb);

  formats::Palette palette_;
  formats::NearestColor nearest_;
  std::map<std::uint32_t, std::unique_ptr<const render::ColorTint>> tints_;  // by color, 4 bits per channel
  int width_ = 0, height_ = 0, scale_ = 1;
  double covered_ = 0;  // pixels
  std::optional<render::ScreenRect> clip_;
  render::DrawList list_;
};

}  // namespace temblor::client
