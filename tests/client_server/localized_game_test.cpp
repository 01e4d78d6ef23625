// A game with localized texts: what its clients read, and what its saved games hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "formats/game/sav.h"
#include "server/save/save_game.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string localized_program() {
  std::string program = small_program();
  const std::string_view spawn = "void() worldspawn = {";
  program.insert(program.find(spawn) + spawn.size(), " self.message = \"$map_small\"; ");
  const std::string_view connect = "void() ClientConnect = {";
  program.insert(program.find(connect) + connect.size(), " bprint(\"$qc_welcome\"); ");
  return program;
}

ServedGameOptions localized_options() {
  return {.max_clients = 1,
          .files = {{"id1/localization/loc_english.txt",
                     "map_small = \"The Small Room\"\nqc_welcome = \"Welcome!\\n\"\nbad line\n"},
                    {"id1/localization/loc_german.txt",
                     "map_small = \"Das kleine Zimmer für Übung\"\nqc_welcome = \"Willkommen!\\n\"\n"}}};
}

TEST(LocalizedGame, ClientsReadTheServersLanguage) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(localized_program(), localized_options());
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  EXPECT_EQ(served.client(me).state().game().level_name, "The Small Room");
  EXPECT_THAT(served.prints(me), HasSubstr("Welcome!\n"));
  EXPECT_THAT(served.console(), HasSubstr("loc_english.txt: line 3: no '=' between a key and its text"));
}

TEST(LocalizedGame, ASavedGameGoesOnInAnotherLanguage) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(localized_program(), localized_options());
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  ASSERT_TRUE(server::save_game(served.server(), "x").ok());
  const std::string text(base::as_text(read_file(served.folder().path() / "id1/x.sav")));
  const formats::Sav sav = formats::read_sav(text).value();
  EXPECT_THAT(sav.comment, HasSubstr("The Small Room"));
  EXPECT_THAT(text, HasSubstr("$map_small"));
  EXPECT_THAT(text, Not(HasSubstr("\"The Small Room\"")));

  ASSERT_TRUE(served.variables().set("language", "german").ok());
  ASSERT_TRUE(server::load_saved_game(served.server(), "x").ok());
  served.run(3);
  EXPECT_EQ(served.client(me).state().game().level_name, "Das kleine Zimmer fur Ubung");
}

}  // namespace
}  // namespace temblor::test
