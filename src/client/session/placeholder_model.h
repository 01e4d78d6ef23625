// What is drawn where a model is missing.
#pragma once

#include "formats/models/mdl.h"

namespace temblor::client {

// A cube of 16 units with a checkered skin, as textures that are missing have.
formats::Mdl make_placeholder_model();

}  // namespace temblor::client
