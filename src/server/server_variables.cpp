#include "server/server_variables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace temblor::server {
namespace {

constexpr double kHuge = 1e6;
// Bytes a second that a modem of the game's days carried: of updates in a fight, some ten a second.
constexpr std::int64_t kMinRate = 2500;

// Rules that stock servers tell, and those that game code reads: of the level that is played, and of the
// next one.
constexpr std::array<std::string_view, 12> kRules = {
    "sv_maxspeed",  "sv_friction", "sv_gravity", "sv_accelerate", "sv_stopspeed", "sv_maxvelocity",
    "edgefriction", "fraglimit",   "timelimit",  "teamplay",      "noexit",       "samelevel",
};
constexpr std::array<std::string_view, 3> kRulesOfNextLevel = {"deathmatch", "coop", "skill"};

}  // namespace

ServerVariables::ServerVariables(command::Variables& io_variables) : variables_(&io_variables) {
  command::Variables& v = io_variables;
  gravity_ = v.add_float("sv_gravity", 800, -kHuge, kHuge, "Pull downwards, in units a second squared.");
  max_velocity_ = v.add_float("sv_maxvelocity", 2000, 1, kHuge,
                              "Fastest that anything moves along an axis, in units a second.");
  friction_ = v.add_float("sv_friction", 4, 0, kHuge, "How soon players come to rest.");
  edge_friction_ =
      v.add_float("edgefriction", 2, 0, kHuge, "How much more friction there is before a deep drop.");
  stop_speed_ = v.add_float("sv_stopspeed", 100, 0, kHuge,
                            "Below this speed friction is as strong as at it, in units a second.");
  accelerate_ = v.add_float("sv_accelerate", 10, 0, kHuge, "How soon players get to their speed.");
  max_speed_ = v.add_float("sv_maxspeed", 320, 0, kHuge, "Fastest that players walk, in units a second.");
  no_step_ = v.add_bool("sv_nostep", false, "Players cannot climb stairs.");

  skill_ = v.add_float("skill", 1, 0, 3, "Of the next level: 0 easy, 1 normal, 2 hard, 3 nightmare.");
  deathmatch_ = v.add_int("deathmatch", 0, 0, 255, "Of the next level: players against one another.");
  coop_ = v.add_bool("coop", false, "Of the next level: players together.");
  v.add_int("teamplay", 0, 0, 255, "Whether players of one team hurt each other (for game code).");
  v.add_int("fraglimit", 0, 0, 1000000, "Kills that end a deathmatch; 0: none (for game code).");
  v.add_float("timelimit", 0, 0, 1000000, "Minutes that a deathmatch lasts; 0: for ever (for game code).");
  v.add_bool("samelevel", false, "A deathmatch goes on in the same level (for game code).");
  v.add_int("noexit", 0, 0, 255, "Players cannot leave a level of a deathmatch (for game code).");
  v.add_bool("pr_checkextension", true, "Game code may ask what this server can do besides the original's.");
  v.add_int("bot_fill", 0, 0, 16, "Players in a deathmatch, made up with bots (for game code); 0: no bots.");
  v.add_int("bot_skill", 1, 0, 3, "How well bots fight, 0 to 3 (for game code).");
  v.add_float("sv_aim", 0.93, -1, 2,
              "Cosine of the angle within which a shot is turned at a target; above 1: never.");
  for (const std::string_view name : {"gamecfg", "nomonsters", "temp1"})
    v.add_float(name, 0, -kHuge, kHuge, "A number for game code.");
  for (const std::string_view name : {"scratch1", "scratch2", "scratch3", "scratch4", "saved1", "saved2",
                                      "saved3", "saved4", "savedgamecfg"})
    v.add_float(name, 0, -1e9, 1e9, "A number that game code keeps from level to level.");

  tick_rate_ = v.add_float("sys_ticrate", 1.0 / 72, 0.001, 0.1,
                           "Seconds between two steps of the world; the original's servers: 0.05.");
  frame_time_ = v.add_float("host_framerate", 0, 0, 0.1,
                            "Seconds that each step moves the world on, whatever the clock says; 0: as many "
                            "as it took.");
  ideal_pitch_scale_ =
      v.add_float("sv_idealpitchscale", 0.8, -kHuge, kHuge,
                  "Degrees that players on stairs look down or up, for each unit that a step rises.");
  reliable_updates_ = v.add_bool("sv_reliableupdates", false,
                                 "Updates are sent until they arrive, and none meanwhile: a lost packet then "
                                 "stops the game, as in the first versions of Quake; to see the difference.");
  max_rate_ =
      v.add_int_or_zero("sv_maxrate", 0, kMinRate, 10'000'000,
                        "Bytes a second of updates to each client; where they do not suffice, it gets fewer "
                        "updates; 0: one each step.");
  autosave_ = v.add_float("sv_autosave", 3, 0, 1440,
                          "Minutes between two saves of a single player's game without being asked, and one "
                          "where a level begins and where the game is left; 0: none.");
  autoload_ = v.add_bool("sv_autoload", true,
                         "A dead player who fires goes on from the level's last saved game (jumping begins "
                         "the level again); 0: always begins again.");
  constexpr std::array<std::string_view, 4> kProtocols = {"auto", "15", "666", "999"};
  protocol_ = v.add_choice("sv_protocol", kProtocols,
                           "Of the next level: the protocol; auto: the oldest that can say all of it.");
  host_name_ = v.add_text("hostname", "Temblor", "The server's name, as lists of servers show it.");
  timeout_ = v.add_float("net_messagetimeout", 300, 1, 86400,
                         "Seconds after which a client that says nothing is dropped.");
  rcon_password_ =
      v.add_text("rcon_password", "", "With it, players may give the server commands; empty: nobody may.");
  cheats_ = v.add_bool("sv_cheats", false, "god, noclip, give and the like work with several players too.");
  pausable_ = v.add_bool("pausable", true, "Players may stop time with `pause`.");
  reload_ = v.add_bool("sv_reload", true, "A program or level that changes on disk is taken up at once.");
}

