// `temblor serve` as hosts use it: a console on standard input, and signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "app/program.h"
#include "platform/posix/udp_socket.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

#define SKIP_WITHOUT_GAME()                           \
  if (!std::filesystem::exists(TEMBLOR_GAME_PROGRAM)) \
  GTEST_SKIP() << "the game's QuakeC is not compiled: fteqcc is not installed"

// Runs a script in which SERVE stands for the server. Returns what both print.
struct ShellRun {
  int exit_status = 0;
  std::string out;
};
ShellRun run_script(const std::filesystem::path& data, std::string script) {
  const TemporaryFolder folder;
  const std::string serve = "'" TEMBLOR_PROGRAM "' --basedir '" + data.string() +
                            "' serve --port 0 --host 127.0.0.1 --map start --progs '" TEMBLOR_GAME_PROGRAM
                            "'";
  script.replace(script.find("SERVE"), 5, serve);
  folder.write("script.sh", script);
  const std::string out = (folder.path() / "out").string();
  const int status =
      std::system(("sh '" + (folder.path() / "script.sh").string() + "' >'" + out + "' 2>&1").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out)};
}

TEST(ServeProgram, ConsoleIsStandardInput) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const ShellRun run = run_script(data, "printf 'status\\nno_such_thing\\nquit\\n' | SERVE\n");
  EXPECT_EQ(run.exit_status, 0) << run.out;
  EXPECT_THAT(run.out, HasSubstr("level start, protocol 15"));
  EXPECT_THAT(run.out, HasSubstr("map:     start"));
  EXPECT_THAT(run.out, HasSubstr("no_such_thing"));
}

TEST(ServeProgram, SignalsEndItLikeQuit) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const ShellRun run = run_script(
      data, "SERVE --duration 60 </dev/null & server=$!\nsleep 2\nkill -TERM $server\nwait $server\n");
  EXPECT_EQ(run.exit_status, 0) << run.out;
  EXPECT_THAT(run.out, HasSubstr("level start"));
}

TEST(ServeProgram, ErrorsAreOneLine) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const TemporaryFolder folder;
  const auto serve = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"--basedir", data.string(), "serve", "--port", "0", "--host", "127.0.0.1"});
    return run_program(folder.path(), options);
  };
  const ProgramRun no_level = serve({"--map", "nowhere", "--progs", TEMBLOR_GAME_PROGRAM});
  EXPECT_EQ(no_level.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(no_level.err)) << no_level.err;
  EXPECT_THAT(no_level.err, HasSubstr("nowhere"));

  const std::string bad = folder.write("bad.dat", "no program").string();
  const ProgramRun no_program = serve({"--map", "start", "--progs", bad});
  EXPECT_EQ(no_program.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(no_program.err)) << no_program.err;
  EXPECT_THAT(no_program.err, HasSubstr("bad.dat"));

  const ProgramRun none = serve({"--map", "start"});
  EXPECT_THAT(none.err, HasSubstr("there is no progs.dat"));
  EXPECT_EQ(serve({"--map", "start", "--maxclients", "0"}).exit_status, 2);
  EXPECT_EQ(serve({}).exit_status, 2);
  const ProgramRun no_address = serve({"--map", "start", "--host", "no.such.address"});
  EXPECT_TRUE(is_one_error_line(no_address.err)) << no_address.err;
}

TEST(ServeProgram, SaysWhatToDoAboutUnusablePorts) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const TemporaryFolder folder;
  const auto serve_at = [&](const std::string& port) {
    return run_program(folder.path(), {"--basedir", data.string(), "serve", "--map", "start", "--progs",
                                       TEMBLOR_GAME_PROGRAM, "--host", "127.0.0.1", "--port", port});
  };
  for (const char* wrong : {"70000", "-1", "abc", "1.5", "65536"}) {
    const ProgramRun run = serve_at(wrong);
    EXPECT_EQ(run.exit_status, 2) << run.err;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(std::string("\"") + wrong + "\" is not a UDP port"));
    EXPECT_THAT(run.err, HasSubstr("1 to 65535"));
  }
  const auto other = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  ASSERT_TRUE(other.ok()) << other.error().message();
  const std::string port = std::to_string((*other)->local_address().port);
  const ProgramRun busy = serve_at(port);
  EXPECT_EQ(busy.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(busy.err)) << busy.err;
  EXPECT_THAT(busy.err, HasSubstr("UDP port " + port + " is in use"));
  EXPECT_THAT(busy.err, HasSubstr("--port"));
}

