// From worked-out light to the bytes of a level: least lights, negative lights, range, styles.
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel_for.h"
#include "compiler/light/faces/face_light.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/sources/settings.h"
#include "compiler/report.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"

namespace temblor::compiler {

struct PackedLight {
  std::size_t lit_faces = 0, dark_faces = 0;
  bool colored = false;
  formats::Lit lit;  // red, green, blue for each gray sample, colored or not
};

// Writes styles and light_offset of every face, in their order, and `lighting`: for each face its styles one
// after the other, the lowest first. A style without any light is left out; of more than four the brightest
// stay (a warning counts the rest). `light`: by light map (LitLevel::maps).
// Those of another scale than 16 texels lie behind all others, and are found by three BSPX lumps, an entry
// for each face: LMSHIFT, a byte, the power of two of its scale; LMOFFSET, int32, as light_offset; LMSTYLE,
// four bytes, as styles. Without scaled maps there are none of these lumps.
PackedLight pack_light_maps(const LitLevel& lit, const LightSettings& settings,
                            const std::vector<FaceLight>& light, base::Jobs& io_jobs, formats::Bsp& io_bsp,
                            Warnings& io_warnings);

}  // namespace temblor::compiler
