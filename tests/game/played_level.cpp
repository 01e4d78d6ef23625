#include "game/played_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "server/game/field_text.h"
#include "server/move_trace.h"

namespace temblor::test {
namespace {

namespace field = server::field;

constexpr std::size_t kManyErrors = 20;  // more would repeat the same

}  // namespace

PlayedLevel::PlayedLevel(const std::filesystem::path& data, std::string_view map,
                         const std::filesystem::path& progs, const PlayedSettings& settings)
    : library_(vfs::FileSystem::open(data).value()), settings_(variables_), inputs_(settings.players) {
  CHECK(variables_.set("developer", "1").ok());  // shows the program's dprint
  CHECK(variables_.set("skill", std::to_string(settings.skill)).ok());
  for (const auto& [variable, value] : settings.rules) CHECK(variables_.set(variable, value).ok());
  const server::GameServices services{.library = library_,
                                      .io_variables = variables_,
                                      .print = [this](std::string_view text) { printed_ += text; }};
  game_ = std::move(server::load_game({.map = std::string(map),
                                       .kind = settings.kind,
                                       .skill = settings.skill,
                                       .program_file = progs,
                                       .max_clients = settings.players},
                                      settings_, services)
                        .value()
                        .game);
  game_->world().tick_s = settings_.tick_s();
}

void PlayedLevel::check(const base::Status& status, std::string_view doing) {
  if (status.ok()) return;
  const vm::Machine& machine = game_->machine();
  errors_.push_back(
      fmt::format("{}: {}\n{}", doing, status.error().message(), machine.describe(machine.failure_trace())));
}

bool PlayedLevel::has_sound(std::string_view name) const {
  const std::vector<std::string>& sounds = game_->precache().sounds;
  return std::find(sounds.begin(), sounds.end(), name) != sounds.end();
}

void PlayedLevel::join(std::uint32_t slot) {
  const server::SpawnParameters parameters = game_->new_parameters().value();
  check(game_->spawn_client(slot, parameters, fmt::format("player{}", slot), 0), "joining");
  inputs_[slot].is_active = true;
}

void PlayedLevel::set(std::string_view variable, std::string_view value) {
  check(variables_.set(std::string(variable), std::string(value)), "set");
}

void PlayedLevel::tick() {
  check(game_->tick(inputs_), "tick");
  for (server::PlayerInput& input : inputs_) input.impulse = 0;
  const base::Bytes said = game_->outbox().reliable().view();
  said_.append(reinterpret_cast<const char*>(said.data()), said.size());
  for (std::uint32_t slot = 0; slot < inputs_.size(); ++slot) {
    if (!inputs_[slot].is_active) continue;
    const base::Bytes sent = game_->outbox().reliable_to(vm::EntityIndex{slot + 1})->view();
    sent_[slot].append(reinterpret_cast<const char*>(sent.data()), sent.size());
  }
  game_->outbox().clear_tick();
}

void PlayedLevel::run(double seconds) {
  const double end = time_s() + seconds;
  while (time_s() < end && errors_.size() < kManyErrors) tick();
}

std::vector<std::uint32_t> PlayedLevel::of_class(std::string_view name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 1; i < edict_count(); ++i)
    if (!is_free(i) && text(edict(i)[field::kClassName]) == name) found.push_back(i);
  return found;
}

float PlayedLevel::global(std::string_view name) const {
  const formats::ProgsDefinition* const definition = game_->machine().program().find_global(name);
  CHECK(definition != nullptr, "{}", name);
  return game_->machine().global_float(vm::GlobalIndex{definition->offset});
}

float PlayedLevel::edict_number(std::uint32_t number, std::string_view field_name) {
  const formats::ProgsDefinition* const definition = game_->machine().program().find_field(field_name);
  CHECK(definition != nullptr, "{}", field_name);
  return edict(number)[server::Field<float>{definition->offset}];
}

