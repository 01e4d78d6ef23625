#include "client/hud_program/program_canvas.h"

#include <algorithm>
#include <cmath>

namespace temblor::client {
namespace {

constexpr int kColorSteps = 15;  // of a channel, from 0 to 1
// The entry of a tint for filled rectangles. Pictures never draw it: there, this index is transparent.
constexpr std::uint8_t kFillIndex = formats::kTransparentIndex;

// Rounds to a whole pixel. Values far outside of any frame stay within the range of int.
int round_pixel(double value) {
  constexpr double kFar = 1e6;
  return std::isnan(value) ? 0 : static_cast<int>(std::lround(std::clamp(value, -kFar, kFar)));
}

std::uint32_t quantize(float channel) {
  if (std::isnan(channel)) return 0;
  return static_cast<std::uint32_t>(std::lround(std::clamp(channel, 0.0f, 1.0f) * kColorSteps));
}

render::ScreenRect intersect(const render::ScreenRect& a, const render::ScreenRect& b) {
  const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
  const int right = std::min(a.x + a.width, b.x + b.width), bottom = std::min(a.y + a.height, b.y + b.height);
  return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

// A part of `size` pixels of a picture: its first pixel and its number of pixels, at least 1.
struct PartRange {
  int first, count;
};
PartRange limit_part(float corner, float size, std::uint32_t pixels) {
  const int count = static_cast<int>(pixels);
  const int first = std::clamp(round_pixel(double{corner} * count), 0, count - 1);
  const int end = round_pixel((double{corner} + double{size}) * count);
  return {first, std::clamp(end, first + 1, count) - first};
}

}  // namespace

ProgramCanvas::ProgramCanvas(const formats::Palette& palette)
    : palette_(palette), nearest_(palette, 0, formats::kTransparentIndex) {}

void ProgramCanvas::begin(int width, int height, int scale) {
  width_ = width;
  height_ = height;
  scale_ = scale;
  covered_ = 0;
  clip_.reset();
  list_.clear();
}

math::Vec2 ProgramCanvas::virtual_size() const {
  return math::Vec2(static_cast<float>(width_), static_cast<float>(height_)) / static_cast<float>(scale_);
}

math::Vec2 ProgramCanvas::move_point(const math::Vec2& point, float right_px, float down_px) const {
  const math::Vec2 moved = point + math::Vec2(right_px, down_px) / static_cast<float>(scale_);
  return glm::clamp(moved, math::Vec2(0.0f), virtual_size());
}

// Both sides are rounded, so that neighbors touch.
render::ScreenRect ProgramCanvas::to_pixels(const VirtualRect& area) const {
  const auto pixel = [this](float a, float b) { return round_pixel((double{a} + double{b}) * scale_); };
  const int left = pixel(area.corner.x, 0), top = pixel(area.corner.y, 0);
  return {left, top, std::max(pixel(area.corner.x, area.size.x) - left, 0),
          std::max(pixel(area.corner.y, area.size.y) - top, 0)};
}

// Each entry is the palette's color times the factor.
const render::ColorTint& ProgramCanvas::find_tint(const math::Vec3& rgb) {
  const std::uint32_t r = quantize(rgb.x), g = quantize(rgb.y), b = quantize(rgb.z);
  std::unique_ptr<const render::ColorTint>& found = tints_[r << 8 | g << 4 | b];
  if (found) return *found;
  const auto scale = [&](const formats::Rgb& color) {
    const auto scaled = [](std::uint8_t channel, std::uint32_t factor) {
      return static_cast<std::uint8_t>((channel * factor + kColorSteps / 2) / kColorSteps);
    };
    return formats::Rgb{scaled(color.r, r), scaled(color.g, g), scaled(color.b, b)};
  };
  constexpr formats::Rgb kWhite{255, 255, 255};
  auto tint = std::make_unique<render::ColorTint>();
  tint->factor = scale(kWhite);
  for (std::size_t i = 0; i < palette_.size(); ++i) {
    const formats::Rgb color = scale(i == kFillIndex ? kWhite : palette_[i]);
    tint->indices[i] = nearest_.find(color);
    tint->rgb[i] = 0xff000000u | std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b;
  }
  found = std::move(tint);
  return *found;
}

// An additive command has its opacity in its tint, because the tables of sums know no opacity.
base::Status ProgramCanvas::add(render::DrawCommand command, const ProgramColor& color) {
  command.opacity = std::min(color.alpha, 1.0f);
  const render::ScreenRect frame{0, 0, width_, height_};
  const render::ScreenRect visible = intersect(command.area, clip_ ? intersect(*clip_, frame) : frame);
  if (visible.width == 0 || visible.height == 0 || !(command.opacity > 0)) return base::Ok{};
  covered_ += 1.0 * visible.width * visible.height;
  if (list_.commands.size() >= kMaxCommands)
    return base::error(base::ErrorCode::kTooLarge, "more than {} pictures in one frame", kMaxCommands);
  if (covered_ > kMaxCoverage * width_ * height_)
    return base::error(base::ErrorCode::kTooLarge, "draws over the whole frame more than {} times",
                       kMaxCoverage);
  command.clip = clip_;
  command.mode = color.mode;
  if (color.mode == render::DrawMode::kAdd) {
    command.tint = &find_tint(color.rgb * command.opacity);
    command.opacity = 1;
  }
  list_.commands.push_back(command);
  return base::Ok{};
}

base::Status ProgramCanvas::fill(const VirtualRect& area, const ProgramColor& color) {
  return add({.area = to_pixels(area), .fill = kFillIndex, .tint = &find_tint(color.rgb)}, color);
}

base::Status ProgramCanvas::draw_picture(const formats::Picture& picture, const VirtualRect& area,
                                         const VirtualRect& part, const ProgramColor& color) {
  if (picture.width == 0 || picture.height == 0) return base::Ok{};
  const PartRange x = limit_part(part.corner.x, part.size.x, picture.width);
  const PartRange y = limit_part(part.corner.y, part.size.y, picture.height);
  const bool is_tinted = color.rgb != math::Vec3(1.0f);
  return add({.picture = &picture,
              .area = to_pixels(area),
              .part_x = x.first,
              .part_y = y.first,
              .part_width = x.count,
              .part_height = y.count,
              .tint = is_tinted ? &find_tint(color.rgb) : nullptr},
             color);
}

// A line is a row of rectangles: one for each step of the shorter side, as long as the line stays in it.
base::Status ProgramCanvas::draw_line(float width, const math::Vec2& from, const math::Vec2& to,
                                      const ProgramColor& color) {
  const math::Vec2 span = to - from;
  const bool is_flat = std::fabs(span.x) >= std::fabs(span.y);
  const float length = is_flat ? std::fabs(span.x) : std::fabs(span.y);
  const float across = is_flat ? std::fabs(span.y) : std::fabs(span.x);
  if (!std::isfinite(length + across)) return base::Ok{};
  const float thickness = std::clamp(width, 1.0f / static_cast<float>(scale_), 64.0f);
  const int steps = std::clamp(round_pixel(double{across} * scale_), 0, width_ + height_) + 1;
  for (int i = 0; i < steps; ++i) {
    const auto at = [&](int step) {
      return from + span * (static_cast<float>(step) / static_cast<float>(steps));
    };
    const math::Vec2 a = at(i), b = at(i + 1);
    const math::Vec2 low(std::min(a.x, b.x), std::min(a.y, b.y));
    const float piece = length / static_cast<float>(steps);
    const math::Vec2 size = is_flat ? math::Vec2(std::max(piece, thickness / 2), thickness)
                                    : math::Vec2(thickness, std::max(piece, thickness / 2));
    TRY_STATUS(fill({low, size}, color));
  }
  return base::Ok{};
}

void ProgramCanvas::set_clip(const VirtualRect& area) {
  clip_ = to_pixels(area);
}

}  // namespace temblor::client
