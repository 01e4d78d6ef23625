#include "vfs/file_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "formats/archives/pak.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::vfs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

struct TextFile {
  std::string name, text;
};

std::vector<formats::ArchiveFile> as_archive_files(const std::vector<TextFile>& files) {
  std::vector<formats::ArchiveFile> archived;
  for (const TextFile& file : files) archived.push_back({file.name, base::as_bytes(file.text)});
  return archived;
}

base::ByteVector make_pak(const std::vector<TextFile>& files) {
  return formats::write_pak(as_archive_files(files)).value();
}

base::ByteVector make_pk3(const std::vector<TextFile>& files) {
  return formats::write_pk3(as_archive_files(files)).value();
}

FileSystem open_or_die(const test::TemporaryFolder& base_folder, const std::vector<std::string>& games = {}) {
  return FileSystem::open(base_folder.path(), games).value();
}

std::string get_text(const FileSystem& files, std::string_view name) {
  const auto bytes = files.read(name);
  return bytes.ok() ? std::string(base::as_text(*bytes)) : bytes.error().message();
}

TEST(NormalizedName, IsLowerCaseWithSlashes) {
  EXPECT_EQ(normalize_name("Maps\\START.bsp"), "maps/start.bsp");
  EXPECT_EQ(normalize_name("a"), "a");
}

TEST(NormalizedName, RejectsNamesThatLeaveFolder) {
  for (const char* name : {"", "/a", "\\a", "..", "a/../b", "a\\..\\b", "c:\\a", "a//b", "a/"})
    EXPECT_EQ(normalize_name(name), std::nullopt) << name;
}

TEST(FileSystem, ReadsALooseFile) {
  const test::TemporaryFolder base_folder;
  const fs::path path = base_folder.write("id1/maps/start.bsp", "level");
  const FileSystem files = open_or_die(base_folder);
  EXPECT_EQ(get_text(files, "maps/start.bsp"), "level");
  EXPECT_TRUE(files.contains("maps/start.bsp"));
  EXPECT_EQ(files.where("maps/start.bsp"), path.string());
  EXPECT_EQ(files.describe("maps/start.bsp"), path.string());
  EXPECT_EQ(files.find_game("maps/start.bsp"), 0u);
}

TEST(FileSystem, IgnoresCase) {
  const test::TemporaryFolder base_folder;
  base_folder.write("ID1/Maps/Start.BSP", "loose");
  base_folder.write("ID1/PAK0.PAK", make_pak({{"GFX/Palette.lmp", "packed"}}));
  const FileSystem files = open_or_die(base_folder);
  EXPECT_EQ(get_text(files, "maps/start.bsp"), "loose");
  EXPECT_EQ(get_text(files, "MAPS\\START.BSP"), "loose");
  EXPECT_EQ(get_text(files, "gfx/palette.lmp"), "packed");
}

TEST(FileSystem, LowerCaseNameWins) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/README.TXT", "large");
  base_folder.write("id1/readme.txt", "small");
  base_folder.write("id1/Readme.txt", "mixed");
  EXPECT_EQ(get_text(open_or_die(base_folder), "ReadMe.txt"), "small");
}

TEST(FileSystem, LaterArchivesHideEarlierOnesAndLooseFiles) {
  const test::TemporaryFolder base_folder;
  for (const char* name : {"id1/a", "id1/b", "id1/c", "id1/d", "id1/e"}) base_folder.write(name, "loose");
  base_folder.write("id1/pak0.pak", make_pak({{"b", "pak0"}, {"c", "pak0"}, {"d", "pak0"}, {"e", "pak0"}}));
  base_folder.write("id1/pak1.pak", make_pak({{"c", "pak1"}, {"d", "pak1"}, {"e", "pak1"}}));
  base_folder.write("id1/alpha.pk3", make_pk3({{"d", "alpha"}, {"e", "alpha"}}));
  base_folder.write("id1/Beta.pk3", make_pk3({{"e", "beta"}}));
  const FileSystem files = open_or_die(base_folder);
  EXPECT_EQ(get_text(files, "a"), "loose");
  EXPECT_EQ(get_text(files, "b"), "pak0");
  EXPECT_EQ(get_text(files, "c"), "pak1");
  EXPECT_EQ(get_text(files, "d"), "alpha");
  EXPECT_EQ(get_text(files, "e"), "beta");
  EXPECT_EQ(files.where("c"), (base_folder.path() / "id1" / "pak1.pak").string());
  EXPECT_EQ(files.describe("c"), "c in " + files.where("c"));
}