// In order of increasing priority: server.cfg, --set, --maxclients, --exec. None works once the level runs.
TEST(ServeProgram, MaxplayersSetsTheSlots) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(data / "id1", folder.path() / "id1");
  folder.write("mod/server.cfg", "maxplayers 0\nmaxplayers many\nmaxplayers 3\n");
  const std::string start = "printf 'maxplayers 9\\nmaxplayers\\nquit\\n' | SERVE --game mod";
  const ShellRun file = run_script(folder.path(), start + "\n");
  EXPECT_EQ(file.exit_status, 0) << file.out;
  EXPECT_THAT(file.out, HasSubstr("up to 3 players, level start"));
  EXPECT_THAT(file.out, HasSubstr("server.cfg:1: maxplayers: \"0\" is not a number from 1 to 255"));
  EXPECT_THAT(file.out, HasSubstr("server.cfg:2: maxplayers: \"many\" is not a number"));
  EXPECT_THAT(file.out, HasSubstr("maxplayers is 3."));
  EXPECT_THAT(file.out, HasSubstr("--maxclients 9")) << "the error says how to do it";
  const ShellRun set = run_script(folder.path(), start + " --set maxplayers=4\n");
  EXPECT_THAT(set.out, HasSubstr("up to 4 players, level start"));
  const ShellRun option = run_script(folder.path(), start + " --maxclients 5 --set maxplayers=4\n");
  EXPECT_THAT(option.out, HasSubstr("up to 5 players, level start"));
  const ShellRun stock = run_script(folder.path(), start + " --maxclients 5 +maxplayers 1\n");
  EXPECT_THAT(stock.out, HasSubstr("up to 1 player, level start"));
}

// DarkPlaces, for example, reads no other protocol. The level reaches from -4095 to 4095.
TEST(ServeProgram, LevelsOfTheStockSizeUseTheOldestProtocol) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(data / "id1", folder.path() / "id1");
  const std::string commands = "'changelevel lq_e0m2\nquit\n'";
  const ShellRun run = run_script(folder.path(), "printf " + commands + " | SERVE\n");
  EXPECT_THAT(run.out, HasSubstr("level lq_e0m2, protocol 15"));
}

TEST(ServeProgram, ErrorsOfTheConfigurationNameFileAndLine) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(data / "id1", folder.path() / "id1");
  folder.write("mod/server.cfg", "// ours\nhostname \"Quiet\"\nhostnam \"Pit\"\nexec rules.cfg\nskill 7\n");
  folder.write("mod/rules.cfg", "fraglimit many\n");
  const ProgramRun run =
      run_program(folder.path(),
                  {"--basedir", folder.path().string(), "--game", "mod", "serve", "--map", "start", "--progs",
                   TEMBLOR_GAME_PROGRAM, "--port", "0", "--host", "127.0.0.1", "--duration", "0.1"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("server.cfg:3: unknown command or variable \"hostnam\""));
  EXPECT_THAT(run.out, HasSubstr("rules.cfg:1: fraglimit cannot be \"many\""));
  EXPECT_THAT(run.out, HasSubstr("server.cfg:5: skill cannot be \"7\""));
  EXPECT_THAT(run.out, HasSubstr("Quiet: UDP port"));
}

TEST(ServeProgram, CommandLineOverridesTheConfiguration) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_GAME();
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(data / "id1", folder.path() / "id1");
  folder.write("mod/server.cfg", "hostname \"From file\"\n");
  const auto name_after = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"--basedir", folder.path().string(), "--game", "mod"});
    options.insert(options.end(), {"serve", "--map", "start", "--progs", TEMBLOR_GAME_PROGRAM, "--port", "0",
                                   "--host", "127.0.0.1", "--duration", "0.1"});
    const ProgramRun run = run_program(folder.path(), options);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const std::size_t end = run.out.find(": UDP port");
    return end == std::string::npos ? run.out + run.err : run.out.substr(run.out.rfind('\n', end) + 1, end);
  };
  EXPECT_THAT(name_after({}), ::testing::StartsWith("From file"));
  EXPECT_THAT(name_after({"--set", "hostname=From the line"}), ::testing::StartsWith("From the line"));
}

}  // namespace
}  // namespace temblor::test
