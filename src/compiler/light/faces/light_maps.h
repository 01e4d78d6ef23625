// Packs computed light into the bytes of a level: minimum lights, negative lights, range and styles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel_for.h"
#include "compiler/light/faces/face_light.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/sources/settings.h"
#include "compiler/report.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"

namespace temblor::compiler {

// Counts, and the colored samples.
struct PackedLight {
  std::size_t lit_faces = 0, dark_faces = 0;
  bool colored = false;
  std::vector<std::uint32_t> hdr;        // for each gray sample; empty unless settings.has_hdr
  std::vector<std::uint8_t> directions;  // three for each gray sample; empty unless settings.has_directions
  formats::Lit lit;                      // red, green and blue for each gray sample, even if all are gray
};

// How light becomes bytes.
struct PackRules {
  const LightSettings& settings;
  int soft = 0;  // luxels on each side over which light is averaged (soften.h)
};

// Writes `lighting`, and styles and light_offset of every face, in the order of the faces: for each face its
// styles one after another, the lowest first. Styles without any light are left out; of more than four, the
// brightest stay, with a warning. `light`: by light map (LitLevel::maps).
//
// Maps of another scale than 16 texels come after all others. BSPX lumps with an entry for each face find
// them: LMSHIFT, LMOFFSET, and LMSTYLE (formats/levels/scaled_light.h), or, if any map is decoupled,
// DECOUPLED_LM for all of them (formats/levels/decoupled_light.h), with LMSTYLE where its styles differ from
// the faces' own. Without such maps these lumps are missing.
PackedLight pack_light_maps(const LitLevel& lit, const PackRules& rules, const std::vector<FaceLight>& light,
                            base::Jobs& io_jobs, formats::Bsp& io_bsp, Warnings& io_warnings);

}  // namespace temblor::compiler