TEST(FileSystem, PaksCountInNumericOrderUpToTheFirstGap) {
  const test::TemporaryFolder base_folder;
  for (int i = 0; i <= 12; ++i)
    if (i != 11)
      base_folder.write("id1/pak" + std::to_string(i) + ".pak", make_pak({{"which", std::to_string(i)}}));
  EXPECT_EQ(get_text(open_or_die(base_folder), "which"), "10");
}

TEST(FileSystem, FirstOfRepeatedPakNamesWins) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/pak0.pak", make_pak({{"x", "first"}, {"X", "second"}}));
  EXPECT_EQ(get_text(open_or_die(base_folder), "x"), "first");
}

TEST(FileSystem, PakNamesCannotLeaveFolder) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/pak0.pak",
                    make_pak({{"../x", "outside"}, {"", "nameless"}, {"maps\\a.bsp", "inside"}}));
  const FileSystem files = open_or_die(base_folder);
  EXPECT_THAT(files.list("", ""), ElementsAre("maps/a.bsp", "pak0.pak"));
}

TEST(FileSystem, LaterGamesHideEarlierOnes) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/pak0.pak", make_pak({{"a", "id1"}, {"b", "id1"}, {"c", "id1"}}));
  base_folder.write("one/b", "one");
  base_folder.write("one/c", "one");
  base_folder.write("Two/c", "two");
  const FileSystem files = open_or_die(base_folder, {"one", "two"});
  EXPECT_EQ(get_text(files, "a"), "id1");
  EXPECT_EQ(get_text(files, "b"), "one");
  EXPECT_EQ(get_text(files, "c"), "two");
  EXPECT_EQ(files.find_game("a"), 0u);
  EXPECT_EQ(files.find_game("b"), 1u);
  EXPECT_EQ(files.find_game("c"), 2u);
  EXPECT_EQ(files.folders().size(), 3u);

  EXPECT_EQ(get_text(open_or_die(base_folder, {"two", "ID1", "one"}), "c"), "one");
  const FileSystem again = open_or_die(base_folder, {"two", "one", "TWO"});
  EXPECT_EQ(get_text(again, "c"), "two");
  EXPECT_EQ(again.folders().size(), 3u);
}

TEST(FileSystem, MountOverHidesItsGameOnly) {
  const test::TemporaryFolder base_folder, elsewhere;
  base_folder.write("id1/pak0.pak", make_pak({{"archived", "id1's"}, {"both", "id1's"}}));
  base_folder.write("id1/loose", "id1's");
  base_folder.write("mod/both", "the mod's");
  elsewhere.write("archived", "my");
  elsewhere.write("loose", "my");
  elsewhere.write("both", "my");
  elsewhere.write("maps/new", "my");
  FileSystem files = open_or_die(base_folder, {"mod"});
  ASSERT_TRUE(files.mount_over(0, elsewhere.path()).ok());
  EXPECT_EQ(get_text(files, "archived"), "my");
  EXPECT_EQ(get_text(files, "loose"), "my");
  EXPECT_EQ(get_text(files, "maps/new"), "my");
  EXPECT_EQ(get_text(files, "both"), "the mod's");
  EXPECT_EQ(files.find_game("maps/new"), 0u);
  EXPECT_EQ(files.folders().size(), 2u);
  EXPECT_TRUE(files.mount_over(1, elsewhere.path() / "not there").ok());
}

