#include "game/played_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "server/move_trace.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

namespace field = server::field;
namespace global = server::global;

std::shared_ptr<const vm::Program> load_program(const std::filesystem::path& path) {
  return vm::Program::load(formats::read_progs(read_file(path)).value()).value();
}

assets::Library open_library(const std::filesystem::path& data) {
  return assets::Library(vfs::FileSystem::open(data).value());
}

std::vector<server::ServerModel> models_of(const world::Level& level, std::string_view map) {
  std::vector<server::ServerModel> models(1);
  models.push_back({.name = fmt::format("maps/{}.bsp", map),
                    .box = level.world().bounds,
                    .brush_model = world::ModelIndex{0}});
  for (std::uint32_t i = 1; i < level.models.size(); ++i)
    models.push_back(
        {.name = fmt::format("*{}", i), .box = level.models[i].bounds, .brush_model = world::ModelIndex{i}});
  return models;
}

math::Vec3 vector_of(std::string_view text) {
  math::Vec3 v(0.0f);
  std::string copy(text);
  char* at = copy.data();
  for (int axis = 0; axis < 3; ++axis) v[axis] = std::strtof(at, &at);
  return v;
}

// The only escape that levels have.
std::string with_line_ends(std::string_view value) {
  std::string text;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const bool is_line_end = value[i] == '\\' && i + 1 < value.size() && value[i + 1] == 'n';
    text += is_line_end ? '\n' : value[i];
    if (is_line_end) ++i;
  }
  return text;
}

}  // namespace

PlayedLevel::PlayedLevel(const std::filesystem::path& data, std::string_view map,
                         const std::filesystem::path& progs, const PlayedSettings& settings)
    : library_(open_library(data)),
      level_(library_.level(fmt::format("maps/{}.bsp", map)).value().level),
      program_(load_program(progs)),
      machine_(program_),
      world_{.level = level_,
             .models = models_of(*level_, map),
             .edicts = server::Edicts(machine_, settings.players),
             .areas = server::Areas(level_->world().bounds),
             .calls = *this},
      outbox_({}, settings.players),
      context_{.world = world_,
               .machine = machine_,
               .outbox = outbox_,
               .precache = precache_,
               .requests = requests_,
               .random = random_,
               .variables = variables_},
      commands_(settings.players),
      active_(settings.players) {
  context_.print = [this](std::string_view text) { printed_ += text; };
  context_.load_model = [this](std::string_view name) -> base::Result<server::ServerModel> {
    if (name.ends_with(".bsp")) {
      TRY(const assets::LoadedLevel loaded, library_.level(name));
      return server::ServerModel{.name = std::string(name), .box = loaded.level->world().bounds};
    }
    TRY(const base::ByteVector bytes, library_.files().read(name));
    return server::ServerModel{.name = std::string(name), .box = {math::Vec3(-16.0f), math::Vec3(16.0f)}};
  };
  add_variables(settings);
  server::add_builtins(machine_, context_);
  machine_.set_global_string(global::kMapName, machine_.strings().zone(map).value());
  machine_.set_global_float(global::kDeathmatch, settings.deathmatch);
  machine_.set_global_float(global::kCoop, settings.coop);
  context_.spawn_parameters.resize(settings.players);
  spawn_entities(settings);
  precache_.is_open = false;
  tick();
  tick();
}

void PlayedLevel::add_variables(const PlayedSettings& settings) {
  const auto add = [&](std::string_view name, float value) {
    variables_.add_float(name, value, -1e6, 1e6, "Of the game.");
  };
  add("skill", settings.skill);
  add("deathmatch", settings.deathmatch);
  add("coop", settings.coop);
  for (const char* name : {"teamplay", "samelevel", "noexit", "timelimit", "fraglimit", "registered"})
    add(name, 0);
  add("developer", 1);
  add("sv_gravity", 800);
  add("sv_aim", 0.93f);
}

base::Status PlayedLevel::call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                               double time_s) {
  if (function == vm::kNoFunction) return base::Ok{};
  const vm::EntityIndex old_self = machine_.global_entity(global::kSelf);
  const vm::EntityIndex old_other = machine_.global_entity(global::kOther);
  machine_.set_global_entity(global::kSelf, self);
  machine_.set_global_entity(global::kOther, other);
  machine_.set_global_float(global::kTime, static_cast<float>(time_s));
  machine_.set_global_float(global::kFrameTime, static_cast<float>(world_.tick_s));
  const base::Status status = machine_.call(function);
  machine_.set_global_entity(global::kSelf, old_self);
  machine_.set_global_entity(global::kOther, old_other);
  return status;
}

