#include "artgen/level_script/keywords.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::artgen {
namespace {

// Keys that entities of many classes have. They have the same names in scripts and in levels.
constexpr std::array<std::string_view, 22> kSharedKeys = {
    "target", "killtarget", "message", "delay", "wait",      "speed",   "sounds", "dmg",
    "health", "lip",        "count",   "style", "noise",     "map",     "light",  "angles",
    "cnt",    "team",       "height",  "event", "worldtype", "material"};

// The spawnflags of stock Quake that remove an entity from a skill or from deathmatch.
constexpr std::array<std::pair<std::string_view, int>, 3> kSkills = {
    {{"easy", 256}, {"normal", 512}, {"hard", 1024}}};
constexpr int kNotInDeathmatch = 2048;

// skill= lists the skills that have the entity; the flags name those that do not.
int read_skill_flags(LevelScriptLine& line) {
  if (!line.has("skill")) return 0;
  std::string rest = line.text("skill", "");
  int flags = 256 | 512 | 1024;
  while (!rest.empty()) {
    const std::string name = rest.substr(0, rest.find(','));
    rest.erase(0, std::min(name.size() + 1, rest.size()));
    const auto* known =
        std::find_if(kSkills.begin(), kSkills.end(), [&](const auto& skill) { return skill.first == name; });
    if (known == kSkills.end())
      line.set_error(fmt::format("skill={} is not one of easy, normal, hard", base::quotable(name)));
    else
      flags &= ~known->second;
  }
  return flags;
}

int read_deathmatch_flag(LevelScriptLine& line) {
  const std::string in_deathmatch = line.text("dm", "yes");
  if (in_deathmatch != "yes" && in_deathmatch != "no") line.set_error("dm= must be yes or no");
  return in_deathmatch == "no" ? kNotInDeathmatch : 0;
}

// The class for as=; empty for the world and for unknown words.
std::string_view find_solid_class(std::string_view as) {
  if (as == "detail") return "func_detail";
  if (as == "fence") return "func_detail_fence";
  if (as == "ghost") return "func_detail_illusionary";
  if (as == "wall") return "func_wall";
  return "";
}

// By the texture's name: "{" marks textures with holes, "*" liquids.
std::string choose_default_kind(std::string_view texture, std::string_view fallback) {
  if (texture.starts_with('{')) return "fence";
  if (texture.starts_with('*')) return "world";
  return std::string(fallback);
}

// Settings that begin with an underscore have the same name as keys for the level compiler.
void copy_compiler_keys(LevelScriptLine& line, formats::Entity& io_entity) {
  for (const auto& [key, value] : line.line().settings)
    if (key.starts_with('_')) set_key(io_entity, key, line.text(key, ""));
}

}  // namespace

base::Status read_lines(const std::vector<ScriptLine>& lines, const Scope& scope, LevelScript& io_script) {
  for (const ScriptLine& line : lines) {
    const LevelKeyword* known = nullptr;
    for (const std::span<const LevelKeyword> family :
         {space_keywords(), solid_keywords(), rock_keywords(), mover_keywords(), entity_keywords()})
      for (const LevelKeyword& word : family)
        if (word.name == line.keyword) known = &word;
    if (known == nullptr) return script_error(line, "unknown level script keyword");
    TRY_STATUS(known->read(line, scope, io_script));
  }
  return base::Ok{};
}

Solid make_solid(const LevelScriptLine& line, std::vector<Point> corners, const Looks& looks) {
  for (Point& corner : corners) corner = line.scope().placement.apply(corner);
  return {std::move(corners), looks, line.line().number};
}

Solid make_solid(const LevelScriptLine& line, const Box& box, const Looks& looks) {
  return make_solid(line, list_corners(box), looks);
}

void add_solids(LevelScriptLine& line, std::vector<Solid> solids, std::string_view fallback,
                LevelScript& io_script) {
  if (solids.empty()) return;
  const std::string texture = solids.front().looks[side_index(Side::kUp)].texture;
  const std::string as = line.text("as", choose_default_kind(texture, fallback));
  formats::Entity fields;
  const std::string_view classname = find_solid_class(as);
  if (classname.empty() && as != "world") line.set_error("as= must be world, detail, fence, ghost or wall");
  set_key(fields, "classname", classname.empty() ? "func_group" : classname);
  copy_compiler_keys(line, fields);
  if (as == "world" && fields.pairs.size() == 1) {
    for (Solid& solid : solids) io_script.structure.push_back(std::move(solid));
    return;
  }
  if (as == "wall") return add_brush_entity(make_entity(line, "func_wall"), std::move(solids), io_script);
  // Solids with the same keys share one entity, so that the map does not contain thousands of them.
  const auto same = std::find_if(io_script.brush_entities.begin(), io_script.brush_entities.end(),
                                 [&](const BrushEntity& body) { return body.fields == fields; });
  if (same == io_script.brush_entities.end())
    return add_brush_entity(std::move(fields), std::move(solids), io_script);
  for (Solid& solid : solids) same->solids.push_back(std::move(solid));
}

formats::Entity make_entity(LevelScriptLine& line, std::string_view classname, int flags) {
  formats::Entity entity;
  set_key(entity, "classname", classname);
  if (line.has("name")) set_key(entity, "targetname", line.text("name", ""));
  for (const std::string_view key : kSharedKeys)
    if (line.has(key)) set_key(entity, key, line.text(key, ""));
  copy_compiler_keys(line, entity);
  flags |= read_skill_flags(line) | read_deathmatch_flag(line);
  flags |= line.integer("flags", 0, 0, 255);
  if (flags != 0) set_key(entity, "spawnflags", flags);
  return entity;
}

void set_key(formats::Entity& io_entity, std::string_view key, std::string_view value) {
  for (auto& [known, old] : io_entity.pairs)
    if (known == key) {
      old = value;
      return;
    }
  io_entity.pairs.emplace_back(key, value);
}

void set_key(formats::Entity& io_entity, std::string_view key, Point position) {
  set_key(io_entity, key, fmt::format("{} {} {}", position.x, position.y, position.z));
}

void set_key(formats::Entity& io_entity, std::string_view key, double value) {
  set_key(io_entity, key, std::string_view(fmt::format("{}", value)));
}

void add_brush_entity(formats::Entity fields, std::vector<Solid> solids, LevelScript& io_script) {
  io_script.brush_entities.push_back({std::move(fields), std::move(solids)});
}

double find_move_angle(const LevelScriptLine& line, Side direction) {
  switch (line.scope().placement.apply(direction)) {
    case Side::kEast:
      // 0 would mean that the key is missing.
      return 360;
    case Side::kNorth:
      return 90;
    case Side::kWest:
      return 180;
    case Side::kSouth:
      return 270;
    case Side::kUp:
      return -1;
    case Side::kDown:
      return -2;
  }
  return 0;
}

}  // namespace temblor::artgen
