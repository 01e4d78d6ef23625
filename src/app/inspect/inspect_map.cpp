// Maps (.map), the source text of levels that editors write.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/levels/map.h"

namespace temblor::app {
namespace {

const char* alignment_name(formats::MapAlignment alignment) {
  switch (alignment) {
    case formats::MapAlignment::kStandard:
      return "standard";
    case formats::MapAlignment::kValve:
      return "Valve 220";
    case formats::MapAlignment::kBrushPrimitive:
      break;
  }
  return "brush primitives";
}

// Checks that worldspawn comes first, that there is a start, and that every brush has enough sides to be
// closed. Only the compiler finds geometric faults.
Inspection find_problems(const formats::Map& map) {
  Inspection problems = Inspection::array();
  if (map.entities.empty() || map.entities.front().fields.classname() != "worldspawn")
    problems.push_back("the first entity is not worldspawn");
  const auto is_start = [](const formats::MapEntity& entity) {
    return entity.fields.classname() == "info_player_start";
  };
  if (std::none_of(map.entities.begin(), map.entities.end(), is_start))
    problems.push_back("no info_player_start");
  constexpr std::size_t kMinSides = 4;
  for (std::size_t i = 0; i < map.entities.size(); ++i)
    for (std::size_t k = 0; k < map.entities[i].brushes.size(); ++k)
      if (const formats::MapBrush& brush = map.entities[i].brushes[k]; brush.sides.size() < kMinSides)
        problems.push_back(
            fmt::format("entity {}, brush {}, line {}: has {} sides, but a brush needs at least 4", i, k,
                        brush.line, brush.sides.size()));
  return problems;
}

}  // namespace

// Reads only this file. Prefabs and textures are not searched.
base::Result<Inspection> inspect_map(base::Bytes bytes) {
  TRY(const formats::Map map, formats::read_map(base::as_text(bytes)));
  std::map<std::string, std::size_t> classes, alignments;
  std::set<std::string> textures;
  std::size_t brushes = 0, sides = 0;
  for (const formats::MapEntity& entity : map.entities) {
    const std::string_view name = entity.fields.classname();
    ++classes[name.empty() ? "(no classname)" : std::string(name)];
    brushes += entity.brushes.size();
    for (const formats::MapBrush& brush : entity.brushes)
      for (const formats::MapSide& side : brush.sides) {
        ++sides;
        ++alignments[alignment_name(side.texturing.alignment)];
        textures.insert(base::to_lower(side.texture));
      }
  }
  return Inspection{{"counts",
                     {{"entities", map.entities.size()},
                      {"brushes", brushes},
                      {"sides", sides},
                      {"textures", textures.size()}}},
                    {"texture alignment, by sides", alignments},
                    {"classes", classes},
                    {"problems", find_problems(map)}};
}

}  // namespace temblor::app
