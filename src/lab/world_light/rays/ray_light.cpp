#include "lab/world_light/rays/ray_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>

#include "lab/world_light/lamps/lamp_stages.h"
#include "lab/world_light/rays/shadow_rays.h"

namespace temblor::lab {

namespace {

constexpr LitKernels kPixelKernels{draw_pixel_lit_u8_simd, draw_pixel_lit_u8_scalar, draw_pixel_lit_u32_simd,
                                   draw_pixel_lit_u32_scalar};

// Light that cannot change a pixel: less than a quarter of a unit of the light map.
constexpr float kMinLight = 64;
constexpr float kFullSum = 65280;
// Points are moved off their face, so that its own plane does not block them.
constexpr float kAway_units = 0.125f;

// Pixels of a span that are next to each other.
struct PixelPacket {
  PointPacket from_eye, world;
  std::size_t count = 0;
};

using LightPacket = std::array<float, kRaysPerPacket>;

// The light of one lamp without shadows, as in phong_kernels.h.
LightPacket compute_light(const PixelPacket& pixels, const PointLamp& lamp,
                          const std::array<float, 3>& normal) {
  LightPacket light;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) {
    const float x = lamp.from_eye[0] - pixels.from_eye[0][i], y = lamp.from_eye[1] - pixels.from_eye[1][i],
                z = lamp.from_eye[2] - pixels.from_eye[2][i];
    const float distance = std::max(std::sqrt(x * x + y * y + z * z), 1.0f);
    const float cosine = (x * normal[0] + y * normal[1] + z * normal[2]) / distance;
    const float strength = std::max(lamp.brightness - lamp.falloff * distance, 0.0f) +
                           (lamp.inverse + lamp.inverse_square / distance) / distance;
    const float from_lamp = -(x * lamp.spot[0] + y * lamp.spot[1] + z * lamp.spot[2]);
    const bool is_lit = cosine > 0 && from_lamp >= lamp.spot_cosine * distance;
    light[i] = is_lit ? strength * (0.5f + 0.5f * cosine) : 0;
  }
  return light;
}

std::uint32_t find_bright(const LightPacket& light, std::size_t count) {
  std::uint32_t bright = 0;
  for (std::size_t i = 0; i < count; ++i) bright |= std::uint32_t{light[i] >= kMinLight} << i;
  return bright;
}

struct LevelShadows {
  std::optional<ShadowRays> rays;
  float min_light = 0;  // 256 times light as stored
};

// The sum of all lamps that reach the pixels. Adds the rays that this takes.
LightPacket sum_light(const PixelPacket& pixels, const LampSpans& spans, const LevelShadows& level,
                      std::uint64_t& io_rays) {
  const ShadowRays& shadows = *level.rays;
  LightPacket sum{};
  for (const PointLamp& lamp : spans.draw.lamps) {
    const LightPacket light = compute_light(pixels, lamp, spans.draw.normal);
    const std::uint32_t bright = find_bright(light, pixels.count);
    if (bright == 0) continue;
    io_rays += static_cast<std::uint64_t>(std::popcount(bright));
    const math::Vec3d from_eye(lamp.from_eye[0], lamp.from_eye[1], lamp.from_eye[2]);
    const std::uint32_t lit =
        lamp.is_sky ? shadows.find_under_sky(pixels.world, bright, math::Vec3(glm::normalize(from_eye)))
                    : shadows.find_lit(pixels.world, bright, math::Vec3(spans.view.eye_world + from_eye));
    for (std::size_t i = 0; i < kRaysPerPacket; ++i)
      if ((lit >> i & 1) != 0) sum[i] += light[i];
  }
  for (float& light : sum) light = std::max(light, level.min_light);
  return sum;
}

// In the units of the kernels.
std::uint32_t convert_light(float sum, bool is_indexed) {
  const float bounded = std::min(sum, kFullSum);
  const float light = is_indexed ? std::max((kFullSum - bounded) * 0.25f, 64.0f) : bounded * 0.5f;
  return static_cast<std::uint32_t>(light + 0.5f);
}

// Draws the spans of one draw, in parts.
class RaySpans {
 public:
  RaySpans(const LampSpans& spans, const LevelShadows& shadows) : spans_(spans), shadows_(shadows) {}

