#include "server/test_world.h"

#include "base/hash.h"
#include "compiler/drafts.h"

namespace temblor::server {
namespace {

constexpr std::uint32_t kEntityWords = kSystemFieldWords + 5;

std::shared_ptr<const vm::Program> empty_program() {
  formats::Progs progs;
  progs.crc = formats::kQuakeProgsCrc;
  progs.statements.resize(1);
  progs.functions.resize(1);
  progs.strings = std::string(1, '\0');
  progs.global_words.resize(92);
  progs.entity_words = kEntityWords;
  return vm::Program::load(std::move(progs)).value();
}

// The words of a few entities do not move in memory when more are made, because tests keep their edicts.
vm::Machine machine_with_room() {
  constexpr std::uint32_t kRoom = 100;
  vm::Machine machine(empty_program());
  CHECK(machine.set_entity_count(kRoom).ok());
  CHECK(machine.set_entity_count(1).ok());
  return machine;
}

std::vector<ServerModel> list_models(const world::Level& level) {
  std::vector<ServerModel> models(1);
  for (std::size_t i = 0; i < level.models.size(); ++i)
    models.push_back({fmt::format("*{}", i), level.models[i].bounds, base::to_index<world::ModelIndex>(i)});
  return models;
}

}  // namespace

vm::FunctionIndex FakeCalls::add(Function function) {
  functions_.push_back(std::move(function));
  return base::to_index<vm::FunctionIndex>(functions_.size() - 1);
}

base::Status FakeCalls::call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                             double time_s) {
  if (function == vm::kNoFunction) return base::Ok{};
  if (function == failing) return base::malformed("the program failed");
  const Call call{function, self, other, time_s};
  if (keeps_log) log.push_back(call);
  if (base::to_size(function) < functions_.size()) functions_[base::to_size(function)](call);
  return base::Ok{};
}

int FakeCalls::count(vm::FunctionIndex function) const {
  int calls = 0;
  for (const Call& call : log) calls += call.function == function ? 1 : 0;
  return calls;
}

TestWorld::TestWorld(const std::string& map_text, std::uint32_t players)
    : TestWorld(test::make_level_of_brushes(test::parse_map(map_text)), players) {}

TestWorld::TestWorld(std::shared_ptr<const world::Level> level, std::uint32_t players)
    : machine(machine_with_room()),
      world{level, list_models(*level), Edicts(machine, players), Areas(level->world().bounds), calls} {
  world.time_s = 10;  // freed numbers are not reused at once
  const Edict ground = world.edicts.world();
  ground.set(field::kSolid, static_cast<float>(Solid::kBsp));
  ground.set(field::kMoveType, static_cast<float>(MoveType::kPush));
  ground.set(field::kModelIndex, 1);
}

Edict TestWorld::spawn(const math::Vec3& origin, const math::Bounds& box, Solid solid, MoveType type) {
  const vm::EntityIndex index = world.edicts.spawn(world.time_s).value();
  const Edict edict = world.edicts[index];
  edict.set(field::kOrigin, origin);
  edict.set(field::kMins, box.mins);
  edict.set(field::kMaxs, box.maxs);
  edict.set(field::kSize, box.maxs - box.mins);
  edict.set(field::kSolid, static_cast<float>(solid));
  edict.set(field::kMoveType, static_cast<float>(type));
  CHECK(link(world, index, TouchTriggers::kNo).ok());
  return edict;
}

Edict TestWorld::spawn_pusher(int number, const math::Vec3& velocity) {
  const ServerModel& model = world.models.at(static_cast<std::size_t>(number) + 1);
  const Edict edict = spawn({0, 0, 0}, model.box, Solid::kBsp, MoveType::kPush);
  edict.set(field::kModelIndex, static_cast<float>(number + 1));
  edict.set(field::kVelocity, velocity);
  edict.set(field::kNextThink, 1e6f);
  CHECK(link(world, edict.index(), TouchTriggers::kNo).ok());
  return edict;
}

Edict TestWorld::player(const math::Vec3& origin) {
  const Edict edict = world.edicts[vm::EntityIndex{1}];
  edict.set(field::kOrigin, origin);
  edict.set(field::kOldOrigin, origin);
  edict.set(field::kMins, kPlayerBox.mins);
  edict.set(field::kMaxs, kPlayerBox.maxs);
  edict.set(field::kSize, kPlayerBox.maxs - kPlayerBox.mins);
  edict.set(field::kSolid, static_cast<float>(Solid::kSlideBox));
  edict.set(field::kMoveType, static_cast<float>(MoveType::kWalk));
  edict.set(field::kViewOffset, {0, 0, 22});
  edict.set(field::kHealth, 100);
  edict.set(field::kFlags, static_cast<float>(flag::kClient));
  CHECK(link(world, edict.index(), TouchTriggers::kNo).ok());
  return edict;
}

base::Status TestWorld::try_tick() {
  constexpr bool kActive[] = {true, true, true, true};
  return run_physics(world, functions, std::span(kActive).first(world.edicts.client_count()), force_retouch);
}

void TestWorld::tick(int count) {
  for (int i = 0; i < count; ++i) {
    const base::Status status = try_tick();
    CHECK(status.ok(), "{}", status.error().message());
  }
}

void TestWorld::command_and_tick(const PlayerCommand& command, int count) {
  for (int i = 0; i < count; ++i) {
    move_player(world, vm::EntityIndex{1}, command);
    tick();
  }
}

std::string hall_text(const std::string& world_brushes, const std::string& entities) {
  return test::entity_text("worldspawn", "",
                           test::walls_text({-512, -512, 0}, {512, 512, 512}, "wall") + world_brushes) +
         entities;
}

std::string flooded_hall_text(double height) {
  return hall_text(test::box_text({-512, -512, 0}, {512, 512, height}, "*water"));
}

std::string door_text(const math::Vec3d& mins, const math::Vec3d& maxs) {
  return test::entity_text("func_door", "", test::box_text(mins, maxs, "wall"));
}

std::uint64_t compute_hash(GameWorld& io_world) {
  std::uint64_t hash = base::hash_with(0, io_world.edicts.count());
  for (std::uint32_t i = 0; i < io_world.edicts.count(); ++i) {
    hash = base::hash_with(hash, io_world.edicts.is_free(vm::EntityIndex{i}) ? 1 : 0);
    for (const std::uint32_t word : io_world.edicts[vm::EntityIndex{i}].words())
      hash = base::hash_with(hash, word);
  }
  return base::hash_with(hash, std::bit_cast<std::uint64_t>(io_world.time_s));
}

}  // namespace temblor::server
