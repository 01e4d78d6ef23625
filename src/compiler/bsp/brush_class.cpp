#include "compiler/bsp/brush_class.h"

#include <array>
#include <string>

#include "base/text.h"

namespace temblor::compiler {
namespace {

constexpr std::array<BrushClass, 6> kWorldClasses = {{
    kWorldClass,
    {"func_group", Fill::kSolid, false},
    {"func_detail", Fill::kDetail, true},
    {"func_detail_wall", Fill::kDetail, true},
    {"func_detail_fence", Fill::kFence, true},
    {"func_detail_illusionary", Fill::kIllusionary, true},
}};

}  // namespace

const BrushClass* world_class(std::string_view classname) {
  for (const BrushClass& known : kWorldClasses)
    if (known.classname == classname) return &known;
  return nullptr;
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

bool is_drawn(std::string_view texture) {
  const Special special = special_of(texture);
  if (special == Special::kWater || special == Special::kSlime || special == Special::kLava)
    return !base::to_lower(texture).ends_with("skip");
  return special == Special::kNone || special == Special::kSky;
}

Fill fill_of(Special special, const BrushClass& of_class) {
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

}  // namespace temblor::compiler
