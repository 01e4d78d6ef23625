#include "compiler/lighting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/cube_room.h"

namespace temblor::test {
namespace {

constexpr double kHalfRoom = 64;

std::string with_double_quotes(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return text;
}

// A wall's texture axes, as cube_room.cpp says: the two axes after its own, t half a texel further on.
struct WallGrid {
  int s_axis, t_axis;
  int first_s, first_t, width, height;
};
WallGrid grid_of(int wall) {
  const int axis = wall / 2;
  const auto first = [](double low) { return static_cast<int>(std::floor(low / 16)) * 16; };
  const auto count = [&](double low, double high) {
    return (static_cast<int>(std::ceil(high / 16)) * 16 - first(low)) / 16 + 1;
  };
  return {(axis + 1) % 3,
          (axis + 2) % 3,
          first(-kHalfRoom),
          first(-kHalfRoom + 0.5),
          count(-kHalfRoom, kHalfRoom),
          count(-kHalfRoom + 0.5, kHalfRoom + 0.5)};
}

}  // namespace

LitResult light(formats::Bsp bsp, const compiler::LightOptions& options, int threads,
                compiler::LightCache* io_cache) {
  LitResult result;
  const auto entities = formats::read_entities(bsp.entities);
  const compiler::FaceKeys keys = compiler::face_keys_of(bsp, entities.value());
  base::Jobs jobs(threads, base::JobBackend::kStdThread);
  result.bsp = std::move(bsp);
  result.summary = compiler::light_level(
                       result.bsp, keys, options, jobs, [](std::size_t, std::size_t) { return true; },
                       result.warnings, io_cache)
                       .value();
  return result;
}

formats::Bsp room_with(const RoomSetup& setup) {
  formats::Bsp bsp = make_cube_room();
  bsp.visibility.clear();
  for (formats::BspLeaf& leaf : bsp.leafs) leaf.visibility_offset = -1;
  bsp.entities =
      with_double_quotes("{ 'classname' 'worldspawn' " + setup.world_keys + " }\n" + setup.entities);
  if (setup.sky) {
    formats::BspMiptex sky = bsp.miptexes[0];
    sky.name = "sky1";
    bsp.miptexes.push_back(sky);
    formats::BspTexinfo texinfo = bsp.texinfos[bsp.faces[4].texinfo];
    texinfo.miptex = static_cast<std::int32_t>(bsp.miptexes.size() - 1);
    bsp.faces[4].texinfo = static_cast<std::uint32_t>(bsp.texinfos.size());
    bsp.texinfos.push_back(texinfo);
  }
  return bsp;
}

std::vector<RoomLuxel> room_luxels(const LitResult& lit, std::uint8_t style, double margin) {
  std::vector<RoomLuxel> luxels;
  for (int wall = 0; wall < 6; ++wall) {
    const formats::BspFace& face = lit.bsp.faces[static_cast<std::size_t>(wall)];
    const WallGrid grid = grid_of(wall);
    const auto found = std::find(face.styles.begin(), face.styles.end(), style);
    const bool has_style = face.light_offset >= 0 && found != face.styles.end();
    const auto samples = static_cast<std::size_t>(grid.width * grid.height);
    const std::size_t first = has_style ? static_cast<std::size_t>(face.light_offset) +
                                              samples * static_cast<std::size_t>(found - face.styles.begin())
                                        : 0;
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0; column < grid.width; ++column) {
        RoomLuxel luxel;
        luxel.wall = wall;
        luxel.normal[wall / 2] = wall % 2 == 0 ? -1 : 1;
        luxel.place_world = luxel.normal * (1 - kHalfRoom);
        luxel.place_world[grid.s_axis] = grid.first_s + 16.0 * column;
        luxel.place_world[grid.t_axis] = grid.first_t + 16.0 * row - 0.5;
        if (std::abs(luxel.place_world[grid.s_axis]) > kHalfRoom - margin ||
            std::abs(luxel.place_world[grid.t_axis]) > kHalfRoom - margin)
          continue;
        if (has_style) {
          const std::size_t sample = first + static_cast<std::size_t>(row * grid.width + column);
          luxel.grey = lit.bsp.lighting.at(sample);
          for (std::size_t channel = 0; channel < 3; ++channel)
            luxel.rgb[channel] =
                lit.summary.coloured ? lit.summary.lit.samples.at(sample * 3 + channel) : luxel.grey;
        }
        luxels.push_back(luxel);
      }
  }
  return luxels;
}

}  // namespace temblor::test
