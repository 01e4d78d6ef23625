#include "support/pictures/random_overlay.h"

#include <limits>
#include <memory>

namespace temblor::test {
namespace {

// Around the frame's edges, or far away.
int random_corner(Random& random) {
  if (random.chance(0.05)) return static_cast<int>(random.bits());
  return static_cast<int>(random.below(200)) - 80;
}

int random_scale(Random& random) {
  if (random.chance(0.1)) return 1 + static_cast<int>(random.below(40'000'000));
  return 1 + static_cast<int>(random.below(9));
}

// Gives a part of the picture an area of any size.
void stretch(render::DrawCommand& io_command, Random& random) {
  const formats::Picture& picture = *io_command.picture;
  const auto part = [&](std::uint32_t side, int first) {
    return 1 + static_cast<int>(random.below(side - static_cast<std::size_t>(first)));
  };
  io_command.part_width = part(picture.width, io_command.part_x);
  io_command.part_height = part(picture.height, io_command.part_y);
  io_command.area.width = static_cast<int>(random.below(150));
  io_command.area.height =
      random.chance(0.1) ? std::numeric_limits<int>::max() : static_cast<int>(random.below(150));
}

}  // namespace

formats::Picture random_picture(Random& random) {
  formats::Picture picture{
      static_cast<std::uint32_t>(1 + random.below(40)), static_cast<std::uint32_t>(1 + random.below(40)), {}};
  for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
    picture.pixels.push_back(random.chance(0.3) ? std::uint8_t{255}
                                                : static_cast<std::uint8_t>(random.bits()));
  return picture;
}

void add_detail(formats::Picture& io_picture, Random& random) {
  auto detail = std::make_shared<formats::PictureDetail>();
  detail->width = 1 + static_cast<std::uint32_t>(random.below(100));
  detail->height = 1 + static_cast<std::uint32_t>(random.below(100));
  for (std::uint32_t i = 0; i < detail->width * detail->height; ++i) {
    const std::uint32_t alpha = random.chance(0.5)   ? static_cast<std::uint32_t>(random.below(256))
                                : random.chance(0.5) ? 255
                                                     : 0;
    detail->colors.push_back(static_cast<std::uint32_t>(random.bits()) >> 8 | alpha << 24);
    detail->indices.push_back(alpha == 0 ? std::uint8_t{255} : static_cast<std::uint8_t>(random.below(255)));
  }
  io_picture.detail = std::move(detail);
}

render::ColorTranslation random_translation(Random& random) {
  render::ColorTranslation translation;
  for (std::uint8_t& index : translation) index = static_cast<std::uint8_t>(random.bits());
  return translation;
}

render::ColorTint random_color_tint(Random& random) {
  render::ColorTint tint;
  for (std::uint8_t& index : tint.indices) index = static_cast<std::uint8_t>(random.bits());
  for (std::uint32_t& color : tint.rgb) color = static_cast<std::uint32_t>(random.bits()) | 0xff000000u;
  return tint;
}

render::DrawCommand random_command(const formats::Picture& picture,
                                   const render::ColorTranslation& translation, Random& random) {
  render::DrawCommand command;
  command.area.x = random_corner(random);
  command.area.y = random_corner(random);
  command.opacity = random.chance(0.5) ? 1.0f : static_cast<float>(random.uniform(-0.2, 1.2));
  if (random.chance(0.2)) {
    command.area.width = static_cast<int>(random.below(150));
    command.area.height =
        random.chance(0.1) ? std::numeric_limits<int>::max() : static_cast<int>(random.below(90));
    command.fill = static_cast<std::uint8_t>(random.bits());
    return command;
  }
  command.picture = &picture;
  command.scale = random_scale(random);
  const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  command.part_x = static_cast<int>(random.below(picture.width));
  command.part_y = static_cast<int>(random.below(picture.height));
  command.area.width =
      command.scale * static_cast<int>(random.below(static_cast<std::size_t>(width - command.part_x) + 1));
  command.area.height =
      command.scale * static_cast<int>(random.below(static_cast<std::size_t>(height - command.part_y) + 1));
  if (random.chance(0.3)) command.translation = &translation;
  if (random.chance(0.3)) stretch(command, random);
  return command;
}

void decorate_command(render::DrawCommand& io_command, const render::ColorTint& tint, Random& random) {
  if (random.chance(0.3)) io_command.tint = &tint;
  if (random.chance(0.3))
    io_command.clip = {random_corner(random), random_corner(random), static_cast<int>(random.below(100)),
                       static_cast<int>(random.below(100))};
  if (random.chance(0.2)) {
    io_command.mode = render::DrawMode::kAdd;
    io_command.opacity = 1;
  } else if (random.chance(0.2)) {
    io_command.mode = random.chance(0.5) ? render::DrawMode::kMultiply : render::DrawMode::kMultiplyTwice;
  }
}

}  // namespace temblor::test
