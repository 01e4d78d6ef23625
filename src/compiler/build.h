// A level with what later runs need so that only what changed is made anew.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "compiler/build/draft.h"
#include "compiler/build/surface_keys.h"
#include "compiler/light/light_cache.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"

namespace temblor::compiler {

enum class VisibilityKind : std::uint8_t {
  kNone,   // every leaf sees every other
  kRough,  // from the sides of planes alone
  kFull,
};

// Hashes of all that a stage's result follows from (build_keys.h); 0: of no result.
using StageKey = std::uint64_t;

struct Build {
  formats::Bsp bsp;  // as a reader of the file sees it; without models: nothing is built yet
  // Lit samples for the file beside the level; nothing where all light is white.
  std::optional<formats::Lit> lit;

  StageKey brushes_key = 0;  // 0 also where a hull of the level leaks, or it is a region of the map
  StageKey solid_occupants_key = 0;
  std::size_t own_textures = 0;  // of sides; others came along because they are frames of these
  std::vector<BrushEntity> brush_entities;
  bool water_is_transparent = true;  // to visibility: what `portals` were made for
  PortalSet portals;
  FaceKeys face_keys;

  VisibilityKind visibility = VisibilityKind::kNone;
  std::optional<double> mean_visible_share;  // of leaves, seen from a leaf; with visibility
  // Full visibility that is begun and not finished (visibility_state.h); empty: none. It knows by itself
  // which portals it belongs to.
  base::ByteVector visibility_state;

  StageKey light_key = 0;
  LightCache light_cache;  // of this level, or of one before it
};

}  // namespace temblor::compiler
