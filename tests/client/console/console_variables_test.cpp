#include "client/console/console_variables.h"

#include <gtest/gtest.h>

namespace temblor::client {
namespace {

TEST(ConsoleVariables, SetTheirFields) {
  command::Variables variables;
  const ConsoleVariables console(variables);
  const ConsoleSettings defaults = console.read(variables);
  EXPECT_EQ(defaults.slide_speed, ConsoleSettings{}.slide_speed);
  EXPECT_EQ(defaults.text_size, 1);
  EXPECT_FALSE(defaults.high_contrast);
  for (const char* assignment :
       {"con_notifytime=7", "con_notifylines=9", "scr_conspeed=1000", "scr_conscale=2", "scr_conalpha=0.5",
        "con_highcontrast=1", "scr_textsize=1.5"})
    ASSERT_TRUE(variables.set_assignment(assignment).ok()) << assignment;
  const ConsoleSettings settings = console.read(variables);
  EXPECT_EQ(settings.notify_time_s, 7);
  EXPECT_EQ(settings.notify_rows, 9);
  EXPECT_EQ(settings.slide_speed, 1000);
  EXPECT_EQ(settings.scale, 2);
  EXPECT_EQ(settings.opacity, 0.5f);
  EXPECT_TRUE(settings.high_contrast);
  EXPECT_EQ(settings.text_size, 1.5f);
}

}  // namespace
}  // namespace temblor::client
