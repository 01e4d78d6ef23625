// What names say of brushes: those of textures, and the classnames of entities whose brushes are the world's.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/bsp/brushes/brush.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// What an entity's brushes become, by its classname and its keys.
struct BrushClass {
  bool is_world = false;      // else a model of their own
  Fill solid = Fill::kSolid;  // of those that are not liquid or sky
  bool is_detail = false;
  std::uint8_t hulls = kAllHulls;
  std::int32_t chop_order = 0;
  bool is_seen_from_inside = false;
  bool keeps_inner_faces = false;
};
BrushClass brush_class_of(const formats::Entity& fields);

enum class Special { kNone, kWater, kSlime, kLava, kSky, kClip, kSkip, kHint, kHintSkip, kOrigin };

Special special_of(std::string_view texture);
bool is_liquid(Special special);
// The first side that says something decides; a hint or origin brush is one with any such side.
Special special_of(const formats::MapBrush& brush);
// Whether a side with this texture is drawn at all.
bool is_drawn(std::string_view texture);

Fill fill_of(Special special, const BrushClass& of_class);
std::uint8_t hulls_of(Special special, Fill fill);  // as Brush::hulls

}  // namespace temblor::compiler
