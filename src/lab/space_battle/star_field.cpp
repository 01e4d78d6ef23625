#include "lab/space_battle/star_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "lab/space_battle/random_numbers.h"
#include "render/frame_buffer.h"

namespace temblor::lab::space {

std::vector<Star> make_stars(std::size_t count, std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<Star> stars(count);
  for (Star& star : stars) {
    // Slices of a ball with equal height have equal surface (Archimedes).
    const double height = random.between(-1, 1), angle = random.between(0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - height * height);
    star.direction = {radius * std::cos(angle), radius * std::sin(angle), height};
    // Few stars are bright.
    const double brightness = 60 + 195 * std::pow(random.between(0, 1), 4);
    const double warmth = random.between(0.75, 1);
    star.color = render::to_rgb({static_cast<std::uint8_t>(brightness),
                                 static_cast<std::uint8_t>(brightness * (0.5 + warmth / 2)),
                                 static_cast<std::uint8_t>(brightness * warmth)});
    star.size_px = brightness > 200 ? 2 : 1;
  }
  return stars;
}

std::span<const StarPixel> find_star_pixels(std::span<const Star> stars, const BattleView& view,
                                            base::Arena& arena) {
  base::ArenaVector<StarPixel> pixels(arena, stars.size() * 2);
  for (const Star& star : stars) {
    const math::Vec3d direction = view.turn_to_view(star.direction);
    if (!view.can_see(direction, 0)) continue;
    const math::Vec2d at = view.to_screen(direction);
    const int left = static_cast<int>(std::lround(at.x)), top = static_cast<int>(std::lround(at.y));
    for (int y = std::max(top, 0); y < std::min(top + star.size_px, view.height); ++y)
      for (int x = std::max(left, 0); x < std::min(left + star.size_px, view.width); ++x)
        pixels.push_back({static_cast<std::uint32_t>(y * view.width + x), star.color});
  }
  // By color, too, so that the order is certain.
  std::sort(pixels.begin(), pixels.end(), [](const StarPixel& a, const StarPixel& b) {
    return std::tie(a.place, a.color) < std::tie(b.place, b.color);
  });
  return pixels.view();
}

}  // namespace temblor::lab::space
