// Clients that load a level slowly. Stock ones read packets in the meantime to stay connected, and give
// up if these contain anything.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "net/protocol/client_message.h"
#include "net/protocol/message_reader.h"
#include "net/transport/client_endpoint.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

// A client that sends nothing on its own, and stores the names of levels and all text that it is sent.
class SlowClient {
 public:
  explicit SlowClient(ServedGame& io_served)
      : served_(io_served), endpoint_(io_served.network().open(platform::ip4_address({10, 0, 9, 9}, 4000))) {
    endpoint_.connect(kServedAddress, served_.now_s());
  }

  void run(double seconds) {
    for (const double until_s = served_.now_s() + seconds; served_.now_s() < until_s;) {
      served_.run(1.0 / 72);
      endpoint_.update(served_.now_s());
      while (const auto event = endpoint_.next_event(served_.now_s()))
        if (const auto* packet = std::get_if<net::FromServer>(&*event)) read(packet->bytes);
    }
  }
  void say(std::string_view line) {
    base::ByteWriter writer;
    CHECK(net::write_client_message(net::StringCommand{line}, net::Protocol::kNetQuake, writer).ok());
    CHECK(endpoint_.send_reliable(std::move(writer).take()).ok());
  }

  int levels = 0;       // serverinfos
  int since_level = 0;  // messages after the last serverinfo, except those that belong to it
  int signon = 0;       // the last signon number
  std::string texts;    // prints and stufftexts

 private:
  void read(base::Bytes packet) {
    reader_.begin(packet);
    bool brings_level = false;
    for (auto message = reader_.next(); message.ok() && *message; message = reader_.next()) {
      if (std::holds_alternative<net::ServerInfo>(**message)) {
        brings_level = true;
        ++levels;
        since_level = 0;
      }
      since_level += brings_level || std::holds_alternative<net::Nop>(**message) ? 0 : 1;
      if (const auto* number = std::get_if<net::SignonNumber>(&**message)) signon = number->number;
      if (const auto* print = std::get_if<net::Print>(&**message)) texts += print->text;
      if (const auto* stuffed = std::get_if<net::StuffText>(&**message)) texts += stuffed->text;
    }
  }

  ServedGame& served_;
  net::ClientEndpoint endpoint_;
  net::MessageReader reader_;
};

TEST(Joining, ALoadingClientIsSentNothing) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t other = served.add_client("talker");
  ASSERT_TRUE(served.run_until_playing(other));
  SlowClient slow(served);
  slow.run(1);
  ASSERT_EQ(slow.levels, 1);
  for (int i = 0; i < 10; ++i) {
    served.command(fmt::format("say line {}", i));
    slow.run(0.2);
  }
  EXPECT_EQ(slow.since_level, 0);
  slow.say("prespawn");
  slow.run(1);
  EXPECT_EQ(slow.signon, 2);
  for (int i = 0; i < 10; ++i) EXPECT_THAT(slow.texts, HasSubstr(fmt::format("line {}\n", i)));
}

TEST(Joining, ALevelThatChangesMeanwhileFollowsTheFirst) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  SlowClient slow(served);
  slow.run(1);
  ASSERT_EQ(slow.levels, 1);
  served.command("changelevel small");
  slow.run(1);
  EXPECT_EQ(slow.levels, 1);
  EXPECT_EQ(slow.since_level, 0);
  slow.say("prespawn");
  slow.run(1);
  EXPECT_EQ(slow.levels, 2);
  EXPECT_THAT(slow.texts, HasSubstr("reconnect"));
  EXPECT_EQ(slow.signon, 1);
  EXPECT_EQ(slow.since_level, 0);
  for (const std::string_view line : {"prespawn", "spawn", "begin"}) {
    slow.say(line);
    slow.run(1);
  }
  EXPECT_EQ(slow.signon, 3);
  EXPECT_EQ(served.server().clients[0].stage, server::ClientStage::kPlaying);
}

// The second change happens before the first could be sent: no answer to the first is expected.
TEST(Joining, LevelsThatFollowAtOnceAreSentOnce) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.conditions = {.delay_s = 0.1}});
  const std::size_t me = served.add_client("me");
  ASSERT_TRUE(served.run_until_playing(me));
  for (const std::string_view line : {"changelevel small; changelevel small", "map small; reload; restart"}) {
    served.command(line);
    served.run(5);
    EXPECT_TRUE(served.client(me).is_playing()) << line << served.console();
    EXPECT_EQ(served.server().clients[0].stage, server::ClientStage::kPlaying) << line;
  }
}

TEST(Joining, AClientThatConnectsDuringALevelChangeGetsThere) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("me");
  for (int i = 0; i < 6; ++i) {
    served.command("changelevel small");
    served.run(0.03);
  }
  served.run(5);
  EXPECT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason() << served.console();
}

}  // namespace
}  // namespace temblor::test
