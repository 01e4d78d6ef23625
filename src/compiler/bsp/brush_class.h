// What names say of brushes: those of textures, and the classnames of entities whose brushes are the world's.
#pragma once

#include <string_view>

#include "compiler/bsp/brush.h"
#include "formats/map.h"

namespace temblor::compiler {

// What an entity's brushes become.
struct BrushClass {
  std::string_view classname;
  Fill solid;  // of its brushes that are not liquid or sky
  bool is_detail;
};
constexpr BrushClass kWorldClass = {"worldspawn", Fill::kSolid, false},
                     kModelClass = {"", Fill::kSolid, false};

// Of worldspawn, func_group and their like; null for entities whose brushes are a model of their own.
const BrushClass* world_class(std::string_view classname);

enum class Special { kNone, kWater, kSlime, kLava, kSky, kClip, kSkip, kHint, kHintSkip, kOrigin };

Special special_of(std::string_view texture);
// The first side that says something decides; a hint or origin brush is one with any such side.
Special special_of(const formats::MapBrush& brush);
// Whether a side with this texture is drawn at all.
bool is_drawn(std::string_view texture);

Fill fill_of(Special special, const BrushClass& of_class);

}  // namespace temblor::compiler
