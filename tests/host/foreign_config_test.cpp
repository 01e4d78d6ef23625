// Config files that other engines write: QuakeSpasm and DarkPlaces (Debian's packages) run with a player's
// settings and write their config.cfg, and our program reads it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "base/text.h"
#include "host/headless_host.h"
#include "support/game_data.h"
#include "support/programs/background_program.h"
#include "support/programs/quakec.h"
#include "support/programs/quakespasm_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kPlayer = R"(unbindall
bind w +forward
bind e +jump
bind F11 "toggle r_fullbright"
bind KP_INS +speed
bind SEMICOLON messagemode
bind \ +mlook
bind KP_SLASH "impulse 3"
bind LEFTARROW +left
bind MOUSE1 +attack
bind MOUSE2 "impulse 10; wait; say hi"
bind MWHEELUP "impulse 10"
name "Ranger X"
color 3 11
sensitivity 5.5
fov 105
crosshair 1
volume 0.3
bgmvolume 0.4
m_pitch -0.022
viewsize 110
)";
// Lines of our own file. These engines do not have all of them at their defaults, so they write all of them.
constexpr std::array kOurLines = {"bind w +forward\n",
                                  "bind e +jump\n",
                                  "bind F11 \"toggle r_fullbright\"\n",
                                  "bind KP_0 +speed\n",
                                  "bind LEFTARROW +left",
                                  "bind SEMICOLON messagemode\n",
                                  "bind \\ +mlook\n",
                                  "bind KP_SLASH \"impulse 3\"\n",
                                  "bind MOUSE1 +attack",
                                  "bind MOUSE2 \"impulse 10; wait; say hi\"\n",
                                  "bind MWHEELUP \"impulse 10\"\n",
                                  "name \"Ranger X\"\n",
                                  "topcolor 3\n",
                                  "bottomcolor 11\n",
                                  "sensitivity 5.5\n",
                                  "crosshair 1\n",
                                  "volume 0.3\n",
                                  "bgmvolume 0.4\n",
                                  "m_pitch -0.022\n",
                                  "viewsize 110\n"};

// Runs the engine, which writes its config file when it quits, and returns the file's text. QuakeSpasm takes
// the home folder of the user account, not $HOME; so the test puts its own folder in that place, where only
// the engine sees it.
std::string write_config(const std::string& engine, const std::string& quit,
                         const std::filesystem::path& base, const TemporaryFolder& home) {
  home.write("base/id1/player.cfg", kPlayer + quit + "\n");
  const std::filesystem::path file = home.path() / ("." + engine) / "id1/config.cfg";
  const std::string run = "mount --bind \"$HOME\" /root && exec " + engine + " -basedir " + base.string() +
                          " -window -width 320 -height 240 -nosound +exec player.cfg";
  const BackgroundProgram program({TEMBLOR_SOURCE_DIR "/tests/support/on_display.sh", "320x240x24", "unshare",
                                   "--map-root-user", "--mount", "sh", "-c", run},
                                  home.path());
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  std::string text, before = "-";
  while (std::chrono::steady_clock::now() < end && (text.empty() || text != before)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    before = std::exchange(text, std::string());
    if (std::filesystem::exists(file)) text = base::as_text(read_file(file));
  }
  EXPECT_FALSE(text.empty()) << engine << " wrote no config file:\n" << program.output();
  return text;
}

struct Engine {
  const char *name, *quit;
};
class ForeignConfig : public ::testing::TestWithParam<Engine> {};

TEST_P(ForeignConfig, GivesTheSamePlayer) {
  const Engine engine = GetParam();
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_QUAKEC();
  if (!is_installed(engine.name) || !is_installed("xvfb-run") || !is_installed("unshare"))
    GTEST_SKIP() << engine.name << " or a display for it (xvfb, xauth) is not installed";
  const TemporaryFolder home;
  if (std::system("unshare --map-root-user --mount mount --bind /tmp /root 2>/dev/null") != 0)
    GTEST_SKIP() << "no user namespaces with mounts, to keep the engine out of this user's home folder";
  const std::optional<std::filesystem::path> base = make_quakespasm_folder(home, data, TEMBLOR_GAME_PROGRAM);
  if (!base) GTEST_SKIP() << "quakespasm, which has the picture of the registered version, is not installed";
  const std::string config = write_config(engine.name, engine.quit, *base, home);
  HeadlessHost host;
  std::filesystem::remove(host.folder().path() / "id1/temblor.cfg");
  host.folder().write("id1/config.cfg", config);
  host.restart();
  host.run(0.1);
  host.command("developer 1; exec config.cfg; writeconfig seen");
  host.run(0.1);
  const base::ByteVector seen = read_file(host.folder().path() / "id1/seen.cfg");
  for (const char* const line : kOurLines)
    EXPECT_THAT(std::string(base::as_text(seen)), HasSubstr(line)) << config;
  for (const std::string& line : host.lines())
    EXPECT_EQ(base::to_lower(line).find("unknown"), std::string::npos) << line;
}

INSTANTIATE_TEST_SUITE_P(Engines, ForeignConfig,
                         ::testing::Values(Engine{"quakespasm", "toggleconsole; quit"},
                                           Engine{"darkplaces", "defer 1 quit"}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace temblor::test
