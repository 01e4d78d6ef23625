// The globals of a HUD program that the engine sets before each call. A program declares those that it needs.
#include "client/hud_program/program_call.h"

namespace temblor::client {
namespace {

void set_number(vm::Machine& io_machine, std::string_view name, double value) {
  const formats::ProgsDefinition* const global = io_machine.program().find_global(name);
  if (global != nullptr && global->type == formats::ProgsType::kFloat)
    io_machine.set_global_float(vm::GlobalIndex{global->offset}, static_cast<float>(value));
}

}  // namespace

void set_program_globals(const Game& game, const HudMoment& moment, vm::Machine& io_machine) {
  set_number(io_machine, "time", moment.time_s);
  set_number(io_machine, "cltime", moment.time_s);
  set_number(io_machine, "frametime", moment.frame_time_s);
  set_number(io_machine, "clframetime", moment.frame_time_s);
  set_number(io_machine, "maxclients", static_cast<double>(game.players.size()));
  set_number(io_machine, "numclientseats", 1);
  set_number(io_machine, "player_localentnum", game.view_entity);
  set_number(io_machine, "player_localnum", game.view_entity - 1);
  set_number(io_machine, "deathmatch", game.deathmatch ? 1 : 0);
  set_number(io_machine, "intermission", static_cast<double>(game.ending));
  set_number(io_machine, "intermission_time", game.ending_since_s);
  set_number(io_machine, "sb_showscores", moment.shows_scores ? 1 : 0);
  set_number(io_machine, "vid_width", moment.width);
  set_number(io_machine, "vid_height", moment.height);
  const formats::ProgsDefinition* const angles = io_machine.program().find_global("view_angles");
  if (angles != nullptr && angles->type == formats::ProgsType::kVector)
    io_machine.set_global_vector(vm::GlobalIndex{angles->offset}, moment.view_angles_deg);
}

}  // namespace temblor::client
