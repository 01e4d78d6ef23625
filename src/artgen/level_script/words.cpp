#include "artgen/level_script/words.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace temblor::artgen {
namespace {

// What entities of many classes have, under the names that levels use.
constexpr std::array<std::string_view, 22> kSharedKeys = {
    "target", "killtarget", "message", "delay", "wait",      "speed",   "sounds", "dmg",
    "health", "lip",        "count",   "style", "noise",     "map",     "light",  "angles",
    "cnt",    "team",       "height",  "event", "worldtype", "material"};

constexpr std::array<std::pair<std::string_view, int>, 3> kSkills = {
    {{"easy", 256}, {"normal", 512}, {"hard", 1024}}};
constexpr int kNotInDeathmatch = 2048;

int skill_flags(PlanLine& line) {
  if (!line.has("skill")) return 0;
  std::string rest = line.text("skill", "");
  int flags = 256 | 512 | 1024;
  while (!rest.empty()) {
    const std::string name = rest.substr(0, rest.find(','));
    rest.erase(0, std::min(name.size() + 1, rest.size()));
    const auto* known =
        std::find_if(kSkills.begin(), kSkills.end(), [&](const auto& skill) { return skill.first == name; });
    if (known == kSkills.end())
      line.complain(fmt::format("skill={} is none of easy, normal, hard", base::quotable(name)));
    else
      flags &= ~known->second;
  }
  return flags;
}

int deathmatch_flags(PlanLine& line) {
  const std::string in_deathmatch = line.text("dm", "yes");
  if (in_deathmatch != "yes" && in_deathmatch != "no") line.complain("dm= is yes or no");
  return in_deathmatch == "no" ? kNotInDeathmatch : 0;
}

std::string_view classname_as(std::string_view as) {
  if (as == "detail") return "func_detail";
  if (as == "fence") return "func_detail_fence";
  if (as == "ghost") return "func_detail_illusionary";
  if (as == "wall") return "func_wall";
  return "";
}

std::string as_unless_said(std::string_view texture, std::string_view otherwise) {
  if (texture.starts_with('{')) return "fence";
  if (texture.starts_with('*')) return "world";
  return std::string(otherwise);
}

// Keys of the compiler, which begin with an underscore in the line as in the level.
void take_compiler_keys(PlanLine& line, formats::Entity& io_entity) {
  for (const auto& [key, value] : line.line().settings)
    if (key.starts_with('_')) set_key(io_entity, key, line.text(key, ""));
}

}  // namespace

base::Status read_lines(const std::vector<ScriptLine>& lines, const Scope& scope, Plan& io_plan) {
  for (const ScriptLine& line : lines) {
    const PlanWord* known = nullptr;
    for (const std::span<const PlanWord> family :
         {space_words(), solid_words(), rock_words(), mover_words(), thing_words()})
      for (const PlanWord& word : family)
        if (word.name == line.word) known = &word;
    if (known == nullptr) return script_error(line, "plans have no such word");
    TRY_STATUS(known->read(line, scope, io_plan));
  }
  return base::Ok{};
}

Solid solid_of(const PlanLine& line, std::vector<Point> corners, const Looks& looks) {
  for (Point& corner : corners) corner = line.scope().placement.apply(corner);
  return {std::move(corners), looks, line.line().number};
}

Solid solid_of(const PlanLine& line, const Box& box, const Looks& looks) {
  return solid_of(line, corners_of(box), looks);
}

void put_solids(PlanLine& line, std::vector<Solid> solids, std::string_view otherwise, Plan& io_plan) {
  if (solids.empty()) return;
  const std::string texture = solids.front().looks[index_of(Side::kUp)].texture;
  const std::string as = line.text("as", as_unless_said(texture, otherwise));
  formats::Entity fields;
  const std::string_view classname = classname_as(as);
  if (classname.empty() && as != "world") line.complain("as= is world, detail, fence, ghost or wall");
  set_key(fields, "classname", classname.empty() ? "func_group" : classname);
  take_compiler_keys(line, fields);
  if (as == "world" && fields.pairs.size() == 1) {
    for (Solid& solid : solids) io_plan.structure.push_back(std::move(solid));
    return;
  }
  if (as == "wall") return put_body(entity_of(line, "func_wall"), std::move(solids), io_plan);
  // One body for all that are alike: thousands of entities would say the same.
  const auto same = std::find_if(io_plan.bodies.begin(), io_plan.bodies.end(),
                                 [&](const Body& body) { return body.fields == fields; });
  if (same == io_plan.bodies.end()) return put_body(std::move(fields), std::move(solids), io_plan);
  for (Solid& solid : solids) same->solids.push_back(std::move(solid));
}

formats::Entity entity_of(PlanLine& line, std::string_view classname, int flags) {
  formats::Entity entity;
  set_key(entity, "classname", classname);
  if (line.has("name")) set_key(entity, "targetname", line.text("name", ""));
  for (const std::string_view key : kSharedKeys)
    if (line.has(key)) set_key(entity, key, line.text(key, ""));
  take_compiler_keys(line, entity);
  flags |= skill_flags(line) | deathmatch_flags(line);
  flags |= line.whole("flags", 0, 0, 255);
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

void set_key(formats::Entity& io_entity, std::string_view key, Point place) {
  set_key(io_entity, key, fmt::format("{} {} {}", place.x, place.y, place.z));
}

void set_key(formats::Entity& io_entity, std::string_view key, double value) {
  set_key(io_entity, key, std::string_view(fmt::format("{}", value)));
}

void put_body(formats::Entity fields, std::vector<Solid> solids, Plan& io_plan) {
  io_plan.bodies.push_back({std::move(fields), std::move(solids)});
}

double move_angle(const PlanLine& line, Side way) {
  switch (line.scope().placement.apply(way)) {
    case Side::kEast:
      return 360;  // 0 would be no angle at all
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
