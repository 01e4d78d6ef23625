// A weapon has one name: in the menu's keys, in messages, in the map editor, and on the help picture.
#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

std::string read_lower(const char* file) {
  std::string text = read_text(repository_root() / file);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

TEST(WeaponNames, AreTheSameEverywhere) {
  const std::string pickups =
      read_lower("game/quakec/items/ammo_items.qc") + read_lower("game/quakec/weapons/tremor.qc");
  const std::string keys = read_lower("src/client/menu/pages/option_tables.cpp") +
                           read_lower("src/client/menu/pages/option_tables.h");
  const std::string editor = read_lower("packaging/trenchbroom/Temblor/Temblor.fgd");
  const std::string cheats = read_lower("src/server/commands/give.cpp");
  for (const std::string name : {"double-barreled shotgun", "nailgun", "super nailgun", "grenade launcher",
                                 "rocket launcher", "thunderbolt", "tremor"}) {
    const std::string quoted = '"' + name;
    EXPECT_NE(pickups.find(quoted), std::string::npos) << name;
    EXPECT_NE(keys.find(quoted), std::string::npos) << name;
    EXPECT_NE(editor.find(quoted), std::string::npos) << name;
    if (name == "tremor") continue;  // `give` does not know the program's own weapons by name
    EXPECT_NE(cheats.find(quoted), std::string::npos) << name;
  }
  const std::string help = read_lower("game/art/pictures/landscape.art");
  for (const char* name :
       {"1 pickaxe", "2 shotgun", "3 double-barreled shotgun", "4 nailgun", "5 super nailgun",
        "6 grenade launcher", "7 rocket launcher", "8 thunderbolt", "9 tremor"})
    EXPECT_NE(help.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace temblor::test
