// The model that is drawn in place of a missing one.
#pragma once

#include "formats/models/mdl.h"

namespace temblor::client {

// A cube of 16 units with a checkered skin, like the texture for missing textures.
formats::Mdl make_placeholder_model();

}  // namespace temblor::client
