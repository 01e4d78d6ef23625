#include "app/files/child_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Waits for at most 20 s.
bool ends(app::ChildProcess& io_process) {
  for (int i = 0; i < 2000 && !io_process.has_ended(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return io_process.has_ended();
}

TEST(ChildProcess, EndsByItself) {
  auto process = app::ChildProcess::start({"sh", "-c", "echo one; echo two; exit 3"});
  ASSERT_TRUE(process.ok()) << process.error().message();
  ASSERT_TRUE(ends(*process));
  EXPECT_THAT(process->messages(), ElementsAre("one", "two"));
  const base::Status status = process->finish();
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message(), HasSubstr("two"));
  EXPECT_TRUE(process->finish().ok()) << "the error has been reported";
}

TEST(ChildProcess, IsTerminatedWithoutWaiting) {
  auto process = app::ChildProcess::start({"sleep", "1000"});
  ASSERT_TRUE(process.ok()) << process.error().message();
  process->lower_priority();
  EXPECT_FALSE(process->has_ended());
  process->terminate();
  ASSERT_TRUE(ends(*process));
  EXPECT_FALSE(process->finish().ok());
}

TEST(ChildProcess, ReportsItsExitStatusAndOutput) {
  auto process = app::ChildProcess::start({"sh", "-c", "cat; printf 'a\\000b'; exit 3"});
  ASSERT_TRUE(process.ok()) << process.error().message();
  process->close_input();
  ASSERT_TRUE(ends(*process));
  EXPECT_EQ(process->wait().value(), 3);
  EXPECT_EQ(process->output_size(), 3u);
  EXPECT_EQ(process->output(100), std::string("a\0b", 3));
  EXPECT_EQ(process->output(1), "b");
  EXPECT_EQ(app::ChildProcess::start({"sh", "-c", "kill -9 $$"})->wait().value(), 128 + 9);
}

// The lock is free when no process has it open. The system needs a moment to end a process.
TEST(ChildProcess, SeparateSessionLeavesNoProcess) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "lock").string();
  folder.write("lock", "");
  const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
  for (const char* command : {"exec 9< \"$0\"; flock 9; echo begun; sleep 1000 & exit 0",
                              "exec 9< \"$0\"; flock 9; trap '' TERM; echo begun; sleep 1000; sleep 1000"}) {
    auto process = app::ChildProcess::start({"sh", "-c", command, path}, app::ChildSession::kSeparate);
    ASSERT_TRUE(process.ok()) << process.error().message();
    for (int i = 0; i < 2000 && process->messages().empty(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_NE(flock(file, LOCK_EX | LOCK_NB), 0) << command;
    { const app::ChildProcess ended = std::move(process).value(); }
    bool is_free = false;
    for (int i = 0; i < 2000 && !is_free; ++i) {
      is_free = flock(file, LOCK_EX | LOCK_NB) == 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(is_free ? 0 : 10));
    }
    EXPECT_TRUE(is_free) << command;
    flock(file, LOCK_UN);
  }
  close(file);
}

}  // namespace
}  // namespace temblor::test
