#include "scripted_player/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "scripted_player/decisions/monster_watch.h"
#include "scripted_player/decisions/pick.h"
#include "server/system_globals.h"

namespace temblor::player {
namespace {

constexpr double kSettle_s = 1.0;
constexpr double kEpilogue_s = 3;
constexpr double kTellEvery_s = 5, kAskForGodEvery_s = 1;
constexpr double kLookAtMonstersEvery_s = 0.25;

class Run {
 public:
  explicit Run(const RunSetup& setup) : setup_(setup) {}

  base::Result<RunReport> play() {
    TRY(session_, Session::start(setup_.session));
    if (setup_.has_god)
      for (std::size_t i = 0; i < session_->player_count(); ++i) session_->client(i).send_command("god");
    moves_.resize(session_->player_count());
    turns_.resize(session_->player_count());
    began_s_ = session_->now_s();
    report_.is_deathmatch = is_deathmatch();
    while (session_->now_s() - began_s_ < kSettle_s && session_->has_game()) step();
    if (!session_->has_game()) return failed();
    map_name_ = session_->game().setup().map_name;
    map_ = LevelMap::make(session_->game());
    report_.places = map_->graph.places().size();
    report_.ways = map_->graph.ways();
    if (setup_.lists_places) list_places();
    make_brains();
    monsters_.emplace(session_->game());
    play_on();
    finish();
    return std::move(report_);
  }

 private:
  void make_brains() {
    for (std::size_t i = 0; i < session_->player_count(); ++i)
      brains_.push_back(std::make_unique<Brain>(*map_, session_->game(),
                                                BrainSetup{.seed = setup_.session.seed * 1000 + i,
                                                           .slot = session_->slot_of(i),
                                                           .visits_secrets = setup_.visits_secrets,
                                                           .fights = setup_.fights,
                                                           .fights_players = is_deathmatch(),
                                                           .visits_stops = setup_.visits_stops,
                                                           .roams = is_deathmatch(),
                                                           .waypoints = setup_.waypoints,
                                                           .exit_map = setup_.exit_map}));
  }

  void list_places() {
    for (const Place& place : map_->graph.places())
      report_.place_list += fmt::format(
          "{:.0f} {:.0f} {:.0f} {}\n", place.at.x, place.at.y, place.at.z,
          place.swims ? "water"
          : place.mover < 0
              ? "floor"
              : fmt::format("{} state {}", map_->facts.movers[static_cast<std::size_t>(place.mover)].describe,
                            place.state));
  }

  RunReport failed() {
    report_.errors.push_back(session_->console());
    return report_;
  }

  bool is_deathmatch() const { return setup_.session.bots > 0; }
  double played_s() const { return session_->now_s() - began_s_; }

  void step() { session_->step(moves_); }

  void play_on() {
    server::Game* last = &session_->game();
    double told_s = 0, looked_s = 0;
    while (played_s() < setup_.limit_s) {
      if (!session_->has_game()) {
        report_.errors.push_back(session_->console());
        return;
      }
      server::Game& game = session_->game();
      if (&game != last) {
        if (game.setup().map_name != map_name_) {
          report_.reached_exit = true;
          report_.exit = game.setup().map_name;
          return;
        }
        last = &game;
        for (auto& brain : brains_) brain->begin_again(game);
        monsters_.emplace(game);
      }
      if (is_over()) {
        report_.reached_exit = true;
        return;
      }
      count();
      keep_gods();
      if (played_s() - looked_s > kLookAtMonstersEvery_s) {
        looked_s = played_s();
        monsters_->look(game, looked_s);
      }
      think();
      if (setup_.tell && played_s() - told_s > kTellEvery_s) {
        told_s = played_s();
        tell();
      }
      if (std::all_of(brains_.begin(), brains_.end(), [](const auto& b) { return b->has_given_up(); }))
        return;
      step();
    }
    if (is_deathmatch()) return;
    report_.complaints.push_back(fmt::format("no exit was reached in {:.0f} s", setup_.limit_s));
    for (const auto& brain : brains_) report_.complaints.push_back(brain->describe());
  }

  // Again after each death; the command turns it on and off.
  void keep_gods() {
    if (!setup_.has_god || played_s() - asked_for_god_s_ < kAskForGodEvery_s) return;
    asked_for_god_s_ = played_s();
    for (std::size_t i = 0; i < session_->player_count(); ++i) {
      const server::Edict player = session_->game().player(session_->slot_of(i));
      if (session_->client(i).is_playing() && player[server::field::kHealth] > 0 &&
          !player.has_flag(server::flag::kGodMode))
        session_->client(i).send_command("god");
    }
  }

