// The layout of the 2021 release, made from LibreQuake's data and the shipped game: an archive for each game,
// and QuakeEX.kpf with localized texts next to them. Played from the start of a level to its exit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/archives/pak.h"
#include "formats/archives/pk3.h"
#include "formats/levels/bsp.h"
#include "scripted_player/session/run.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTexts =
    "// Texts\nmap_lq = \"The First Level\"\nmap_t1 = \"The Level of the Add-on\"\n";

// Replaces the title of a level by a key.
base::ByteVector rename_level(const base::ByteVector& bytes, std::string_view key) {
  formats::Bsp bsp = formats::read_bsp(bytes).value();
  constexpr std::string_view kName = "\"message\" \"";
  const std::size_t begin = bsp.entities.find(kName) + kName.size();
  bsp.entities.replace(begin, bsp.entities.find('"', begin) - begin, key);
  return formats::write_bsp(bsp, formats::BspVersion::k29).value();
}

// Packs folders of id1 and the game code.
base::ByteVector pack_game(const fs::path& id1, const std::string& level, std::string_view key) {
  std::vector<std::pair<std::string, base::ByteVector>> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(id1, fs::directory_options::follow_directory_symlink)) {
    const std::string name = fs::relative(entry.path(), id1).string();
    const bool is_level = name.starts_with("maps/") && !name.starts_with("maps/b_");
    if (!entry.is_regular_file() || name.starts_with("music") || name.ends_with(".dem")) continue;
    if (is_level && name != "maps/" + level + ".bsp") continue;
    base::ByteVector bytes = read_file(entry.path());
    files.emplace_back(name, is_level ? rename_level(bytes, key) : std::move(bytes));
  }
  if (std::none_of(files.begin(), files.end(), [](const auto& file) { return file.first == "progs.dat"; }))
    files.emplace_back("progs.dat", read_file(TEMBLOR_GAME_PROGRAM));
  std::vector<formats::ArchiveFile> archive;
  for (const auto& [name, bytes] : files) archive.push_back({name, bytes});
  return formats::write_pak(archive).value();
}

struct Played {
  std::string title{};
  bool has_reached_exit = false;
  std::string report{};
};

// The player cannot be hurt, because this tests the data, not fights.
Played play(const fs::path& base_folder, const std::vector<std::string>& games, const std::string& level) {
  player::RunSetup setup;
  setup.session.base_folder = base_folder;
  setup.session.games = games;
  setup.session.map = level;
  setup.session.can_cheat = setup.has_god = true;
  Played played;
  const auto session = player::Session::start(setup.session);
  if (!session.ok()) return {.report = session.error().message()};
  played.title = (*session)->client(0).state().game().level_name;
  const player::RunReport report = player::play_level(setup).value();
  played.has_reached_exit = report.reached_exit;
  played.report = player::as_text(report);
  return played;
}

TEST(ReleaseLayout, IsPlayedToItsExits) {
  DATA_FOLDER_OR_SKIP(data);
  if (!fs::exists(fs::path(TEMBLOR_SHIPPED_FOLDER) / "id1/maps/t1.bsp"))
    GTEST_SKIP() << "t1 has not been built";
  const TemporaryFolder folder;
  folder.write("rerelease/id1/pak0.pak", pack_game(data / "id1", "lq_e0m1", "$map_lq"));
  folder.write("rerelease/mg1/pak0.pak",
               pack_game(fs::path(TEMBLOR_SHIPPED_FOLDER) / "id1", "t1", "$map_t1"));
  folder.write("rerelease/QuakeEX.kpf",
               formats::write_pk3(
                   std::vector{formats::ArchiveFile{"localization/loc_english.txt", base::as_bytes(kTexts)}})
                   .value());
  const Played first = play(folder.path(), {}, "lq_e0m1");
  EXPECT_EQ(first.title, "The First Level");
  EXPECT_TRUE(first.has_reached_exit) << first.report;
  const Played second = play(folder.path() / "rerelease", {"mg1"}, "t1");
  EXPECT_EQ(second.title, "The Level of the Add-on");
  EXPECT_TRUE(second.has_reached_exit) << second.report;
}

}  // namespace
}  // namespace temblor::test
