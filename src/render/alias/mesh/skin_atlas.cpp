#include "render/alias/mesh/skin_atlas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::render {

namespace {

// Texels stay this far inside of their part, so that rounding never shows a neighbor.
constexpr float kTexelMargin = 1.0f / 16;
// Whole skins that a coordinate may exceed them by without a repetition: rounding of exporters.
constexpr float kRepetitionSlack = 1.0f / 256;

// The range of repetitions that coordinates lie in.
struct Repetitions {
  std::int32_t first = 0;
  std::uint32_t count = 1;
};

Repetitions count_repetitions(const std::vector<math::Vec2>& texels, int axis) {
  float least = 1, most = 0;
  for (const math::Vec2& texel : texels) {
    least = std::min(least, texel[axis]);
    most = std::max(most, texel[axis]);
  }
  const float first = std::floor(least + kRepetitionSlack), end = std::ceil(most - kRepetitionSlack);
  return {static_cast<std::int32_t>(first), static_cast<std::uint32_t>(std::max(end - first, 1.0f))};
}

std::uint8_t pick_texel(const formats::Picture& picture, const AtlasPart& part, std::uint32_t s,
                        std::uint32_t t) {
  const std::uint64_t column = std::uint64_t{s % part.width} * picture.width / part.width;
  const std::uint64_t row = std::uint64_t{t % part.height} * picture.height / part.height;
  return picture.pixels[row * picture.width + column];
}

}  // namespace

base::Result<SkinAtlas> make_skin_atlas(const std::vector<formats::PosedMesh>& meshes,
                                        const std::vector<formats::Picture>& pictures) {
  SkinAtlas atlas;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    const Repetitions across = count_repetitions(meshes[mesh].texels, 0);
    const Repetitions down = count_repetitions(meshes[mesh].texels, 1);
    const AtlasPart part{pictures[mesh].width, pictures[mesh].height, across.first, down.first, across.count,
                         down.count,           atlas.height};
    const std::uint64_t width = std::uint64_t{part.width} * part.columns;
    const std::uint64_t height = std::uint64_t{part.height} * part.rows + atlas.height;
    const std::uint64_t joined_width = std::max<std::uint64_t>(width, atlas.width);
    if (std::max(width, height) > kMaxAtlasSide || joined_width * height > kMaxAtlasTexels)
      return base::error(
          base::ErrorCode::kTooLarge,
          "mesh {}: its skin, {} x {} times, makes a picture of {} x {} texels; the limits are {} "
          "texels for a side and {} in all",
          mesh, part.columns, part.rows, joined_width, height, kMaxAtlasSide, kMaxAtlasTexels);
    atlas.width = std::max(atlas.width, static_cast<std::uint32_t>(width));
    atlas.height = static_cast<std::uint32_t>(height);
    atlas.parts.push_back(part);
  }
  return atlas;
}

std::vector<TexelPoint> place_texels(const AtlasPart& part, const std::vector<math::Vec2>& texels) {
  const auto place = [](float coordinate, std::int32_t first, std::uint32_t size, std::uint32_t count) {
    const float texel = (coordinate - static_cast<float>(first)) * static_cast<float>(size);
    return std::clamp(texel, kTexelMargin, static_cast<float>(size * count) - kTexelMargin);
  };
  std::vector<TexelPoint> placed;
  for (const math::Vec2& texel : texels)
    placed.push_back({place(texel.x, part.first_s, part.width, part.columns),
                      place(texel.y, part.first_t, part.height, part.rows) + static_cast<float>(part.top)});
  return placed;
}

std::vector<std::uint8_t> join_pictures(const SkinAtlas& atlas,
                                        const std::vector<formats::Picture>& pictures) {
  std::vector<std::uint8_t> joined(std::size_t{atlas.width} * atlas.height);
  for (std::size_t mesh = 0; mesh < pictures.size(); ++mesh) {
    const AtlasPart& part = atlas.parts[mesh];
    for (std::uint32_t t = 0; t < part.height * part.rows; ++t) {
      std::uint8_t* row = joined.data() + std::size_t{part.top + t} * atlas.width;
      for (std::uint32_t s = 0; s < part.width * part.columns; ++s)
        row[s] = pick_texel(pictures[mesh], part, s, t);
    }
  }
  return joined;
}

}  // namespace temblor::render
