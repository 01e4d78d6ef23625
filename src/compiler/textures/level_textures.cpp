#include "compiler/textures/level_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "base/text.h"
#include "compiler/bsp/brushes/brush_class.h"
#include "compiler/bsp/brushes/region.h"
#include "compiler/textures/texture_sources.h"

namespace temblor::compiler {
namespace {

// The common part of the names of an animation's frames: "lava" for "+0lava" and "+1lava".
std::string find_sequence_name(std::string_view name) {
  return name.size() > 2 && name.front() == '+' ? base::to_lower(name.substr(2)) : std::string{};
}

// Calls `visit(entity number, brush number, side)` for every side that is drawn.
template <typename Visit>
void visit_drawn_sides(const formats::Map& map, const Visit& visit) {
  for (std::size_t entity = 0; entity < map.entities.size(); ++entity) {
    const std::vector<formats::MapBrush>& brushes = map.entities[entity].brushes;
    for (std::size_t brush = 0; brush < brushes.size(); ++brush) {
      if (is_region_brush(brushes[brush])) continue;
      for (const formats::MapSide& side : brushes[brush].sides)
        if (is_drawn(side.texture)) visit(entity, brush, side);
    }
  }
}

// The sides with a texture that no source has.
struct MissingTexture {
  std::size_t faces = 0;
  std::string first_place;
};

}  // namespace

std::vector<std::string_view> find_texture_names(const formats::Map& map) {
  std::vector<std::string_view> names;
  visit_drawn_sides(map, [&](std::size_t, std::size_t, const formats::MapSide& side) {
    if (names.empty() || names.back() != side.texture) names.push_back(side.texture);
  });
  return names;
}

void warn_about_missing_textures(const formats::Map& map, const TextureSet& set, std::size_t source_count,
                                 Warnings& io_warnings) {
  std::map<std::string, MissingTexture> missing;
  for (const std::string& name : set.missing) missing.try_emplace(texture_key(name));
  visit_drawn_sides(map, [&](std::size_t entity, std::size_t brush, const formats::MapSide& side) {
    const auto found = missing.find(texture_key(side.texture));
    if (found != missing.end() && found->second.faces++ == 0)
      found->second.first_place = fmt::format("entity {}, brush {}, line {}", entity, brush, side.line);
  });
  for (const std::string& name : set.missing) {
    const MissingTexture& texture = missing.at(texture_key(name));
    io_warnings.push_back(
        {"texture not found", fmt::format("\"{}\" on {}, the first on {} (searched {})", base::quotable(name),
                                          base::counted(texture.faces, "face"), texture.first_place,
                                          base::counted(source_count, "source"))});
  }
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
