// Sends real datagrams over the loopback interface.
#include "platform/posix/udp_socket.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "support/mutations.h"

namespace temblor::platform::posix {
namespace {

std::unique_ptr<DatagramSocket> open_test_socket(const UdpOptions& options) {
  auto socket = open_udp_socket(options);
  EXPECT_TRUE(socket.ok()) << socket.error().message();
  return std::move(socket).value();
}

// Waits for a datagram for up to 2 s; delivery is not immediate.
std::optional<Datagram> await_datagram(DatagramSocket& socket) {
  for (int tries = 0; tries < 2000; ++tries) {
    if (const auto datagram = socket.receive()) return datagram;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::nullopt;
}

TEST(UdpSocket, SendsAndReceives) {
  const auto a = open_test_socket({.host = "127.0.0.1"}), b = open_test_socket({.host = "127.0.0.1"});
  EXPECT_NE(a->local_address().port, 0);
  EXPECT_FALSE(a->receive());
  a->send(b->local_address(), base::as_bytes("hello"));
  const auto there = await_datagram(*b);
  ASSERT_TRUE(there);
  EXPECT_EQ(there->from, a->local_address());
  EXPECT_EQ(base::as_text(there->bytes), "hello");
  b->send(there->from, {});
  const auto back = await_datagram(*a);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->bytes.empty());
}

TEST(UdpSocket, KnowsHowLongADatagramHasWaited) {
  const auto a = open_test_socket({.host = "127.0.0.1"}), b = open_test_socket({.host = "127.0.0.1"});
  // Linux starts to note arrival times a moment after the first socket asks for them. Until then, a datagram
  // gets the time at which it is read.
  double waited_s = 0;
  for (int tries = 0; tries < 20 && waited_s < 0.05; ++tries) {
    a->send(b->local_address(), base::as_bytes("early"));
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    const auto late = await_datagram(*b);
    ASSERT_TRUE(late);
    waited_s = late->waited_s;
  }
  EXPECT_GE(waited_s, 0.05);
  EXPECT_LT(waited_s, 5);
}

TEST(UdpSocket, DualStackSocketReportsIp4Peers) {
  const auto all = open_test_socket({}), one = open_test_socket({.host = "127.0.0.1"});
  const std::uint16_t port = all->local_address().port;
  one->send(ip4_address({127, 0, 0, 1}, port), base::as_bytes("x"));
  const auto got = await_datagram(*all);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->from, one->local_address());
  all->send(got->from, base::as_bytes("y"));
  ASSERT_TRUE(await_datagram(*one));
}

TEST(UdpSocket, LargestDatagramArrivesWhole) {
  const auto a = open_test_socket({.host = "127.0.0.1"}), b = open_test_socket({.host = "127.0.0.1"});
  test::Random random(1);
  const base::ByteVector bytes = test::random_bytes(random, 65507);
  a->send(b->local_address(), bytes);
  const auto got = await_datagram(*b);
  ASSERT_TRUE(got);
  EXPECT_EQ(base::ByteVector(got->bytes.begin(), got->bytes.end()), bytes);
}

TEST(UdpSocket, UnsendableDatagramsAreDropped) {
  const auto a = open_test_socket({.host = "127.0.0.1"});
  a->send(ip4_address({127, 0, 0, 1}, 1), base::as_bytes("nobody there"));
  a->send(*parse_host("2001:db8::1", 9), base::as_bytes("no IPv6 here"));
  a->send(a->local_address(), base::ByteVector(70000));
  EXPECT_FALSE(a->receive());
}

TEST(UdpSocket, PortInUseIsAnError) {
  const auto first = open_test_socket({.host = "127.0.0.1"});
  const std::uint16_t port = first->local_address().port;
  const auto second = open_udp_socket({.port = port, .host = "127.0.0.1"});
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, base::ErrorCode::kIo);
  EXPECT_NE(second.error().message().find("UDP port " + std::to_string(port)), std::string::npos);
  EXPECT_EQ(open_udp_socket({.host = "localhost"}).error().code, base::ErrorCode::kUsage);
}

TEST(UdpSocket, KnowsItsOwnHost) {
  EXPECT_TRUE(is_own_host(ip4_address({127, 0, 0, 1}, 26000)));
  const auto taken = open_test_socket({.host = "127.0.0.1"});
  EXPECT_TRUE(is_own_host(taken->local_address())) << "the port does not matter";
  // Addresses for documentation belong to no machine.
  EXPECT_FALSE(is_own_host(ip4_address({192, 0, 2, 1}, 26000)));
  EXPECT_FALSE(is_own_host(*parse_host("2001:db8::1", 26000)));
}

TEST(UdpSocket, LooksUpHosts) {
  EXPECT_EQ(*look_up("10.0.0.1", 26000), ip4_address({10, 0, 0, 1}, 26000));
  EXPECT_EQ(*look_up("localhost:5", 26000), ip4_address({127, 0, 0, 1}, 5));
  const auto unknown = look_up("no-such-host.invalid", 1);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, base::ErrorCode::kNotFound);
  EXPECT_FALSE(look_up("localhost:x", 1).ok());
}

}  // namespace
}  // namespace temblor::platform::posix
