// `temblor compile` with files that are not what they should be: one line says what, and a level that was
// there stays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "app/program.h"
#include "support/levels/room_map.h"
#include "support/mutations.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string room(const std::string& world_fields = "") {
  return entity_text("worldspawn", world_fields, walls_text({-128, -128, 0}, {128, 128, 128}, "wall")) +
         point_text("info_player_start", {0, 0, 32});
}

std::string last_line(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1) + "\n";
}

class CompileBadInput : public ::testing::Test {
 protected:
  void expect_error(const std::vector<std::string>& words, const std::vector<std::string>& parts) {
    const ProgramRun run = run_program(folder_.path(), words);
    EXPECT_EQ(run.exit_status, 1) << run.err;
    EXPECT_TRUE(is_one_error_line(last_line(run.err))) << run.err;
    for (const std::string& part : parts) EXPECT_THAT(last_line(run.err), HasSubstr(part));
  }
  // A note, but also a level.
  void expect_note(const std::vector<std::string>& words, const std::string& part) {
    const ProgramRun run = run_program(folder_.path(), words);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("temblor: note: "));
    EXPECT_THAT(run.err, HasSubstr(part));
  }
  TemporaryFolder folder_;
};

TEST_F(CompileBadInput, InvalidMaps) {
  fs::create_directory(folder_.path() / "folder.map");
  folder_.write("bytes.map", std::string("\x01\x02{\xff\xfe", 5));
  folder_.write("unbalanced.map", room() + "}");
  folder_.write("unclosed.map", room().substr(0, 400));
  folder_.write("nan.map",
                room() + entity_text("func_wall", "", "{\n( 0 0 nan ) ( 0 1 0 ) ( 1 0 0 ) a 0 0 0 1 1\n}\n"));
  folder_.write("huge.map", room() + entity_text("func_wall", "",
                                                 "{\n( 0 0 1e99 ) ( 0 1 0 ) ( 1 0 0 ) a 0 0 0 1 1\n}\n"));
  folder_.write("noworld.map", point_text("info_player_start", {0, 0, 0}));
  expect_error({"compile", "folder.map"}, {"folder.map: not a file"});
  expect_error({"compile", "bytes.map"}, {"bytes.map", "line 1"});
  expect_error({"compile", "unbalanced.map"}, {"unbalanced.map", "line 57"});
  expect_error({"compile", "unclosed.map"}, {"unclosed.map", "entity 0 (worldspawn), brush 0, line 10"});
  expect_error({"compile", "nan.map"}, {"entity 2 (func_wall), brush 0, line 61", "nan"});
  expect_error({"compile", "huge.map"}, {"entity 2 (func_wall), brush 0, line 61", "1e+99"});
  expect_error({"compile", "noworld.map"}, {"noworld.map", "worldspawn"});
}

TEST_F(CompileBadInput, InvalidWads) {
  folder_.write("room.map", room());
  folder_.write("named.map", room("\"wad\" \"header.wad;nowhere/else.wad\""));
  folder_.write("header.wad", "WAD2");
  folder_.write("table.wad", base::Bytes(to_bytes(std::string("WAD2\x05\0\0\0\xff\xff\xff\x7f", 12))));
  // One entry, whose texture is beyond the end of the file.
  std::string lying("WAD2\x01\0\0\0\x0c\0\0\0", 12);
  lying += std::string("\xff\xff\xff\x7f\x10\0\0\0\x10\0\0\0\x44\0\0\0wall\0\0\0\0\0\0\0\0\0\0\0\0", 32);
  folder_.write("lying.wad", base::Bytes(to_bytes(lying)));
  fs::create_directory(folder_.path() / "empty");
  for (const char* wad : {"header.wad", "table.wad", "lying.wad"})
    expect_note({"compile", "room.map", "--wad", wad}, wad);
  expect_note({"compile", "room.map", "--wad", "room.map"}, "room.map");
  expect_note({"compile", "room.map", "--wad", "empty"}, "texture not found");
  expect_note({"compile", "named.map"}, "header.wad");
  expect_note({"compile", "named.map"}, "nowhere/else.wad");
}

// A WAD in the map's `wad` key is not missing if --wad names a file with the same name elsewhere.
TEST_F(CompileBadInput, WadsOfTheCommandLineAreNotMissing) {
  fs::create_directory(folder_.path() / "else");
  folder_.write("room.map", room("\"wad\" \"C:\\quake\\Walls.wad\""));
  folder_.write("else/walls.wad", std::string("WAD2\0\0\0\0\x0c\0\0\0", 12));
  expect_note({"compile", "room.map"}, "WAD not found");
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--wad", "else/walls.wad"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, ::testing::Not(HasSubstr("WAD not found")));
}

TEST_F(CompileBadInput, FullDisksAndBadOutputsLeaveNoFiles) {
  folder_.write("room.map", room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 0);
  const std::string before = read_text(folder_.path() / "room.bsp");
  fs::create_directory(folder_.path() / "taken.bsp");
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  expect_error({"compile", "room.map", "-o", "/dev/full"}, {"/dev/full", "No space left", "-o"});
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "not replaced by a level";
  EXPECT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "/dev/null"}).exit_status, 0);
  EXPECT_FALSE(fs::exists("/dev/null.build"));
  expect_error({"compile", "room.map", "-o", "taken.bsp"}, {"taken.bsp", "-o"});
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), before);
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("room.map", "room.bsp", "room.build", "taken.bsp"));
}

}  // namespace
}  // namespace temblor::test
