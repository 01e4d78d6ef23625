// The models of a level's precache list, loaded: numbers in messages become things to draw.
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
using ClientModel = std::variant<world::ModelIndex, AliasModelPtr, SpritePtr>;

class ModelTable {
 public:
  // `names` as in Game::models: [1] is the level. Fails when the level is not there or cannot be used; any
  // other model that cannot gets a stand-in, and a line in `io_notes`.
  static base::Result<ModelTable> load(const assets::Library& library, std::span<const std::string> names,
                                       std::vector<std::string>& io_notes);

  // The level, with the brush models that are files of their own joined to it.
  const std::shared_ptr<const world::Level>& level() const { return level_; }
  // The stand-in for numbers past the list. Number 0 is no model, and not to be asked for.
  const ClientModel& model(std::size_t number) const;
  bool has(std::size_t number) const { return number < models_.size(); }
  const AliasModelPtr& beam(BeamModel beam) const { return beams_[static_cast<std::size_t>(beam)]; }
  // formats::MdlFlags by number; 0 for what is not an alias model.
  std::span<const std::uint32_t> flags() const { return flags_; }

 private:
  void load_models(const assets::Library& library, const std::shared_ptr<const world::Level>& level,
                   std::span<const std::string> names, std::vector<std::string>& io_notes);
  void load_beams(const assets::Library& library);

  std::shared_ptr<const world::Level> level_;
  std::vector<ClientModel> models_;
  std::vector<std::uint32_t> flags_;
  std::array<AliasModelPtr, 4> beams_;
  ClientModel placeholder_;
};

}  // namespace temblor::client
