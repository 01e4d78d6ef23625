// The models of a level's precache list, loaded. Translates model numbers of messages to things to draw.
//
//   "maps/e1m1.bsp" "*3"  "maps/b_bh25.bsp" -> world::ModelIndex   a part of the (joined) level
//   "progs/ogre.mdl"                        -> AliasModelPtr, and another if an MD5 model replaces it
//   "models/gem.md3"                        -> AliasModelPtr
//   "progs/s_bubble.spr"                    -> SpritePtr
//
// The table is constant after loading and shares models with the asset library.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "assets/library.h"
#include "base/result.h"
#include "client/effects/effects.h"
#include "formats/models/spr.h"
#include "render/alias_model.h"
#include "world/level.h"

namespace temblor::client {

using AliasModelPtr = std::shared_ptr<const render::AliasModel>;
using SpritePtr = std::shared_ptr<const formats::Spr>;
// A brush model of the level (submodels and joined ammo boxes too), an alias model, or a sprite.
using ClientModel = std::variant<world::ModelIndex, AliasModelPtr, SpritePtr>;

class ModelTable {
 public:
  // Loads the models. `names` is Game::models: [0] is empty, [1] is the level. Fails if the level is missing
  // or unusable. Any other model that is missing or unusable gets a placeholder and a line in `io_notes`; an
  // unusable MD5 model gets only the line.
  static base::Result<ModelTable> load(const assets::Library& library, std::span<const std::string> names,
                                       const assets::LevelOptions& options,
                                       std::vector<std::string>& io_notes);

  // The level. Brush models from other files (ammo boxes) are joined to it.
  const std::shared_ptr<const world::Level>& level() const { return level_; }
  // Returns the placeholder for numbers past the list. Number 0 means no model and must not be passed.
  const ClientModel& model(std::size_t number) const;
  bool contains(std::size_t number) const { return number < models_.size(); }
  // Returns the alias model to draw for a number: its MD5 model if it has one and `prefers_md5`, otherwise
  // that of model(). Null if model() is of another kind.
  const render::AliasModel* alias_model(std::size_t number, bool prefers_md5) const;
  // The model of a beam's pieces, in the same way; null if the game has none.
  const render::AliasModel* beam(BeamModel beam, bool prefers_md5) const {
    return beams_[static_cast<std::size_t>(beam)].choose(prefers_md5);
  }
  // The model of a casing, and the sprite of a puff; null if the game has none.
  const render::AliasModel* casing(CasingModel casing, bool prefers_md5) const {
    return casings_[static_cast<std::size_t>(casing)].choose(prefers_md5);
  }
  const formats::Spr* puff(PuffPicture picture) const {
    return puffs_[static_cast<std::size_t>(picture)].get();
  }
  // formats::MdlFlags by model number; 0 for models that are not alias models.
  std::span<const std::uint32_t> flags() const { return flags_; }
  // Heights of alias models by model number, in units; 0 for others.
  std::span<const float> heights() const { return heights_; }
  // By model number: the submodel of the level that "*N" names; the world (0) for all other models.
  std::span<const world::ModelIndex> submodels() const { return submodels_; }

 private:
  // A model as MDL file and as the MD5 model that replaces it; each null if there is none.
  struct AliasPair {
    AliasModelPtr mdl, md5;
    const render::AliasModel* choose(bool prefers_md5) const {
      return prefers_md5 && md5 != nullptr ? md5.get() : mdl.get();
    }
  };
  static base::Result<AliasPair> load_alias_pair(const assets::Library& library, const std::string& path,
                                                 std::vector<std::string>& io_notes);
  void load_models(const assets::Library& library, const std::shared_ptr<const world::Level>& level,
                   std::span<const std::string> names, const assets::LevelOptions& options,
                   std::vector<std::string>& io_notes);
  void load_effects(const assets::Library& library, std::vector<std::string>& io_notes);

  std::shared_ptr<const world::Level> level_;
  std::vector<ClientModel> models_;
  std::vector<AliasModelPtr> md5_models_;  // by model number; null: none
  std::vector<std::uint32_t> flags_;
  std::vector<float> heights_;
  std::vector<world::ModelIndex> submodels_;
  std::array<AliasPair, 4> beams_;
  std::array<AliasPair, 2> casings_;
  std::array<SpritePtr, 4> puffs_;
  ClientModel placeholder_;
};

}  // namespace temblor::client
