// A bad network simulated by the kernel (tc netem), in a network namespace of its own: real sockets,
// and losses, copies and delays that are not ours. For the same in process, longer and on a virtual clock,
// see hostile_test.cpp.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>

#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

// 300 ms there and back, with jitter.
constexpr const char* kConditions = "delay 150ms 75ms loss 20% duplicate 5%";

bool runs(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

// A namespace with only this process's own traffic; the destructor restores the old one.
class OwnNetwork {
 public:
  OwnNetwork() : outside_(open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC)) {
    if (outside_ < 0 || unshare(CLONE_NEWNET) != 0)
      missing_ = "no network namespace may be made (that takes root)";
    else if (!runs("ip link set lo up"))
      missing_ = "ip, of the package iproute2, is not here";
    else if (!become_bad() || !become_good())
      missing_ = "the kernel has no netem (tc qdisc add ... netem)";
  }
  ~OwnNetwork() {
    if (outside_ < 0) return;
    EXPECT_EQ(setns(outside_, CLONE_NEWNET), 0);
    close(outside_);
  }
  OwnNetwork(const OwnNetwork&) = delete;
  OwnNetwork& operator=(const OwnNetwork&) = delete;

  // The missing parts of this machine; empty if there are none.
  const std::string& missing() const { return missing_; }
  bool become_bad() { return runs(fmt::format("tc qdisc add dev lo root netem {}", kConditions)); }
  bool become_good() { return runs("tc qdisc del dev lo root"); }

 private:
  int outside_;
  std::string missing_;
};

TEST(NetemNetwork, NoClientAndNoChatLineIsLost) {
  SKIP_WITHOUT_QUAKEC();
  OwnNetwork network;
  if (!network.missing().empty()) GTEST_SKIP() << network.missing();
  ServedGame served(small_program(), {.is_real = true});
  // A client asks for a connection only three times; in the bad network one of two dozen would fail.
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(served.run_until_playing(served.add_client(fmt::format("p{}", i))));
  ASSERT_TRUE(network.become_bad());
  served.run(20);
  for (const std::size_t player : {0u, 1u})
    ASSERT_TRUE(served.client(player).is_playing()) << served.client(player).disconnect_reason();
  const std::uint64_t before = served.client(0).updates();
  constexpr int kLines = 100;
  for (int i = 0; i < kLines; ++i) {
    served.client(0).send_command(fmt::format("say line {} of it", i));
    served.run(0.2, {.angles_deg = {0, 45, 0}, .forward = 100});
  }
  served.run(20);
  for (const std::size_t player : {0u, 1u}) {
    ASSERT_TRUE(served.client(player).is_playing()) << served.client(player).disconnect_reason();
    std::size_t at = 0;
    for (int i = 0; i < kLines; ++i) {
      at = served.prints(player).find(fmt::format("line {} of it", i), at);
      ASSERT_NE(at, std::string::npos) << "line " << i << " is missing or out of order";
    }
  }
  EXPECT_GT(served.client(0).updates(), before + 500);
  EXPECT_GT(served.client(0).channel().statistics().lost, 0u) << "the network was a good one";
}

}  // namespace
}  // namespace temblor::test
