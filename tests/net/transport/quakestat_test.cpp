// Queries by a real server browser over a real socket: quakestat (Debian package qstat).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "net/transport/endpoint_bench.h"
#include "net/transport/server_endpoint.h"
#include "platform/posix/udp_socket.h"

namespace temblor::net {
namespace {

using ::testing::HasSubstr;

std::string capture_output(const std::string& command) {
  struct Close {
    void operator()(FILE* pipe) const { pclose(pipe); }
  };
  const std::unique_ptr<FILE, Close> pipe(popen(command.c_str(), "r"));
  std::string output;
  std::array<char, 4096> part{};
  while (pipe != nullptr && fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr)
    output += part.data();
  return output;
}

// Serves queries on a port of this machine until it is destroyed.
class ServedPort {
 public:
  explicit ServedPort(const ServerDescription& description)
      : endpoint_(sockets(), {}, [description] { return description; }),
        port_(endpoint_.local_address().port),
        thread_([this] { serve(); }) {}
  ~ServedPort() {
    stop_ = true;
    thread_.join();
  }
  std::uint16_t port() const { return port_; }

 private:
  static ServerEndpoint::Sockets sockets() {
    ServerEndpoint::Sockets one;
    one.push_back(platform::posix::open_udp_socket({.host = "127.0.0.1"}).value());
    return one;
  }
  void serve() {
    for (double now_s = 0; !stop_; now_s += 0.005) {
      endpoint_.update(now_s);
      while (endpoint_.next_event(now_s)) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  ServerEndpoint endpoint_;
  std::uint16_t port_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;  // last member: the thread uses the others
};

TEST(Quakestat, ShowsServerPlayersAndRules) {
  if (std::system("command -v quakestat >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "quakestat is not installed (package qstat)";
  ServerDescription description = test::described();
  for (int i = 0; i < 15; ++i)
    description.players.push_back({"player" + std::to_string(i), 0, i, 10, "private"});
  for (int i = 0; i < 20; ++i)
    description.rules.push_back({"sv_rule" + std::to_string(i), std::to_string(i)});
  const ServedPort server(description);
  const std::string output =
      capture_output("quakestat -qs 127.0.0.1:" + std::to_string(server.port()) + " -P -R -raw '|' 2>&1");
  EXPECT_THAT(output, HasSubstr("|a host|"));
  EXPECT_THAT(output, HasSubstr("|dm1|16|16|"));
  EXPECT_THAT(output, HasSubstr("fraglimit=20"));
  EXPECT_THAT(output, HasSubstr("sv_rule19=19"));
  EXPECT_THAT(output, HasSubstr("bob"));
  EXPECT_THAT(output, HasSubstr("player14"));
}

}  // namespace
}  // namespace temblor::net
