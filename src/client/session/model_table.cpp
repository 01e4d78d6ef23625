#include "client/session/model_table.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "assets/posed_models.h"
#include "base/text.h"
#include "client/session/placeholder_model.h"
#include "world/join_levels.h"

namespace temblor::client {
namespace {

// The level's precache number.
constexpr std::size_t kLevelNumber = 1;
// In the order of BeamModel. Messages name beams by kind rather than by precache number, so their models are
// loaded by path, as in stock Quake.
constexpr std::array<const char*, 4> kBeamPaths = {"progs/bolt.mdl", "progs/bolt2.mdl", "progs/bolt3.mdl",
                                                   "progs/beam.mdl"};
// In the orders of CasingModel and PuffPicture. No message names these.
constexpr std::array<const char*, 2> kCasingPaths = {"progs/c_shell.mdl", "progs/c_brass.mdl"};
constexpr std::array<const char*, 4> kPuffPaths = {"progs/s_smoke.spr", "progs/s_dust.spr",
                                                   "progs/s_ring.spr", "progs/s_bubble.spr"};

// Parses "*N"; returns nothing if the level has no such submodel.
std::optional<world::ModelIndex> find_submodel(const world::Level& level, std::string_view name) {
  std::uint32_t number = 0;
  const auto [end, failure] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  if (failure != std::errc{} || end != name.data() + name.size() || number >= level.models.size())
    return std::nullopt;
  return static_cast<world::ModelIndex>(number);
}

base::Error missing_submodel(std::string_view name, const world::Level& level) {
  return base::error(base::ErrorCode::kNotFound, "model {} is not in level {}", base::printable(name),
                     level.name);
}

base::Result<AliasModelPtr> load_md5_model(const assets::Library& library, const std::string& path,
                                           const formats::Mdl& mdl) {
  TRY(const std::optional<formats::PosedModel> posed,
      assets::load_md5_replacement(library.files(), path, mdl));
  if (!posed) return AliasModelPtr();
  return render::make_alias_model(*posed, path);
}

// Loads a part of the level or a sprite.
base::Result<ClientModel> load_other_model(const assets::Library& library, const world::Level& level,
                                           const std::string& name) {
  if (name.starts_with('*')) {
    const auto part = find_submodel(level, name);
    if (!part) return missing_submodel(name, level);
    return ClientModel(*part);
  }
  TRY(formats::Spr sprite, library.sprite(name));
  return ClientModel(std::make_shared<const formats::Spr>(std::move(sprite)));
}

bool is_alias_model(const std::string& name) {
  return !name.starts_with('*') && !base::to_lower(name).ends_with(".spr");
}

// Ammo boxes and similar items are .bsp files too.
bool is_level(const std::string& name) {
  return base::to_lower(name).ends_with(".bsp");
}

}  // namespace

base::Result<ModelTable::AliasPair> ModelTable::load_alias_pair(const assets::Library& library,
                                                                const std::string& path,
                                                                std::vector<std::string>& io_notes) {
  if (assets::is_posed_model(path)) {
    TRY(const formats::PosedModel posed, assets::load_posed_model(library.files(), path, io_notes));
    TRY(AliasModelPtr model, render::make_alias_model(posed, path).with_file(path));
    return AliasPair{std::move(model), nullptr};
  }
  TRY(const formats::Mdl mdl, library.alias_model_with_skins(path, io_notes));
  AliasPair pair{render::make_alias_model(mdl, path), nullptr};
  base::Result<AliasModelPtr> md5 = load_md5_model(library, path, mdl);
  if (md5.ok())
    pair.md5 = std::move(md5).value();
  else
    io_notes.push_back(fmt::format("{}. {} is drawn instead", md5.error().message(), path));
  return pair;
}

// Brush models from other files are joined to the level, so that one tree of models serves rendering and
// traces.
void ModelTable::load_models(const assets::Library& library, const std::shared_ptr<const world::Level>& level,
                             std::span<const std::string> names, const assets::LevelOptions& options,
                             std::vector<std::string>& io_notes) {
  models_.assign(names.size(), placeholder_);
  md5_models_.resize(names.size());
  models_[kLevelNumber] = world::ModelIndex{0};
  std::vector<std::shared_ptr<const world::Level>> boxes;
  std::vector<std::size_t> box_numbers;
  const auto note = [&](const base::Error& error) {
    io_notes.push_back(fmt::format("{}. A placeholder is drawn instead", error.message()));
  };
  for (std::size_t number = kLevelNumber + 1; number < names.size(); ++number) {
    if (is_level(names[number])) {
      base::Result<assets::LoadedLevel> box = library.level(names[number], options);
      if (!box.ok()) {
        note(box.error());
        continue;
      }
      boxes.push_back(box->level);
      box_numbers.push_back(number);
      continue;
    }
    if (is_alias_model(names[number])) {
      base::Result<AliasPair> pair = load_alias_pair(library, names[number], io_notes);
      if (!pair.ok()) {
        note(pair.error());
        continue;
      }
      models_[number] = std::move(pair->mdl);
      md5_models_[number] = std::move(pair->md5);
      continue;
    }
    base::Result<ClientModel> model = load_other_model(library, *level, names[number]);
    if (model.ok())
      models_[number] = std::move(model).value();
    else
      note(model.error());
  }
  const world::JoinedLevel joined = world::join_levels(level, boxes);
  level_ = joined.level;
  for (std::size_t i = 0; i < boxes.size(); ++i) models_[box_numbers[i]] = joined.models[i];
}

// Not every game has all of them, and most levels show few, so missing ones are not reported.
void ModelTable::load_effects(const assets::Library& library, std::vector<std::string>& io_notes) {
  const auto load_alias = [&](const char* path, AliasPair& out_pair) {
    base::Result<AliasPair> pair = load_alias_pair(library, path, io_notes);
    if (pair.ok()) out_pair = std::move(pair).value();
  };
  for (std::size_t i = 0; i < kBeamPaths.size(); ++i) load_alias(kBeamPaths[i], beams_[i]);
  for (std::size_t i = 0; i < kCasingPaths.size(); ++i) load_alias(kCasingPaths[i], casings_[i]);
  for (std::size_t i = 0; i < kPuffPaths.size(); ++i) {
    base::Result<formats::Spr> sprite = library.sprite(kPuffPaths[i]);
    if (sprite.ok()) puffs_[i] = std::make_shared<const formats::Spr>(std::move(sprite).value());
  }
}

base::Result<ModelTable> ModelTable::load(const assets::Library& library, std::span<const std::string> names,
                                          const assets::LevelOptions& options,
                                          std::vector<std::string>& io_notes) {
  if (names.size() <= kLevelNumber)
    return base::malformed("the server named no level: its list of models is empty");
  TRY(const assets::LoadedLevel loaded, library.level(names[kLevelNumber], options));
  io_notes.insert(io_notes.end(), loaded.notes.begin(), loaded.notes.end());

  ModelTable table;
  table.placeholder_ = render::make_alias_model(make_placeholder_model(), "missing model");
  table.load_models(library, loaded.level, names, options, io_notes);
  table.load_effects(library, io_notes);
  for (std::size_t number = 0; number < names.size(); ++number) {
    const ClientModel& model = table.models_[number];
    const auto* alias = std::get_if<AliasModelPtr>(&model);
    table.flags_.push_back(alias != nullptr ? render::find_model_flags(**alias) : 0);
    const math::Bounds bounds = alias != nullptr ? render::model_bounds(**alias) : math::Bounds{};
    table.heights_.push_back(bounds.maxs.z - bounds.mins.z);
    const auto* brush_model = std::get_if<world::ModelIndex>(&model);
    const bool is_submodel = brush_model != nullptr && names[number].starts_with('*');
    table.submodels_.push_back(is_submodel ? *brush_model : world::ModelIndex{0});
  }
  return table;
}

const ClientModel& ModelTable::model(std::size_t number) const {
  return contains(number) ? models_[number] : placeholder_;
}

const render::AliasModel* ModelTable::alias_model(std::size_t number, bool prefers_md5) const {
  const auto* mdl = std::get_if<AliasModelPtr>(&model(number));
  if (mdl == nullptr) return nullptr;
  const bool has_md5 = contains(number) && md5_models_[number] != nullptr;
  return prefers_md5 && has_md5 ? md5_models_[number].get() : mdl->get();
}

}  // namespace temblor::client