TEST(FileSystem, SourcesAreInTheOrderOfSearch) {
  const test::TemporaryFolder base_folder, elsewhere;
  base_folder.write("shared.kpf", make_pk3({{"s", ""}}));
  base_folder.write("id1/pak0.pak", make_pak({{"a", ""}, {"b", ""}}));
  base_folder.write("id1/pak1.pak", make_pak({{"a", ""}}));
  base_folder.write("mod/extra.pk3", make_pk3({{"c", ""}}));
  FileSystem files = open_or_die(base_folder, {"mod"});
  ASSERT_TRUE(files.mount_over(0, elsewhere.path()).ok());
  std::vector<std::string> sources;
  for (const FileSystem::Source& source : files.sources())
    sources.push_back(fs::relative(source.path, base_folder.path()).string() +
                      (source.files_inside ? " " + std::to_string(*source.files_inside) : ""));
  EXPECT_THAT(sources,
              ElementsAre("mod/extra.pk3 1", "mod", fs::relative(elsewhere.path(), base_folder.path()),
                          "id1/pak1.pak 1", "id1/pak0.pak 2", "id1", "shared.kpf 1"));
}

TEST(FileSystem, ReadsTheLayersOfAFile) {
  const test::TemporaryFolder base_folder, user_folder;
  base_folder.write("id1/a.txt", "id1 loose");
  base_folder.write("id1/pak0.pak", make_pak({{"a.txt", "id1 pak"}, {"b.txt", "b"}}));
  base_folder.write("low/a.txt", "low");
  base_folder.write("top/A.TXT", "top");
  user_folder.write("a.txt", "low of the user");
  FileSystem files = open_or_die(base_folder, {"low", "top"});
  ASSERT_TRUE(files.mount_over(1, user_folder.path()).ok());
  std::vector<std::string> found;
  for (const FileSystem::Layer& layer : files.read_layers("A.txt"))
    found.push_back(std::to_string(layer.game) + std::string(base::as_text(layer.bytes.value())));
  EXPECT_THAT(found, ElementsAre("0id1 pak", "1low of the user", "2top"));
  EXPECT_EQ(files.read_layers("a.txt")[0].description,
            "a.txt in " + (base_folder.path() / "id1/pak0.pak").string());
  EXPECT_EQ(files.read_layers("b.txt").size(), 1u);
  EXPECT_THAT(files.read_layers("c.txt"), IsEmpty());
  EXPECT_THAT(files.read_layers("../c.txt"), IsEmpty());
  files.hide_file("a.txt");
  EXPECT_THAT(files.read_layers("a.txt"), IsEmpty());
}

TEST(FileSystem, MountsASingleFileAboveAllOthers) {
  const test::TemporaryFolder base_folder, elsewhere;
  base_folder.write("id1/pak0.pak", make_pak({{"maps/a.bsp", "id1's"}, {"maps/a.lit", "id1's"}}));
  base_folder.write("mod/maps/a.bsp", "the mod's");
  elsewhere.write("level.bsp", "my");
  FileSystem files = open_or_die(base_folder, {"mod"});
  files.mount_file("maps/A.bsp", elsewhere.path() / "level.bsp");
  EXPECT_EQ(get_text(files, "maps/a.bsp"), "my");
  EXPECT_EQ(files.find_game("maps/a.bsp"), 1u);
  EXPECT_EQ(files.where("maps/a.bsp"), (elsewhere.path() / "level.bsp").string());
  files.mount_file("../a.bsp", elsewhere.path() / "level.bsp");
  EXPECT_FALSE(files.contains("../a.bsp"));
  files.hide_file("MAPS/a.lit");
  EXPECT_FALSE(files.contains("maps/a.lit"));
  FileSystem none;
  none.mount_file("maps/a.bsp", elsewhere.path() / "level.bsp");
  EXPECT_EQ(get_text(none, "maps/a.bsp"), "my");
}