void PlayedLevel::check(const base::Status& status, std::string_view doing) {
  if (status.ok()) return;
  errors_.push_back(fmt::format("{}: {}\n{}", doing, status.error().message(),
                                machine_.describe(machine_.failure_trace())));
}

void PlayedLevel::set_key(server::Edict edict, std::string_view key, std::string_view value) {
  std::string angles;
  if (key == "angle") {
    angles = fmt::format("0 {} 0", value);
    key = "angles";
    value = angles;
  }
  if (key == "light") key = "light_lev";
  const formats::ProgsDefinition* const definition = program_->find_field(key);
  if (definition == nullptr) return;
  const auto word = definition->offset;
  switch (definition->type) {
    case formats::ProgsType::kFloat:
      edict.set(server::Field<float>{word}, std::strtof(std::string(value).c_str(), nullptr));
      break;
    case formats::ProgsType::kVector:
      edict.set(server::Field<math::Vec3>{word}, vector_of(value));
      break;
    case formats::ProgsType::kString: {
      const std::string text = with_line_ends(value);
      edict.set(server::Field<vm::StringIndex>{word}, machine_.strings().zone(text).value());
      break;
    }
    case formats::ProgsType::kFunction:
      edict.set(server::Field<vm::FunctionIndex>{word}, program_->find_function(value));
      break;
    default:
      break;
  }
}

void PlayedLevel::spawn_entity(const formats::Entity& keys, vm::EntityIndex index) {
  for (const auto& [key, value] : keys.pairs)
    if (!key.starts_with('_')) set_key(world_.edicts[index], key, value);
  const vm::FunctionIndex function = program_->find_function(keys.classname());
  if (function == vm::kNoFunction) {
    errors_.push_back(fmt::format("no spawn function: {}", keys.classname()));
    server::remove(world_, index);
    return;
  }
  check(call(function, index, vm::kWorld, world_.time_s), keys.classname());
}

void PlayedLevel::spawn_entities(const PlayedSettings& settings) {
  const std::vector<formats::Entity> all = level_->entities;
  const server::Edict world = world_.edicts.world();
  world.set(field::kModel, machine_.strings().zone(world_.models[1].name).value());
  world.set(field::kModelIndex, 1);
  world.set(field::kSolid, static_cast<float>(server::Solid::kBsp));
  world.set(field::kMoveType, static_cast<float>(server::MoveType::kPush));
  const int filter = settings.deathmatch != 0 ? 2048
                     : settings.skill < 1     ? 256
                     : settings.skill < 2     ? 512
                                              : 1024;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (static_cast<int>(all[i].find_number("spawnflags").value_or(0)) & filter) continue;
    spawn_entity(all[i], i == 0 ? vm::kWorld : world_.edicts.spawn(world_.time_s).value());
  }
}

void PlayedLevel::join(std::uint32_t slot) {
  const vm::EntityIndex index{slot + 1};
  const server::Edict edict = world_.edicts[index];
  edict.set(field::kColorMap, static_cast<float>(slot + 1));
  edict.set(field::kNetName, machine_.strings().zone(fmt::format("player{}", slot)).value());
  check(call(system_function(global::kSetNewParms), vm::kWorld, vm::kWorld, world_.time_s), "SetNewParms");
  for (int i = 0; i < global::kParmCount; ++i)
    context_.spawn_parameters[slot][static_cast<std::size_t>(i)] = machine_.global_float(server::parm(i));
  check(call(system_function(global::kClientConnect), index, vm::kWorld, world_.time_s), "ClientConnect");
  check(call(system_function(global::kPutClientInServer), index, vm::kWorld, world_.time_s),
        "PutClientInServer");
  check(server::link(world_, index, server::TouchTriggers::kNo), "link");
  active_[slot] = true;
}

