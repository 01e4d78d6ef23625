#include "net/transport/loopback.h"

#include <gtest/gtest.h>

#include "support/mutations.h"

namespace temblor::net {
namespace {

TEST(Loopback, DeliversInOrderAndOnce) {
  LoopbackNetwork network;
  const auto server = network.open(26000), client = network.open();
  EXPECT_EQ(to_text(server->local_address()), "local:26000");
  EXPECT_NE(client->local_address(), server->local_address());
  for (const char* text : {"one", "two", ""}) client->send(server->local_address(), base::as_bytes(text));
  for (const char* text : {"one", "two", ""}) {
    const auto got = server->receive();
    ASSERT_TRUE(got);
    EXPECT_EQ(got->from, client->local_address());
    EXPECT_EQ(base::as_text(got->bytes), text);
  }
  EXPECT_FALSE(server->receive());
  EXPECT_FALSE(client->receive());
}

TEST(Loopback, NetworksAreSeparate) {
  LoopbackNetwork first, second;
  const auto a = first.open(1), b = second.open(1);
  a->send(b->local_address(), base::as_bytes("x"));
  EXPECT_FALSE(b->receive());
  EXPECT_TRUE(a->receive());
}

TEST(Loopback, DropsDatagramsToClosedPorts) {
  LoopbackNetwork network;
  const auto a = network.open(1);
  a->send({{}, 2, 0}, base::as_bytes("x"));
  a->send(platform::ip4_address({127, 0, 0, 1}, 1), base::as_bytes("x"));
  EXPECT_FALSE(a->receive());
  network.open(2).reset();
  EXPECT_NE(network.open(2), nullptr);  // free again
}

TEST(Loopback, DropsDatagramsWhenBufferIsFull) {
  LoopbackNetwork network;
  const auto a = network.open(1), b = network.open(2);
  const base::ByteVector bytes(1000);
  for (int i = 0; i < 5000; ++i) {
    a->send(b->local_address(), bytes);
    a->send(b->local_address(), {});
  }
  std::size_t got = 0;
  while (b->receive()) ++got;
  EXPECT_GT(got, 1000u);
  EXPECT_LT(got, 2 * kLoopbackBufferBytes / bytes.size());
  a->send(b->local_address(), bytes);
  EXPECT_TRUE(b->receive());
}

}  // namespace
}  // namespace temblor::net
