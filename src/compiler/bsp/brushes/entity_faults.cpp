#include "compiler/bsp/brushes/entity_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "base/nearest_name.h"
#include "base/text.h"
#include "compiler/bsp/brushes/key_names.h"
#include "compiler/bsp/brushes/level_entities.h"
#include "compiler/light/sources/entity_lights.h"

namespace temblor::compiler {
namespace {

// Classes that the game makes of brushes alone. Those that many mods also use as points (trigger_counter,
// trigger_relay) are not in the list.
constexpr std::string_view kBrushOnlyClasses[] = {
    "func_bossgate",       "func_button",      "func_door",
    "func_door_secret",    "func_episodegate", "func_illusionary",
    "func_plat",           "func_train",       "func_wall",
    "trigger_changelevel", "trigger_hurt",     "trigger_monsterjump",
    "trigger_multiple",    "trigger_once",     "trigger_onlyregistered",
    "trigger_push",        "trigger_secret",   "trigger_setskill",
    "trigger_teleport",
};

// Whether a light has the name, or a switchable shadow shares the style of such lights.
bool has_switch_named(const formats::Map& map, std::string_view name) {
  return std::ranges::any_of(map.entities, [&](const formats::MapEntity& entity) {
    const formats::Entity& fields = entity.fields;
    return (is_light(fields) && fields.find("targetname") == name) ||
           fields.find("_switchableshadow_target") == name;
  });
}

class FaultFinder {
 public:
  FaultFinder(const formats::Map& map, std::size_t number, Warnings& io_warnings)
      : map_(map), entity_(map.entities[number]), number_(number), warnings_(io_warnings) {}

  void find() {
    const std::string_view of_class = entity_.fields.classname();
    if (of_class.empty()) warn("entity without a class name", "the game removes it: add a \"classname\" key");
    const bool has_brushes = !entity_.brushes.empty() || entity_.fields.find("model");
    if (!has_brushes && std::ranges::find(kBrushOnlyClasses, of_class) != std::end(kBrushOnlyClasses))
      warn("brush entity without brushes", "the game needs brushes of it: draw them, or remove the entity");
    for (const auto& [key, value] : entity_.fields.pairs) {
      if (is_editor_key(key)) continue;
      constexpr std::size_t kMaxChars = 4096;
      if (value.size() > kMaxChars)
        warn("value too long", fmt::format("{} has {} characters; engines read 1,023 to {}: shorten it",
                                           base::quotable(key), value.size(), "4,096"));
      if (key.starts_with('_')) check_name(key);
    }
    const std::string_view lights = entity_.fields.find("_surflight_targetname").value_or("");
    if (!lights.empty() && !has_switch_named(map_, lights))
      warn("surface lights with a missing light",
           fmt::format("no light has the targetname {}, so _surflight_targetname is ignored",
                       base::quotable(lights)));
  }

 private:
  // The game ignores keys that begin with an underscore, so only compilers and engines can mean them.
  void check_name(const std::string& key) {
    const std::string name = base::to_lower(std::string_view(key).substr(1));
    const auto known = known_key_names();
    if (std::ranges::binary_search(known, std::string_view(name))) return;
    const auto nearest = base::find_nearest_name(name, known);
    warn("unknown key", fmt::format("{} is ignored{}", base::quotable(key),
                                    nearest ? fmt::format("; did you mean _{}?", *nearest) : ""));
  }

  void warn(const char* kind, std::string_view what) {
    const std::string_view of_class = entity_.fields.classname();
    warnings_.push_back(
        {kind, fmt::format("entity {} ({}), line {}: {}", number_,
                           of_class.empty() ? "no class" : base::quotable(of_class), entity_.line, what)});
  }

  const formats::Map& map_;
  const formats::MapEntity& entity_;
  std::size_t number_;
  Warnings& warnings_;
};

}  // namespace

base::Status check_worldspawn(const formats::Map& map) {
  if (map.entities.empty())
    return base::malformed("line 1: the file has no entities; a map begins with an entity worldspawn");
  const formats::MapEntity& first = map.entities.front();
  if (first.fields.classname() == "worldspawn") return base::Ok{};
  const auto world = std::ranges::find_if(map.entities, [](const formats::MapEntity& entity) {
    return entity.fields.classname() == "worldspawn";
  });
  const std::string advice = world == map.entities.end()
                                 ? "there is none"
                                 : fmt::format("move it from line {} to the top", world->line);
  return base::malformed(
      "line {}: the first entity ({}) is not worldspawn; {}", first.line,
      first.fields.classname().empty() ? "no class" : base::quotable(first.fields.classname()), advice);
}

void warn_about_entity_faults(const formats::Map& map, Warnings& io_warnings) {
  for (std::size_t i = 0; i < map.entities.size(); ++i) FaultFinder(map, i, io_warnings).find();
}

}  // namespace temblor::compiler
