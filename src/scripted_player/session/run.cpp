#include "scripted_player/session/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "scripted_player/decisions/choose_item.h"
#include "scripted_player/decisions/monster_watch.h"
#include "server/system_globals.h"

namespace temblor::player {
namespace {

// Before the map of the level is made: doors link, and players fall to the floor.
constexpr double kRunSettle_s = 1.0;
// A demo ends this long after the exit.
constexpr double kEpilogue_s = 3;
constexpr double kStatusEvery_s = 5, kGodModeEvery_s = 1;
constexpr double kLookAtMonstersEvery_s = 0.25;

// One run, from the start of the session to the report.
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
    while (session_->now_s() - began_s_ < kRunSettle_s && session_->has_game()) step();
    if (!session_->has_game()) return failed();
    map_name_ = session_->game().setup().map_name;
    map_ = LevelMap::make(session_->game(), setup_.graphs);
    report_.places = map_->graph.places().size();
    report_.links = map_->graph.link_count();
    if (setup_.lists_places) list_places();
    make_brains();
    monsters_.emplace(session_->game());
    play_to_end();
    finish();
    return std::move(report_);
  }

 private:
  void make_brains() {
    for (std::size_t i = 0; i < session_->player_count(); ++i)
      brains_.push_back(std::make_unique<Brain>(*map_, session_->game(),
                                                BrainSetup{.seed = setup_.session.seed * 1000 + i,
                                                           .slot = session_->slot(i),
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
      report_.place_list +=
          fmt::format("{:.0f} {:.0f} {:.0f} {}\n", place.at.x, place.at.y, place.at.z,
                      place.swims ? "water"
                      : place.mover < 0
                          ? "floor"
                          : fmt::format("{} state {}",
                                        map_->facts.movers[static_cast<std::size_t>(place.mover)].description,
                                        place.state));
  }

  RunReport failed() {
    report_.errors.push_back(session_->console());
    return report_;
  }

  bool is_deathmatch() const { return setup_.session.bots > 0; }
  double played_s() const { return session_->now_s() - began_s_; }

  void step() {
    if (setup_.place_camera && session_->has_game())
      session_->server().camera_world =
          setup_.place_camera(session_->game().time_s() + kTick_s,
                              session_->game().player(session_->slot(0))[server::field::kOrigin]);
    session_->step(moves_);
  }

  // Plays until an exit, the limit, an error of the game code, or until every player has given up. A level
  // that restarts is a new server::Game with the same map name; a different name means that an exit was
  // taken.
  void play_to_end() {
    server::Game* last = &session_->game();
    double status_s = 0, looked_s = 0;
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
        for (auto& brain : brains_) brain->restart(game);
        monsters_.emplace(game);
      }
      if (is_over()) {
        report_.reached_exit = true;
        return;
      }
      count();
      renew_god_mode();
      if (played_s() - looked_s > kLookAtMonstersEvery_s) {
        looked_s = played_s();
        monsters_->look(game, looked_s);
      }
      think();
      if (setup_.on_status && played_s() - status_s > kStatusEvery_s) {
        status_s = played_s();
        report_status();
      }
      if (std::all_of(brains_.begin(), brains_.end(), [](const auto& b) { return b->has_given_up(); }))
        return;
      step();
    }
    if (is_deathmatch()) return;
    report_.problems.push_back(fmt::format("no exit reached within {:.0f} s", setup_.limit_s));
    for (const auto& brain : brains_) report_.problems.push_back(brain->describe());
  }

  // Turns god mode on again after each death. "god" is a toggle, so the flag must be checked first.
  void renew_god_mode() {
    if (!setup_.has_god || played_s() - renewed_god_s_ < kGodModeEvery_s) return;
    renewed_god_s_ = played_s();
    for (std::size_t i = 0; i < session_->player_count(); ++i) {
      const server::Edict player = session_->game().player(session_->slot(i));
      if (session_->client(i).is_playing() && player[server::field::kHealth] > 0 &&
          !player.has_flag(server::flag::kGodMode))
        session_->client(i).send_command("god");
    }
  }

  // Lets each brain choose its move. A view that the server has set, such as after a teleport, is passed on
  // once.
  void think() {
    for (std::size_t i = 0; i < brains_.size(); ++i) {
      const client::Game& seen = session_->client(i).state().game();
      std::optional<math::Vec3> turned;
      if (seen.turns != turns_[i]) turned = seen.set_angles_deg;
      turns_[i] = seen.turns;
      moves_[i] = session_->client(i).is_playing()
                      ? brains_[i]->think(session_->game(), turned, session_->now_s())
                      : net::Move{};
      if (brains_[i]->wants_restart()) session_->client(i).send_command("kill");
    }
  }

  void report_status() {
    for (std::size_t i = 0; i < brains_.size(); ++i) {
      const Self self = read_self(session_->game(), session_->slot(i));
      setup_.on_status(fmt::format("{:5.0f} s  {:5.0f} {:5.0f} {:5.0f}  health {:3.0f}  {}", played_s(),
                                   self.origin.x, self.origin.y, self.origin.z, self.health,
                                   brains_[i]->describe()));
    }
  }

  // Returns whether a player has touched an exit (game code then clears its touch function) or the game shows
  // its ending.
  bool is_over() {
    server::Game& game = session_->game();
    for (const Trigger& trigger : map_->facts.triggers) {
      if (trigger.kind != TriggerKind::kExit || !server::is_there(game.world(), trigger.entity)) continue;
      const vm::FunctionIndex touch = game.world().edicts[trigger.entity][server::field::kTouch];
      if (touch != vm::kNoFunction && game.machine().program().function_name(touch) != "nothing") continue;
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
    report_.frags = static_cast<int>(session_->game().player(session_->slot(0))[server::field::kFrags]);
  }

  void finish() {
    report_.time_s = played_s();
    for (auto& brain : brains_) {
      for (const std::string& text : brain->deaths()) report_.deaths.push_back(text);
      for (const std::string& text : brain->problems()) report_.problems.push_back(text);
    }
    report_.stuck_monsters = monsters_->stuck();
    report_.idle_monsters = monsters_->idle();
    if (is_in_level()) {
      list_closed_doors();
      list_unreached_items();
      report_.state_hash = session_->game().state_hash();
    }
    // Let the demo show the scores for a moment. An exit without scores loads the next level at once.
    for (auto& move : moves_) move.buttons = 0;
    if (setup_.session.records) {
      for (const double until_s = session_->now_s() + kEpilogue_s;
           session_->now_s() < until_s && report_.reached_exit && is_in_level();)
        session_->step(moves_);
      if (auto bytes = session_->client(0).finish_recording()) report_.demo = std::move(*bytes);
    }
  }

  // Lists the doors that no player has seen open.
  void list_closed_doors() {
    for (std::size_t i = 0; i < map_->facts.movers.size(); ++i) {
      const Mover& mover = map_->facts.movers[i];
      if (mover.kind != MoverKind::kDoor && mover.kind != MoverKind::kSecretDoor) continue;
      if (!brains_.empty() && std::none_of(brains_.begin(), brains_.end(), [&](const auto& brain) {
            return brain->saw_open(static_cast<int>(i));
          }))
        report_.closed_doors.push_back(mover.description);
    }
  }

  // Lists the items that no place touches, with some slack for items at the edge of a shelf.
  void list_unreached_items() {
    server::GameWorld& world = session_->game().world();
    for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
      const vm::EntityIndex entity{i};
      if (world.edicts.is_free(entity)) continue;
      const server::Edict edict = world.edicts[entity];
      if (!is_item_available(edict)) continue;
      if (map_->graph.find_touching(entity_box(edict), 12).empty())
        report_.unreached_items.push_back(describe(session_->game(), entity));
    }
  }

  const RunSetup& setup_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<const LevelMap> map_;
  std::vector<std::unique_ptr<Brain>> brains_;
  std::optional<MonsterWatch> monsters_;
  std::vector<net::Move> moves_;
  // By player: how many views the server had set, as of the last tick.
  std::vector<std::uint32_t> turns_;
  RunReport report_;
  std::string map_name_;
  double began_s_ = 0, renewed_god_s_ = 0;
};

}  // namespace

base::Result<RunReport> play_level(const RunSetup& setup) {
  return Run(setup).play();
}

}  // namespace temblor::player
