// Game: set-up, ticks, and calls of QuakeC's functions for players. Bots are in game/bots.cpp.
#include "server/game.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/hash.h"
#include "builtins/script_files.h"
#include "server/game/server_models.h"

namespace temblor::server {
namespace {

// In nextthink and other times, 0 means never, as in stock Quake.
constexpr double kFirstTime_s = 1;
constexpr double kSettlingTick_s = 0.1;  // things fall to the floor before any player joins
constexpr int kSettlingTicks = 2;

}  // namespace

// Calls QuakeC, and restores its `self` and `other` afterward: calls nest, when a touch function moves
// something that touches something else. Remembers who was `self` in the first call that failed, because that
// entity's player may have caused the failure.
class Game::Calls final : public GameCalls {
 public:
  explicit Calls(vm::Machine& io_machine) : machine_(io_machine) {}

  base::Status call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                    double time_s) override {
    if (function == vm::kNoFunction) return base::Ok{};
    const vm::EntityIndex old_self = machine_.global_entity(global::kSelf);
    const vm::EntityIndex old_other = machine_.global_entity(global::kOther);
    machine_.set_global_entity(global::kSelf, self);
    machine_.set_global_entity(global::kOther, other);
    machine_.set_global_float(global::kTime, static_cast<float>(time_s));
    const base::Status status = machine_.call(function);
    if (!status.ok() && !failed_self_) failed_self_ = machine_.global_entity(global::kSelf);
    machine_.set_global_entity(global::kSelf, old_self);
    machine_.set_global_entity(global::kOther, old_other);
    return status;
  }

  std::optional<vm::EntityIndex> failed_self() const { return failed_self_; }

 private:
  vm::Machine& machine_;
  std::optional<vm::EntityIndex> failed_self_;  // `self` of the innermost call of the first failure
};

// The members refer to each other, so a Game is never moved. context_ gets functions instead of a pointer to
// the game, so that built-in functions can be tested without one.
Game::Game(GameSetup setup, GameServices services)
    : setup_(std::move(setup)),
      services_(std::move(services)),
      machine_(setup_.program, setup_.limits),
      calls_(std::make_unique<Calls>(machine_)),
      world_{.level = setup_.level,
             .models = make_level_models(*setup_.level, fmt::format("maps/{}.bsp", setup_.map_name)),
             .edicts = Edicts(machine_, setup_.max_clients),
             .areas = Areas(setup_.level->world().bounds),
             .calls = *calls_,
             .settings = setup_.settings,
             .time_s = kFirstTime_s,
             .tick_s = kSettlingTick_s,
             .gravity_field = float_field(*setup_.program, "gravity")},
      outbox_(setup_.dialect, setup_.max_clients),
      random_(setup_.seed),
      context_{
          .world = world_,
          .machine = machine_,
          .outbox = outbox_,
          .precache = precache_,
          .requests = requests_,
          .random = random_,
          .shared = {.variables = services_.io_variables,
                     .random = [this] { return random_.next_fraction(); },
                     .time_s = [this] { return world_.time_s; },
                     .files = builtins::ScriptFiles(
                         services_.data_folder,
                         [this](std::string_view name) { return services_.library.files().read(name); }),
                     .print = services_.print,
                     .find_pack =
                         [this](std::string_view file) { return services_.library.files().where(file); }},
          .light_styles = world::make_standard_light_styles(),
          .spawn_parameters = std::vector<SpawnParameters>(setup_.max_clients),
          .load_model = [this](std::string_view name) { return load_server_model(services_.library, name); },
          .client_command =
              [this](vm::EntityIndex player, std::string_view line) {
                if (requests_.player_commands.size() < Requests::kMaxPlayerCommands)
                  requests_.player_commands.push_back({player, std::string(line)});
              },
          .bot_services = bot_services(),
          .localization = setup_.localization.get()},
      mission_pack_(assets::find_mission_pack(services_.library.files())),
      items2_field_(float_field(*setup_.program, "items2")),
      look_fields_(*setup_.program),
      movement_field_(vector_field(*setup_.program, "movement")),
      client_colors_field_(float_field(*setup_.program, "clientcolors")) {
  add_builtins(machine_, context_);
  const auto field_index = [&](auto field) { return vm::FieldIndex{field.word}; };
  // For the STATE instruction, with which QuakeC's state functions set their frame and next think.
  machine_.set_state_fields({.self = global::kSelf,
                             .time = global::kTime,
                             .next_think = field_index(field::kNextThink),
                             .frame = field_index(field::kFrame),
                             .think = field_index(field::kThink)});
}

base::Result<std::unique_ptr<Game>> Game::prepare(GameSetup setup, GameServices services) {
  TRY_STATUS(check_system_definitions(*setup.program).with_file("progs.dat"));
  std::unique_ptr<Game> game(new Game(std::move(setup), std::move(services)));
  TRY_STATUS(game->set_up_world());
  return game;
}

