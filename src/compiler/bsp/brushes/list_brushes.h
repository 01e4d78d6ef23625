// The brushes of a level as the lump BRUSHLIST has them.
#pragma once

#include <vector>

#include "compiler/bsp/brushes/level_brushes.h"
#include "formats/bspx/brush_list.h"

namespace temblor::compiler {

// Lists everything that stops players, and liquids and sky: the world's brushes in its space, those of other
// models in theirs. Models without such brushes are left out, so they are not solid. A brush that stops only
// some hulls is listed if it stops players.
std::vector<formats::ListedModel> list_brushes(const LevelBrushes& level);

}  // namespace temblor::compiler
