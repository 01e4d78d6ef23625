#include "host/session/server_search.h"

#include <gmock/gmock.h>

#include <deque>

#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "net/transport/control.h"
#include "platform/headless/window.h"
#include "support/programs/quakec.h"

namespace temblor {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

// A network on which replies arrive that a test has put there.
class FakeSocket : public platform::DatagramSocket {
 public:
  using Arrived = std::deque<std::pair<platform::Address, base::ByteVector>>;
  FakeSocket(Arrived& io_arrived, const double& waited_s) : arrived_(io_arrived), waited_s_(waited_s) {}

  void send(const platform::Address&, base::Bytes) override {}
  std::optional<platform::Datagram> receive() override {
    if (arrived_.empty()) return std::nullopt;
    last_ = std::move(arrived_.front());
    arrived_.pop_front();
    return platform::Datagram{.from = last_.first, .bytes = last_.second, .waited_s = waited_s_};
  }
  platform::Address local_address() const override { return {}; }

 private:
  Arrived& arrived_;
  const double& waited_s_;
  std::pair<platform::Address, base::ByteVector> last_;
};

class ServerSearchTest : public ::testing::Test {
 protected:
  ServerSearchTest() {
    window_.set_now(0);
    EXPECT_TRUE(search_.begin().ok());
  }

  void reply(std::array<std::uint8_t, 4> host, std::string_view name, std::uint16_t port = 26000) {
    auto packet = net::write_control_packet(
        net::ServerInfoReply{.address = "", .host_name = name, .map = "dm4", .players = 1, .max_players = 8});
    arrived_.emplace_back(platform::ip4_address(host, port), std::move(packet).value());
  }
  std::vector<std::string> find_addresses() {
    window_.set_now(0.1);
    search_.update();
    std::vector<std::string> addresses;
    for (const client::MenuServer& server : search_.found()) addresses.push_back(server.address);
    return addresses;
  }

  FakeSocket::Arrived arrived_;
  double waited_s_ = 0;  // of replies
  platform::headless::HeadlessWindow window_{{}};
  host::Services services_{
      .window = window_,
      .open_socket = [this](std::uint16_t) -> base::Result<std::unique_ptr<platform::DatagramSocket>> {
        return std::unique_ptr<platform::DatagramSocket>(std::make_unique<FakeSocket>(arrived_, waited_s_));
      },
      .is_own_host =
          [](const platform::Address& address) {
            return address.same_host(platform::ip4_address({192, 168, 0, 5}, 0));
          },
      .write_file = [](const std::filesystem::path&, base::Bytes) { return base::Status(base::Ok{}); },
      .print_line = [](std::string_view) {}};
  host::ServerSearch search_{services_};
};

TEST_F(ServerSearchTest, ListsServersWithTheSameName) {
  reply({192, 168, 0, 2}, "UNNAMED");
  reply({192, 168, 0, 3}, "UNNAMED");
  EXPECT_THAT(find_addresses(), ElementsAre("192.168.0.2:26000", "192.168.0.3:26000"));
}

TEST_F(ServerSearchTest, ListsAServerOfThisMachineOnce) {
  reply({127, 0, 0, 1}, "UNNAMED");
  reply({192, 168, 0, 5}, "UNNAMED");
  reply({192, 168, 0, 2}, "UNNAMED");
  reply({192, 168, 0, 2}, "UNNAMED");
  EXPECT_THAT(find_addresses(), ElementsAre("127.0.0.1:26000", "192.168.0.2:26000"));
}

// The reply was there long before the frame that reads it.
TEST_F(ServerSearchTest, PingIsTheTimeUntilTheReplyArrived) {
  waited_s_ = 0.088;
  reply({192, 168, 0, 2}, "Attic");
  find_addresses();
  ASSERT_EQ(search_.found().size(), 1u);
  EXPECT_EQ(search_.found()[0].ping_ms, 12);
}

TEST_F(ServerSearchTest, ForgetsTheListOfTheLastSearch) {
  reply({192, 168, 0, 2}, "Attic");
  EXPECT_THAT(find_addresses(), ElementsAre("192.168.0.2:26000"));
  ASSERT_TRUE(search_.begin().ok());
  EXPECT_THAT(find_addresses(), IsEmpty());
  reply({192, 168, 0, 2}, "Attic");
  EXPECT_THAT(find_addresses(), ElementsAre("192.168.0.2:26000"));
}

TEST(ServerList, IsPrintedAsTheServersReply) {
  SKIP_WITHOUT_QUAKEC();
  test::HeadlessHost host;
  FakeSocket::Arrived arrived;
  const double waited_s = 0;
  host.host().services.open_socket =
      [&](std::uint16_t) -> base::Result<std::unique_ptr<platform::DatagramSocket>> {
    return std::unique_ptr<platform::DatagramSocket>(std::make_unique<FakeSocket>(arrived, waited_s));
  };
  host.command("slist");
  host.run(0.1);
  EXPECT_THAT(host.lines(), Contains("Looking for servers on the local network..."));
  auto packet = net::write_control_packet(net::ServerInfoReply{
      .address = "", .host_name = "Attic", .map = "dm4", .players = 1, .max_players = 8});
  arrived.emplace_back(platform::ip4_address({192, 168, 0, 2}, 26000), std::move(packet).value());
  host.run(0.1);
  EXPECT_THAT(host.lines(), Contains(AllOf(StartsWith("192.168.0.2:26000 "), HasSubstr(" Attic "),
                                           HasSubstr(" dm4 "), HasSubstr(" 1/8 "))));
  EXPECT_FALSE(host.has_printed("connect ADDRESS")) << "the search goes on";
  host.run(6, 0.5);
  EXPECT_THAT(host.lines(), Contains("1 server; join with: connect ADDRESS"));
  host.command("slist");
  host.run(6, 0.5);
  EXPECT_THAT(host.lines(), Contains("No servers found."));
}

}  // namespace
}  // namespace temblor
