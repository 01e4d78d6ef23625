// Light styles that the game switches: of lights with a targetname, and of brushes with a switchable shadow.
#pragma once

#include <vector>

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

}  // namespace temblor::compiler
