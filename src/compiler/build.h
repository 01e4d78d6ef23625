// A compiled level together with everything that later runs need to redo only what has changed.
//
// The incremental build manager (build/incremental_build.h) compares the keys in here with the keys of the
// map at hand and decides stage by stage whether to build or to reuse. build_file.h saves a Build beside the
// level.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/bsp/draft.h"
#include "compiler/light/light_cache.h"
#include "compiler/light/surface_keys.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"

namespace temblor::compiler {

// How tight a level's visibility is.
enum class VisibilityKind : std::uint8_t {
  kNone,   // every leaf sees every other
  kRough,  // the quick bound of vis/flow/base_visibility.h
  kFull,
};

// A hash of everything that a stage's result depends on (build/build_keys.h); 0: there is no result.
using StageKey = std::uint64_t;

// A plain value; moving it is cheap.
struct Build {
  formats::Bsp bsp;  // as formats::read_bsp() reads it back; without models: nothing has been built yet
  // Colored samples for the .lit file beside the level; nothing if all light is white.
  std::optional<formats::Lit> lit;

  // The BSP stage. Its key is 0 also if a hull leaks or if only a region of the map was compiled: such
  // results are never reused.
  StageKey brushes_key = 0;
  StageKey solid_occupants_key = 0;
  // The number of textures that sides use. They come first in `bsp`, before the other frames of their
  // animations.
  std::size_t own_textures = 0;
  std::vector<BrushEntity> brush_entities;
  bool water_is_transparent = true;  // how `portals` treat the surfaces of liquids
  PortalSet portals;
  FaceKeys face_keys;

  VisibilityKind visibility = VisibilityKind::kNone;
  std::optional<double> mean_visible_share;  // of all leaves, seen from an average leaf; only with visibility
  // Full visibility that was begun and not finished (vis/visibility_state.h); empty: none. The bytes
  // themselves say which portals they belong to, so this may outlive the level.
  base::ByteVector visibility_state;

  StageKey light_key = 0;
  LightCache light_cache;  // of this level or of an earlier version of it
};

// Makes a Build from a finished level whose map is not available: portals come from the level's tree, and
// face keys from its entity text (so the keys of func_group and func_detail are lost). Fails if the entity
// text does not parse or if the tree has too many portals.
base::Result<Build> make_build_from_level(formats::Bsp bsp, std::optional<formats::Lit> lit,
                                          bool water_is_transparent);

}  // namespace temblor::compiler
