#include "bench/client_server/crowd.h"

#include <algorithm>

#include "server/move_trace.h"
#include "support/random.h"

namespace temblor::bench {

std::vector<vm::EntityIndex> list_monsters(server::GameWorld& world) {
  std::vector<vm::EntityIndex> monsters;
  for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
    const vm::EntityIndex index{i};
    if (!world.edicts.is_free(index) && world.edicts[index].has_flag(server::flag::kMonster))
      monsters.push_back(index);
  }
  return monsters;
}

base::Status add_monsters(std::size_t count, server::Game& io_game) {
  server::GameWorld& world = io_game.world();
  const std::vector<vm::EntityIndex> own = list_monsters(world);
  test::Random random(5);
  std::size_t added = own.size();
  for (int attempt = 0; !own.empty() && added < count && attempt < 200'000; ++attempt) {
    const server::Edict model = world.edicts[own[random.below(own.size())]];
    const math::Vec3 from = model[server::field::kOrigin];
    const math::Vec3 place =
        server::trace_move(world, from, model[server::field::kMins], model[server::field::kMaxs],
                           from + random.in_cube(500) * math::Vec3{1, 1, 0}, server::MoveKind::kNoMonsters,
                           model.index())
            .trace.end;
    TRY(const vm::EntityIndex copy, world.edicts.spawn(world.time_s));
    const server::Edict edict = world.edicts[copy];
    const auto words = world.edicts[model.index()].words();
    std::copy(words.begin(), words.end(), edict.words().begin());
    edict.set(server::field::kOrigin, place);
    if (server::is_stuck(world, copy)) {
      world.edicts.free(copy, 0);  // long ago: the next one takes its place
      continue;
    }
    TRY_STATUS(server::link(world, copy, server::TouchTriggers::kNo));
    ++added;
  }
  return base::Ok{};
}

base::Status set_upon_player(server::Game& io_game) {
  server::GameWorld& world = io_game.world();
  const vm::FunctionIndex hunt = io_game.machine().program().find_function("start_hunt");
  if (hunt == vm::kNoFunction)
    return base::error(base::ErrorCode::kUnsupported, "the program has no start_hunt()");
  const server::Edict player = io_game.player(0);
  player.set_flag(server::flag::kGodMode);
  for (const vm::EntityIndex monster : list_monsters(world)) {
    world.edicts[monster].set(server::field::kEnemy, player.index());
    TRY_STATUS(world.calls.call(hunt, monster, vm::EntityIndex{0}, world.time_s));
  }
  return base::Ok{};
}

}  // namespace temblor::bench
