#include "app/files/file_watch.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

class FileWatchTest : public ::testing::Test {
 protected:
  // Sets another modification time, because two saves may have the same one on a coarse clock.
  void save(const std::string& name, int seconds) {
    const auto path = folder_.write(name, name);
    std::filesystem::last_write_time(path, start_ + std::chrono::seconds(seconds));
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  template <typename... Paths>
  void watch(const Paths&... files) {
    watch_.add({app::read_file_stamp(files)...});
  }

  TemporaryFolder folder_;
  std::filesystem::file_time_type start_ = std::filesystem::file_time_type::clock::now();
  app::FileWatch watch_;
};

TEST_F(FileWatchTest, ReportsAChangeOnceWhenItIsStable) {
  save("a", 0);
  watch(path("a"));
  EXPECT_FALSE(watch_.has_changed());
  save("a", 10);
  EXPECT_FALSE(watch_.has_changed()) << "it may still be written";
  save("a", 20);
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
  EXPECT_FALSE(watch_.has_changed());
}

TEST_F(FileWatchTest, ReplacementIsAChangeButRemovalIsNot) {
  save("a", 0);
  save("b", 0);
  watch(path("a"), path("b"));
  std::filesystem::remove(path("a"));
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_FALSE(watch_.has_changed());
  save("a", 10);
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
  std::filesystem::remove(path("a"));
  save("b", 10);
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed()) << "the change of the other file is reported";
}

TEST_F(FileWatchTest, AddingAgainKeepsTheOlderStamp) {
  save("a", 0);
  watch(path("a"), path("later"));
  save("a", 10);
  watch(path("a"));
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
  save("later", 0);
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
}

TEST_F(FileWatchTest, ReportsAChangeBetweenStampAndWatch) {
  save("a", 0);
  const std::vector<app::FileStamp> before{app::read_file_stamp(path("a")),
                                           app::read_file_stamp(path("later"))};
  save("a", 10);
  watch_.add(before);
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
  save("later", 0);
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
  EXPECT_FALSE(watch_.has_changed());
}

TEST_F(FileWatchTest, NewFileChangesItsFolder) {
  std::filesystem::create_directory(path("art"));
  std::filesystem::last_write_time(path("art"), start_ - std::chrono::seconds(10));
  watch(path("art"));
  EXPECT_FALSE(watch_.has_changed());
  folder_.write("art/brick.png", "brick");
  EXPECT_FALSE(watch_.has_changed());
  EXPECT_TRUE(watch_.has_changed());
}

}  // namespace
}  // namespace temblor::test