TEST(FileSystem, ListsSortedWithoutDuplicates) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/maps/B.bsp", "");
  base_folder.write("id1/maps/b.lit", "");
  base_folder.write("id1/maps/deep/c.bsp", "");
  base_folder.write("id1/mapsx/d.bsp", "");
  base_folder.write("id1/pak0.pak", make_pak({{"maps/a.bsp", ""}, {"maps/b.bsp", ""}}));
  const FileSystem files = open_or_die(base_folder);
  EXPECT_THAT(files.list("maps/", ".bsp"), ElementsAre("maps/a.bsp", "maps/b.bsp", "maps/deep/c.bsp"));
  EXPECT_THAT(files.list("Maps/", ".LIT"), ElementsAre("maps/b.lit"));
  EXPECT_THAT(files.list("nothing", ""), IsEmpty());
}

TEST(FileSystem, MissingFileErrorListsFolders) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/a", "");
  base_folder.write("mod/a", "");
  const auto bytes = open_or_die(base_folder, {"mod"}).read("maps/x\n.bsp");
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, base::ErrorCode::kNotFound);
  const std::string message = bytes.error().message();
  EXPECT_THAT(message, HasSubstr("maps/x?.bsp: not in"));
  EXPECT_THAT(message, HasSubstr((base_folder.path() / "id1").string()));
  EXPECT_THAT(message, HasSubstr((base_folder.path() / "mod").string()));
  EXPECT_THAT(message, HasSubstr("--game"));
}

TEST(FileSystem, ReaderOutlivesFileSystem) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/loose", "in a file");
  base_folder.write("id1/pak0.pak", make_pak({{"a", "other"}, {"packed", "in a pak"}}));
  base_folder.write("id1/x.pk3", make_pk3({{"zipped", "in a pk3"}}));
  std::optional<FileSystem> files(open_or_die(base_folder));
  std::vector<std::pair<std::string, std::function<base::Result<base::ByteVector>()>>> readers;
  for (const char* const name : {"loose", "packed", "zipped", "nowhere"})
    readers.emplace_back(get_text(*files, name), files->reader(name));
  files.reset();
  for (const auto& [text, read] : readers) {
    const auto bytes = read();
    EXPECT_EQ(bytes.ok() ? std::string(base::as_text(*bytes)) : bytes.error().message(), text);
  }
  EXPECT_FALSE(readers.back().second().ok());
}

// The layout of the 2021 release: QuakeEX.kpf next to the games.
void write_release(const test::TemporaryFolder& folder, const std::string& prefix) {
  folder.write(prefix + "QuakeEX.kpf",
               make_pk3({{"localization/loc_english.txt", "shared"}, {"a.txt", "shared"}}));
  folder.write(prefix + "id1/pak0.pak", make_pak({{"a.txt", "id1"}}));
  folder.write(prefix + "mg1/pak0.pak", make_pak({{"b.txt", "mg1"}}));
}

TEST(FileSystem, FindsTheReleaseBelowItsFolder) {
  const test::TemporaryFolder base_folder;
  write_release(base_folder, "Rerelease/");
  for (const fs::path& folder : {base_folder.path(), base_folder.path() / "Rerelease"}) {
    const auto files = FileSystem::open(folder, std::vector<std::string>{"mg1"});
    ASSERT_TRUE(files.ok()) << files.error().message();
    EXPECT_EQ(get_text(*files, "Localization/loc_english.txt"), "shared");
    EXPECT_EQ(files->find_game("localization/loc_english.txt"), 0u);
    EXPECT_EQ(get_text(*files, "a.txt"), "id1") << "a game hides what all games share";
    EXPECT_EQ(get_text(*files, "b.txt"), "mg1");
    EXPECT_EQ(files->folders()[0], base_folder.path() / "Rerelease/id1");
  }
  // The game of 1996, which stores install next to the release, is the folder's own game.
  base_folder.write("id1/a.txt", "1996");
  EXPECT_EQ(get_text(open_or_die(base_folder), "a.txt"), "1996");
  EXPECT_FALSE(open_or_die(base_folder).contains("localization/loc_english.txt"));
}

