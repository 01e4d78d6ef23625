#include "client/session/model_table.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

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

base::Result<AliasModelPtr> load_alias_model(const assets::Library& library, const std::string& path) {
  TRY(const formats::Mdl mdl, library.alias_model(path));
  return render::make_alias_model(mdl, path);
}

// Loads any model that is not a level of its own.
base::Result<ClientModel> load_model(const assets::Library& library, const world::Level& level,
                                     const std::string& name) {
  if (name.starts_with('*')) {
    const auto part = find_submodel(level, name);
    if (!part) return missing_submodel(name, level);
    return ClientModel(*part);
  }
  if (base::to_lower(name).ends_with(".spr")) {
    TRY(formats::Spr sprite, library.sprite(name));
    return ClientModel(std::make_shared<const formats::Spr>(std::move(sprite)));
  }
  TRY(AliasModelPtr model, load_alias_model(library, name));
  return ClientModel(std::move(model));
}

// Ammo boxes and similar items are .bsp files too.
bool is_level(const std::string& name) {
  return base::to_lower(name).ends_with(".bsp");
}

}  // namespace

// Brush models from other files are joined to the level, so that one tree of models serves rendering and
// traces.
void ModelTable::load_models(const assets::Library& library, const std::shared_ptr<const world::Level>& level,
                             std::span<const std::string> names, const assets::LevelOptions& options,
                             std::vector<std::string>& io_notes) {
  models_.assign(names.size(), placeholder_);
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
    base::Result<ClientModel> model = load_model(library, *level, names[number]);
    if (model.ok())
      models_[number] = std::move(model).value();
    else
      note(model.error());
  }
  const world::JoinedLevel joined = world::join_levels(level, boxes);
  level_ = joined.level;
  for (std::size_t i = 0; i < boxes.size(); ++i) models_[box_numbers[i]] = joined.models[i];
}

// Not every game has all four, and most levels show none, so missing ones are not reported.
void ModelTable::load_beams(const assets::Library& library) {
  for (std::size_t i = 0; i < kBeamPaths.size(); ++i) {
    base::Result<AliasModelPtr> beam = load_alias_model(library, kBeamPaths[i]);
    if (beam.ok()) beams_[i] = std::move(beam).value();
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
  table.load_beams(library);
  for (std::size_t number = 0; number < names.size(); ++number) {
    const ClientModel& model = table.models_[number];
    const auto* alias = std::get_if<AliasModelPtr>(&model);
    table.flags_.push_back(alias != nullptr ? render::find_model_flags(**alias) : 0);
    const auto* brush_model = std::get_if<world::ModelIndex>(&model);
    const bool is_submodel = brush_model != nullptr && names[number].starts_with('*');
    table.submodels_.push_back(is_submodel ? *brush_model : world::ModelIndex{0});
  }
  return table;
}

const ClientModel& ModelTable::model(std::size_t number) const {
  return contains(number) ? models_[number] : placeholder_;
}

}  // namespace temblor::client
