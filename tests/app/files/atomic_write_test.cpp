#include "app/files/atomic_write.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;

TEST(ReplaceFile, WritesAllBytesAndLeavesNoOtherFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("level.bsp", "the level that was there before");
  ASSERT_TRUE(app::replace_file(file, base::as_bytes("new")).ok());
  EXPECT_EQ(read_text(file), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

// Another program's temporary file is not overwritten.
TEST(ReplaceFile, KeepsTemporaryFilesOfOtherPrograms) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "level.bsp";
  const fs::path others = folder.write("level.bsp.new", "half of a level");
  ASSERT_TRUE(app::replace_file(file, base::as_bytes("new")).ok());
  EXPECT_EQ(read_text(file), "new");
  EXPECT_EQ(read_text(others), "half of a level");
}

TEST(ReplaceFile, FollowsLinks) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("game/level.bsp", "old");
  const fs::path link = folder.path() / "link.bsp";
  fs::create_symlink("game/level.bsp", link);
  ASSERT_TRUE(app::replace_file(link, base::as_bytes("new")).ok());
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_text(file), "new");
}

TEST(ReplaceFile, MakesTheFolderOfAFileThatTheProgramNames) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "player" / "id1" / "quick.sav";
  ASSERT_TRUE(app::replace_file(file, base::as_bytes("saved"), app::Remedy::kNone).ok());
  EXPECT_EQ(read_text(file), "saved");
  const base::Status status =
      app::replace_file(file / "below_a_file" / "x", base::as_bytes("new"), app::Remedy::kNone);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message(), ::testing::HasSubstr("cannot write (Not a directory)"));
}

TEST(ReplaceFile, FailsForAnInvalidPath) {
  const TemporaryFolder folder;
  const base::Status status = app::replace_file(folder.path() / "none" / "level.bsp", base::as_bytes("new"));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, base::ErrorCode::kIo);
  EXPECT_THAT(status.error().message(), ::testing::HasSubstr("none/level.bsp"));
}

}  // namespace
}  // namespace temblor::test