TEST(FileSystem, KpfInAGameCountsAsPk3) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/a.KPF", make_pk3({{"a.txt", "kpf"}, {"b.txt", "kpf"}}));
  base_folder.write("id1/b.pk3", make_pk3({{"a.txt", "pk3"}}));
  const FileSystem files = open_or_die(base_folder);
  EXPECT_EQ(get_text(files, "a.txt"), "pk3");
  EXPECT_EQ(get_text(files, "b.txt"), "kpf");
}

TEST(FileSystem, NamesADamagedKpf) {
  const base::ByteVector whole = make_pk3({{"localization/loc_english.txt", std::string(10000, 'x')}});
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
    const test::TemporaryFolder base_folder;
    base_folder.write("id1/a.txt", "id1");
    base_folder.write("QuakeEX.kpf",
                      base::ByteVector(whole.begin(), whole.begin() + static_cast<long>(size)));
    const auto files = FileSystem::open(base_folder.path());
    ASSERT_FALSE(files.ok()) << size;
    EXPECT_THAT(files.error().message(), HasSubstr((base_folder.path() / "QuakeEX.kpf").string()));
  }
}

TEST(FileSystem, MissingFoldersAreErrors) {
  const test::TemporaryFolder base_folder;
  const auto none = FileSystem::open(base_folder.path() / "nowhere");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, base::ErrorCode::kNotFound);
  EXPECT_THAT(none.error().message(), HasSubstr("--basedir"));

  const auto empty = FileSystem::open(base_folder.path());
  ASSERT_FALSE(empty.ok());
  EXPECT_THAT(empty.error().message(), HasSubstr("no game folder \"id1\""));

  base_folder.write("id1/a", "");
  base_folder.write("file", "not a folder");
  for (const char* game : {"mod", "file"}) {
    const auto missing = FileSystem::open(base_folder.path(), std::vector<std::string>{game});
    ASSERT_FALSE(missing.ok()) << game;
    EXPECT_EQ(missing.error().code, base::ErrorCode::kNotFound);
    EXPECT_THAT(missing.error().message(), HasSubstr(game));
  }
}

TEST(FileSystem, RejectsInvalidGameNames) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/a", "");
  for (const char* game : {"", "..", ".", "id1/../id1", "/tmp", "a/b", "a\\b"}) {
    const auto files = FileSystem::open(base_folder.path(), std::vector<std::string>{game});
    ASSERT_FALSE(files.ok()) << game;
    EXPECT_EQ(files.error().code, base::ErrorCode::kUsage) << game;
  }
}

TEST(FileSystem, NamesDamagedArchive) {
  for (const char* name : {"pak0.pak", "bad.pk3"}) {
    const test::TemporaryFolder base_folder;
    const fs::path path = base_folder.write(std::string("id1/") + name, "no archive at all");
    const auto files = FileSystem::open(base_folder.path());
    ASSERT_FALSE(files.ok()) << name;
    EXPECT_EQ(files.error().file, path.string());
    EXPECT_THAT(files.error().what, HasSubstr("copy this archive from the game again"));
  }
}

TEST(FileSystem, RejectsEmptyArchive) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/pak0.pak", "");
  EXPECT_FALSE(FileSystem::open(base_folder.path()).ok());
}

TEST(FileSystem, DamagedPk3EntryFailsOnRead) {
  const test::TemporaryFolder base_folder;
  base::ByteVector bytes = make_pk3({{"a", std::string(1000, 'a')}});
  bytes[35] ^= std::byte{0xff};  // packed data: after the local header of 30 bytes and the name of 1
  base_folder.write("id1/x.pk3", bytes);
  const FileSystem files = open_or_die(base_folder);
  const auto data = files.read("a");
  ASSERT_FALSE(data.ok());
  EXPECT_THAT(data.error().message(), HasSubstr("a in "));
  EXPECT_THAT(data.error().message(), HasSubstr("x.pk3"));
}

