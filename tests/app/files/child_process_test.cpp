#include "app/files/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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

}  // namespace
}  // namespace temblor::test