PhysicsSettings ServerVariables::physics() const {
  const auto number = [&](command::VariableIndex i) {
    return static_cast<float>(variables_->float_value(i));
  };
  return {.gravity = number(gravity_),
          .max_velocity = number(max_velocity_),
          .friction = number(friction_),
          .edge_friction = number(edge_friction_),
          .stop_speed = number(stop_speed_),
          .accelerate = number(accelerate_),
          .max_speed = number(max_speed_),
          .no_step = variables_->bool_value(no_step_)};
}

GameKind ServerVariables::kind(std::size_t max_clients) const {
  if (variables_->bool_value(coop_)) return GameKind::kCooperative;
  if (variables_->int_value(deathmatch_) != 0) return GameKind::kDeathmatch;
  return max_clients > 1 ? GameKind::kCooperative : GameKind::kSingle;
}

void ServerVariables::set_kind(GameKind kind) const {
  const auto set = [&](const char* name, bool value) {
    const base::Status status = variables_->set(name, value ? "1" : "0");
    CHECK(status.ok());
  };
  set("coop", kind == GameKind::kCooperative);
  // Game code knows kinds of deathmatch by numbers above 1.
  if (kind != GameKind::kDeathmatch) set("deathmatch", false);
}

bool ServerVariables::is_pausable() const {
  return variables_->bool_value(pausable_);
}

int ServerVariables::skill() const {
  return static_cast<int>(std::floor(variables_->float_value(skill_) + 0.5));
}

double ServerVariables::tick_s() const {
  return variables_->float_value(tick_rate_);
}
double ServerVariables::world_tick_s() const {
  const double frame_time_s = variables_->float_value(frame_time_);
  return frame_time_s > 0 ? frame_time_s : tick_s();
}
float ServerVariables::ideal_pitch_scale() const {
  return static_cast<float>(variables_->float_value(ideal_pitch_scale_));
}
bool ServerVariables::has_reliable_updates() const {
  return variables_->bool_value(reliable_updates_);
}
double ServerVariables::max_rate_bytes_per_second() const {
  return static_cast<double>(variables_->int_value(max_rate_));
}
double ServerVariables::autosave_s() const {
  return variables_->float_value(autosave_) * 60;
}
bool ServerVariables::autoloads() const {
  return variables_->bool_value(autoload_);
}

std::optional<net::Protocol> ServerVariables::protocol() const {
  switch (variables_->choice_value(protocol_)) {
    case 1:
      return net::Protocol::kNetQuake;
    case 2:
      return net::Protocol::kFitzQuake;
    case 3:
      return net::Protocol::kRmq;
    default:
      return std::nullopt;
  }
}

std::string ServerVariables::host_name() const {
  return variables_->text_value(host_name_);
}
float ServerVariables::timeout_s() const {
  return static_cast<float>(variables_->float_value(timeout_));
}
const std::string& ServerVariables::rcon_password() const {
  return variables_->text_value(rcon_password_);
}
bool ServerVariables::cheats_allowed() const {
  return variables_->bool_value(cheats_);
}
bool ServerVariables::reloads() const {
  return variables_->bool_value(reload_);
}

std::vector<std::pair<std::string, std::string>> ServerVariables::rules() const {
  std::vector<std::pair<std::string, std::string>> rules;
  const auto add = [&](std::string_view name) { rules.emplace_back(name, variables_->find(name)->text); };
  std::for_each(kRules.begin(), kRules.end(), add);
  std::for_each(kRulesOfNextLevel.begin(), kRulesOfNextLevel.end(), add);
  return rules;
}

std::vector<std::pair<std::string, std::string>> ServerVariables::rules_changed_since(
    std::uint64_t version) const {
  std::vector<std::pair<std::string, std::string>> changed;
  if (variables_->version() == version) return changed;
  for (const std::string_view name : kRules)
    if (const command::Variable* rule = variables_->find(name); rule->version > version)
      changed.emplace_back(name, rule->text);
  return changed;
}

}  // namespace temblor::server
