// docs/settings.md names every console variable.
#include <gtest/gtest.h>

#include "app/program.h"
#include "command/variables.h"
#include "host/host_variables.h"

namespace temblor::test {
namespace {

TEST(SettingsPage, NamesEveryVariable) {
  const std::string page = read_text(std::filesystem::path(TEMBLOR_DOCS) / "settings.md");
  command::Variables variables;
  const host::HostVariables settings(variables);
  for (const command::Variable* variable : variables.all()) {
    // "`scratch1` to `scratch4`" includes those between.
    if (variable->name == "scratch2" || variable->name == "scratch3" || variable->name == "saved2" ||
        variable->name == "saved3")
      continue;
    EXPECT_NE(page.find("`" + variable->name + "`"), std::string::npos) << variable->name;
  }
}

}  // namespace
}  // namespace temblor::test