void PlayedLevel::tick() {
  for (std::uint32_t slot = 0; slot < active_.size(); ++slot)
    if (active_[slot]) server::move_player(world_, vm::EntityIndex{slot + 1}, commands_[slot]);
  const std::unique_ptr<bool[]> active(new bool[active_.size()]);
  std::copy(active_.begin(), active_.end(), active.get());
  const server::TickFunctions functions{system_function(global::kStartFrame),
                                        system_function(global::kPlayerPreThink),
                                        system_function(global::kPlayerPostThink)};
  std::uint32_t& force_retouch = machine_.global_words()[static_cast<std::uint32_t>(global::kForceRetouch)];
  check(server::run_physics(world_, functions, {active.get(), active_.size()}, force_retouch), "tick");
  const base::Bytes said = outbox_.reliable().view();
  said_.append(reinterpret_cast<const char*>(said.data()), said.size());
  outbox_.clear_tick();
  world_.sounds.clear();
}

void PlayedLevel::run(double seconds) {
  const double end = world_.time_s + seconds;
  while (world_.time_s < end && errors_.size() < 20) tick();
}

std::vector<std::uint32_t> PlayedLevel::of_class(std::string_view name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 1; i < edict_count(); ++i)
    if (!is_free(i) && text(edict(i)[field::kClassName]) == name) found.push_back(i);
  return found;
}

float PlayedLevel::global(std::string_view name) const {
  const formats::ProgsDefinition* const definition = program_->find_global(name);
  CHECK(definition != nullptr, "{}", name);
  return machine_.global_float(vm::GlobalIndex{definition->offset});
}

float PlayedLevel::edict_number(std::uint32_t number, std::string_view field_name) {
  const formats::ProgsDefinition* const definition = program_->find_field(field_name);
  CHECK(definition != nullptr, "{}", field_name);
  return edict(number)[server::Field<float>{definition->offset}];
}

void PlayedLevel::put(server::Edict edict, const math::Vec3& origin) {
  edict.set(field::kOrigin, origin);
  check(server::link(world_, edict.index(), server::TouchTriggers::kYes), "put");
}

std::uint32_t PlayedLevel::spawn(std::string_view name, const math::Vec3& origin, float yaw_deg) {
  precache_.is_open = true;
  const vm::EntityIndex index = world_.edicts.spawn(world_.time_s).value();
  formats::Entity keys;
  keys.pairs = {{"classname", std::string(name)},
                {"origin", fmt::format("{} {} {}", origin[0], origin[1], origin[2])},
                {"angle", fmt::format("{}", yaw_deg)}};
  spawn_entity(keys, index);
  precache_.is_open = false;
  return static_cast<std::uint32_t>(index);
}

bool PlayedLevel::has_room(const math::Vec3& origin, const math::Vec3& mins, const math::Vec3& maxs) {
  const math::Vec3 below = origin - math::Vec3(0, 0, 40);
  const server::EntityTrace down =
      server::trace_move(world_, origin, mins, maxs, below, server::MoveKind::kNormal, vm::kWorld);
  return !down.trace.start_solid && down.trace.fraction < 1;
}

void PlayedLevel::call_function(std::string_view name, vm::EntityIndex self, vm::EntityIndex other) {
  check(call(program_->find_function(name), self, other, world_.time_s), name);
}

void PlayedLevel::hurt(std::uint32_t number, std::uint32_t by, float damage) {
  machine_.set_parameter_entity(0, vm::EntityIndex{number});
  machine_.set_parameter_entity(1, vm::EntityIndex{by});
  machine_.set_parameter_entity(2, vm::EntityIndex{by});
  machine_.set_parameter_float(3, damage);
  call_function("hurt", vm::kWorld);
}

void PlayedLevel::use(std::uint32_t number, std::uint32_t by) {
  const formats::ProgsDefinition* const instigator = program_->find_global("instigator");
  machine_.set_global_entity(vm::GlobalIndex{instigator->offset}, vm::EntityIndex{by});
  check(call(edict(number)[field::kUse], vm::EntityIndex{number}, vm::EntityIndex{by}, world_.time_s), "use");
}

std::vector<std::uint32_t> PlayedLevel::all_words() {
  std::vector<std::uint32_t> words;
  for (std::uint32_t i = 0; i < edict_count(); ++i) {
    const auto of_one = edict(i).words();
    words.insert(words.end(), of_one.begin(), of_one.end());
  }
  return words;
}

void PlayedLevel::touch(std::uint32_t number, std::uint32_t by) {
  check(call(edict(number)[field::kTouch], vm::EntityIndex{number}, vm::EntityIndex{by}, world_.time_s),
        "touch");
}

}  // namespace temblor::test