base::Result<std::unique_ptr<Game>> Game::start(GameSetup setup, GameServices services) {
  TRY(std::unique_ptr<Game> game, prepare(std::move(setup), std::move(services)));
  TRY_STATUS(game->spawn_level());
  return game;
}

// Sets globals and fields that hold before QuakeC runs for the first time.
base::Status Game::set_up_world() {
  TRY(const vm::StringIndex map_name, machine_.make_string(setup_.map_name));
  machine_.set_global_string(global::kMapName, map_name);
  const auto as_float = [](bool value) { return value ? 1.0f : 0.0f; };
  machine_.set_global_float(global::kDeathmatch, as_float(setup_.kind == GameKind::kDeathmatch));
  machine_.set_global_float(global::kCoop, as_float(setup_.kind == GameKind::kCooperative));
  machine_.set_global_float(global::kServerFlags, setup_.server_flags);
  machine_.set_global_float(global::kFrameTime, static_cast<float>(world_.tick_s));

  const Edict world_edict = world_.edicts.world();
  TRY(const vm::StringIndex model_name, machine_.make_string(world_.models[1].name));
  world_edict.set(field::kModel, model_name);
  world_edict.set(field::kModelIndex, 1.0f);
  world_edict.set(field::kSolid, static_cast<float>(Solid::kBsp));
  world_edict.set(field::kMoveType, static_cast<float>(MoveType::kPush));
  return base::Ok{};
}

// Spawn functions may precache; nothing may afterward, because clients load the list as they join. The two
// ticks let items and monsters drop to the floor, so that baselines contain where they come to rest.
base::Status Game::spawn_level() {
  const world::SpawnRules rules{.skill = setup_.skill, .deathmatch = setup_.kind == GameKind::kDeathmatch};
  TRY(spawn_report_,
      spawn_entities(world_, machine_, setup_.level->entities, rules, [&] { mark_signon_end(); }));
  precache_.is_open = false;
  machine_.protect_world(true);
  for (int i = 0; i < kSettlingTicks; ++i) TRY_STATUS(tick({}));
  world_.tick_s = setup_.tick_s;
  take_baselines(world_, *setup_.program, outbox_, [&] { mark_signon_end(); });
  return base::Ok{};
}

// The signon is sent in several messages. It is split only here, so that what one call of QuakeC writes stays
// together.
void Game::mark_signon_end() {
  const std::size_t end = outbox_.signon().size();
  if (signon_ends_.empty() ? end > 0 : end > signon_ends_.back()) signon_ends_.push_back(end);
}

base::Status Game::call(vm::GlobalIndex function, vm::EntityIndex self) {
  return world_.calls.call(machine_.global_function(function), self, vm::kWorld, world_.time_s);
}

// Inputs are applied in slot order before any physics. At the end, while no QuakeC runs, the strings that
// nothing refers to any more are freed.
base::Status Game::tick(std::span<const PlayerInput> inputs) {
  context_.debug_shapes.drop_ended(world_.time_s);
  machine_.set_global_float(global::kFrameTime, static_cast<float>(world_.tick_s));
  for (std::size_t slot = 0; slot < setup_.max_clients; ++slot) {
    active_players_[slot] = bots_[slot] || (slot < inputs.size() && inputs[slot].is_active);
    if (bots_[slot])
      apply_bot_input(slot);
    else if (active_players_[slot])
      apply_input(slot, inputs[slot]);
  }
  const std::span<const bool> active = std::span(active_players_).first(setup_.max_clients);
  TRY_STATUS(run_physics(world_, tick_functions(), active,
                         machine_.global_words()[base::to_size(global::kForceRetouch)]));
  send_sounds();
  mark_signon_end();
  machine_.collect_strings();
  return base::Ok{};
}

// The sounds of this move go out with the next tick's messages.
base::Status Game::play_move(std::size_t slot, const PlayerInput& input) {
  machine_.set_global_float(global::kFrameTime, static_cast<float>(world_.tick_s));
  apply_input(slot, input);
  TRY_STATUS(run_player(world_, player_index(slot), tick_functions()));
  send_sounds();
  return base::Ok{};
}

TickFunctions Game::tick_functions() const {
  return {.start_frame = machine_.global_function(global::kStartFrame),
          .player_pre_think = machine_.global_function(global::kPlayerPreThink),
          .player_post_think = machine_.global_function(global::kPlayerPostThink)};
}

// Stores an impulse only if it is not 0: game code clears it when it has handled it, which may take several
// ticks. Stock clients have no button 1.
void Game::apply_input(std::size_t slot, const PlayerInput& input) {
  const Edict edict = player(slot);
  edict.set(field::kViewAngles, input.command.view_angles_deg);
  edict.set(field::kButton0, static_cast<float>(input.buttons & 1));
  edict.set(field::kButton2, static_cast<float>(input.buttons >> 1 & 1));
  if (input.impulse != 0) edict.set(field::kImpulse, static_cast<float>(input.impulse));
  if (movement_field_)
    edict.set(*movement_field_, math::Vec3(input.command.forward, input.command.side, input.command.up));
  move_player(world_, edict.index(), input.command);
}

