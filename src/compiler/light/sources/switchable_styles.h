// Light styles that the game switches: of lights with a targetname, of brushes that share one, and of
// switchable shadows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/light/surface_keys.h"
#include "compiler/report.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// Whether the shadow of a brush entity can be switched (_switchableshadow, _switchableshadow_target).
bool has_switchable_shadow(const formats::Entity& entity);

// Gives every light with a targetname the style that belongs to the name, as "style": 32 and up, in the order
// in which names first appear. After them, gives every brush entity with a switchable shadow a style, as
// "switchshadstyle": the same for all with one targetname, and for those whose _switchableshadow_target names
// a light, that light's. worldspawn's _compilerstyle_start and _compilerstyle_max (32, 64) bound the styles.
// Returns whether an entity changed. Names without a style that is left keep theirs, with a warning.
bool assign_switchable_styles(std::vector<formats::Entity>& io_entities, Warnings& io_warnings);

// The name of the switchable shadow of a func_detail or func_group; empty without one. Such a brush is part
// of the world, so no entity can tell game code its style. It shares that of a light
// (_switchableshadow_target) or of a brush entity (_switchableshadow with the same targetname).
std::string find_brush_shadow_name(const formats::Entity& entity);

// Styles by entry of FaceKeys::keys. 0: none, also because nothing in the level has the name.
struct BrushStyles {
  std::vector<std::uint8_t> shadows;         // SurfaceKeys::shadow_name
  std::vector<std::uint8_t> surface_lights;  // SurfaceKeys::surface_light_name
};
// `entities`: with any or without styles.
BrushStyles find_brush_styles(std::span<const formats::Entity> entities, const FaceKeys& keys);

}  // namespace temblor::compiler
