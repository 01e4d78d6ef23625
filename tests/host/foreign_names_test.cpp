// Names that players bring from other engines, in config files and at the console.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/headless_host.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

std::size_t count_lines(const HeadlessHost& host, std::string_view part) {
  return static_cast<std::size_t>(
      std::count_if(host.lines().begin(), host.lines().end(),
                    [&](const std::string& line) { return line.find(part) != std::string::npos; }));
}

double number(const HeadlessHost& host, std::string_view name) {
  return host.variables().variables().find(name)->number;
}

TEST(ForeignNames, SetTheSameSettingInItsUnit) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"cl_bob 0.01; r_lerpmodels 0; r_novis 1; cl_rollangle 0"});
  host.run(0.1);
  EXPECT_EQ(number(host, "v_bob"), 0.5);
  EXPECT_EQ(number(host, "cl_nolerp"), 1);
  EXPECT_EQ(number(host, "r_use_pvs"), 0);
  EXPECT_EQ(number(host, "v_roll"), 0);
  EXPECT_EQ(count_lines(host, "unknown"), 0u);
  host.command("cl_bob");
  host.run(0.1);
  EXPECT_TRUE(host.has_printed("\"cl_bob\" is called \"v_bob\" here"));
}

TEST(ForeignNames, WithoutACounterpartAreMentionedOnceToDevelopers) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"gl_texturemode 3; r_shadows 1"});
  host.run(0.1);
  EXPECT_EQ(count_lines(host, "gl_texturemode"), 0u);
  host.command("developer 1; gl_texturemode 3; gl_texturemode 2");
  host.run(0.1);
  EXPECT_EQ(count_lines(host, "gl_texturemode"), 1u);
  host.command("vid_widht 100");
  host.run(0.1);
  EXPECT_TRUE(host.has_printed("unknown command or variable \"vid_widht\"")) << "a mistyped name of ours";
}

TEST(ForeignNames, UnknownOnesInConfigFilesAreCounted) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host;
  host.folder().write("id1/autoexec.cfg", "nothing 1\nsensitivity 7\nno_such 2\nvid_stretch 1\nneither 3\n");
  host.restart();
  host.run(0.1);
  EXPECT_EQ(number(host, "sensitivity"), 7);
  EXPECT_EQ(count_lines(host, "unknown"), 1u);
  EXPECT_TRUE(host.has_printed("3 unknown commands or variables in config files, for example \"nothing\""));
  host.command("developer 1; exec autoexec.cfg");
  host.run(0.1);
  EXPECT_TRUE(host.has_printed("autoexec.cfg:3: unknown command or variable \"no_such\""));
}

}  // namespace
}  // namespace temblor::test
