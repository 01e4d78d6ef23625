// Rate limits for unverified peers, measured with floods.
#include "net/transport/admission/unverified_peer_limits.h"

#include <gtest/gtest.h>

#include "net/transport/admission/token_bucket.h"
#include "support/random.h"

namespace temblor::net {
namespace {

platform::Address peer(unsigned number, unsigned port = 1) {
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(number >> shift); };
  return platform::ip4_address({10, byte(16), byte(8), byte(0)}, static_cast<std::uint16_t>(port));
}

TEST(TokenBucket, AllowsBurstThenRate) {
  TokenBucket bucket;
  const Rate rate{5, 2};
  int taken = 0;
  for (int i = 0; i < 100; ++i) taken += bucket.spend(1, rate, 1000);
  EXPECT_EQ(taken, 5);
  for (int tick = 0; tick <= 100; ++tick) taken += bucket.spend(1, rate, 1000 + tick / 10.0);
  EXPECT_EQ(taken, 5 + 20);
  EXPECT_FALSE(bucket.spend(5.5, rate, 1e9));
  EXPECT_TRUE(bucket.can_spend(5, rate, 1e9));
  EXPECT_TRUE(bucket.spend(5, rate, 1e9));
}

TEST(UnverifiedPeerLimits, PortsOfHostShareBudget) {
  UnverifiedPeerLimits limits({.connections_per_host = {10, 1}, .connections_in_total = {100, 10}});
  int admitted = 0;
  for (unsigned port = 1; port <= 1000; ++port) admitted += limits.admit_connection_request(peer(1, port), 0);
  EXPECT_EQ(admitted, 10);
  // Its rejected requests do not use up the budget of others.
  EXPECT_TRUE(limits.admit_connection_request(peer(2), 0));
  EXPECT_TRUE(limits.admit_connection_request(peer(1), 1));
}

TEST(UnverifiedPeerLimits, AllHostsShareCommonBudget) {
  UnverifiedPeerLimits limits({.connections_per_host = {10, 1}, .connections_in_total = {100, 10}});
  int admitted = 0;
  for (unsigned i = 0; i < 100000; ++i) admitted += limits.admit_connection_request(peer(i), i / 10000.0);
  EXPECT_NEAR(admitted, 100 + 10 * 10, 1);
}

TEST(UnverifiedPeerLimits, FloodIsNotAmplified) {
  UnverifiedPeerLimits limits;
  constexpr std::size_t kQuestion = 12, kAnswer = 100, kBelow = 28;
  double answered = 0, to_victim = 0;
  constexpr double kSeconds = 100;
  test::Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const double now_s = i / 200000.0 * kSeconds;
    const auto from = random.chance(0.5) ? peer(7) : peer(static_cast<unsigned>(random.below(1 << 20)));
    if (!limits.admit_query(from, false, now_s) ||
        !limits.admit_reply(from, kQuestion, kAnswer, false, now_s))
      continue;
    answered += kAnswer + kBelow;
    if (from.same_host(peer(7))) to_victim += kAnswer + kBelow;
  }
  const UnverifiedPeerRates rates;
  // A million other hosts may have evicted the victim from the table now and then.
  EXPECT_LE(answered, rates.reply_bytes_in_total.burst + rates.reply_bytes_in_total.per_second * kSeconds);
  EXPECT_LE(to_victim, answered);
  EXPECT_LT(answered, 200000.0 * (kQuestion + kBelow) / 4);
}

TEST(UnverifiedPeerLimits, VictimGetsBurstAndTrickle) {
  UnverifiedPeerLimits limits;
  double sent = 0;
  for (int i = 0; i < 100000; ++i) {
    const double now_s = i / 1000.0;
    if (limits.admit_query(peer(7), false, now_s) && limits.admit_reply(peer(7), 12, 100, false, now_s))
      sent += 128;
  }
  const Rate rate = UnverifiedPeerRates{}.reply_bytes_per_host;
  EXPECT_LE(sent, rate.burst + rate.per_second * 100);
  EXPECT_GT(sent, rate.burst / 2);
}

TEST(UnverifiedPeerLimits, PlayersAreExemptFromCommonBudget) {
  UnverifiedPeerLimits limits;
  for (unsigned i = 0; i < 100000; ++i) limits.admit_query(peer(i), false, 0);
  EXPECT_FALSE(limits.admit_query(peer(200000), false, 0));
  EXPECT_TRUE(limits.admit_query(peer(200001), true, 0));
  EXPECT_TRUE(limits.admit_reply(peer(200001), 12, 100, true, 0));
  // A reply no larger than its request is always free.
  EXPECT_TRUE(limits.admit_reply(peer(200002), 12, 12, false, 0));
}

TEST(UnverifiedPeerLimits, Ip6NetworkCountsAsOneHost) {
  UnverifiedPeerLimits limits({.connections_per_host = {1, 0}, .connections_in_total = {100, 10}});
  EXPECT_TRUE(limits.admit_connection_request(*platform::parse_host("2001:db8::1", 1), 0));
  EXPECT_FALSE(limits.admit_connection_request(*platform::parse_host("2001:db8::ffff:1", 1), 0));
  EXPECT_TRUE(limits.admit_connection_request(*platform::parse_host("2001:db8:0:1::1", 1), 0));
}

TEST(UnverifiedPeerLimits, LimitsWrongPasswords) {
  UnverifiedPeerLimits limits;
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(limits.admit_password(peer(1), 0));
    limits.record_wrong_password(peer(1), 0);
  }
  EXPECT_FALSE(limits.admit_password(peer(1), 0));
  EXPECT_TRUE(limits.admit_password(peer(2), 0));
  EXPECT_TRUE(limits.admit_password(peer(1), 12.1));
}

TEST(Password, ComparesInConstantTime) {
  EXPECT_TRUE(equal_in_constant_time("secret", "secret"));
  for (const char* given : {"", "s", "secre", "secreT", "Secret", "secretsecret", "secret "})
    EXPECT_FALSE(equal_in_constant_time(given, "secret")) << given;
  EXPECT_FALSE(equal_in_constant_time("", ""));
}

}  // namespace
}  // namespace temblor::net