  // Returns the number of rays.
  std::uint64_t draw() {
    for (const render::Span& span : spans_.spans)
      for (int first = 0; first < span.count; first += kPart) draw_part(span, first);
    return rays_;
  }

 private:
  void draw_part(const render::Span& span, int first) {
    const int count = std::min(kPart, span.count - first);
    for (int i = 0; i < count; i += static_cast<int>(kRaysPerPacket)) {
      const PixelPacket pixels = place_pixels(span.x + first + i, span.y, count - i);
      const LightPacket sum = sum_light(pixels, spans_, shadows_, rays_);
      for (std::size_t lane = 0; lane < kRaysPerPacket; ++lane)
        light_[static_cast<std::size_t>(i) + lane] =
            convert_light(sum[lane], spans_.sources.format == render::PixelFormat::kIndexed);
    }
    const render::Span part{static_cast<std::uint16_t>(span.x + first), span.y,
                            static_cast<std::uint16_t>(count)};
    LitSpans job = spans_.job;
    job.spans = &part;
    job.span_count = 1;
    kPixelKernels.choose(spans_.sources)(job, {light_.data(), first}, spans_.target);
  }

  PixelPacket place_pixels(int x, int y, int count) const {
    const render::ViewFrame& view = spans_.view;
    const render::KernelPlane& depth = spans_.job.depth;
    const math::Vec3d right = view.axes.right / view.pixels_per_unit;
    const math::Vec3d row = view.axes.forward - view.axes.up * ((y - view.center_y) / view.pixels_per_unit);
    PixelPacket pixels;
    pixels.count = std::min(static_cast<std::size_t>(count), kRaysPerPacket);
    for (std::size_t i = 0; i < kRaysPerPacket; ++i) {
      const double column = x + static_cast<double>(std::min(i, pixels.count - 1));
      const double per_z = depth.at_origin + depth.dx * column + depth.dy * y;
      const math::Vec3d at = (row + right * (column - view.center_x)) /
                             std::max(per_z, static_cast<double>(render::kMinSpanDepth));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        pixels.from_eye[axis][i] = static_cast<float>(at[a]);
        pixels.world[axis][i] =
            static_cast<float>(view.eye_world[a] + at[a]) + kAway_units * spans_.draw.normal[axis];
      }
    }
    return pixels;
  }

  static constexpr int kPart = 256;  // pixels
  const LampSpans& spans_;
  const LevelShadows& shadows_;
  std::uint64_t rays_ = 0;
  std::array<std::uint32_t, kPart + kCellPadding> light_{};
};

}  // namespace

base::Status check_ray_light(std::span<const double> values, const world::Level& level) {
  const std::size_t shadowed = find_shadowed_lamps(level).size();
  if (shadowed == 0) TRY_STATUS(check_lamps(values, level));
  if (shadowed >= kMaxShadowedLamps)
    return base::error(base::ErrorCode::kTooLarge,
                       "{}: surfaces that glow make {} lights or more, so ray-light cannot draw it",
                       level.name, kMaxShadowedLamps);
  return ShadowRays::check();
}

render::FrameStages make_ray_light(std::span<const double> values, Counter* counter) {
  const auto shadows = std::make_shared<LevelShadows>();
  return make_lamp_stages(
      {.lamps_per_face = static_cast<std::size_t>(values[0]), .has_shadows = true}, counter,
      [=](const world::Level& level) {
        *shadows = {};
        shadows->min_light = 256 * find_min_light(level);
        if (base::Result<ShadowRays> made = ShadowRays::make(level); made.ok())
          shadows->rays = std::move(made).value();
        return shadows->rays.has_value();
      },
      [=](const LampSpans& spans) {
        const std::uint64_t rays = RaySpans(spans, *shadows).draw();
        if (counter != nullptr) counter->add({.rays = rays});
      });
}

}  // namespace temblor::lab
