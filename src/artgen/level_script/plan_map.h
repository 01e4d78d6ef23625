// A plan as the map that is compiled.
#pragma once

#include "artgen/level_script/plan.h"
#include "base/result.h"
#include "formats/levels/map.h"

namespace temblor::artgen {

// A level's line with all that stands under it.
base::Result<Plan> read_plan(const ScriptLine& level);

// The shell, rock and bands are made here.
formats::Map map_of_plan(const Plan& plan);

// What is wrong with where things stand: in the rock, in a solid. Errors name the line of the thing.
base::Status check_plan(const Plan& plan);

}  // namespace temblor::artgen
