// Variables, commands, levels, extensions and files: what game code requests from the server.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "server/builtins/builtin_stage.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace global = server::global;

class Settings : public ::testing::Test {
 protected:
  Settings() {
    stage.variables.add_float("sv_gravity", 800, -10000, 10000, "How hard things fall.");
    stage.variables.add_bool("pausable", true, "Whether players may pause.");
    stage.variables.add_text("hostname", "unnamed", "The server's name.");
  }
  Stage stage;
};

TEST_F(Settings, CvarReadsNumbers) {
  EXPECT_EQ(stage.number("cvar", "sv_gravity"), 800);
  EXPECT_EQ(stage.number("cvar", "SV_Gravity"), 800);
  EXPECT_EQ(stage.number("cvar", "pausable"), 1);
  EXPECT_EQ(stage.number("cvar", "hostname"), 0);
  EXPECT_EQ(stage.number("cvar", "no_such_thing"), 0);
  EXPECT_EQ(stage.text("cvar_string", "sv_gravity"), "800");
  EXPECT_EQ(stage.text("cvar_string", "hostname"), "unnamed");
  EXPECT_EQ(stage.text("cvar_string", "no_such_thing"), "");
}

TEST_F(Settings, CvarSetKeepsWhatDoesNotFit) {
  stage.run("cvar_set", "sv_gravity", "100");
  EXPECT_EQ(stage.number("cvar", "sv_gravity"), 100);
  stage.run("cvar_set", "sv_gravity", "heavy");
  EXPECT_EQ(stage.number("cvar", "sv_gravity"), 100);
  stage.run("cvar_set", "no_such_thing", "1");
  EXPECT_EQ(stage.number("cvar", "sv_gameplayfix_random"), 0);
  stage.run("cvar_set", "sv_gameplayfix_random", "2");
  EXPECT_EQ(stage.number("cvar", "sv_gameplayfix_random"), 2);
  EXPECT_THAT(stage.printed, HasSubstr("sv_gravity"));
  EXPECT_THAT(stage.printed, HasSubstr("no_such_thing"));
}

TEST_F(Settings, RegistercvarMakesOneOnce) {
  EXPECT_EQ(stage.number("registercvar", "my_mode", "3.5"), 1);
  EXPECT_EQ(stage.number("cvar", "my_mode"), 3.5f);
  EXPECT_EQ(stage.number("registercvar", "MY_mode", "4"), 0);
  EXPECT_EQ(stage.number("cvar", "my_mode"), 3.5f);
  EXPECT_EQ(stage.number("registercvar", "sv_gravity", "1"), 0);
  EXPECT_EQ(stage.number("cvar", "sv_gravity"), 800);
  for (const std::string& name :
       {std::string(""), std::string("a b"), std::string("quit;"), std::string(64, 'a')})
    EXPECT_THAT(stage.error("registercvar", name, "1"), HasSubstr("is not a variable name"));
  std::string error;
  for (int i = 0; i < 10000 && error.empty(); ++i)
    error = stage.error("registercvar", fmt::format("v{}", i), "");
  EXPECT_THAT(error, HasSubstr("builtin registercvar: there are 4096 variables already"));
}

TEST_F(Settings, LocalcmdWaitsForTheConsole) {
  stage.run("localcmd", "restart\n");
  stage.run("localcmd", "map ", "start\n");
  EXPECT_EQ(stage.requests.commands, "restart\nmap start\n");
  std::string error;
  for (int i = 0; i < 100 && error.empty(); ++i) error = stage.error("localcmd", std::string(1000, 'x'));
  EXPECT_THAT(error, HasSubstr("builtin localcmd: more than 65536 bytes of commands are waiting"));
  EXPECT_LE(stage.requests.commands.size(), 65536u);
}

TEST_F(Settings, TheFirstChangelevelCounts) {
  EXPECT_FALSE(stage.requests.change_level.has_value());
  stage.run("changelevel", "e1m2");
  stage.run("changelevel", "e1m8");
  EXPECT_EQ(stage.requests.change_level, "e1m2");
}

TEST_F(Settings, SetspawnparmsGivesAPlayersOwn) {
  stage.context.spawn_parameters.resize(1);
  for (int i = 0; i < 16; ++i)
    stage.context.spawn_parameters[0][static_cast<std::size_t>(i)] = 100.0f + static_cast<float>(i);
  stage.run("setspawnparms", Stage::kPlayer1);
  EXPECT_EQ(stage.machine.global_float(vm::GlobalIndex{43}), 100);
  EXPECT_EQ(stage.machine.global_float(vm::GlobalIndex{58}), 115);
  stage.run("setspawnparms", Stage::kPlayer2);
  EXPECT_EQ(stage.machine.global_float(vm::GlobalIndex{43}), 0);
  EXPECT_THAT(stage.error("setspawnparms", vm::kWorld),
              HasSubstr("builtin setspawnparms: parameter 1 is entity 0"));
}

