// Classifies brushes by the names of textures and of entity classes: liquids, sky, clip, hint, detail, ...
// The names are those of Quake's own qbsp and of ericw-tools.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/bsp/brushes/brush.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// The kind of brushes that an entity's classname and keys ask for.
struct BrushClass {
  bool is_world = false;      // false: they become a model of their own
  Fill solid = Fill::kSolid;  // the fill of brushes that are neither liquid nor sky
  bool is_detail = false;
  std::uint8_t hulls = kAllHulls;
  std::int32_t chop_order = 0;
  bool is_seen_from_inside = false;
  bool keeps_inner_faces = false;
};
// Reads the class of an entity; unknown classnames become models of their own.
BrushClass find_brush_class(const formats::Entity& fields);

// The meaning of a texture's name.
enum class SpecialTexture { kNone, kWater, kSlime, kLava, kSky, kClip, kSkip, kHint, kHintSkip, kOrigin };

// Ignores case. kNone: an ordinary texture.
SpecialTexture find_special_texture(std::string_view texture);
bool is_liquid(SpecialTexture special);
// A brush with any hint or origin side is a hint or origin brush; otherwise, its first side with a meaning
// other than skip decides.
SpecialTexture find_special_texture(const formats::MapBrush& brush);
// Whether a side with this texture is drawn.
bool is_drawn(std::string_view texture);

// The contents of a brush with that texture, and the hulls (Brush::hulls) that it belongs to.
Fill find_fill(SpecialTexture special, const BrushClass& of_class);
std::uint8_t find_hulls(SpecialTexture special, Fill fill);

}  // namespace temblor::compiler
