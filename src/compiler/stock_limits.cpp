#include "compiler/stock_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "base/text.h"
#include "compiler/bsp/brushes/level_entities.h"

namespace temblor::compiler {
namespace {

constexpr std::size_t kTextureHeaderBytes = 40;

std::size_t count_texture_bytes(const formats::BspMiptex& texture) {
  std::size_t bytes = kTextureHeaderBytes;
  for (const auto& level : texture.mips) bytes += level.size();
  return bytes;
}

std::string describe_entity(const formats::Map& map, std::size_t number) {
  const formats::MapEntity& entity = map.entities[number];
  return fmt::format("entity {} ({}), line {}", number, base::quotable(entity.fields.classname()),
                     entity.line);
}

// Finds the entity that adds most brushes to model 0, or the only entity of another model.
std::size_t find_entity(const LimitPlaces& places, std::size_t model) {
  const std::string name = model == 0 ? "" : fmt::format("*{}", model);
  std::size_t found = 0, most_brushes = 0, next = 0;
  for (std::size_t i = 0; i < places.map.entities.size(); ++i) {
    const formats::MapEntity& entity = places.map.entities[i];
    if (is_point_entity(entity)) continue;
    if (next == places.brush_entities.size()) break;
    if (places.brush_entities[next++].model != name || entity.brushes.size() <= most_brushes) continue;
    found = i;
    most_brushes = entity.brushes.size();
  }
  return found;
}

// "entity 3 (func_wall), line 88, is the first beyond it".
std::string describe_model(const LimitPlaces& places, std::size_t model) {
  const std::size_t entity = find_entity(places, model);
  if (model > 0) return fmt::format("{}, is the first beyond it", describe_entity(places.map, entity));
  return fmt::format("of the world, {}, adds most: {} brushes", describe_entity(places.map, entity),
                     places.map.entities[entity].brushes.size());
}

void warn(const PartCount& part, std::string place, Warnings& io_warnings) {
  io_warnings.push_back(
      {fmt::format("{} {} exceed the original engine's limit of {}", part.count, part.what, part.limit),
       std::move(place)});
}

// The largest texture, and the first side that has it.
std::string describe_largest_texture(const formats::Map& map, const formats::Bsp& bsp) {
  const auto largest = std::ranges::max_element(bsp.miptexes, {}, count_texture_bytes);
  if (largest == bsp.miptexes.end()) return "";
  std::string place = fmt::format("\"{}\" is the largest, {} bytes", base::quotable(largest->name),
                                  count_texture_bytes(*largest));
  const std::string name = base::to_lower(largest->name);
  for (std::size_t i = 0; i < map.entities.size(); ++i)
    for (const formats::MapBrush& brush : map.entities[i].brushes)
      for (const formats::MapSide& side : brush.sides)
        if (base::to_lower(side.texture) == name)
          return place + fmt::format(", first on line {} (entity {})", side.line, i);
  return place;
}

// Names the longest of the entities that are in the level. Groups of the world are not.
std::string describe_longest_entity(const LimitPlaces& places) {
  std::size_t count = 0, longest = 0, most_letters = 0, next = 0;
  for (std::size_t i = 0; i < places.map.entities.size(); ++i) {
    const formats::MapEntity& entity = places.map.entities[i];
    if (!is_point_entity(entity) &&
        (next == places.brush_entities.size() || !places.brush_entities[next++].is_in_level))
      continue;
    ++count;
    std::size_t letters = 0;
    for (const auto& [key, value] : entity.fields.pairs)
      if (!is_editor_key(key)) letters += key.size() + value.size();
    if (letters <= most_letters) continue;
    most_letters = letters;
    longest = i;
  }
  if (count == 0) return "";
  return fmt::format("{} entities; the longest is {}", count, describe_entity(places.map, longest));
}

std::string describe_model_with_most_faces(const LimitPlaces& places, const formats::Bsp& bsp) {
  const auto most = std::ranges::max_element(bsp.models, {}, &formats::BspModel::face_count);
  if (most == bsp.models.end()) return "";
  const std::size_t entity = find_entity(places, static_cast<std::size_t>(most - bsp.models.begin()));
  return fmt::format("{}, has most faces: {}", describe_entity(places.map, entity), most->face_count);
}

// Positions of the original network protocol end there.
constexpr float kStockReach = 4096;

// Warns if the level is larger than the original protocol, and names its farthest corner.
void warn_about_reach(const formats::Bsp& bsp, Warnings& io_warnings) {
  const auto find_reach = [](const math::Vec3& vertex) {
    return std::max({std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
  };
  const auto farthest = std::ranges::max_element(bsp.vertices, {}, find_reach);
  if (farthest == bsp.vertices.end() || find_reach(*farthest) <= kStockReach) return;
  warn({"units from the origin", static_cast<std::size_t>(find_reach(*farthest)),
        static_cast<std::size_t>(kStockReach)},
       fmt::format("a corner at {:.0f} {:.0f} {:.0f}", farthest->x, farthest->y, farthest->z), io_warnings);
}

// In the order of count_bytes().
enum ByteKind : std::size_t { kTextures, kEntities, kVisibility, kLight };

}  // namespace

std::vector<PartCount> count_records(const formats::Bsp& bsp) {
  return {{"planes", bsp.planes.size(), 32767}, {"vertices", bsp.vertices.size(), 65535},
          {"nodes", bsp.nodes.size(), 32767},   {"texinfos", bsp.texinfos.size(), 4096},
          {"faces", bsp.faces.size(), 65535},   {"clipnodes", bsp.clipnodes.size(), 32767},
          {"leaves", bsp.leaves.size(), 8192},  {"marksurfaces", bsp.marksurfaces.size(), 65535},
          {"edges", bsp.edges.size(), 256000},  {"surfedges", bsp.surfedges.size(), 512000},
          {"models", bsp.models.size(), 256},   {"textures", bsp.miptexes.size(), 512}};
}

std::vector<PartCount> count_bytes(const formats::Bsp& bsp) {
  std::size_t texture_bytes = 0;
  for (const formats::BspMiptex& texture : bsp.miptexes) texture_bytes += count_texture_bytes(texture);
  return {{"bytes of textures", texture_bytes, 0x200000},
          {"bytes of entity text", bsp.entities.size(), 65536},
          {"bytes of visibility", bsp.visibility.size(), 0x100000},
          {"bytes of light", bsp.lighting.size(), 0x100000}};
}

std::vector<PartCount> count_parts(const formats::Bsp& bsp) {
  std::vector<PartCount> parts = count_records(bsp);
  std::ranges::move(count_bytes(bsp), std::back_inserter(parts));
  return parts;
}

void warn_about_records(const LimitPlaces& places, const formats::Bsp& bsp,
                        std::span<const std::vector<PartCount>> after_model, Warnings& io_warnings) {
  const std::vector<PartCount> whole = count_records(bsp);
  for (std::size_t kind = 0; kind < whole.size(); ++kind) {
    if (!whole[kind].is_exceeded()) continue;
    const auto first = std::ranges::find_if(
        after_model, [&](const std::vector<PartCount>& counts) { return counts[kind].is_exceeded(); });
    const std::ptrdiff_t model = first == after_model.end() ? 0 : first - after_model.begin();
    warn(whole[kind], describe_model(places, static_cast<std::size_t>(model)), io_warnings);
  }
  warn_about_reach(bsp, io_warnings);
}

void warn_about_bytes(const LimitPlaces& places, const formats::Bsp& bsp, Warnings& io_warnings) {
  const std::vector<PartCount> parts = count_bytes(bsp);
  if (parts[kTextures].is_exceeded())
    warn(parts[kTextures], describe_largest_texture(places.map, bsp), io_warnings);
  if (parts[kEntities].is_exceeded()) warn(parts[kEntities], describe_longest_entity(places), io_warnings);
  if (parts[kVisibility].is_exceeded()) warn(parts[kVisibility], describe_model(places, 0), io_warnings);
  if (parts[kLight].is_exceeded())
    warn(parts[kLight], describe_model_with_most_faces(places, bsp), io_warnings);
}

}  // namespace temblor::compiler