std::string Game::localize(std::string_view text) const {
  return setup_.localization ? setup_.localization->localize(text) : std::string(text);
}

SpawnParameters Game::parameters() const {
  SpawnParameters parameters;
  for (int i = 0; i < global::kParmCount; ++i)
    parameters[static_cast<std::size_t>(i)] = machine_.global_float(parm(i));
  return parameters;
}

base::Result<SpawnParameters> Game::new_parameters() {
  TRY_STATUS(call(global::kSetNewParms, vm::kWorld));
  return parameters();
}

base::Result<SpawnParameters> Game::parameters_to_carry(std::size_t slot) {
  TRY_STATUS(call(global::kSetChangeParms, player_index(slot)));
  return parameters();
}

// The parameters are passed through the globals parm1 to parm16, as in stock Quake.
base::Status Game::spawn_client(std::size_t slot, const SpawnParameters& parameters, std::string_view name,
                                std::uint8_t colors) {
  const Edict edict = player(slot);
  unlink(world_, edict.index());
  std::fill(edict.words().begin(), edict.words().end(), 0u);
  edict.set(field::kColorMap, static_cast<float>(slot + 1));
  TRY_STATUS(set_player_look(slot, name, colors));
  context_.spawn_parameters[slot] = parameters;
  for (int i = 0; i < global::kParmCount; ++i)
    machine_.set_global_float(parm(i), parameters[static_cast<std::size_t>(i)]);
  TRY_STATUS(call(global::kClientConnect, edict.index()));
  return call(global::kPutClientInServer, edict.index());
}

base::Status Game::disconnect_client(std::size_t slot) {
  bots_[slot] = false;
  return call(global::kClientDisconnect, player_index(slot));
}

base::Status Game::kill(std::size_t slot) {
  return call(global::kClientKill, player_index(slot));
}

// Teams are numbered from 1: the color of the pants, plus one.
base::Status Game::set_player_look(std::size_t slot, std::string_view name, std::uint8_t colors) {
  const Edict edict = player(slot);
  TRY(const vm::StringIndex made, machine_.make_string(name));
  edict.set(field::kNetName, made);
  edict.set(field::kTeam, static_cast<float>((colors & 15) + 1));
  return base::Ok{};
}

// Saved games have one player, in slot 0.
void Game::restore_environment(const world::LightStylePatterns& styles, const SpawnParameters& parameters) {
  context_.light_styles = styles;
  context_.spawn_parameters[0] = parameters;
}

void Game::send_sounds() {
  for (const PhysicsSound& sound : world_.sounds) send_sound(sound);
  world_.sounds.clear();
}

// Plays a sound with the default volume and attenuation of QuakeC's sound(), from the middle of the entity.
void Game::send_sound(const PhysicsSound& sound) {
  const auto& names = precache_.sounds;
  const auto found = std::find(names.begin(), names.end(), sound.name);
  if (found == names.end()) return;  // game code that wants this sound precaches it
  const Edict edict = world_.edicts[sound.entity];
  const math::Vec3 middle = edict[field::kOrigin] + (edict[field::kMins] + edict[field::kMaxs]) * 0.5f;
  outbox_.write_sound({.entity = static_cast<std::uint16_t>(base::to_size(sound.entity)),
                       .sound = static_cast<std::uint16_t>(found - names.begin()),
                       .origin = middle});
}

Game::~Game() = default;

// A failure in a monster's think function is nobody's fault, even if a player woke the monster.
std::optional<std::size_t> Game::blamed_player() const {
  const std::optional<vm::EntityIndex> self = calls_->failed_self();
  if (!self || !world_.edicts.is_client(*self)) return std::nullopt;
  return base::to_size(*self) - 1;
}

// Covers globals, all entities' words (also those of free ones), which entities are free, time, and random
// numbers. It leaves out links, leaves and messages, which follow from them. Strings count by number only.
std::uint64_t Game::state_hash(std::vector<std::uint32_t>* out_entities) const {
  if (out_entities != nullptr) out_entities->clear();
  std::uint64_t hash = base::hash_bytes_fast(std::as_bytes(machine_.global_words()));
  for (std::uint32_t i = 0; i < machine_.entity_count(); ++i) {
    const vm::EntityIndex index{i};
    const std::uint64_t entity = base::hash_with(base::hash_bytes_fast(std::as_bytes(machine_.entity(index))),
                                                 world_.edicts.state(index).is_free);
    if (out_entities != nullptr) out_entities->push_back(static_cast<std::uint32_t>(entity));
    hash = base::hash_with(hash, entity);
  }
  const std::array<std::uint64_t, 2> rest = {std::bit_cast<std::uint64_t>(world_.time_s), random_.state()};
  return base::hash_with_bytes(hash, std::as_bytes(std::span(rest)));
}

}  // namespace temblor::server
