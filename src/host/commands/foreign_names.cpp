#include "host/commands/foreign_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "command/text.h"
#include "host/commands/configuration.h"

namespace temblor::host {
namespace {

// Our variable has the value factor * VALUE + offset. A name may have several counterparts.
struct Counterpart {
  std::string_view foreign, own;
  double factor = 1, offset = 0;
};
constexpr std::array kCounterparts = {
    Counterpart{"cl_bob", "v_bob", 50},          // the stock value is 0.02
    Counterpart{"cl_rollangle", "v_roll", 0.5},  // 2 degrees
    Counterpart{"v_gunkick", "v_shake"},
    Counterpart{"v_kickpitch", "v_kick", 1 / 0.6},  // 0.6 degrees for each point of damage
    Counterpart{"v_kickroll", "v_kick", 1 / 0.6},
    Counterpart{"gl_polyblend", "v_tint_damage"},
    Counterpart{"gl_polyblend", "v_tint_bonus"},
    Counterpart{"gl_polyblend", "v_tint_powerup"},
    Counterpart{"gl_polyblend", "v_tint_liquid"},
    Counterpart{"gl_cshiftpercent", "v_tint_damage", 0.01},
    Counterpart{"gl_cshiftpercent", "v_tint_bonus", 0.01},
    Counterpart{"gl_cshiftpercent", "v_tint_powerup", 0.01},
    Counterpart{"gl_cshiftpercent", "v_tint_liquid", 0.01},
    Counterpart{"r_lerpmodels", "cl_nolerp", -1, 1},
    Counterpart{"r_lerpmove", "cl_nolerp", -1, 1},
    Counterpart{"snd_waterfx", "s_underwater"},
    Counterpart{"scr_sbarscale", "scr_scale"},
    Counterpart{"scr_menuscale", "scr_textsize"},
    Counterpart{"r_novis", "r_use_pvs", -1, 1},
    Counterpart{"host_autosave", "sv_autosave"},
    Counterpart{"sfxvolume", "volume"},
    Counterpart{"vid_gamma", "gamma"},
    Counterpart{"vid_contrast", "contrast"},
    Counterpart{"cl_maxfps", "host_maxfps"},
    Counterpart{"show_fps", "scr_showfps"},
    Counterpart{"joy_deadzone", "joy_deadzone_look"},
    Counterpart{"joy_deadzone", "joy_deadzone_move"},
    Counterpart{"host_speeds", "r_speeds", 2},
};

// 0 sets our variable to `off`, other numbers set it to `on`.
struct Switch {
  std::string_view foreign, own, off, on;
};
constexpr std::array kSwitches = {
    Switch{"vid_fullscreen", "vid_mode", "window", "fullscreen"},
    // 1 corrects the weapon's look for the field of view of the game.
    Switch{"cl_gun_fovscale", "r_viewmodel_fov", "0", "90"},
    Switch{"r_showtris", "r_show", "picture", "edges"},
};

// Settings without a counterpart, each with a space before and after it.
constexpr std::string_view kIgnored =
    " "
    "r_scale r_softemu r_shadows r_waterquality r_oldwater r_oldskyleaf r_fastsky r_skyalpha "
    "r_skyfog r_sky_quality r_stereo r_noshadow_list r_clearcolor r_overbright "
    "r_overbright_models r_quadparticles cl_rollspeed "
    "v_iyaw_cycle v_iroll_cycle v_ipitch_cycle v_iyaw_level v_iroll_level v_ipitch_level scr_ofsx "
    "scr_ofsy scr_ofsz scr_showram scr_showturtle scr_showpause scr_conwidth scr_menubgalpha "
    "m_filter snd_mixspeed snd_speed snd_filterquality snd_show ambient_fade nosound precache "
    "_snd_mixahead bgm_extmusic bgmbuffer cfg_unbindall external_ents external_vis joy_deadzone_trigger "
    "r_viewmodel_quake sv_fishfix loadas8bit crosshairx crosshairy sys_throttle mem_list "
    "scr_sbar fov_adapt sv_altnoclip pr_engine con_logcenterprint v_centermove skyroom rate "
    "heartbeat tp_msg team skin setinfo serverinfo user observe listen test test2 viewmodel "
    "viewframe viewnext viewprev language "
    "vid_borderless vid_bpp vid_config_x vid_config_y vid_describecurrentmode vid_describemodes "
    "vid_desktopfullscreen vid_fsaa vid_fsaamode vid_refreshrate vid_unlock vid_wait "
    "r_drawflat r_norefresh r_pos r_stereodepth scr_usekfont showpause showturtle timerefresh tracepos "
    "v_centerspeed cl_shownet devstats flush hunk_print imagedump imagelist in_debugkeys max_edicts mcache "
    "serverprofile snd_noextraupdate sndspeed sv_freezenonclients cmdline ";

// Config files contain all settings of other renderers and of their windows. Another typed vid_ name may be
// a mistyped one of ours.
bool is_ignored(std::string_view name, bool is_in_file) {
  return kIgnored.find(fmt::format(" {} ", name)) != std::string_view::npos || name.starts_with("gl_") ||
         (is_in_file && name.starts_with("vid_"));
}

bool is_number(const command::Variable& variable) {
  return variable.type == command::VariableType::kFloat || variable.type == command::VariableType::kInt;
}

}  // namespace

bool ForeignNames::set_known(Arguments arguments) {
  const std::string name = base::to_lower(arguments[0]);
  if (set_converted(name, arguments) || set_counterpart(name, arguments)) return true;
  if (!is_ignored(name, console_.is_in_file())) return false;
  if (is_developer() && reported_.insert(name).second)
    console_.print_error(fmt::format("\"{}\" is a setting of other engines that has no counterpart here",
                                     base::quotable(name)));
  return true;
}

bool ForeignNames::handle(Arguments arguments) {
  if (set_known(arguments)) return true;
  // An unknown name in our own file means that the file is damaged.
  if (!console_.is_in_file() || console_.file() == kConfigurationFile || is_developer()) return false;
  if (unknown_++ == 0) first_unknown_ = base::to_lower(arguments[0]);
  return true;
}

bool ForeignNames::is_developer() const {
  return variables_.find("developer")->number != 0;
}

// _cl_name is a text. _cl_color holds both colors: 16 * shirt + trousers. Switches are choices of ours.
bool ForeignNames::set_converted(std::string_view name, Arguments arguments) {
  constexpr int kMaxColors = 255, kLastColor = 13;  // the rows above are full-bright
  const auto* const found_switch = std::ranges::find(kSwitches, name, &Switch::foreign);
  const bool is_name = name == "_cl_name", is_color = name == "_cl_color";
  const bool is_switch = found_switch != kSwitches.end();
  if (!is_name && !is_color && !is_switch) return false;
  const auto value_text = [&](std::string_view own) { return variables_.find(own)->text; };
  if (arguments.size() == 1) {
    const std::string_view own = is_name ? "name" : is_switch ? found_switch->own : "topcolor";
    console_.print_error(
        is_color ? fmt::format("\"{}\" is called \"topcolor\" and \"bottomcolor\" here; they are "
                               "\"{}\" and \"{}\"",
                               name, value_text("topcolor"), value_text("bottomcolor"))
                 : fmt::format("\"{}\" is called \"{}\" here; it is \"{}\"", name, own, value_text(own)));
    return true;
  }
  const std::string value = arguments[1];
  const auto set = [&](std::string_view own, std::string_view text) {
    if (const base::Status status = variables_.set(own, text); !status.ok())
      console_.print_error(status.error().message());
  };
  if (is_name) {
    set("name", value);
    return true;
  }
  const std::optional<double> number = command::parse_number(value);
  const bool is_whole = number && *number == std::floor(*number);
  if (!number || *number < 0 || *number > kMaxColors || (is_color && !is_whole)) {
    console_.print_error(fmt::format("\"{}\" is called {} here; it takes a number from 0 to {}", name,
                                     is_color ? "topcolor and bottomcolor" : found_switch->own, kMaxColors));
  } else if (is_color) {
    const int colors = static_cast<int>(*number);
    set("topcolor", std::to_string(std::min(colors / 16, kLastColor)));
    set("bottomcolor", std::to_string(std::min(colors % 16, kLastColor)));
  } else {
    set(found_switch->own, *number == 0 ? found_switch->off : found_switch->on);
  }
  return true;
}

bool ForeignNames::set_counterpart(std::string_view name, Arguments arguments) {
  const auto value = arguments.size() > 1 ? command::parse_number(arguments[1]) : std::nullopt;
  bool is_found = false;
  for (const Counterpart& counterpart : kCounterparts) {
    if (counterpart.foreign != name) continue;
    is_found = true;
    const command::Variable& own = *variables_.find(counterpart.own);
    if (!value) {
      console_.print_error(
          fmt::format("\"{}\" is called \"{}\" here; it is \"{}\"", name, own.name, own.text));
      continue;
    }
    const double wanted = *value * counterpart.factor + counterpart.offset;
    const base::Status status =
        variables_.set(own.name, is_number(own) ? fmt::format("{:g}", std::clamp(wanted, own.min, own.max))
                                 : wanted != 0  ? "1"
                                                : "0");
    if (!status.ok()) console_.print_error(status.error().message());
  }
  return is_found;
}

std::string ForeignNames::take_report() {
  const std::size_t count = std::exchange(unknown_, 0);
  if (count == 0) return {};
  if (count == 1)
    return fmt::format("unknown command or variable \"{}\" in a config file", base::quotable(first_unknown_));
  return fmt::format(
      "{} unknown commands or variables in config files, for example \"{}\" (developer 1 lists them)", count,
      base::quotable(first_unknown_));
}

}  // namespace temblor::host
