// The host's console: from afar, and against those who should not be here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "served/served_game.h"
#include "support/quakec.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(HostCommands, RemoteConsoleNeedsItsPassword) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("host");
  ASSERT_TRUE(served.run_until_playing(me));
  served.client(me).send_command("rcon anything status");
  served.run(1);
  EXPECT_THAT(served.prints(me), HasSubstr("wrong rcon password"));
  served.command("rcon_password secret");
  served.run(0.1);
  served.client(me).send_command("rcon secret status");
  served.run(1);
  EXPECT_THAT(served.prints(me), HasSubstr("map:     small"));
}

TEST(HostCommands, RemotePasswordsMayHaveBlanks) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("host");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("rcon_password \"a long sentence\"");
  served.run(0.1);
  served.client(me).send_command("rcon \"a long sentence\" say it works");
  served.run(1);
  EXPECT_THAT(served.prints(me), HasSubstr("it works"));
  EXPECT_THAT(served.console(), Not(HasSubstr("sentence")));
}

TEST(HostCommands, ABannedPlayersAddressCanBeUnbanned) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t rogue = served.add_client("rogue");
  ASSERT_TRUE(served.run_until_playing(rogue));
  served.command("ban #1");
  served.run(1);
  ASSERT_EQ(served.server().endpoint().bans().size(), 1u);
  served.client(rogue).connect(kServedAddress, served.now_s());
  EXPECT_FALSE(served.run_until_playing(rogue));
  served.command("unban 10.0.0.2");
  served.run(1);
  EXPECT_TRUE(served.server().endpoint().bans().empty()) << served.console();
  served.client(rogue).connect(kServedAddress, served.now_s());
  EXPECT_TRUE(served.run_until_playing(rogue));
}

}  // namespace
}  // namespace temblor::test
