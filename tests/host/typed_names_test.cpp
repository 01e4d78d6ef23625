// Names that players of other engines type. Those that are settings of other renderers do nothing, but none
// is an error.
#include <gtest/gtest.h>

#include <sstream>

#include "client_server/served_game.h"
#include "host/headless_host.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

constexpr const char* kNames =
    "registered developer reconnect version path dir flocate setpos mapname randmap games mods skies "
    "demos saves configs stuffcmds fog sky skyroom music_stop music_pause bf pointfile entities "
    "edicts edictcount viewmodel viewframe soundlist soundinfo net_stats slist listen test resetcfg "
    "aliaslist menu_maps menu_mods menu_skill menu_credits vid_restart vid_test vid_fullscreen "
    "chase_active chase_back r_lockpvs r_novis r_drawworld r_drawentities r_fullbright r_lightmap "
    "r_speeds r_showtris r_showbboxes r_shadows r_dynamic r_flatlightstyles r_lerpmodels r_lerpmove "
    "r_waterwarp r_litwater r_particles r_scale r_softemu r_viewmodel_fov cl_gun_fovscale "
    "gl_polyblend gl_flashblend r_noshadow_list scr_crosshairscale scr_sbarscale scr_menuscale "
    "scr_sbar scr_clock scr_showspeed cl_bob cl_rollangle v_gunkick v_kicktime v_idlescale "
    "v_centermove host_timescale host_speeds host_autosave _cl_name _cl_color m_filter fov_adapt "
    "sv_altnoclip pr_engine campaign con_logcenterprint scr_centertime scr_printspeed snd_mixspeed "
    "snd_waterfx ambient_fade language user users setinfo serverinfo rate team skin observe tp_msg "
    "loc r_fastsky r_skyalpha r_skyfog ping tell heartbeat addip listip killserver "
    "v_kickpitch v_kickroll cl_bobcycle cl_bobup cl_rollspeed gl_cshiftpercent vid_borderless vid_bpp "
    "vid_desktopfullscreen vid_fsaa vid_refreshrate vid_describemodes timerefresh r_pos r_drawflat "
    "showturtle showpause scr_usekfont v_centerspeed cmdline";
// At the console of a dedicated server.
constexpr const char* kServerNames = "users edicts ping tell heartbeat addip listip version killserver";

TEST(TypedNames, AreKnown) {
  SKIP_WITHOUT_QUAKEC();
  constexpr double kOneFrame_s = 0.01;
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  std::istringstream names(kNames);
  for (std::string name; names >> name;) {
    game.command(name);
    game.run(kOneFrame_s);
    EXPECT_FALSE(game.has_printed("unknown command or variable \"" + name + "\"")) << name;
  }
  // The same check finds a name that nobody knows.
  game.command("r_nothing");
  game.run(kOneFrame_s);
  EXPECT_TRUE(game.has_printed("unknown command or variable \"r_nothing\""));
}

TEST(TypedNames, OfServersAreKnown) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  std::istringstream names(kServerNames);
  for (std::string name; names >> name;) {
    served.command(name);
    served.run(0.03);
    EXPECT_EQ(served.console().find("unknown command or variable \"" + name + "\""), std::string::npos);
  }
  EXPECT_TRUE(served.server().wants_to_quit) << "killserver";
  served.command("r_nothing");
  served.run(0.03);
  EXPECT_NE(served.console().find("unknown command or variable \"r_nothing\""), std::string::npos);
}

TEST(TypedNames, OfServersDoTheSameAsElsewhere) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  served.add_client("anna");
  ASSERT_TRUE(served.run_until_playing(0));
  served.command("ping; tell anna hello there; tell nobody x; version");
  served.run(0.2);
  EXPECT_NE(served.console().find("Client ping times:\n"), std::string::npos);
  EXPECT_NE(served.console().find(" anna\n"), std::string::npos);
  EXPECT_NE(served.console().find("there is no player \"nobody\""), std::string::npos);
  EXPECT_NE(served.console().find("Temblor"), std::string::npos);
  EXPECT_NE(served.prints(0).find(":hello there\n"), std::string::npos);
}

}  // namespace
}  // namespace temblor::test
