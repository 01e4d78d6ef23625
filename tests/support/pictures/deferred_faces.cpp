#include "support/pictures/deferred_faces.h"

#include <fmt/format.h>

namespace temblor::test {

DrawableLevel with_fences(const DrawableLevel& drawable) {
  constexpr std::uint8_t kClear = 255;
  auto level = std::make_shared<world::Level>(*drawable.level);
  level->identity = std::make_shared<const world::LevelIdentity>();
  bool fence = true;
  for (world::Texture& texture : level->textures) {
    if (texture.kind != world::TextureKind::kOpaque) continue;
    fence = !fence;
    if (!fence) continue;
    texture.name = fmt::format("{{{}", texture.name);
    texture.kind = world::TextureKind::kCutout;
    for (std::uint32_t y = 0; y < texture.height; ++y)
      for (std::uint32_t x = 0; x < texture.width; ++x)
        if (x % 8 < 4 || (x * 7 + y * 3) % 11 == 0)
          texture.mips[0][std::size_t{y} * texture.width + x] = kClear;
  }
  DrawableLevel fenced = drawable;
  fenced.name += "_fenced";
  fenced.level = level;
  return fenced;
}

}  // namespace temblor::test
