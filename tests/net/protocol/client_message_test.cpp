// Client messages: read and written byte by byte as the protocol description has them, and malformed ones.
#include "net/protocol/client_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "net/protocol/dialects.h"
#include "support/effort.h"
#include "support/mutations.h"
#include "support/random.h"

namespace temblor::net {
namespace {

using base::ErrorCode;
using test::pack_bytes;

constexpr Protocol kProtocols[] = {Protocol::kNetQuake, Protocol::kFitzQuake, Protocol::kRmq};

base::ByteVector written(const ClientMessage& message, Protocol protocol) {
  base::ByteWriter writer;
  const base::Status status = write_client_message(message, protocol, writer);
  EXPECT_TRUE(status.ok()) << status.error().message();
  return std::move(writer).take();
}

base::Error make_client_read_error(base::Bytes bytes, Protocol protocol = Protocol::kNetQuake) {
  ClientMessageReader reader(bytes, protocol);
  while (true) {
    const auto message = reader.next();
    if (!message.ok()) return message.error();
    if (!message->has_value()) return base::malformed("no error");
  }
}

ClientMessage only_message(base::Bytes bytes, Protocol protocol) {
  ClientMessageReader reader(bytes, protocol);
  const auto message = reader.next();
  EXPECT_TRUE(message.ok() && message->has_value());
  EXPECT_FALSE(reader.next().value().has_value());
  return **message;
}

// Hand-made bytes: time 1.5; a quarter, half, and eighth of a turn; forward 400, side -350, up 0; attack and
// jump; impulse 7.
const Move kMove{1.5f, {90, -180, 45}, 400, -350, 0, 3, 7};
const base::ByteVector kMove15 =
    pack_bytes({3, 0, 0, 0xc0, 0x3f, 0x40, 0x80, 0x20, 0x90, 0x01, 0xa2, 0xfe, 0, 0, 3, 7});
const base::ByteVector kMove666 =
    pack_bytes({3, 0, 0, 0xc0, 0x3f, 0x00, 0x40, 0x00, 0x80, 0x00, 0x20, 0x90, 0x01, 0xa2, 0xfe, 0, 0, 3, 7});

TEST(ClientMessage, BytesMatchDescription) {
  EXPECT_EQ(written(kMove, Protocol::kNetQuake), kMove15);
  EXPECT_EQ(written(kMove, Protocol::kFitzQuake), kMove666);
  EXPECT_EQ(written(kMove, Protocol::kRmq), kMove666);
  for (const Protocol protocol : kProtocols) {
    EXPECT_EQ(written(Nop{}, protocol), pack_bytes({1}));
    EXPECT_EQ(written(Disconnect{}, protocol), pack_bytes({2}));
    EXPECT_EQ(written(StringCommand{"god"}, protocol), pack_bytes({4, 'g', 'o', 'd', 0}));
  }
}

TEST(ClientMessage, ReadsMove) {
  for (const bool wide : {false, true}) {
    const auto message = only_message(wide ? kMove666 : kMove15, wide ? Protocol::kRmq : Protocol::kNetQuake);
    const Move& move = std::get<Move>(message);
    EXPECT_EQ(move.time_s, 1.5f);
    EXPECT_EQ(move.angles_deg, math::Vec3(90, -180, 45));
    EXPECT_EQ(move.forward, 400);
    EXPECT_EQ(move.side, -350);
    EXPECT_EQ(move.up, 0);
    EXPECT_EQ(move.buttons, 3);
    EXPECT_EQ(move.impulse, 7);
  }
}

TEST(ClientMessage, ReadsSeveralInOnePacket) {
  const base::ByteVector bytes = pack_bytes({1, 4, 'a', 0, 4, 0, 2});
  ClientMessageReader reader(bytes, Protocol::kNetQuake);
  EXPECT_STREQ(message_name(*reader.next().value()), "clc_nop");
  EXPECT_EQ(std::get<StringCommand>(*reader.next().value()).text, "a");
  EXPECT_EQ(std::get<StringCommand>(*reader.next().value()).text, "");
  EXPECT_STREQ(message_name(*reader.next().value()), "clc_disconnect");
  EXPECT_FALSE(reader.next().value().has_value());
}

TEST(ClientMessage, AnglesRoundTripWithinHalfAStep) {
  test::Random random(1);
  for (int i = 0; i < test::effort(20000, 2000); ++i) {
    const Protocol protocol = kProtocols[random.below(3)];
    const double step_deg = protocol == Protocol::kNetQuake ? 360.0 / 256 : 360.0 / 65536;
    const Move sent{static_cast<float>(random.uniform(0, 1e5)), random.in_cube(1000), 1, 2, 3, 4, 5};
    const base::ByteVector bytes = written(sent, protocol);
    const auto message = only_message(bytes, protocol);
    const Move& got = std::get<Move>(message);
    EXPECT_EQ(got.time_s, sent.time_s);
    for (int axis = 0; axis < 3; ++axis) {
      const double off = std::remainder(double{got.angles_deg[axis]} - double{sent.angles_deg[axis]}, 360.0);
      ASSERT_LE(std::abs(off), step_deg / 2 + 1e-4) << sent.angles_deg[axis];
    }
  }
}

TEST(BadClientMessage, NamesUnknownNumbers) {
  for (int id = 0; id < 256; ++id) {
    if (id >= 1 && id <= 4) continue;
    const base::Error error = make_client_read_error(pack_bytes({1, id, 1}));
    EXPECT_EQ(error.code, ErrorCode::kUnsupported);
    EXPECT_EQ(error.message(), "offset 1: message " + std::to_string(id) + ": unknown message");
  }
}

TEST(BadClientMessage, RejectsTruncation) {
  EXPECT_EQ(make_client_read_error(base::Bytes(kMove15).first(5)).message(),
            "offset 0: clc_move: message ends after 5 of 16 bytes");
  EXPECT_EQ(make_client_read_error(base::Bytes(kMove666).first(18), Protocol::kRmq).message(),
            "offset 0: clc_move: message ends after 18 of 19 bytes");
  EXPECT_EQ(make_client_read_error(pack_bytes({1, 1, 4, 'a'})).message(),
            "offset 2: clc_stringcmd: text has no terminating zero");
}

TEST(BadClientMessage, RejectsLongTexts) {
  base::ByteVector longest = pack_bytes({4});
  longest.resize(kMaxCommandBytes, std::byte{'a'});
  longest.push_back(std::byte{0});
  EXPECT_EQ(std::get<StringCommand>(only_message(longest, Protocol::kNetQuake)).text,
            std::string(kMaxCommandBytes - 1, 'a'));
  for (const std::size_t size : {kMaxCommandBytes, std::size_t{65536}}) {
    base::ByteVector bytes = pack_bytes({4});
    bytes.resize(size + 1, std::byte{'a'});
    bytes.push_back(std::byte{0});
    const base::Error error = make_client_read_error(bytes);
    EXPECT_EQ(error.code, ErrorCode::kTooLarge);
    EXPECT_EQ(error.message(), "offset 0: clc_stringcmd: text of " + std::to_string(size) +
                                   " bytes exceeds the limit of 1023");
    base::ByteWriter writer;
    EXPECT_FALSE(
        write_client_message(StringCommand{std::string(size, 'a')}, Protocol::kNetQuake, writer).ok());
    EXPECT_EQ(writer.size(), 0u);
  }
}

TEST(BadClientMessage, RejectsNonFiniteNumbers) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  EXPECT_EQ(make_client_read_error(test::with_number(kMove15, 1, kNone)).message(),
            "offset 0: clc_move: time is nan");
  EXPECT_EQ(make_client_read_error(test::with_number(kMove666, 1, -kEndless), Protocol::kFitzQuake).message(),
            "offset 0: clc_move: time is -inf");
  base::ByteWriter writer;
  EXPECT_FALSE(write_client_message(Move{.time_s = kNone}, Protocol::kNetQuake, writer).ok());
  EXPECT_FALSE(
      write_client_message(Move{.angles_deg = math::Vec3(kEndless)}, Protocol::kNetQuake, writer).ok());
  EXPECT_FALSE(write_client_message(StringCommand{{"a\0b", 3}}, Protocol::kNetQuake, writer).ok());
  EXPECT_EQ(writer.size(), 0u);
}

TEST(BadClientMessage, ReaderIsAtEndAfterError) {
  const base::ByteVector bytes = pack_bytes({9, 1, 1});
  ClientMessageReader reader(bytes, Protocol::kNetQuake);
  EXPECT_FALSE(reader.next().ok());
  EXPECT_FALSE(reader.next().value().has_value());
}

// Messages read from random bytes round-trip.
TEST(BadClientMessage, SurvivesRandomBytes) {
  test::Random random(2);
  int read = 0;
  for (int i = 0; i < test::effort(50000, 5000); ++i) {
    base::ByteVector bytes = test::random_bytes(random, random.below(64));
    for (std::byte& byte : bytes)
      if (random.chance(0.4)) byte = static_cast<std::byte>(random.below(6));
    const Protocol protocol = kProtocols[random.below(3)];
    ClientMessageReader reader(bytes, protocol);
    for (std::size_t offset = 0;; ++read) {
      const auto message = reader.next();
      if (!message.ok() || !message->has_value()) break;
      const base::ByteVector again = written(**message, protocol);
      ASSERT_LE(offset + again.size(), bytes.size());
      ASSERT_EQ(std::memcmp(again.data(), bytes.data() + offset, again.size()), 0);
      offset += again.size();
    }
  }
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace temblor::net
