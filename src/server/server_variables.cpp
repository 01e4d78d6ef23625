#include "server/server_variables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "assets/localization.h"

namespace temblor::server {
namespace {

// For physics settings: any value that a player could mean is allowed, but no infinity.
constexpr double kHuge = 1e6;
// Bytes per second of a modem when the game came out: about ten snapshots per second in a fight.
constexpr std::int64_t kMinRate = 2500;

// The rules that stock servers report, and those that game code reads.
constexpr std::array<std::string_view, 13> kRules = {
    "sv_maxspeed",    "sv_friction",  "sv_gravity",   "sv_accelerate", "sv_stopspeed",
    "sv_maxvelocity", "edgefriction", "fraglimit",    "timelimit",     "teamplay",
    "noexit",         "samelevel",    "capturelimit",
};
// They are reported, too, but a change is not announced to players: it takes effect with the next level.
constexpr std::array<std::string_view, 3> kRulesOfNextLevel = {"deathmatch", "coop", "skill"};

}  // namespace

// Variables that only game code reads are registered and forgotten: cvar() finds them by name.
ServerVariables::ServerVariables(command::Variables& io_variables) : variables_(&io_variables) {
  command::Variables& v = io_variables;
  gravity_ = v.add_float("sv_gravity", 800, -kHuge, kHuge, "Gravity, in units per second squared.");
  max_velocity_ = v.add_float("sv_maxvelocity", 2000, 1, kHuge,
                              "Maximum speed of anything along each axis, in units per second.");
  friction_ = v.add_float("sv_friction", 4, 0, kHuge, "Ground friction of players.");
  edge_friction_ = v.add_float("edgefriction", 2, 0, kHuge, "Factor on friction at the edge of a deep drop.");
  stop_speed_ = v.add_float("sv_stopspeed", 100, 0, kHuge,
                            "Friction does not get weaker below this speed, in units per second.");
  accelerate_ = v.add_float("sv_accelerate", 10, 0, kHuge, "Acceleration of players.");
  max_speed_ =
      v.add_float("sv_maxspeed", 320, 0, kHuge, "Maximum walking speed of players, in units per second.");
  no_step_ = v.add_bool("sv_nostep", false, "Players cannot climb steps.");

  skill_ = v.add_float("skill", 1, 0, 3, "Skill of the next level: 0 easy, 1 normal, 2 hard, 3 nightmare.");
  deathmatch_ = v.add_int("deathmatch", 0, 0, 255, "1: the next level is a deathmatch.");
  coop_ = v.add_bool("coop", false, "1: the next level is played cooperatively.");
  v.add_int("teamplay", 0, 0, 255,
            "1: teammates cannot hurt each other; 2: they can; 3: capture the flag (for game code).");
  v.add_int("fraglimit", 0, 0, 1000000, "Frags that end a deathmatch; 0: no limit (for game code).");
  v.add_int("capturelimit", 0, 0, 1000000,
            "Captures that end a game of capture the flag; 0: no limit (for game code).");
  v.add_float("timelimit", 0, 0, 1000000, "Minutes until a deathmatch ends; 0: no limit (for game code).");
  v.add_bool("samelevel", false, "1: a deathmatch stays in the same level (for game code).");
  v.add_int("noexit", 0, 0, 255, "1: players cannot leave the level in a deathmatch (for game code).");
  v.add_bool("registered", false,
             "1: the data is that of the registered game (for game code; set by each level).");
  v.add_int("developer", 0, 0, 100, "1: shows the output of game code's dprint.");
  v.add_bool("pr_checkextension", true, "Game code may query the extensions of this server.");
  v.add_int("bot_fill", 0, 0, 16,
            "Bots fill a deathmatch up to this many players (for game code). 0: no bots.");
  v.add_int("bot_skill", 1, 0, 3, "Skill of bots: 0 easy, 1 normal, 2 hard, 3 expert (for game code).");
  v.add_float("sv_aim", 0.93, -1, 2,
              "Cosine of the angle within which shots are aimed at a target; above 1: never.");
  for (const std::string_view name : {"gamecfg", "nomonsters", "temp1", "campaign", "horde"})
    v.add_float(name, 0, -kHuge, kHuge, "A number for game code.");
  for (const std::string_view name : {"scratch1", "scratch2", "scratch3", "scratch4", "saved1", "saved2",
                                      "saved3", "saved4", "savedgamecfg"})
    v.add_float(name, 0, -1e9, 1e9, "A number that game code keeps between levels.");

  tick_rate_ = v.add_float("sys_ticrate", 1.0 / 72, 0.001, 0.1,
                           "Length of a server tick, in seconds; stock servers use 0.05.");
  frame_time_ = v.add_float("host_framerate", 0, 0, 0.1,
                            "Game time of each tick, in seconds, whatever the clock says; 0: the same as "
                            "sys_ticrate.");
  ideal_pitch_scale_ =
      v.add_float("sv_idealpitchscale", 0.8, -kHuge, kHuge,
                  "Degrees that players on stairs look up or down, for each unit that a step rises.");
  reliable_updates_ =
      v.add_bool("sv_reliableupdates", false,
                 "1: snapshots are sent reliably, so that a lost packet stops the game, as in "
                 "the first versions of Quake. For comparison only.");
  max_rate_ =
      v.add_int_or_zero("sv_maxrate", 0, kMinRate, 10'000'000,
                        "Maximum bytes of snapshots per second to each client, which gets fewer snapshots "
                        "if need be; 0: one each tick.");
  autosave_ =
      v.add_float("sv_autosave", 3, 0, 1440,
                  "Minutes between autosaves of a single-player game, which is also saved at the start "
                  "of a level and on leaving; 0: no autosaves.");
  autoload_ = v.add_bool("sv_autoload", true,
                         "1: a dead player who fires loads the level's last save (jumping restarts the "
                         "level); 0: always restarts.");
  constexpr std::array<std::string_view, 4> kProtocols = {"auto", "15", "666", "999"};
  protocol_ =
      v.add_choice("sv_protocol", kProtocols,
                   "Protocol of the next level; auto: the oldest one that can express the level, but at "
                   "least 666 in games that a player starts.");
  host_name_ = v.add_text("hostname", "Temblor", "The server's name in server browsers.");
  language_ = v.add_text("language", assets::kDefaultLanguage,
                         "Language of the texts of games that have several: english, french, german, "
                         "italian, spanish, and others. A server's players read the server's language, from "
                         "the next level on.");
  timeout_ =
      v.add_float("net_messagetimeout", 300, 1, 86400, "Seconds after which a silent client is dropped.");
  rcon_password_ = v.add_text("rcon_password", "",
                              "Password for remote console commands (rcon); empty: rcon is disabled.");
  cheats_ = v.add_bool("sv_cheats", false, "1: cheats (god, noclip, give ...) work in multiplayer, too.");
  pausable_ = v.add_bool("pausable", true, "Players may pause the game.");
  reload_ =
      v.add_bool("sv_reload", true, "1: game code and levels that change on disk are reloaded at once.");
}

math::PhysicsSettings ServerVariables::physics() const {
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

// coop has precedence, as in the original. Without either, several players play together.
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
  // Values above 1 are kinds of deathmatch to game code, so they stay.
  if (kind != GameKind::kDeathmatch) set("deathmatch", false);
}

void ServerVariables::set_registered(bool is_registered) const {
  const base::Status status = variables_->set("registered", is_registered ? "1" : "0");
  CHECK(status.ok());
}

// --- Getters. Each converts from the type and unit of the variable to what the server uses.
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

// The order of kProtocols above.
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

const std::string& ServerVariables::language() const {
  return variables_->text_value(language_);
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

// Versions are numbers that grow with each change of any variable, so that an unchanged set costs one
// comparison.
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