TEST_F(Settings, CheckextensionSaysWhatWorks) {
  for (const char* name :
       {"DP_QC_SINCOSSQRTPOW", "DP_QC_MINMAXBOUND", "DP_QC_RANDOMVEC", "DP_QC_TRACEBOX", "DP_QC_ETOS",
        "DP_REGISTERCVAR", "DP_QC_FINDFLOAT", "DP_QC_COPYENTITY", "DP_QC_FINDCHAIN", "DP_QC_FINDCHAINFLOAT",
        "DP_QC_CVAR_STRING", "DP_QC_FINDFLAGS", "DP_QC_SPRINTF", "dp_qc_sprintf"})
    EXPECT_EQ(stage.number("checkextension", name), 1) << name;
  for (const char* name :
       {"", "DP_QC", "DP_QC_SPRINTF2", "FTE_CSQC", "FRIK_FILE", "KRIMZON_SV_PARSECLIENTCOMMAND",
        "DP_SV_BOTCLIENT", "DP_SV_DROPCLIENT", "DP_QC_WHICHPACK"})
    EXPECT_EQ(stage.number("checkextension", name), 0) << name;
  stage.context.shared.files = builtins::ScriptFiles("somewhere", nullptr);
  stage.context.client_command = [](vm::EntityIndex, std::string_view) {};
  EXPECT_EQ(stage.number("checkextension", "FRIK_FILE"), 1);
  EXPECT_EQ(stage.number("checkextension", "KRIMZON_SV_PARSECLIENTCOMMAND"), 1);
  stage.context.bot_services.spawn_bot = [] { return base::Result(vm::kWorld); };
  stage.context.shared.find_pack = [](std::string_view) { return std::string(); };
  for (const char* name : {"DP_SV_BOTCLIENT", "DP_SV_DROPCLIENT", "DP_QC_WHICHPACK"})
    EXPECT_EQ(stage.number("checkextension", name), 1) << name;
}

TEST_F(Settings, BotsComeAndGoAndAreKnownAsSuch) {
  EXPECT_THAT(stage.error("spawnclient"), HasSubstr("no bots"));
  std::vector<std::size_t> dropped;
  stage.context.bot_services = {
      .spawn_bot = [] { return base::Result(Stage::kPlayer2); },
      .drop =
          [&](std::size_t slot) {
            dropped.push_back(slot);
            return base::Status(base::Ok{});
          },
      .player_type =
          [](std::size_t slot) { return slot == 0 ? server::PlayerType::kHuman : server::PlayerType::kBot; }};
  EXPECT_EQ(stage.entity("spawnclient"), Stage::kPlayer2);
  EXPECT_EQ(stage.number("clienttype", Stage::kPlayer1), 1);
  EXPECT_EQ(stage.number("clienttype", Stage::kPlayer2), 2);
  EXPECT_EQ(stage.number("clienttype", stage.spawn()), 3);
  stage.run("dropclient", Stage::kPlayer2);
  EXPECT_THAT(dropped, ElementsAre(1));
  EXPECT_THAT(stage.error("dropclient", vm::kWorld), HasSubstr("not a player"));
}

TEST_F(Settings, WhichpackSaysWhereAFileIs) {
  EXPECT_EQ(stage.text("whichpack", "progs/a.mdl"), "");
  stage.context.shared.find_pack = [](std::string_view file) {
    return std::string(file == "progs/a.mdl" ? "id1/pak0.pak" : "");
  };
  EXPECT_EQ(stage.text("whichpack", "progs/a.mdl"), "id1/pak0.pak");
  EXPECT_EQ(stage.text("whichpack", "progs/b.mdl"), "");
}

TEST_F(Settings, ClientcommandIsDoneForAPlayer) {
  EXPECT_THAT(stage.error("clientcommand", Stage::kPlayer1, "say hi"), HasSubstr("builtin clientcommand: "));
  std::vector<std::string> done;
  stage.context.client_command = [&](vm::EntityIndex player, std::string_view command) {
    done.push_back(fmt::format("{}: {}", base::to_size(player), command));
  };
  stage.run("clientcommand", Stage::kPlayer2, "say hi");
  EXPECT_THAT(done, ElementsAre("2: say hi"));
  EXPECT_THAT(stage.error("clientcommand", vm::kWorld, "quit"), HasSubstr("which is not a player"));
}

class Files : public ::testing::Test {
 protected:
  Files() { stage.context.shared.files = builtins::ScriptFiles(folder.path() / "data", nullptr); }
  TemporaryFolder folder;
  Stage stage;
};

TEST_F(Files, AreWrittenAndReadByLines) {
  const float out = stage.number("fopen", "scores.txt", 2);
  ASSERT_GE(out, 0);
  stage.run("fputs", out, "first", " line\n", "second\n");
  stage.run("fclose", out);
  const float in = stage.number("fopen", "scores.txt", 0);
  EXPECT_EQ(stage.text("fgets", in), "first line");
  EXPECT_EQ(stage.text("fgets", in), "second");
  stage.run("fgets", in);
  EXPECT_EQ(stage.machine.returned_string(), vm::kEmptyString);
  stage.run("fclose", in);
  EXPECT_EQ(base::as_text(read_file(folder.path() / "data" / "scores.txt")), "first line\nsecond\n");
}

TEST_F(Files, WhatCannotBeOpenedIsMinusOne) {
  EXPECT_EQ(stage.number("fopen", "not_there.txt", 0), -1);
  EXPECT_EQ(stage.printed, "") << "a missing file is not worth a warning";
  EXPECT_EQ(stage.number("fopen", "../escape.txt", 2), -1);
  EXPECT_THAT(stage.printed, HasSubstr("builtin fopen: the file name \"../escape.txt\""));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "escape.txt"));
  EXPECT_THAT(stage.error("fopen", "a.txt", 3),
              HasSubstr("builtin fopen: mode 3 is not 0 (read), 1 (append) or 2 (write)"));
}

TEST_F(Files, BadHandlesAreErrors) {
  for (const float handle : {-1.0f, 0.0f, 1e20f, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THAT(stage.error("fclose", handle), HasSubstr("builtin fclose: file"));
    EXPECT_THAT(stage.error("fgets", handle), HasSubstr("builtin fgets: file"));
    EXPECT_THAT(stage.error("fputs", handle, "x"), HasSubstr("builtin fputs: file"));
  }
}

}  // namespace
}  // namespace temblor::test