std::string PlayedLevel::edict_function(std::uint32_t number, std::string_view field_name) {
  const vm::Program& program = game_->machine().program();
  const formats::ProgsDefinition* const definition = program.find_field(field_name);
  CHECK(definition != nullptr, "{}", field_name);
  return std::string(
      program.function_name(edict(number)[server::Field<vm::FunctionIndex>{definition->offset}]));
}

void PlayedLevel::put(server::Edict edict, const math::Vec3& origin) {
  edict.set(field::kOrigin, origin);
  check(server::link(world(), edict.index(), server::TouchTriggers::kYes), "put");
}

bool PlayedLevel::sees(std::uint32_t watcher, std::uint32_t other) {
  const auto eyes = [this](std::uint32_t number) {
    return edict(number)[field::kOrigin] + edict(number)[field::kViewOffset];
  };
  return !server::trace_move(world(), eyes(watcher), {}, {}, eyes(other), server::MoveKind::kNoMonsters,
                             edict(watcher).index())
              .hit;
}

std::uint32_t PlayedLevel::spawn(std::string_view name, const math::Vec3& origin, float yaw_deg) {
  const vm::EntityIndex index = world().edicts.spawn(time_s()).value();
  const std::pair<std::string_view, std::string> keys[] = {
      {"classname", std::string(name)},
      {"origin", fmt::format("{} {} {}", origin[0], origin[1], origin[2])},
      {"angles", fmt::format("0 {} 0", yaw_deg)}};
  for (const auto& [key, value] : keys) {
    const formats::ProgsDefinition* const definition = game_->machine().program().find_field(key);
    CHECK(definition != nullptr, "{}", key);
    const std::size_t words = formats::value_words(definition->type);
    check(server::set_value(game_->machine(), *definition, value,
                            world().edicts[index].words().subspan(definition->offset, words)),
          key);
  }
  game_->precache().is_open = true;
  call_function(name, index);
  game_->precache().is_open = false;
  return static_cast<std::uint32_t>(index);
}

bool PlayedLevel::has_room(const math::Vec3& origin, const math::Vec3& mins, const math::Vec3& maxs) {
  const math::Vec3 below = origin - math::Vec3(0, 0, 40);
  const server::EntityTrace down =
      server::trace_move(world(), origin, mins, maxs, below, server::MoveKind::kNormal, vm::kWorld);
  return !down.trace.start_solid && down.trace.fraction < 1;
}

void PlayedLevel::call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                       std::string_view doing) {
  check(world().calls.call(function, self, other, time_s()), doing);
}

void PlayedLevel::call_function(std::string_view name, vm::EntityIndex self, vm::EntityIndex other) {
  const vm::FunctionIndex function = game_->machine().program().find_function(name);
  CHECK(function != vm::kNoFunction, "{}", name);
  call(function, self, other, name);
}

void PlayedLevel::hurt(std::uint32_t number, std::uint32_t by, float damage) {
  vm::Machine& machine = game_->machine();
  machine.set_parameter_entity(0, vm::EntityIndex{number});
  machine.set_parameter_entity(1, vm::EntityIndex{by});
  machine.set_parameter_entity(2, vm::EntityIndex{by});
  machine.set_parameter_float(3, damage);
  call_function("hurt", vm::kWorld);
}

void PlayedLevel::use(std::uint32_t number, std::uint32_t by) {
  const formats::ProgsDefinition* const instigator = game_->machine().program().find_global("instigator");
  CHECK(instigator != nullptr);
  game_->machine().set_global_entity(vm::GlobalIndex{instigator->offset}, vm::EntityIndex{by});
  call(edict(number)[field::kUse], vm::EntityIndex{number}, vm::EntityIndex{by}, "use");
}

void PlayedLevel::touch(std::uint32_t number, std::uint32_t by) {
  call(edict(number)[field::kTouch], vm::EntityIndex{number}, vm::EntityIndex{by}, "touch");
}

}  // namespace temblor::test
