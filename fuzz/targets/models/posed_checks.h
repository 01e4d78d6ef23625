// Checks of models that fuzz targets of several formats share.
#pragma once

#include "formats/models/posed_model.h"

namespace temblor::fuzz {

// CHECKs that the model has valid poses, and that the renderer makes a model of it or refuses it with an
// error. Gives it skins of a few texels.
void check_drawable(formats::PosedModel model);

}  // namespace temblor::fuzz