// Makes a sparse file of `size` bytes, which uses no disk space.
void make_sparse(const fs::path& path, std::uint64_t size) {
  fs::create_directories(path.parent_path());
  std::ofstream(path).close();
  fs::resize_file(path, size);
}

TEST(FileSystem, RejectsHugeFilesUnread) {
  constexpr std::uint64_t kThreeGb = 3'000'000'000;
  const test::TemporaryFolder loose;
  make_sparse(loose.path() / "id1" / "maps" / "a.bsp", kThreeGb);
  const auto bytes = open_or_die(loose).read("maps/a.bsp");
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, base::ErrorCode::kTooLarge);

  const test::TemporaryFolder packed;
  make_sparse(packed.path() / "id1" / "big.pk3", kThreeGb);
  const auto files = FileSystem::open(packed.path());
  ASSERT_FALSE(files.ok());
  EXPECT_EQ(files.error().code, base::ErrorCode::kTooLarge);
}

TEST(FileSystem, RejectsHugePakEntryUnread) {
  const test::TemporaryFolder base_folder;
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("PACK"));
  writer.i32(12);
  writer.i32(64);
  writer.fixed_text("huge", 56);
  writer.i32(0);
  writer.i32(2'000'000'000);
  const fs::path path = base_folder.write("id1/pak0.pak", writer.view());
  fs::resize_file(path, 2'000'000'000);
  const auto bytes = open_or_die(base_folder).read("huge");
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, base::ErrorCode::kTooLarge);
  EXPECT_THAT(bytes.error().message(), HasSubstr("huge in " + path.string()));
}

TEST(FileSystem, FollowsLinksThatDoNotLoop) {
  const test::TemporaryFolder base_folder;
  base_folder.write("id1/a", "file");
  fs::create_directory_symlink(base_folder.path() / "id1", base_folder.path() / "id1" / "loop");
  fs::create_symlink(base_folder.path() / "nowhere", base_folder.path() / "id1" / "dangling");
  fs::create_symlink(base_folder.path() / "id1" / "a", base_folder.path() / "id1" / "b");
  fs::create_directory_symlink(base_folder.path() / "id1", base_folder.path() / "mod");
  base_folder.write("elsewhere/track02.ogg", "music");
  fs::create_directory_symlink(base_folder.path() / "elsewhere", base_folder.path() / "id1" / "music");
  const FileSystem files = open_or_die(base_folder, {"mod"});
  EXPECT_THAT(files.list("", ""), ElementsAre("a", "b", "music/track02.ogg"));
  EXPECT_EQ(get_text(files, "b"), "file");
  EXPECT_EQ(get_text(files, "music/track02.ogg"), "music");
}

TEST(FileSystem, RejectsShrunkFile) {
  const test::TemporaryFolder base_folder;
  const fs::path path = base_folder.write("id1/pak0.pak", make_pak({{"a", "content"}}));
  const FileSystem files = open_or_die(base_folder);
  fs::resize_file(path, 14);
  const auto bytes = files.read("a");
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, base::ErrorCode::kIo);
}

TEST(FileSystem, FindsStockData) {
  DATA_FOLDER_OR_SKIP(data);
  const auto files = FileSystem::open(data);
  ASSERT_TRUE(files.ok()) << files.error().message();
  const auto palette = files->read("gfx/PALETTE.lmp");
  ASSERT_TRUE(palette.ok()) << palette.error().message();
  EXPECT_EQ(palette->size(), 768u);
  EXPECT_THAT(files->list("maps/", ".bsp"), ::testing::Contains("maps/start.bsp"));
}

}  // namespace
}  // namespace temblor::vfs
