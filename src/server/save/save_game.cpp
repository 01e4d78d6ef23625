#include "server/save/save_game.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/game/field_text.h"

namespace temblor::server {
namespace {

using formats::ProgsDefinition;
using formats::ProgsType;

// Vectors and functions are not saved, as in stock Quake.
bool is_saved_global(const ProgsDefinition& definition) {
  return definition.is_saved &&
         (definition.type == ProgsType::kString || definition.type == ProgsType::kFloat ||
          definition.type == ProgsType::kEntity);
}

// "origin_x" is a component of "origin", which is saved as a whole.
bool is_vector_component(std::string_view name) {
  return name.size() > 2 && name[name.size() - 2] == '_' && name.back() >= 'x' && name.back() <= 'z';
}

formats::SavPairs saved_globals(const vm::Machine& machine) {
  formats::SavPairs pairs;
  const formats::Progs& progs = machine.program().progs();
  for (const ProgsDefinition& definition : progs.globals)
    if (is_saved_global(definition))
      pairs.emplace_back(progs.string_at(definition.name),
                         value_text(machine, definition, machine.global_words().subspan(definition.offset)));
  return pairs;
}

// Stores a value. One that this program cannot have is noted and skipped; other errors are passed on.
base::Status set_or_note(vm::Machine& io_machine, const ProgsDefinition* definition, const std::string& name,
                         const std::string& value, std::span<std::uint32_t> words,
                         std::vector<std::string>& io_notes) {
  if (!definition) {
    io_notes.push_back(fmt::format("the saved game sets \"{}\", which this game code does not have", name));
    return base::Ok{};
  }
  const base::Status status = set_value(io_machine, *definition, value, words.subspan(definition->offset));
  if (status.ok() || status.error().code != base::ErrorCode::kUsage) return status;
  io_notes.push_back(fmt::format("the saved game sets \"{}\": {}", name, status.error().what));
  return base::Ok{};
}

base::Status restore_entity(const formats::SavPairs& pairs, vm::EntityIndex index, Game& io_game,
                            std::vector<std::string>& io_notes) {
  vm::Machine& machine = io_game.machine();
  const std::span<std::uint32_t> words = machine.entity(index);
  std::fill(words.begin(), words.end(), 0u);
  for (const auto& [name, value] : pairs)
    TRY_STATUS(set_or_note(machine, machine.program().find_field(name), name, value, words, io_notes));
  return base::Ok{};
}

}  // namespace

formats::SavPairs nonzero_fields(const Game& game, vm::EntityIndex index) {
  const vm::Machine& machine = game.machine();
  formats::SavPairs pairs;
  const formats::Progs& progs = machine.program().progs();
  const std::span<const std::uint32_t> words = machine.entity(index);
  for (const ProgsDefinition& field : progs.fields) {
    const std::string_view name = progs.string_at(field.name);
    const auto value = words.subspan(field.offset, formats::value_words(field.type));
    const bool is_zero =
        std::all_of(value.begin(), value.end(), [](std::uint32_t word) { return word == 0; });
    if (is_zero || is_vector_component(name)) continue;
    std::string text = value_text(machine, field, value);
    if (!text.empty()) pairs.emplace_back(name, std::move(text));
  }
  return pairs;
}

// A free entity is an empty list of fields, so that the others keep their numbers.
formats::Sav make_save(const Game& game, std::string comment) {
  formats::Sav sav;
  comment.resize(std::min(comment.size(), formats::kSavCommentChars));
  std::replace(comment.begin(), comment.end(), '\n', ' ');
  sav.comment = std::move(comment);
  sav.spawn_parameters = game.spawn_parameters(0);
  sav.skill = game.setup().skill;
  sav.map = game.setup().map_name;
  sav.time_s = static_cast<float>(game.time_s());
  sav.light_styles = game.light_styles();
  sav.globals = saved_globals(game.machine());
  const Edicts& edicts = game.world().edicts;
  for (std::uint32_t number = 0; number < edicts.count(); ++number) {
    const vm::EntityIndex index{number};
    sav.entities.push_back(edicts.is_free(index) ? formats::SavPairs{} : nonzero_fields(game, index));
  }
  return sav;
}

std::size_t count_used_entities(const formats::Sav& sav) {
  std::size_t count = sav.entities.size();
  while (count > 0 && sav.entities[count - 1].empty()) --count;
  return count;
}

// All entities are unlinked first, and linked again when their fields are set, so that areas and leaves
// match. Triggers are not touched: a save must not change by being loaded.
base::Result<std::vector<std::string>> restore(const formats::Sav& sav, Game& io_game) {
  if (sav.entities.size() < 2) return base::malformed("has no entity for the player");
  std::vector<std::string> notes;
  GameWorld& world = io_game.world();
  vm::Machine& machine = io_game.machine();
  for (std::uint32_t number = 0; number < world.edicts.count(); ++number)
    unlink(world, vm::EntityIndex{number});
  const auto count =
      std::max(static_cast<std::uint32_t>(sav.entities.size()), io_game.setup().max_clients + 1);
  TRY_STATUS(world.edicts.set_count(count));
  for (const auto& [name, value] : sav.globals)
    TRY_STATUS(set_or_note(machine, machine.program().find_global(name), name, value, machine.global_words(),
                           notes));
  world.time_s = sav.time_s;
  for (std::size_t number = 0; number < sav.entities.size(); ++number) {
    const auto index = base::to_index<vm::EntityIndex>(number);
    TRY_STATUS(restore_entity(sav.entities[number], index, io_game, notes));
    if (sav.entities[number].empty() && number > io_game.setup().max_clients)
      world.edicts.free(index, world.time_s);
    else
      TRY_STATUS(link(world, index, TouchTriggers::kNo));
  }
  io_game.restore_environment(sav.light_styles, sav.spawn_parameters);
  return notes;
}

}  // namespace temblor::server
