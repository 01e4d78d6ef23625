// The directions of faces at their corners, for the lump FACENORMALS.
#pragma once

#include "compiler/light/lit_level.h"
#include "formats/bspx/face_normals.h"

namespace temblor::compiler {

// Normals are those with which faces are lit: curved for faces with _phong. Tangents and bitangents point
// along s and t of the texture, as far as they are perpendicular to the normal. All have length 1.
formats::FaceNormals make_face_normals(const LitLevel& lit);

}  // namespace temblor::compiler
