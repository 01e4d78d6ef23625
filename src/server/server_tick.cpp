// Time: a step of the server plays the ticks that are due. Both steps and ticks are lists of stages, which
// session/stages.h describes.
#include <algorithm>

#include "server/server.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

// After a longer wait (a stopped process), the game continues where it was instead of running faster.
constexpr double kMaxWait_s = 0.25;

// The first call only sets the clock: its origin is unknown.
void advance_clock(ServerClock& io_clock, double now_s) {
  io_clock.unplayed_s += io_clock.has_started ? std::min(now_s - io_clock.now_s, kMaxWait_s) : 0;
  io_clock.has_started = true;
  io_clock.now_s = now_s;
}

// The length of a tick is read once per step, so that game code that changes sys_ticrate takes effect with
// the next one. A tick may end the level: then there is nothing left to play.
void play_due_ticks(Server& io_server) {
  ServerClock& clock = io_server.clock;
  const double tick_s = io_server.settings().tick_s();
  while (io_server.game && clock.unplayed_s >= tick_s) {
    clock.unplayed_s -= tick_s;
    server_tick(io_server);
  }
  if (!io_server.game) clock.unplayed_s = 0;
}

void apply_game_settings(const ServerVariables& settings, GameWorld& io_world) {
  io_world.settings = settings.physics();
  io_world.tick_s = settings.world_tick_s();
  io_world.ideal_pitch_scale = settings.ideal_pitch_scale();
}

// Moves are taken from the queues even while the game is paused, so that they do not pile up. Only ticks that
// the game has played are counted.
base::Status play_tick(Server& io_server) {
  TRY_STATUS(play_moves(io_server));
  send_move_parameters(io_server);
  if (io_server.clock.is_paused) return base::Ok{};
  TRY_STATUS(io_server.game->tick(io_server.tick_inputs));
  ++io_server.clock.ticks;
  return base::Ok{};
}

}  // namespace

// Commands run before ticks, so that a command typed in this frame takes effect in it. Clients that failed
// are dropped only here, where no stage holds a reference to them.
void step_server(Server& io_server, double now_s) {
  advance_clock(io_server.clock, now_s);
  receive_packets(io_server);
  io_server.console.run();
  send_changed_rules(io_server);
  play_due_ticks(io_server);
  replace_dead_connections(io_server);
  drop_failed_clients(io_server);
  send_packets(io_server);
  autosave_if_due(io_server);
}

// Bots come first after the tick, because snapshots contain their names. Requests of QuakeC (a change of
// level, for example) come last: clients still get the last tick of the old level.
void server_tick(Server& io_server) {
  apply_game_settings(io_server.settings(), io_server.game->world());
  if (const base::Status played = play_tick(io_server); !played.ok())
    return handle_game_failure(io_server, played.error());
  update_bot_clients(io_server);
  send_snapshots(io_server);
  handle_game_requests(io_server);
}

double time_until_next_tick_s(const Server& server, double now_s) {
  const ServerClock& clock = server.clock;
  return std::max(0.0, server.settings().tick_s() - clock.unplayed_s - (now_s - clock.now_s));
}

}  // namespace temblor::server