  void think() {
    for (std::size_t i = 0; i < brains_.size(); ++i) {
      const client::Game& seen = session_->client(i).state().game();
      std::optional<math::Vec3> turned;
      if (seen.turns != turns_[i]) turned = seen.set_angles_deg;
      turns_[i] = seen.turns;
      moves_[i] = session_->client(i).is_playing()
                      ? brains_[i]->think(session_->game(), turned, session_->now_s())
                      : net::Move{};
      if (brains_[i]->wants_to_begin_again()) session_->client(i).send_command("kill");
    }
  }

  void tell() {
    for (std::size_t i = 0; i < brains_.size(); ++i) {
      const Self self = feel_self(session_->game(), session_->slot_of(i));
      setup_.tell(fmt::format("{:5.0f} s  {:5.0f} {:5.0f} {:5.0f}  health {:3.0f}  {}", played_s(),
                              self.origin.x, self.origin.y, self.origin.z, self.health,
                              brains_[i]->describe()));
    }
  }

  // Somebody has touched an exit, wherever it leads, or what ends a game has come.
  bool is_over() {
    server::Game& game = session_->game();
    for (const Trigger& trigger : map_->facts.triggers) {
      if (trigger.kind != TriggerKind::kExit || !server::is_there(game.world(), trigger.entity)) continue;
      const vm::FunctionIndex touch = game.world().edicts[trigger.entity][server::field::kTouch];
      if (touch != vm::kNoFunction && game.machine().program().name_of(touch) != "nothing") continue;
      report_.exit = trigger.map;
      return true;
    }
    return session_->client(0).state().game().ending != client::Ending::kNone;
  }

  bool is_in_level() const { return session_->has_game() && session_->game().setup().map_name == map_name_; }

  void count() {
    const vm::Machine& machine = session_->game().machine();
    const auto whole = [&](vm::GlobalIndex i) { return static_cast<int>(machine.global_float(i)); };
    report_.kills = whole(server::global::kKilledMonsters);
    report_.monsters = whole(server::global::kTotalMonsters);
    report_.found_secrets = whole(server::global::kFoundSecrets);
    report_.secrets = whole(server::global::kTotalSecrets);
    report_.frags = static_cast<int>(session_->game().player(session_->slot_of(0))[server::field::kFrags]);
  }

  void finish() {
    report_.time_s = played_s();
    for (auto& brain : brains_) {
      for (const std::string& text : brain->deaths()) report_.deaths.push_back(text);
      for (const std::string& text : brain->complaints()) report_.complaints.push_back(text);
    }
    report_.stuck_monsters = monsters_->stuck();
    report_.idle_monsters = monsters_->idle();
    if (is_in_level()) {
      note_doors();
      note_items();
      report_.state_hash = session_->game().state_hash();
    }
    // The scores stay a moment at a recording's end. An exit without scores leads on at once.
    for (auto& move : moves_) move.buttons = 0;
    if (setup_.records) {
      for (const double until_s = session_->now_s() + kEpilogue_s;
           session_->now_s() < until_s && report_.reached_exit && is_in_level();)
        session_->step(moves_);
      if (auto bytes = session_->client(0).finish_recording()) report_.recording = std::move(*bytes);
    }
  }

  void note_doors() {
    for (std::size_t i = 0; i < map_->facts.movers.size(); ++i) {
      const Mover& mover = map_->facts.movers[i];
      if (mover.kind != MoverKind::kDoor && mover.kind != MoverKind::kSecretDoor) continue;
      if (!brains_.empty() && std::none_of(brains_.begin(), brains_.end(), [&](const auto& brain) {
            return brain->saw_open(static_cast<int>(i));
          }))
        report_.closed_doors.push_back(mover.describe);
    }
  }

  void note_items() {
    server::GameWorld& world = session_->game().world();
    for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
      const vm::EntityIndex entity{i};
      if (world.edicts.is_free(entity)) continue;
      const server::Edict edict = world.edicts[entity];
      if (!lies_ready(edict)) continue;
      if (map_->graph.touching(box_of(edict), 12).empty())
        report_.unreached_items.push_back(describe(session_->game(), entity));
    }
  }

  const RunSetup& setup_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<const LevelMap> map_;
  std::vector<std::unique_ptr<Brain>> brains_;
  std::optional<MonsterWatch> monsters_;
  std::vector<net::Move> moves_;
  std::vector<std::uint32_t> turns_;
  RunReport report_;
  std::string map_name_;
  double began_s_ = 0, asked_for_god_s_ = 0;
};

}  // namespace

base::Result<RunReport> play_level(const RunSetup& setup) {
  return Run(setup).play();
}

}  // namespace temblor::player
