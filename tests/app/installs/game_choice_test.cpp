#include "app/installs/game_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/program.h"
#include "formats/archives/pak.h"
#include "support/game_data.h"
#include "support/programs/background_program.h"
#include "support/programs/small_game.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(GameChoice, TheLineIsReplacedAndOthersStay) {
  const TemporaryFolder home;
  const fs::path file = home.path() / "temblor/temblor.cfg";
  EXPECT_EQ(app::read_choice(file, "/home/me").value(), std::nullopt);
  ASSERT_TRUE(app::write_choice(file, "/games/my quake").ok());
  EXPECT_EQ(app::read_choice(file, "/home/me").value(), "/games/my quake");
  home.write("temblor/temblor.cfg", "// mine\nbasedir a\n\xff unknown\n  BASEDIR ~/quake\n");
  EXPECT_EQ(app::read_choice(file, "/home/me").value(), "/home/me/quake");
  ASSERT_TRUE(app::write_choice(file, "temblor").ok());
  EXPECT_EQ(read_text(file), "// mine\n\xff unknown\nbasedir temblor\n");
}

TEST(GameChoice, BadFilesAreErrorsAndAreKept) {
  const TemporaryFolder home;
  const fs::path file = home.write("temblor.cfg", "\nbasedir\n");
  EXPECT_EQ(app::read_choice(file, "").error().message(),
            file.string() + ": line 2: basedir takes one folder; put quotes around a name with spaces");
  home.write("temblor.cfg", std::string(2 << 20, 'x'));
  EXPECT_THAT(app::read_choice(file, "").error().message(), HasSubstr(file.string() + ": 2097152 bytes"));
  EXPECT_FALSE(app::write_choice(file, "x").ok());
  EXPECT_EQ(fs::file_size(file), 2u << 20);
}

// A program with its shipped game, and a home with a Steam library.
class Household {
 public:
  Household() {
    fs::create_directories(path() / "bin");
    fs::create_directories(path() / "empty");
    fs::copy_file(TEMBLOR_PROGRAM, path() / "bin/temblor");
    fs::copy(game_.path(), path() / "bin/game", fs::copy_options::recursive);
    fs::create_directories(steam().parent_path());
    fs::copy(game_.path(), steam(), fs::copy_options::recursive);
    folder_.write("home/.steam/steam/steamapps/common/Quake/id1/pak0.pak", read_file(pak()));
  }
  const fs::path& path() const { return folder_.path(); }
  fs::path steam() const { return path() / "home/.steam/steam/steamapps/common/Quake"; }
  fs::path shipped() const { return path() / "bin/game"; }
  fs::path settings() const { return path() / "home/.config/temblor/temblor.cfg"; }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }

  // Plays for some frames with these commands. Returns what the program prints.
  std::string play(const std::string& commands, const std::string& environment = "",
                   const std::string& options = "") const {
    const std::string line =
        "cd '" + (path() / "empty").string() +
        "' && env -u TEMBLOR_DATA -u XDG_CONFIG_HOME -u XDG_DATA_HOME HOME='" + (path() / "home").string() +
        "' ASAN_OPTIONS=detect_leaks=0 " + environment +
        " '" TEMBLOR_SOURCE_DIR
        "/tests/support/on_display.sh"
        "' 640x480x24 ../bin/temblor " +
        options +
        " play --nosound --size 640x480 --duration 60 --exec 'alias w \"wait; wait; wait; wait; wait\"; w; " +
        commands + "; w; w; basedir; quit' >../out 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0);
    return read_text(path() / "out");
  }

 private:
  // An archive without files is an error.
  fs::path pak() const {
    const fs::path file = path() / "pak";
    folder_.write("pak",
                  formats::write_pak(std::vector{formats::ArchiveFile{"a", base::as_bytes("a")}}).value());
    return file;
  }
  SmallGame game_;
  TemporaryFolder folder_;
};

#define SKIP_WITHOUT_XVFB() \
  if (!is_installed("xvfb-run")) GTEST_SKIP() << "a display (xvfb, xauth) is not installed"

TEST(PlayProgram, OffersTheGameOfAStoreAndKeepsTheAnswer) {
  SKIP_WITHOUT_XVFB();
  const Household house;
  std::string out = house.play("screenshot asked");
  EXPECT_THAT(out, HasSubstr("Playing " + house.shipped().string()));
  EXPECT_THAT(out, HasSubstr("Quake (Steam)"));
  EXPECT_FALSE(fs::exists(house.settings())) << "no answer yet";
  const Png asked = read_png(house.shipped() / "id1/asked.png");

  out = house.play("basedir \"" + house.steam().string() + "\"");
  EXPECT_THAT(out, HasSubstr("Playing " + house.steam().string()));
  EXPECT_EQ(read_text(house.settings()), "basedir " + house.steam().string() + "\n");
  EXPECT_THAT(house.play("w"), HasSubstr("Playing " + house.steam().string()));

  out = house.play("basedir temblor; w; w; screenshot answered");
  EXPECT_THAT(out, HasSubstr("Playing " + house.shipped().string()));
  EXPECT_EQ(read_text(house.settings()), "basedir temblor\n");
  EXPECT_NE(read_png(house.shipped() / "id1/answered.png"), asked) << "the menu asks once";
}

TEST(PlayProgram, ExplicitGameDataTakesPrecedence) {
  SKIP_WITHOUT_XVFB();
  const Household house;
  house.write("home/.config/temblor/temblor.cfg", "basedir \"" + house.steam().string() + "\"\n");
  fs::copy(house.shipped(), house.path() / "data", fs::copy_options::recursive);
  EXPECT_THAT(house.play("w", "TEMBLOR_DATA=../data"), HasSubstr("Playing ../data"));
  EXPECT_THAT(house.play("w", "TEMBLOR_DATA=/nowhere", "--basedir ../bin/game"),
              HasSubstr("Playing ../bin/game"));
  EXPECT_THAT(house.play("w"), HasSubstr("Playing " + house.steam().string()));
}

TEST(PlayProgram, NamesSettingsThatItCannotUse) {
  SKIP_WITHOUT_XVFB();
  const Household house;
  house.write("home/.config/temblor/temblor.cfg", "basedir /nowhere\n");
  const std::string out = house.play("w");
  EXPECT_THAT(out, HasSubstr("temblor.cfg: basedir: there is no id1 in /nowhere"));
  EXPECT_THAT(out, HasSubstr("Playing " + house.shipped().string()));
  EXPECT_THAT(house.play("basedir /nowhere2"), HasSubstr("Playing " + house.shipped().string()))
      << "the game goes on";
  EXPECT_EQ(read_text(house.settings()), "basedir /nowhere\n");
}

}  // namespace
}  // namespace temblor::test
