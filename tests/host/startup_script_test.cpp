// quake.rc and the configuration files that it runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "host/session/configure.h"
#include "support/programs/quakec.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

class StartupScript : public ::testing::Test {
 protected:
  void SetUp() override { SKIP_WITHOUT_QUAKEC(); }

  // Starts with these files in id1 instead of those that an earlier start wrote.
  void start(const std::vector<std::pair<std::string, std::string>>& files) {
    std::filesystem::remove(host_.folder().path() / "id1/temblor.cfg");
    for (const auto& [name, text] : files) host_.folder().write("id1/" + name, text);
    host_.restart();
    host_.run(0.2);
  }
  // The lines that `echo` printed, joined.
  std::string echoes() const {
    std::string text;
    for (const std::string& line : host_.lines())
      if (line.starts_with("run:")) text += line.substr(4);
    return text;
  }
  std::string text(std::string_view name) const {
    const command::Variable* const variable = host_.variables().variables().find(name);
    return variable == nullptr ? "none" : variable->text;
  }

  HeadlessHost host_;
};

TEST_F(StartupScript, RunsFilesInTheOrderOfStockQuakeWithoutQuakeRc) {
  start({{"default.cfg", "echo run:d\nfov 80"},
         {"config.cfg", "echo run:c\nfov 100"},
         {"autoexec.cfg", "echo run:a\n"}});
  EXPECT_EQ(echoes(), "dca");
  EXPECT_EQ(text("fov"), "100");
}

TEST_F(StartupScript, RunsTheLinesOfQuakeRcInTheirOrder) {
  start({{"quake.rc",
          "exec default.cfg\necho run:1\nexec mod.cfg\nexec config.cfg\necho run:2\nexec "
          "autoexec.cfg\nstuffcmds\n"
          "echo run:3\n"},
         {"default.cfg", "echo run:d\n"},
         {"mod.cfg", "echo run:m\nfov 80\n"},
         {"config.cfg", "echo run:c\n"},
         {"autoexec.cfg", "echo run:a\n"}});
  EXPECT_EQ(echoes(), "d1mc2a3");
  EXPECT_EQ(text("fov"), "80");
}

// A player who turns off a setting of the game's default.cfg finds it off at the next start, although that is
// the engine's default.
TEST_F(StartupScript, SettingsOfTheGameAreDefaultsThatPlayersCanChange) {
  const std::vector<std::pair<std::string, std::string>> game = {{"default.cfg", "r_marks 1\ncrosshair 3\n"}};
  start(game);
  EXPECT_EQ(text("r_marks"), "1");
  ASSERT_TRUE(host_.variables().variables().set("r_marks", "0").ok());
  ASSERT_TRUE(host::save_configuration(host_.host()).ok());
  host_.restart();
  host_.run(0.2);
  EXPECT_EQ(text("r_marks"), "0");
  EXPECT_EQ(text("crosshair"), "3");
  ASSERT_TRUE(host_.variables().variables().reset("r_marks").ok());
  EXPECT_EQ(text("r_marks"), "1");
  // Another game, without such settings.
  start({{"default.cfg", ""}});
  EXPECT_EQ(text("r_marks"), "0");
  EXPECT_EQ(text("crosshair"), "0");
}

// They are written at the end, so a script that forgets them must not erase them.
// Scripts and players can read it before a game begins.
TEST_F(StartupScript, KnowsTheRegisteredGame) {
  start({{"autoexec.cfg", "alias unused"}});
  EXPECT_EQ(text("registered"), "0");
  start({{"gfx/pop.lmp", std::string(256, '\0')}});
  EXPECT_EQ(text("registered"), "1");
}

TEST_F(StartupScript, ReadsTheSettingsAlsoWithoutAnExec) {
  start({{"quake.rc", "sensitivity 7\n"}, {"config.cfg", "fov 100\n"}});
  EXPECT_EQ(text("fov"), "100");
  EXPECT_EQ(text("sensitivity"), "7");
}

TEST_F(StartupScript, MissesNoFileThatStockQuakeDoesNotNeed) {
  start({{"quake.rc",
          "exec default.cfg\nexec config.cfg\nexec autoexec.cfg\nexec missing.cfg\nstuffcmds\nstartdemos "
          "demo1\n"}});
  EXPECT_TRUE(host_.has_printed("missing.cfg"));
  for (const char* const file : {"default.cfg", "config.cfg", "autoexec.cfg", "demo1"})
    EXPECT_FALSE(host_.has_printed(file)) << file;
}

TEST_F(StartupScript, KeepsOurKeysAndTheAdditionalOnesOfTheGame) {
  start({{"default.cfg", "unbindall\nbind w \"echo theirs\"\nbind F8 \"echo eight\"\n"}});
  const client::Bindings& bindings = host_.host().input.bindings;
  EXPECT_EQ(bindings.find_keys("+forward").empty(), false) << "ours override those of the game";
  EXPECT_EQ(bindings.find_keys("echo theirs").empty(), true);
  EXPECT_EQ(bindings.find_keys("echo eight").empty(), false);
}

// A script waits for frames, and there are none yet.
TEST_F(StartupScript, DoesNotStopAtWait) {
  start({{"default.cfg", "wait;wait;wait\n"},
         {"config.cfg", "wait\nfov 100\n"},
         {"autoexec.cfg", "alias loop \"wait;loop\"\nloop\n"}});
  EXPECT_EQ(text("fov"), "100");
}

TEST_F(StartupScript, RunsTheCommandLineAfterIt) {
  host_.folder().write("id1/quake.rc", std::string("stuffcmds\nfov 95\n"));
  host_.restart(nullptr, {"fov 70"});
  host_.run(0.2);
  EXPECT_EQ(text("fov"), "70");
  host_.command("fov 60; stuffcmds");
  host_.run(0.2);
  EXPECT_EQ(text("fov"), "70");
}

TEST_F(StartupScript, TheCommandLineMayContainStuffcmds) {
  start({});
  host_.restart(nullptr, {"inc sensitivity 1; stuffcmds"});
  host_.run(0.2);
  const std::string once = text("sensitivity");
  host_.command("stuffcmds");
  host_.run(0.2);
  EXPECT_NE(text("sensitivity"), once);
}

TEST_F(StartupScript, SetaKeepsAVariableOfTheMod) {
  start({{"default.cfg", "set mod_hint first\nseta mod_mode 2\n"}});
  EXPECT_EQ(text("mod_hint"), "first");
  host_.command("seta mod_mode 5; set mod_hint second; seta gl_texturemode 1; set cl_bob 0.01");
  host_.run(0.2);
  EXPECT_EQ(text("gl_texturemode"), "none") << "a name of other engines";
  EXPECT_EQ(text("v_bob"), "0.5");
  ASSERT_TRUE(host::save_configuration(host_.host()).ok());
  host_.folder().write("id1/default.cfg", std::string("set mod_hint first\nseta mod_mode 2\n"));
  host_.restart();
  host_.run(0.2);
  EXPECT_EQ(text("mod_mode"), "5");
  EXPECT_EQ(text("mod_hint"), "first");
}

}  // namespace
}  // namespace temblor::test
