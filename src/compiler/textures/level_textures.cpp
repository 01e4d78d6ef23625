#include "compiler/textures/level_textures.h"

#include <algorithm>
#include <optional>
#include <string>

#include "base/text.h"
#include "compiler/bsp/brushes/brush_class.h"
#include "compiler/bsp/brushes/region.h"

namespace temblor::compiler {
namespace {

// The common part of the names of an animation's frames: "lava" for "+0lava" and "+1lava".
std::string find_sequence_name(std::string_view name) {
  return name.size() > 2 && name.front() == '+' ? base::to_lower(name.substr(2)) : std::string{};
}

}  // namespace

std::vector<std::string_view> find_texture_names(const formats::Map& map) {
  std::vector<std::string_view> names;
  for (const formats::MapEntity& entity : map.entities)
    for (const formats::MapBrush& brush : entity.brushes) {
      if (is_region_brush(brush)) continue;
      for (const formats::MapSide& side : brush.sides)
        if (is_drawn(side.texture) && (names.empty() || names.back() != side.texture))
          names.push_back(side.texture);
    }
  return names;
}

math::Vec2d find_texture_size(const TextureSet& set, std::string_view name) {
  const std::optional<std::uint32_t> found = set.find(name);
  if (!found) return {64, 64};
  const formats::BspMiptex& texture = set.miptexes[*found];
  return {texture.width, texture.height};
}

void set_textures(const TextureSet& set, std::size_t own_textures, formats::Bsp& io_bsp) {
  io_bsp.miptexes.resize(own_textures);
  std::vector<std::string> sequences;
  std::vector<bool> taken(set.miptexes.size(), false);
  for (formats::BspMiptex& texture : io_bsp.miptexes) {
    const std::optional<std::uint32_t> found = set.find(texture.name);
    if (const std::string sequence = find_sequence_name(texture.name); !sequence.empty())
      sequences.push_back(sequence);
    if (!found) continue;
    taken[*found] = true;
    texture = set.miptexes[*found];
  }
  for (std::size_t i = 0; i < set.miptexes.size(); ++i) {
    const std::string sequence = find_sequence_name(set.miptexes[i].name);
    if (taken[i] || sequence.empty()) continue;
    if (std::find(sequences.begin(), sequences.end(), sequence) != sequences.end())
      io_bsp.miptexes.push_back(set.miptexes[i]);
  }
}

}  // namespace temblor::compiler
