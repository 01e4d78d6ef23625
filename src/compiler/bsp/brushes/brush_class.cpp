#include "compiler/bsp/brushes/brush_class.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/text.h"
#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

// The classes whose brushes become part of the world.
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

// Clamped, so that any text converts without overflow.
std::int32_t whole_number_or(const formats::Entity& fields, std::string_view key, std::int32_t otherwise) {
  constexpr float kMaxValue = 1 << 20;
  return static_cast<std::int32_t>(
      std::clamp(read_number_or(fields, key, static_cast<float>(otherwise)), -kMaxValue, kMaxValue));
}

}  // namespace

BrushClass find_brush_class(const formats::Entity& fields) {
  BrushClass found;
  found.chop_order = whole_number_or(fields, "chop_order", 0);
  found.is_seen_from_inside = read_number_or(fields, "mirrorinside", 0) > 0;
  found.keeps_inner_faces = read_number_or(fields, "noclipfaces", 0) > 0;
  if (const std::int32_t hulls = whole_number_or(fields, "hulls", 0); hulls > 0)
    found.hulls = static_cast<std::uint8_t>(hulls & kAllHulls);
  for (const WorldClass& known : kWorldClasses) {
    if (known.classname != fields.classname()) continue;
    found.is_world = true;
    found.solid = known.solid;
    found.is_detail = known.is_detail;
    found.is_seen_from_inside |= known.solid == Fill::kVisBlocker;
    return found;
  }
  // The game may move it to where a player looks out of it.
  if (found.is_seen_from_inside || found.keeps_inner_faces) found.solid = Fill::kFence;
  return found;
}

// "hintskip" before "hint", because that is a prefix.
SpecialTexture find_special_texture(std::string_view texture) {
  const std::string name = base::to_lower(texture);
  const auto begins = [&](std::string_view with) { return name.starts_with(with); };
  if (begins("*lava")) return SpecialTexture::kLava;
  if (begins("*slime")) return SpecialTexture::kSlime;
  if (begins("*")) return SpecialTexture::kWater;
  if (begins("sky")) return SpecialTexture::kSky;
  if (name == "clip") return SpecialTexture::kClip;
  if (name == "hintskip") return SpecialTexture::kHintSkip;
  if (begins("hint")) return SpecialTexture::kHint;
  if (name == "origin") return SpecialTexture::kOrigin;
  if (name == "skip" || name == "caulk" || name == "nodraw") return SpecialTexture::kSkip;
  return SpecialTexture::kNone;
}

SpecialTexture find_special_texture(const formats::MapBrush& brush) {
  SpecialTexture found = SpecialTexture::kNone;
  for (const formats::MapSide& side : brush.sides) {
    const SpecialTexture special = find_special_texture(side.texture);
    if (special == SpecialTexture::kHint || special == SpecialTexture::kOrigin) return special;
    if (found == SpecialTexture::kNone && special != SpecialTexture::kSkip &&
        special != SpecialTexture::kHintSkip)
      found = special;
  }
  return found;
}

bool is_liquid(SpecialTexture special) {
  return special == SpecialTexture::kWater || special == SpecialTexture::kSlime ||
         special == SpecialTexture::kLava;
}

// A liquid whose name ends in "skip" is there but not drawn.
bool is_drawn(std::string_view texture) {
  const SpecialTexture special = find_special_texture(texture);
  if (is_liquid(special)) return !base::to_lower(texture).ends_with("skip");
  return special == SpecialTexture::kNone || special == SpecialTexture::kSky;
}

Fill find_fill(SpecialTexture special, const BrushClass& of_class) {
  // Games ask only the world what fills a place; a door that looks like water is still a door.
  if (!of_class.is_world && special != SpecialTexture::kHint) return of_class.solid;
  switch (special) {
    case SpecialTexture::kWater:
      return Fill::kWater;
    case SpecialTexture::kSlime:
      return Fill::kSlime;
    case SpecialTexture::kLava:
      return Fill::kLava;
    case SpecialTexture::kSky:
      return Fill::kSky;
    case SpecialTexture::kHint:
      return Fill::kEmpty;
    default:
      return of_class.solid;
  }
}

// Clip brushes are not drawn and do not stop points; liquids and illusionary brushes do not stop boxes.
std::uint8_t find_hulls(SpecialTexture special, Fill fill) {
  const bool stops_boxes = is_blocked(fill) || fill == Fill::kSky;
  if (special == SpecialTexture::kClip) return stops_boxes ? kAllHulls & ~kDrawnHull : 0;
  return stops_boxes ? kAllHulls : kDrawnHull;
}

}  // namespace temblor::compiler
