// Channel: packets byte by byte as the protocol description has them, and two channels over a simulated
// network that loses, duplicates, delays, and reorders.
#include "net/transport/channel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "support/effort.h"
#include "support/mutations.h"
#include "support/programs/bad_network.h"

namespace temblor::net {
namespace {

using base::ErrorCode;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Packets = std::vector<base::ByteVector>;

// A channel that collects its packets and copies its results.
struct End {
  Channel channel;
  Packets sent{};

  auto sink() {
    return [this](base::Bytes packet) { sent.emplace_back(packet.begin(), packet.end()); };
  }
  Packets taken() { return std::exchange(sent, {}); }
  void send(std::string_view text, double now_s) {
    EXPECT_TRUE(channel.send_reliable(base::as_bytes(text), now_s, sink()).ok());
  }
  void send_unreliable(std::string_view text) {
    EXPECT_TRUE(channel.send_unreliable(base::as_bytes(text), sink()).ok());
  }
  // "R:text", "U:text" for a message, "" for none.
  std::string receive(base::Bytes packet, double now_s) {
    const auto got = channel.receive(packet, now_s, sink());
    if (!got.ok()) return "error: " + got.error().message();
    if (!got->has_value()) return "";
    return ((*got)->reliable ? "R:" : "U:") + std::string(base::as_text((*got)->bytes));
  }
};

base::ByteVector packet(std::uint32_t word, std::uint32_t sequence, std::string_view content = {}) {
  base::ByteVector bytes;
  for (const std::uint32_t number : {word, sequence})
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::byte>(number >> shift));
  const base::Bytes rest = base::as_bytes(content);
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

TEST(Channel, PacketBytesMatchDescription) {
  End end;
  end.send("hi", 0);
  EXPECT_THAT(end.taken(), ElementsAre(packet(0x0009000a, 0, "hi")));
  end.send_unreliable("there");
  end.send_unreliable("");
  EXPECT_THAT(end.taken(), ElementsAre(packet(0x0010000d, 0, "there"), packet(0x00100008, 1)));
  EXPECT_EQ(end.receive(packet(0x00090009, 0, "x"), 0), "R:x");
  EXPECT_THAT(end.taken(), ElementsAre(packet(0x00020008, 0)));
}

TEST(Channel, SendsFragmentsOneAtATime) {
  End from, to;
  const std::string text = std::string(1024, 'a') + std::string(1024, 'b') + "c";
  from.send(text, 0);
  from.send("next", 0);
  std::vector<std::string> got;
  std::vector<std::size_t> sizes;
  for (int i = 0; i < 10; ++i)
    for (const auto& data : from.taken()) {
      sizes.push_back(data.size());
      if (const std::string message = to.receive(data, 0); !message.empty()) got.push_back(message);
      for (const auto& ack : to.taken()) EXPECT_EQ(from.receive(ack, 0), "");
    }
  EXPECT_THAT(sizes, ElementsAre(1032, 1032, 9, 12));
  EXPECT_THAT(got, ElementsAre("R:" + text, "R:next"));
  EXPECT_TRUE(from.channel.can_send_reliable());
  EXPECT_EQ(from.channel.queued_bytes(), 0u);
}

TEST(Channel, MessageOfWholeFragmentsHasNoEmptyLastFragment) {
  End end;
  end.send(std::string(1024, 'a'), 0);
  EXPECT_THAT(end.taken(), ElementsAre(packet(0x00090408, 0, std::string(1024, 'a'))));
}

TEST(Channel, ResendsEverySecondUntilAcknowledged) {
  End end;
  end.send("x", 10);
  const Packets first = end.taken();
  end.channel.update(10.99, end.sink());
  EXPECT_THAT(end.taken(), IsEmpty());
  end.channel.update(11, end.sink());
  EXPECT_EQ(end.taken(), first);
  end.channel.update(11.99, end.sink());
  EXPECT_THAT(end.taken(), IsEmpty());
  end.channel.update(12, end.sink());
  EXPECT_EQ(end.taken(), first);
  EXPECT_FALSE(end.channel.can_send_reliable());
  end.receive(packet(0x00020008, 0), 12);
  EXPECT_TRUE(end.channel.can_send_reliable());
  end.channel.update(100, end.sink());
  EXPECT_THAT(end.taken(), IsEmpty());
  EXPECT_EQ(end.channel.statistics().resent, 2u);
}

TEST(Channel, ResendsSoonerOnceRoundTripIsKnown) {
  End end;
  double now_s = 0;
  for (std::uint32_t sequence = 0; sequence < 50; ++sequence) {
    end.send("x", now_s);
    end.receive(packet(0x00020008, sequence), now_s += 0.05);
  }
  EXPECT_NEAR(end.channel.round_trip_s().value(), 0.05, 1e-9);
  end.taken();
  end.send("y", now_s);
  end.taken();
  end.channel.update(now_s + 0.09, end.sink());
  EXPECT_THAT(end.taken(), IsEmpty());
  end.channel.update(now_s + 0.11, end.sink());
  EXPECT_EQ(end.taken().size(), 1u);
  // The acknowledgment of a resent fragment gives no sample.
  end.receive(packet(0x00020008, 50), now_s + 5);
  EXPECT_NEAR(end.channel.round_trip_s().value(), 0.05, 1e-9);
}

TEST(Channel, AcknowledgesAndIgnoresDuplicates) {
  End end;
  EXPECT_EQ(end.receive(packet(0x00090009, 0, "x"), 0), "R:x");
  EXPECT_EQ(end.receive(packet(0x00090009, 0, "x"), 0), "");
  EXPECT_EQ(end.receive(packet(0x00090009, 7, "z"), 0), "");  // ahead of the sequence: no sender does that
  EXPECT_THAT(end.taken(), ElementsAre(packet(0x00020008, 0), packet(0x00020008, 0), packet(0x00020008, 7)));
  EXPECT_EQ(end.receive(packet(0x00090009, 1, "y"), 0), "R:y");
  EXPECT_EQ(end.channel.statistics().duplicates, 2u);
}

TEST(Channel, IgnoresForgedAcknowledgments) {
  End end;
  end.receive(packet(0x00020008, 0), 0);  // nothing is in flight
  end.send("x", 0);
  for (const std::uint32_t sequence : {1u, 2u, 0xffffffffu}) end.receive(packet(0x00020008, sequence), 0);
  EXPECT_FALSE(end.channel.can_send_reliable());
  end.receive(packet(0x00020008, 0), 0);
  EXPECT_TRUE(end.channel.can_send_reliable());
}

TEST(Channel, DropsStaleUnreliableMessagesAndCountsLostOnes) {
  End end;
  EXPECT_EQ(end.receive(packet(0x00100009, 2, "c"), 0), "U:c");
  EXPECT_EQ(end.receive(packet(0x00100009, 1, "b"), 0), "");
  EXPECT_EQ(end.receive(packet(0x00100009, 2, "c"), 0), "");
  EXPECT_EQ(end.receive(packet(0x00100009, 5, "f"), 0), "U:f");
  EXPECT_EQ(end.channel.statistics().lost, 4u);
  EXPECT_EQ(end.channel.statistics().stale, 2u);
  EXPECT_THAT(end.taken(), IsEmpty());
}

TEST(Channel, IgnoresForgedSequenceJump) {
  End end;
  EXPECT_EQ(end.receive(packet(0x00100009, 0xfffffff0, "x"), 0), "");
  EXPECT_EQ(end.receive(packet(0x00100009, 70000, "x"), 0), "");
  EXPECT_EQ(end.receive(packet(0x00100009, 0, "a"), 0), "U:a");
}

TEST(Channel, ReliableAndUnreliableSequencesAreSeparate) {
  End end;
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(end.receive(packet(0x00100009, i, "u"), 0), "U:u");
  EXPECT_EQ(end.receive(packet(0x00090009, 0, "r"), 0), "R:r");
}

TEST(Channel, LimitsFollowProtocol) {
  EXPECT_EQ(message_limits_for(Protocol::kNetQuake, PeerPlace::kSameProcess).reliable_bytes, 8000u);
  EXPECT_EQ(message_limits_for(Protocol::kNetQuake, PeerPlace::kSameProcess).unreliable_bytes, 64000u);
  EXPECT_EQ(message_limits_for(Protocol::kNetQuake, PeerPlace::kSameMachine).unreliable_bytes, 1024u);
  EXPECT_EQ(message_limits_for(Protocol::kFitzQuake, PeerPlace::kNetwork).unreliable_bytes, 1400u);
  EXPECT_EQ(message_limits_for(Protocol::kFitzQuake, PeerPlace::kSameMachine).unreliable_bytes, 64000u);
  EXPECT_EQ(message_limits_for(Protocol::kRmq, PeerPlace::kSameProcess).unreliable_bytes, 64000u);
  EXPECT_EQ(find_peer_place({}), PeerPlace::kSameProcess);
  EXPECT_EQ(find_peer_place(platform::ip4_address({127, 0, 0, 1}, 5)), PeerPlace::kSameMachine);
  EXPECT_EQ(find_peer_place(*platform::parse_host("::1", 5)), PeerPlace::kSameMachine);
  EXPECT_EQ(find_peer_place(platform::ip4_address({192, 0, 2, 1}, 5)), PeerPlace::kNetwork);
  End end;
  const base::ByteVector large(8001);
  EXPECT_EQ(end.channel.send_reliable(large, 0, end.sink()).error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(end.channel.send_unreliable(base::Bytes(large).first(1025), end.sink()).error().message(),
            "unreliable message of 1025 bytes exceeds the peer's limit of 1024");
  EXPECT_THAT(end.sent, IsEmpty());
  end.channel.set_sent_limits(message_limits_for(Protocol::kRmq, PeerPlace::kSameProcess));
  EXPECT_TRUE(end.channel.send_reliable(large, 0, end.sink()).ok());
  EXPECT_TRUE(end.channel.send_unreliable(large, end.sink()).ok());
}

TEST(Channel, RejectsMessagesWhenQueueIsFull) {
  End end{Channel({.queue_bytes = 10})};
  end.send("12345", 0);
  end.send("6789", 0);
  const auto status = end.channel.send_reliable(base::as_bytes("ab"), 0, end.sink());
  EXPECT_EQ(status.error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(end.channel.queued_bytes(), 9u);
  end.send("0", 0);
}

TEST(BadPacket, IsRejectedWithReasonAndChangesNothing) {
  End end;
  EXPECT_THAT(end.receive({}, 0), HasSubstr("packet of 0 bytes is shorter than its header"));
  EXPECT_THAT(end.receive(base::Bytes(packet(0x00090008, 0)).first(7), 0),
              HasSubstr("is shorter than its header"));
  EXPECT_THAT(end.receive(packet(0x0009000a, 0, "x"), 0), HasSubstr("9 bytes declares a size of 10"));
  for (const std::uint32_t flags : {0u, 0x00040000u, 0x00080000u, 0x00030000u, 0x00180000u, 0x80000000u})
    EXPECT_THAT(end.receive(packet(flags | 9, 0, "x"), 0), HasSubstr("has invalid flags"));
  EXPECT_THAT(end.receive(packet(0x00020009, 0, "x"), 0), HasSubstr("with 1 bytes of content"));
  EXPECT_THAT(end.sent, IsEmpty());
  EXPECT_EQ(end.receive(packet(0x00090009, 0, "x"), 0), "R:x");
}

TEST(BadPacket, EndlessMessageFailsAtLimit) {
  End end{Channel({.max_received_bytes = 8192})};
  const std::string kilobyte(1024, 'a');
  std::uint32_t sequence = 0;
  for (; sequence < 8; ++sequence) EXPECT_EQ(end.receive(packet(0x00010408, sequence, kilobyte), 0), "");
  const auto got = end.channel.receive(packet(0x00010408, sequence, kilobyte), 0, end.sink());
  ASSERT_FALSE(got.ok());
  EXPECT_EQ(got.error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(got.error().message(), "reliable message exceeds 8192 bytes");
}

// Damaged and forged packets cause an error or a reply, and never exceed the memory limits.
TEST(BadPacket, RandomPackets) {
  test::Random random(3);
  for (int round = 0; round < test::effort(200, 20); ++round) {
    End end{Channel({.max_received_bytes = 5000})};
    std::uint32_t sequence = 0;
    for (int i = 0; i < 300; ++i) {
      constexpr std::uint32_t kFlags[] = {0x00010000, 0x00090000, 0x00020000, 0x00100000, 0x80000000};
      const std::string content(random.below(600), 'x');
      base::ByteVector bytes =
          packet(kFlags[random.below(5)] | static_cast<std::uint32_t>(content.size() + 8), sequence, content);
      if (random.chance(0.3)) bytes = test::with_flipped_bits(bytes, random);
      if (random.chance(0.1)) bytes = test::random_bytes(random, random.below(40));
      const auto got = end.channel.receive(bytes, i, end.sink());
      ASSERT_TRUE(!got.ok() || !got->has_value() || (*got)->bytes.size() <= 5000u);
      sequence += static_cast<std::uint32_t>(random.below(2));
    }
  }
}

// A channel on a bad network, with the messages that it sent and received.
class Peer {
 public:
  auto sink() {
    return [this](base::Bytes packet) { socket_->send(other_, packet); };
  }
  Peer(test::BadNetwork& network, std::uint16_t port, std::uint16_t other)
      : socket_(network.open({{}, port, 0})), other_{{}, other, 0} {}

  void tick(double now_s) {
    while (const auto datagram = socket_->receive()) {
      const auto got = channel_.receive(datagram->bytes, now_s, sink());
      ASSERT_TRUE(got.ok()) << got.error().message();
      if (got->has_value()) hear(**got);
    }
    channel_.update(now_s, sink());
  }
  bool send_reliable(const base::ByteVector& message, double now_s) {
    return channel_.send_reliable(message, now_s, sink()).ok();
  }
  void send_number(std::uint32_t number) {
    base::ByteWriter writer;
    writer.u32(number);
    ASSERT_TRUE(channel_.send_unreliable(writer.view(), sink()).ok());
  }
  const Channel& channel() const { return channel_; }
  const Packets& heard() const { return heard_; }
  std::size_t numbers_heard() const { return numbers_heard_; }

 private:
  void hear(const ChannelMessage& message) {
    if (message.reliable) return heard_.emplace_back(message.bytes.begin(), message.bytes.end()), void();
    const std::uint32_t number = base::ByteReader(message.bytes).u32();
    EXPECT_GE(number, next_number_);  // in order, without duplicates
    next_number_ = number + 1;
    ++numbers_heard_;
  }

  std::unique_ptr<platform::DatagramSocket> socket_;
  platform::Address other_;
  Channel channel_;
  Packets heard_;
  std::uint32_t next_number_ = 0;
  std::size_t numbers_heard_ = 0;
};

TEST(BadNetwork, DeliversReliableMessagesOnceAndInOrder) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    test::BadNetwork network({0.2, 0.05, 0.3, 0.15}, seed);
    Peer a(network, 1, 2), b(network, 2, 1);
    Packets sent_a, sent_b;
    const double end_s = test::effort(600, 120);
    std::uint32_t sent = 0;
    const auto speak = [&](Peer& peer, Packets& io_sent, double now_s) {
      const base::ByteVector message = test::random_bytes(random, 1 + random.below(4000));
      if (peer.send_reliable(message, now_s)) io_sent.push_back(message);
    };
    for (int tick = 0; tick < 72 * end_s; ++tick) {
      const double now_s = tick / 72.0;
      network.advance_to(now_s);
      // The last fifth (two minutes) drains the queues.
      if (now_s < end_s * 0.8 && random.chance(0.002)) speak(a, sent_a, now_s);
      if (now_s < end_s * 0.8 && random.chance(0.002)) speak(b, sent_b, now_s);
      a.send_number(sent);
      b.send_number(sent++);
      a.tick(now_s);
      b.tick(now_s);
    }
    EXPECT_GT(sent_a.size(), 4u);
    EXPECT_EQ(a.heard(), sent_b);
    EXPECT_EQ(b.heard(), sent_a);
    // Jitter makes many stale, but enough arrive in order.
    EXPECT_GT(a.numbers_heard(), sent / 20);
    EXPECT_GT(a.channel().statistics().resent, 0u);
  }
}

}  // namespace
}  // namespace temblor::net
