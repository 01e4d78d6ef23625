#include "server/game/spawn_entities.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "server/game/field_text.h"
#include "server/game/half_life/brush_entities.h"
#include "world/entity_opacity.h"

namespace temblor::server {
namespace {

// Keys for map compilers or clients. Game code does not need a field for them.
bool is_for_others(std::string_view key) {
  constexpr std::array<std::string_view, 10> kKeys = {"wad",        "mapversion", "fog",        "sky",
                                                      "skyname",    "skybox",     "wateralpha", "lavaalpha",
                                                      "slimealpha", "telealpha"};
  return key.empty() || key.front() == '_' || key.starts_with("//") ||
         std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

// Some editors write blanks after a key.
std::string_view without_trailing_blanks(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// Collects notes, each text once.
class Notes {
 public:
  void add(std::string note) {
    if (known_.insert(note).second) notes_.push_back(std::move(note));
  }
  std::vector<std::string> take() && { return std::move(notes_); }

 private:
  std::set<std::string, std::less<>> known_;
  std::vector<std::string> notes_;
};

// Two keys are not fields, as in the original: "angle" is the yaw of "angles", and "light" is "light_lev".
// Values that the program does not understand are noted, so that one bad key does not stop the level.
base::Status set_key(vm::Machine& io_machine, const Edict& edict, std::string_view key, std::string value,
                     Notes& io_notes) {
  key = without_trailing_blanks(key);
  if (key == "angle") {
    key = "angles";
    value = fmt::format("0 {} 0", value);
  } else if (key == "light") {
    key = "light_lev";
  }
  const formats::ProgsDefinition* field = io_machine.program().find_field(key);
  if (!field) {
    if (is_for_others(key)) return base::Ok{};
    io_notes.add(fmt::format("\"{}\" is not a field of this program", key));
    return base::Ok{};
  }
  const base::Status set = set_value(io_machine, *field, value, edict.words().subspan(field->offset));
  if (!set.ok() && set.error().code != base::ErrorCode::kUsage) return set;
  if (!set.ok()) io_notes.add(fmt::format("key \"{}\": {}", key, set.error().what));
  return base::Ok{};
}

base::Status set_keys(vm::Machine& io_machine, const Edict& edict, const formats::Entity& entity,
                      Notes& io_notes) {
  for (const auto& [key, value] : entity.pairs) TRY_STATUS(set_key(io_machine, edict, key, value, io_notes));
  return base::Ok{};
}

std::string describe_unknown_class(std::string_view class_name, std::size_t number,
                                   const math::Vec3& origin) {
  const std::string what =
      class_name.empty() ? "it has no classname, and is left out"
                         : fmt::format("there is no function \"{}\" to spawn such entities", class_name);
  return fmt::format("entity {} at {:g} {:g} {:g}: {}", number, origin.x, origin.y, origin.z, what);
}

// Half-Life has no skills in its spawnflags: doors and triggers use those bits for other things.
bool is_left_out(int spawn_flags, const world::SpawnRules& rules, bool is_half_life) {
  return (!is_half_life || rules.deathmatch) && world::is_excluded(spawn_flags, rules);
}

}  // namespace

// The first entity is the world, which is never excluded, and is spawned like the others.
base::Result<SpawnReport> spawn_entities(GameWorld& io_world, vm::Machine& io_machine,
                                         std::span<const formats::Entity> entities,
                                         const world::SpawnRules& rules,
                                         base::FunctionRef<void()> after_each) {
  SpawnReport report;
  Notes notes;
  std::set<std::string, std::less<>> reported_classes;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    vm::EntityIndex index = vm::kWorld;
    if (i > 0) {
      TRY(index, io_world.edicts.spawn(io_world.time_s));
    }
    if (const base::Status set = set_keys(io_machine, io_world.edicts[index], entities[i], notes); !set.ok())
      return base::error(set.error().code, "{}: entity {}: {}", io_world.level->name, i, set.error().what);
    const Edict edict = io_world.edicts[index];
    const bool is_half_life = io_world.level->is_half_life;
    // In the field, 0 is the default, and numbers below 0 are invisible.
    if (const auto opacity = is_half_life ? world::find_half_life_opacity(entities[i]) : std::nullopt)
      TRY_STATUS(
          set_key(io_machine, edict, "alpha", *opacity == 0 ? "-1" : fmt::format("{}", *opacity), notes));
    if (i > 0 && is_left_out(edict.whole(field::kSpawnFlags), rules, is_half_life)) {
      remove(io_world, index);
      ++report.filtered;
      continue;
    }
    const std::string class_name(io_machine.text(edict[field::kClassName]));
    const vm::FunctionIndex spawn = io_machine.program().find_function(class_name);
    if (spawn == vm::kNoFunction && i > 0 && is_half_life) {
      TRY(const bool is_shown, show_half_life_entity(io_world, entities[i], index));
      if (is_shown) {
        ++report.spawned;
        continue;
      }
    }
    if (spawn == vm::kNoFunction) {
      if (reported_classes.insert(class_name).second)
        report.unknown_classes.push_back(describe_unknown_class(class_name, i, edict[field::kOrigin]));
      if (i > 0) remove(io_world, index);
      continue;
    }
    TRY_STATUS(io_world.calls.call(spawn, index, vm::kWorld, io_world.time_s));
    ++report.spawned;
    after_each();
  }
  report.notes = std::move(notes).take();
  return report;
}

}  // namespace temblor::server
