// Files of game code: below the data folder, and nowhere else.
#include "builtins/script_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::builtins {
namespace {

using base::ErrorCode;
using ::testing::ElementsAre;

std::string text_of_file(const std::filesystem::path& path) {
  return std::string(base::as_text(test::read_file(path)));
}

std::vector<std::string> list_lines(ScriptFiles& io_files, std::string_view name) {
  const int handle = io_files.open(name, ScriptFileMode::kRead).value();
  std::vector<std::string> lines;
  while (const auto line = io_files.read_line(handle).value()) lines.emplace_back(*line);
  EXPECT_TRUE(io_files.close(handle).ok());
  return lines;
}

void write_file(ScriptFiles& io_files, std::string_view name, ScriptFileMode mode, std::string_view text) {
  const int handle = io_files.open(name, mode).value();
  EXPECT_TRUE(io_files.write(handle, text).ok());
  EXPECT_TRUE(io_files.close(handle).ok());
}

std::size_t files_below(const std::filesystem::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    count += entry.is_regular_file() ? 1 : 0;
  return count;
}

TEST(ScriptFiles, WritesAppendsAndReadsBack) {
  test::TemporaryFolder folder;
  ScriptFiles files(folder.path() / "data", nullptr);
  write_file(files, "scores.txt", ScriptFileMode::kWrite, "one\ntwo\n");
  write_file(files, "data/scores.txt", ScriptFileMode::kAppend, "\nlast");
  EXPECT_EQ(text_of_file(folder.path() / "data" / "scores.txt"), "one\ntwo\n\nlast");
  EXPECT_THAT(list_lines(files, "scores.txt"), ElementsAre("one", "two", "", "last"));
  write_file(files, "scores.txt", ScriptFileMode::kWrite, "new");
  EXPECT_THAT(list_lines(files, "scores.txt"), ElementsAre("new"));
  write_file(files, "by/level/e1m1.txt", ScriptFileMode::kWrite, "deep\r\n");
  EXPECT_THAT(list_lines(files, "by/level/e1m1.txt"), ElementsAre("deep"));
}

TEST(ScriptFiles, ReadsGameDataIfTheFolderHasNoSuchFile) {
  test::TemporaryFolder folder;
  std::vector<std::string> asked;
  ScriptFiles files(folder.path() / "data", [&](std::string_view name) -> base::Result<base::ByteVector> {
    asked.emplace_back(name);
    if (name != "data/maps.txt") return base::error(ErrorCode::kNotFound, "not there");
    const base::Bytes bytes = base::as_bytes("start\ne1m1\n");
    return base::ByteVector(bytes.begin(), bytes.end());
  });
  EXPECT_THAT(list_lines(files, "maps.txt"), ElementsAre("start", "e1m1"));
  EXPECT_EQ(files.open("other.txt", ScriptFileMode::kRead).error().code, ErrorCode::kNotFound);
  write_file(files, "maps.txt", ScriptFileMode::kWrite, "mine");
  EXPECT_THAT(list_lines(files, "maps.txt"), ElementsAre("mine"));
  EXPECT_THAT(asked, ElementsAre("data/maps.txt", "data/other.txt"));
}

TEST(ScriptFiles, NamesCannotLeaveTheFolder) {
  test::TemporaryFolder folder;
  folder.write("secret.txt", "secret");
  ScriptFiles files(folder.path() / "data", [](std::string_view name) -> base::Result<base::ByteVector> {
    ADD_FAILURE() << name;
    return base::error(ErrorCode::kNotFound, "asked");
  });
  for (const std::string name : {"../secret.txt",
                                 "data/../../secret.txt",
                                 "a/../../secret.txt",
                                 "..",
                                 ".",
                                 "",
                                 "/etc/passwd",
                                 "data/",
                                 "data//etc/passwd",
                                 "a//b",
                                 "a/",
                                 ".hidden",
                                 "a/.hidden",
                                 "C:/secret.txt",
                                 "C:secret.txt",
                                 "..\\secret.txt",
                                 "a\\b",
                                 "a\nb",
                                 "a:b",
                                 "tail.",
                                 "tail ",
                                 " head",
                                 "caf\xe9",
                                 "a*b",
                                 "a|b",
                                 "~/x\x01"})
    for (const ScriptFileMode mode :
         {ScriptFileMode::kRead, ScriptFileMode::kAppend, ScriptFileMode::kWrite}) {
      const auto opened = files.open(name, mode);
      ASSERT_FALSE(opened.ok()) << name;
      EXPECT_EQ(opened.error().code, ErrorCode::kUsage) << name;
    }
  const std::string long_name(ScriptFiles::kMaxNameChars + 1, 'a');
  EXPECT_EQ(files.open(long_name, ScriptFileMode::kWrite).error().code, ErrorCode::kUsage);
  EXPECT_EQ(files_below(folder.path()), 1u);
}

TEST(ScriptFiles, HandlesAreCheckedAndFew) {
  test::TemporaryFolder folder;
  ScriptFiles files(folder.path(), nullptr);
  for (const int handle : {-1, 0, 5, ScriptFiles::kMaxOpen, 1 << 30}) {
    EXPECT_EQ(files.close(handle).error().code, ErrorCode::kUsage);
    EXPECT_EQ(files.read_line(handle).error().code, ErrorCode::kUsage);
    EXPECT_EQ(files.write(handle, "x").error().code, ErrorCode::kUsage);
  }
  for (int i = 0; i < ScriptFiles::kMaxOpen; ++i)
    EXPECT_EQ(files.open(fmt::format("f{}", i), ScriptFileMode::kWrite).value(), i);
  EXPECT_EQ(files.open("more", ScriptFileMode::kWrite).error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(files.read_line(3).error().code, ErrorCode::kUsage) << "it is open for writing";
  EXPECT_TRUE(files.close(3).ok());
  EXPECT_EQ(files.open("f3", ScriptFileMode::kRead).value(), 3);
  EXPECT_EQ(files.write(3, "x").error().code, ErrorCode::kUsage) << "it is open for reading";
  EXPECT_FALSE(files.read_line(3).value().has_value());
  EXPECT_TRUE(files.write(0, "kept").ok());
  EXPECT_TRUE(files.close_all().ok());
  EXPECT_EQ(text_of_file(folder.path() / "f0"), "kept");
  EXPECT_EQ(files.close(0).error().code, ErrorCode::kUsage);
}

TEST(ScriptFiles, AFileIsLimited) {
  test::TemporaryFolder folder;
  ScriptFiles files(folder.path(), nullptr);
  const std::string megabyte(std::size_t{1} << 20, 'x');
  int handle = files.open("big", ScriptFileMode::kWrite).value();
  for (std::size_t i = 0; i < ScriptFiles::kMaxFileBytes >> 20; ++i)
    ASSERT_TRUE(files.write(handle, megabyte).ok());
  EXPECT_EQ(files.write(handle, "x").error().code, ErrorCode::kTooLarge);
  ASSERT_TRUE(files.close(handle).ok());
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "big"), ScriptFiles::kMaxFileBytes);
  handle = files.open("big", ScriptFileMode::kAppend).value();
  EXPECT_EQ(files.write(handle, "x").error().code, ErrorCode::kTooLarge)
      << "appending starts at the file's size";
  ASSERT_TRUE(files.close(handle).ok());
}

TEST(ScriptFiles, WithoutAFolderNothingIsWritten) {
  ScriptFiles files;
  EXPECT_FALSE(files.can_write());
  EXPECT_EQ(files.open("a", ScriptFileMode::kWrite).error().code, ErrorCode::kUsage);
  EXPECT_EQ(files.open("a", ScriptFileMode::kRead).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace temblor::builtins
