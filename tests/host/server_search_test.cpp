#include "host/session/server_search.h"

#include <gmock/gmock.h>

#include <deque>

#include "net/transport/control.h"
#include "platform/headless/window.h"

namespace temblor {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A network on which replies arrive that a test has put there.
class FakeSocket : public platform::DatagramSocket {
 public:
  using Arrived = std::deque<std::pair<platform::Address, base::ByteVector>>;
  explicit FakeSocket(Arrived& io_arrived) : arrived_(io_arrived) {}

  void send(const platform::Address&, base::Bytes) override {}
  std::optional<platform::Datagram> receive() override {
    if (arrived_.empty()) return std::nullopt;
    last_ = std::move(arrived_.front());
    arrived_.pop_front();
    return platform::Datagram{last_.first, last_.second};
  }
  platform::Address local_address() const override { return {}; }

 private:
  Arrived& arrived_;
  std::pair<platform::Address, base::ByteVector> last_;
};

class ServerSearchTest : public ::testing::Test {
 protected:
  ServerSearchTest() { EXPECT_TRUE(search_.begin(0).ok()); }

  void reply(std::array<std::uint8_t, 4> host, std::string_view name, std::uint16_t port = 26000) {
    auto packet = net::write_control_packet(
        net::ServerInfoReply{.address = "", .host_name = name, .map = "dm4", .players = 1, .max_players = 8});
    arrived_.emplace_back(platform::ip4_address(host, port), std::move(packet).value());
  }
  std::vector<std::string> find_addresses() {
    search_.update(0.1);
    std::vector<std::string> addresses;
    for (const client::MenuServer& server : search_.found()) addresses.push_back(server.address);
    return addresses;
  }

  FakeSocket::Arrived arrived_;
  platform::headless::HeadlessWindow window_{{}};
  host::Services services_{
      .window = window_,
      .open_socket = [this](std::uint16_t) -> base::Result<std::unique_ptr<platform::DatagramSocket>> {
        return std::unique_ptr<platform::DatagramSocket>(std::make_unique<FakeSocket>(arrived_));
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

TEST_F(ServerSearchTest, ForgetsTheListOfTheLastSearch) {
  reply({192, 168, 0, 2}, "Attic");
  EXPECT_THAT(find_addresses(), ElementsAre("192.168.0.2:26000"));
  ASSERT_TRUE(search_.begin(1).ok());
  EXPECT_THAT(find_addresses(), IsEmpty());
  reply({192, 168, 0, 2}, "Attic");
  EXPECT_THAT(find_addresses(), ElementsAre("192.168.0.2:26000"));
}

}  // namespace
}  // namespace temblor
