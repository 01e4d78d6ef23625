// What is drawn where a model is missing.
#pragma once

#include "formats/mdl.h"

namespace temblor::client {

// A cube of 16 units with a checkered skin, as textures that are missing have.
formats::Mdl make_stand_in_model();

}  // namespace temblor::client
