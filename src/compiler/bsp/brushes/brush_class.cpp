#include "compiler/bsp/brushes/brush_class.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/text.h"
#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

struct WorldClass {
  std::string_view classname;
  Fill solid;
  bool is_detail;
};
constexpr std::array<WorldClass, 7> kWorldClasses = {{
    {"worldspawn", Fill::kSolid, false},
    {"func_group", Fill::kSolid, false},
    {"func_detail", Fill::kDetail, true},
    {"func_detail_wall", Fill::kDetailWall, true},
    {"func_detail_fence", Fill::kFence, true},
    {"func_detail_illusionary", Fill::kIllusionary, true},
    {"func_illusionary_visblocker", Fill::kVisBlocker, false},
}};

std::int32_t whole_number_or(const formats::Entity& fields, std::string_view key, std::int32_t otherwise) {
  constexpr float kMost = 1 << 20;
  return static_cast<std::int32_t>(
      std::clamp(number_or(fields, key, static_cast<float>(otherwise)), -kMost, kMost));
}

}  // namespace

BrushClass brush_class_of(const formats::Entity& fields) {
  BrushClass of;
  of.chop_order = whole_number_or(fields, "chop_order", 0);
  of.is_seen_from_inside = number_or(fields, "mirrorinside", 0) > 0;
  of.keeps_inner_faces = number_or(fields, "noclipfaces", 0) > 0;
  if (const std::int32_t hulls = whole_number_or(fields, "hulls", 0); hulls > 0)
    of.hulls = static_cast<std::uint8_t>(hulls & kAllHulls);
  for (const WorldClass& known : kWorldClasses) {
    if (known.classname != fields.classname()) continue;
    of.is_world = true;
    of.solid = known.solid;
    of.is_detail = known.is_detail;
    of.is_seen_from_inside |= known.solid == Fill::kVisBlocker;
    return of;
  }
  // The game may move it to where somebody looks out of it.
  if (of.is_seen_from_inside || of.keeps_inner_faces) of.solid = Fill::kFence;
  return of;
}

Special special_of(std::string_view texture) {
  const std::string name = base::to_lower(texture);
  const auto begins = [&](std::string_view with) { return name.starts_with(with); };
  if (begins("*lava")) return Special::kLava;
  if (begins("*slime")) return Special::kSlime;
  if (begins("*")) return Special::kWater;
  if (begins("sky")) return Special::kSky;
  if (name == "clip") return Special::kClip;
  if (name == "hintskip") return Special::kHintSkip;
  if (begins("hint")) return Special::kHint;
  if (name == "origin") return Special::kOrigin;
  if (name == "skip" || name == "caulk" || name == "nodraw") return Special::kSkip;
  return Special::kNone;
}

Special special_of(const formats::MapBrush& brush) {
  Special found = Special::kNone;
  for (const formats::MapSide& side : brush.sides) {
    const Special special = special_of(side.texture);
    if (special == Special::kHint || special == Special::kOrigin) return special;
    if (found == Special::kNone && special != Special::kSkip && special != Special::kHintSkip)
      found = special;
  }
  return found;
}

bool is_liquid(Special special) {
  return special == Special::kWater || special == Special::kSlime || special == Special::kLava;
}

bool is_drawn(std::string_view texture) {
  const Special special = special_of(texture);
  if (is_liquid(special)) return !base::to_lower(texture).ends_with("skip");
  return special == Special::kNone || special == Special::kSky;
}

Fill fill_of(Special special, const BrushClass& of_class) {
  // Games ask the world alone what a place is filled with; a door that looks like water is a door.
  if (!of_class.is_world && special != Special::kHint) return of_class.solid;
  switch (special) {
    case Special::kWater:
      return Fill::kWater;
    case Special::kSlime:
      return Fill::kSlime;
    case Special::kLava:
      return Fill::kLava;
    case Special::kSky:
      return Fill::kSky;
    case Special::kHint:
      return Fill::kEmpty;
    default:
      return of_class.solid;
  }
}

std::uint8_t hulls_of(Special special, Fill fill) {
  const bool stops_boxes = is_blocked(fill) || fill == Fill::kSky;
  if (special == Special::kClip) return stops_boxes ? kAllHulls & ~kDrawnHull : 0;
  return stops_boxes ? kAllHulls : kDrawnHull;
}

}  // namespace temblor::compiler
