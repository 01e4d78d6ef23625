// The part of Comparison that checks the depth and color of a drawn face.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "oracle/comparison.h"

namespace temblor::oracle {
namespace {

// The renderer's texel position may be off by this fraction of a pixel's extent, plus this much.
constexpr double kTexelSlackPixels = 1.0 / 128;
constexpr double kTexelSlack = 1.0 / 128;
// If a pixel spans more texels than this, almost any color is possible, so it is not compared.
constexpr double kMaxTexelsPerPixel = 64;

// 1/z may be off by this fraction of its change from pixel to pixel, plus this relative error of floats.
constexpr double kDepthSlackPixels = 1.0 / 128;
constexpr double kDepthSlackRelative = 1e-5;

constexpr double kDerivativeStepPixels = 1.0 / 64;
constexpr double kFullLight = 128 * 256;  // 8.8 light that leaves an rgb color as it is
constexpr double kLightStep = 4 * 256;    // 8.8 light from one row of the colormap to the next

int channel_value(std::uint32_t rgb, std::size_t channel) {
  return static_cast<int>(rgb >> (16 - 8 * channel) & 0xff);
}

}  // namespace

math::Vec2d Comparison::texture_position_at(double x_px, double y_px, const Hit& hit) const {
  const Ray ray = rays_.ray(x_px, y_px);
  const math::Vec3d point_world = ray.at(ray_scene_.distance_to_plane(ray, hit.instance, hit.face));
  return texture_position(level_, level_.face(hit.face), ray_scene_.to_model(hit.instance, point_world));
}

world::TextureIndex Comparison::find_texture(const Hit& hit) const {
  const int entity_frame = hit.instance == 0 ? 0 : scene_.brush_models[hit.instance - 1].frame;
  return world::find_animated_texture(level_, level_.face(hit.face).texture, scene_.time_s, entity_frame);
}

void Comparison::judge_depth(int x, int y, const Hit& hit, Tally& io_tally) const {
  const bool perspective = scene_.camera.projection == render::Projection::kPerspective;
  const auto depth_at = [&](double x_px, double y_px) {
    const double z = ray_scene_.distance_to_plane(rays_.ray(x_px, y_px), hit.instance, hit.face);
    return perspective ? 1 / z : -z;
  };
  const double right = depth_at(x, y);
  const double change = std::abs(depth_at(x + 1, y) - right) + std::abs(depth_at(x, y + 1) - right);
  const double slack = kDepthSlackPixels * change + kDepthSlackRelative * std::abs(right);
  const auto drawn = static_cast<double>(drawn_.frame.depth()[pixel_index(x, y)]);
  ++io_tally.depths;
  if (std::abs(drawn - right) <= slack) ++io_tally.right_depths;
}

void Comparison::judge_color(int x, int y, const Hit& hit, Tally& io_tally) const {
  const std::optional<bool> right = is_right_color(x, y, hit);
  if (!right) return;
  ++io_tally.colors;
  if (*right)
    ++io_tally.right_colors;
  else if (io_tally.findings.size() < Tally::kMaxFindings)
    io_tally.findings.push_back(describe_color(x, y, hit));
}

// The texels that the renderer may have used for a pixel; nothing if there are too many.
std::optional<Comparison::TexelRange> Comparison::find_texels(int x, int y, const Hit& hit) const {
  const world::Face& face = level_.face(hit.face);
  const math::Vec2d center = texture_position_at(x, y, hit);
  const math::Vec2d per_pixel = (glm::abs(texture_position_at(x + kDerivativeStepPixels, y, hit) - center) +
                                 glm::abs(texture_position_at(x, y + kDerivativeStepPixels, hit) - center)) /
                                kDerivativeStepPixels;
  if (std::max(per_pixel.x, per_pixel.y) > kMaxTexelsPerPixel) return std::nullopt;
  const math::Vec2d slack = per_pixel * kTexelSlackPixels + kTexelSlack;
  const auto texel = [&](int axis, double offset) {
    const auto position = static_cast<std::int64_t>(std::floor(center[axis] + offset));
    const std::int64_t first = face.texture_mins[static_cast<std::size_t>(axis)];
    return std::clamp(position, first, first + face.texture_extents[static_cast<std::size_t>(axis)] - 1);
  };
  return TexelRange{{texel(0, -slack.x), texel(1, -slack.y)}, {texel(0, slack.x), texel(1, slack.y)}};
}

// Nothing if there are too many possible colors.
std::optional<bool> Comparison::is_right_color(int x, int y, const Hit& hit) const {
  const std::size_t position = pixel_index(x, y);
  const world::Face& face = level_.face(hit.face);
  if (face.kind == world::FaceKind::kSky || face.kind == world::FaceKind::kLiquid)
    return is_in_texture(position, hit);
  const std::optional<TexelRange> range = find_texels(x, y, hit);
  if (!range) return std::nullopt;
  for (std::int64_t t = range->first.t; t <= range->last.t; ++t)
    for (std::int64_t s = range->first.s; s <= range->last.s; ++s)
      if (matches_color(position, hit, {s, t})) return true;
  return false;
}

// The face that covers the pixel: the first face with holes in front of `opaque` that has no hole there, else
// `opaque`. Nothing if the border of a hole is too close to decide.
std::optional<Hit> Comparison::covering(int x, int y, const Hit& opaque) const {
  constexpr std::uint8_t kHole = 255;
  const Ray ray = rays_.ray(x, y);
  double from = kNearPlane;
  for (;;) {
    const std::optional<Hit> front = ray_scene_.nearest(ray, from, [&](const Hit& hit) {
      return hit.distance < opaque.distance && has_holes(hit) && is_shown(ray, hit);
    });
    if (!front) return opaque;
    const std::optional<TexelRange> range = find_texels(x, y, *front);
    if (!range) return std::nullopt;
    std::size_t texels = 0, holes = 0;
    for (std::int64_t t = range->first.t; t <= range->last.t; ++t)
      for (std::int64_t s = range->first.s; s <= range->last.s; ++s, ++texels)
        holes += texel_at(level_.texture(find_texture(*front)), {s, t}) == kHole;
    if (holes == 0) return front;
    if (holes < texels) return std::nullopt;
    from = std::nextafter(front->distance, opaque.distance);
  }
}

std::string Comparison::describe_color(int x, int y, const Hit& hit) const {
  const world::Face& face = level_.face(hit.face);
  const math::Vec2d at = texture_position_at(x, y, hit);
  const bool indexed = drawn_.frame.format() == render::PixelFormat::kIndexed;
  const std::uint32_t drawn =
      indexed ? drawn_.frame.indexed()[pixel_index(x, y)] : drawn_.frame.rgb()[pixel_index(x, y)];
  const TexelPosition texel{static_cast<std::int64_t>(std::floor(at.x)),
                            static_cast<std::int64_t>(std::floor(at.y))};
  const world::Texture& texture = level_.texture(find_texture(hit));
  const Light light =
      sample_light(level_, face, scene_.light_styles, texel, indexed ? LightColor::kGray : LightColor::kRgb);
  return fmt::format("pixel {},{}: face {} ({}) at s {} t {}, texel {}, light {} {} {}: drawn {:x}", x, y,
                     base::to_size(hit.face), texture.name, at.x, at.y, texel_at(texture, texel),
                     light[0] / 256, light[1] / 256, light[2] / 256, drawn);
}

// Within one step of light of the texel's color.
bool Comparison::matches_color(std::size_t position, const Hit& hit, TexelPosition texel) const {
  const world::Face& face = level_.face(hit.face);
  const std::uint8_t color = texel_at(level_.texture(find_texture(hit)), texel);
  const bool lit = face.kind == world::FaceKind::kLit;
  if (drawn_.frame.format() == render::PixelFormat::kIndexed) {
    const std::uint8_t drawn = drawn_.frame.indexed()[position];
    if (!lit) return drawn == color;
    const int row =
        colormap_row(sample_light(level_, face, scene_.light_styles, texel, LightColor::kGray)[0]);
    for (int near_row = std::max(row - 1, 0); near_row <= std::min(row + 1, formats::Colormap::kRows - 1);
         ++near_row)
      if (drawn_.colormap.rows[static_cast<std::size_t>(near_row) * 256 + color] == drawn) return true;
    return false;
  }
  const std::uint32_t drawn = drawn_.frame.rgb()[position];
  const formats::Rgb rgb = drawn_.palette[color];
  const std::array<int, 3> channels = {rgb.r, rgb.g, rgb.b};
  const bool shaded = lit && color < 256 - drawn_.colormap.fullbrights;
  const Light light = sample_light(level_, face, scene_.light_styles, texel, LightColor::kRgb);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto shade = [&](double light_there) {
      return std::clamp(shaded ? channels[channel] * light_there / kFullLight : channels[channel], 0.0,
                        255.0);
    };
    const int drawn_channel = channel_value(drawn, channel);
    if (drawn_channel < std::floor(shade(light[channel] - kLightStep)) ||
        drawn_channel > std::ceil(shade(light[channel] + kLightStep)))
      return false;
  }
  return true;
}

// Sky and liquids move. Without repeating the renderer's arithmetic, only this is known: the color is one of
// their texture's.
bool Comparison::is_in_texture(std::size_t position, const Hit& hit) const {
  const std::bitset<256>& colors = prepared_.texture_colors(find_texture(hit));
  if (drawn_.frame.format() == render::PixelFormat::kIndexed) return colors[drawn_.frame.indexed()[position]];
  const std::uint32_t drawn = drawn_.frame.rgb()[position];
  for (std::size_t color = 0; color < colors.size(); ++color) {
    const formats::Rgb rgb = drawn_.palette[color];
    if (colors[color] && drawn == (0xff000000u | rgb.r << 16u | rgb.g << 8u | rgb.b)) return true;
  }
  return false;
}

}  // namespace temblor::oracle
