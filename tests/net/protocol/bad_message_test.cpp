// Malformed messages: their error messages, and that nothing worse happens.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "net/protocol/dialects.h"
#include "net/protocol/message_text.h"
#include "net/protocol/random_message.h"
#include "support/effort.h"
#include "support/mutations.h"

namespace temblor::net {
namespace {

using base::ErrorCode;
using test::k15;
using test::k666;
using test::make_reader;
using test::pack_bytes;
using test::written;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

constexpr Dialect kFloats{Protocol::kRmq, kFloatCoord | kFloatAngle};

// Reads bytes, as if from offset 1000 of a file, to their first error.
base::Error make_read_error(base::Bytes bytes, const Dialect& dialect = k15) {
  MessageReader reader = make_reader(dialect);
  reader.begin(bytes, 1000);
  while (true) {
    const auto message = reader.next();
    if (!message.ok()) return message.error();
    if (!message->has_value()) return base::malformed("no error");
  }
}

TEST(BadMessage, NamesTruncatedMessageAndOffset) {
  // A sound with volume, after a nop.
  EXPECT_EQ(make_read_error(pack_bytes({1, 6, 1, 255})).message(),
            "offset 1001: svc_sound: message ends after 3 of 12 bytes");
  EXPECT_EQ(make_read_error(pack_bytes({3})).message(),
            "offset 1000: svc_updatestat: message ends after 1 of 6 bytes");
  EXPECT_EQ(make_read_error(pack_bytes({0x80 | 2})).message(),
            "offset 1000: fast update: message ends after 1 of 4 bytes");
  EXPECT_EQ(make_read_error(pack_bytes({12, 3})).message(),
            "offset 1000: svc_lightstyle: pattern has no terminating zero");
  EXPECT_EQ(make_read_error(pack_bytes({8, 'a', 'b'})).message(),
            "offset 1000: svc_print: text has no terminating zero");
  EXPECT_EQ(make_read_error(pack_bytes({38, 0, 0xff, 0x7f, 'a', 0, 'b'})).message(),
            "offset 1000: svc_botchat: text has no terminating zero");
}

TEST(BadMessage, RejectsUnknownNumbers) {
  for (int id = 0; id < 128; ++id) {
    const bool known = (id >= 1 && id <= 34 && id != 21) || id == 37 || id == 38 || (id >= 40 && id <= 44) ||
                       id == 52 || (id >= 54 && id <= 56);
    const bool of_2021 = id >= 45 && id <= 56;
    const base::Error error = make_read_error(pack_bytes({id}));
    SCOPED_TRACE(error.message());
    if (known) {
      EXPECT_THAT(error.message(), ::testing::Not(HasSubstr("unknown message")));
      EXPECT_THAT(error.message(), ::testing::Not(HasSubstr("which is not supported")));
      continue;
    }
    EXPECT_EQ(error.code, ErrorCode::kUnsupported);
    if (of_2021) {
      EXPECT_THAT(
          error.message(),
          MatchesRegex("offset 1000: svc_[a-z]+: message of the 2021 re-release, which is not supported "
                       ".the first message of its packet."));
    } else {
      EXPECT_EQ(error.message(), "offset 1000: message " + std::to_string(id) +
                                     ": unknown message (the first message of its packet)");
    }
  }
}

// A name ends before the message that is really unknown if an earlier message was longer than expected.
TEST(BadMessage, NamesTheMessagesBeforeAnUnknownOne) {
  const auto read = [](std::initializer_list<int> bytes) {
    return make_read_error(pack_bytes(bytes), k15).message();
  };
  EXPECT_EQ(read({1, 99}), "offset 1001: message 99: unknown message (after svc_nop)");
  EXPECT_EQ(read({40, 0x81, 64, 1, 0, 27, 1, 45, 1}),
            "offset 1007: svc_setviews: message of the 2021 re-release, which is not supported (after fast "
            "update, svc_killedmonster, svc_nop)");
  EXPECT_EQ(read({1, 23, 99, 0, 0}),
            "offset 1001: svc_temp_entity: unknown kind of effect 99 (after svc_nop)");
  MessageReader reader;
  const base::ByteVector unknown = pack_bytes({1, 99}), cut = pack_bytes({3, 1}),
                         protocol = test::with_number(written(ServerInfo{}, k15), 1, std::int32_t{14});
  for (const auto& [bytes, is_unknown] : {std::pair{&unknown, true}, {&cut, false}, {&protocol, false}}) {
    reader.begin(*bytes);
    while (reader.next().ok()) {
    }
    EXPECT_EQ(reader.is_at_unknown(), is_unknown);
  }
}

TEST(BadMessage, RejectsUnknownProtocols) {
  const auto info = [](std::int32_t protocol) {
    return test::with_number(written(ServerInfo{}, k15), 1, protocol);
  };
  for (const std::int32_t protocol : {0, 14, 16, 28, 667, -1, std::numeric_limits<std::int32_t>::max()}) {
    const base::Error error = make_read_error(info(protocol));
    EXPECT_EQ(error.code, ErrorCode::kUnsupported);
    EXPECT_EQ(error.message(), "offset 1000: svc_serverinfo: protocol " + std::to_string(protocol) +
                                   " is not supported; supported are 15, 666, and 999");
  }
  const Dialect rmq{Protocol::kRmq, 0};
  EXPECT_EQ(make_read_error(test::with_number(written(ServerInfo{.dialect = rmq}, rmq), 5, 0x300u)).message(),
            "offset 1000: svc_serverinfo: flags 0x300 of protocol 999 are not supported; supported are 0xfe");
}

TEST(BadMessage, NamesFteExtensions) {
  base::ByteWriter writer;
  writer.u8(11);
  writer.bytes(base::as_bytes("FTEX"));
  writer.u32(0x20);
  writer.bytes(base::as_bytes("FTE2"));
  writer.u32(8 | 64);
  writer.i32(999);
  writer.bytes(test::to_bytes("any other bytes"));
  const base::Error error = make_read_error(writer.view());
  EXPECT_EQ(error.code, ErrorCode::kUnsupported);
  EXPECT_EQ(
      error.message(),
      "offset 1000: svc_serverinfo: unsupported protocol extensions FTEX 0x20 and FTE2 0x48 (replacement "
      "deltas, size encoding)");
}

TEST(BadMessage, RejectsLongPrecacheLists) {
  base::ByteWriter writer;
  writer.u8(11);
  writer.i32(15);
  writer.u16(1);
  writer.bytes(test::to_bytes("name"));
  writer.u8(0);
  for (int i = 0; i < 100000; ++i) {
    writer.u8('m');
    writer.u8(0);
  }
  const base::Error error = make_read_error(writer.view());
  EXPECT_EQ(error.code, ErrorCode::kTooLarge);
  EXPECT_EQ(error.message(), "offset 1000: svc_serverinfo: model list has more than 4096 names");

  const std::vector<std::string_view> models(kMaxModels, "m"), sounds(kMaxSounds, "s");
  MessageReader reader;
  const base::ByteVector most = written(ServerInfo{.models = models, .sounds = sounds}, k15);
  reader.begin(most);
  EXPECT_TRUE(reader.next().ok());
  base::ByteVector more(most.begin(), most.end() - 1);
  for (const char byte : {'s', '\0', '\0'}) more.push_back(static_cast<std::byte>(byte));
  EXPECT_THAT(make_read_error(more).message(), HasSubstr("sound list has more than 2048 names"));
  EXPECT_THAT(make_read_error(base::Bytes(most).first(most.size() - 1)).message(),
              HasSubstr("sound list has no terminating zero"));
}

TEST(BadMessage, RejectsUnknownFlags) {
  const std::string kFirst = " (the first message of its packet)";
  EXPECT_EQ(make_read_error(pack_bytes({0x81, 0x80, 7})).message(),
            "offset 1000: fast update: protocol 15 does not define flags 0x8000" + kFirst);
  EXPECT_EQ(make_read_error(pack_bytes({0x81, 0x80, 0x60, 7}), k666).message(),
            "offset 1000: fast update: protocol 666 does not define flags 0x600000" + kFirst);
  EXPECT_EQ(make_read_error(pack_bytes({0x81, 0x80, 0x80, 2, 7}), k666).message(),
            "offset 1000: fast update: protocol 666 does not define flags 0x2000000" + kFirst);
  EXPECT_EQ(make_read_error(pack_bytes({15, 0, 0x81})).message(),
            "offset 1000: svc_clientdata: protocol 15 does not define flags 0x8100" + kFirst);
  EXPECT_EQ(make_read_error(pack_bytes({6, 9})).message(),
            "offset 1000: svc_sound: protocol 15 does not define flags 0x8" + kFirst);
  EXPECT_EQ(make_read_error(pack_bytes({6, 4}), k666).message(),
            "offset 1000: svc_sound: protocol 666 does not define flags 0x4" + kFirst);
  EXPECT_EQ(make_read_error(pack_bytes({42, 1, 0, 16}), k666).message(),
            "offset 1000: svc_spawnbaseline2: protocol 666 does not define flags 0x10" + kFirst);
}

TEST(BadMessage, RejectsInvalidFields) {
  EXPECT_EQ(make_read_error(pack_bytes({23, 14, 0, 0, 0, 0, 0, 0})).message(),
            "offset 1000: svc_temp_entity: unknown kind of effect 14 (the first message of its packet)");
  EXPECT_EQ(make_read_error(pack_bytes({5, 0x00, 0x7d})).message(),
            "offset 1000: svc_setview: entity 32000 exceeds 31999");
  EXPECT_EQ(make_read_error(pack_bytes({0x81, 0x40, 0xff, 0xff})).message(),
            "offset 1000: fast update: entity 65535 exceeds 31999");
  EXPECT_EQ(make_read_error(pack_bytes({22, 0x00, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})).message(),
            "offset 1000: svc_spawnbaseline: entity 32768 exceeds 31999");
  EXPECT_EQ(make_read_error(pack_bytes({0x81, 0x80, 2, 7, 1}), k666).message(),
            "offset 1000: fast update: frame has a high byte but no low byte");
  EXPECT_EQ(make_read_error(test::with_number(written(ServerInfo{}, k15), 5, std::uint8_t{0})).message(),
            "offset 1000: svc_serverinfo: max clients is 0");
}

TEST(BadMessage, RejectsNonFiniteNumbers) {
  const float none = std::numeric_limits<float>::quiet_NaN(),
              endless = std::numeric_limits<float>::infinity();
  EXPECT_EQ(make_read_error(test::with_number(written(Time{}, k15), 1, none)).message(),
            "offset 1000: svc_time: time is nan");
  const base::ByteVector damage = written(Damage{}, kFloats), angle = written(SetAngle{}, kFloats);
  EXPECT_EQ(make_read_error(test::with_number(damage, 7, -endless), kFloats).message(),
            "offset 1000: svc_damage: coordinate is -inf");
  EXPECT_EQ(make_read_error(test::with_number(damage, 11, 1e9f), kFloats).message(),
            "offset 1000: svc_damage: coordinate 1000000000 exceeds 134217728");
  EXPECT_EQ(make_read_error(test::with_number(angle, 1, none), kFloats).message(),
            "offset 1000: svc_setangle: angle is nan");
}

TEST(BadMessage, ReaderIsAtEndAfterError) {
  MessageReader reader;
  const base::ByteVector bad = pack_bytes({1, 0, 1, 1}), good = pack_bytes({1});
  reader.begin(bad);
  EXPECT_TRUE(reader.next().ok());
  EXPECT_FALSE(reader.next().ok());
  EXPECT_FALSE(reader.next().value().has_value());
  reader.begin(good);
  EXPECT_TRUE(reader.next().value().has_value());
}

TEST(BadMessage, RejectedServerInfoKeepsDialect) {
  MessageReader reader = make_reader(k666);
  const base::ByteVector cut = pack_bytes({11, 15, 0, 0, 0, 1, 0});
  reader.begin(cut);
  EXPECT_FALSE(reader.next().ok());
  EXPECT_EQ(reader.dialect(), k666);
}

// Every prefix of a message is an error that names the right length, as far as the flags that determine the
// length are present.
TEST(BadMessage, RejectsEveryTruncation) {
  for (std::uint64_t seed = 0; seed < test::effort(2000, 300); ++seed) {
    test::Random random(seed);
    const Dialect dialect = std::array{k15, k666, kFloats}[random.below(3)];
    const base::ByteVector bytes = written(test::random_message(random, dialect), dialect);
    test::for_each_truncation(bytes, [&](const base::ByteVector& cut) {
      if (cut.empty()) return;
      const std::string message = make_read_error(cut, dialect).message();
      unsigned long long have = 0, all = 0;
      const std::size_t at = message.find("message ends");
      if (at == std::string::npos) {
        ASSERT_THAT(message, HasSubstr("has no terminating zero")) << "seed " << seed;
        return;
      }
      ASSERT_EQ(std::sscanf(message.c_str() + at, "message ends after %llu of %llu bytes", &have, &all), 2)
          << message;
      ASSERT_EQ(have, cut.size()) << "seed " << seed << ": " << message;
      ASSERT_GT(all, have) << "seed " << seed << ": " << message;
      ASSERT_LE(all, bytes.size()) << "seed " << seed << ": " << message;
    });
  }
}

// Reading any bytes ends with an error, or after at most one message per byte; and every message can be
// written in its dialect.
void read_all(base::Bytes bytes, MessageReader& io_reader) {
  io_reader.begin(bytes);
  for (std::size_t messages = 0;; ++messages) {
    ASSERT_LE(messages, bytes.size());
    const auto message = io_reader.next();
    if (!message.ok() || !message->has_value()) return;
    base::ByteWriter writer;
    const base::Status status = write_message(**message, {Protocol::kRmq, kFloatCoord | kFloatAngle}, writer);
    ASSERT_TRUE(status.ok()) << status.error().message();
  }
}

TEST(BadMessage, SurvivesRandomBytesAndFlippedBits) {
  MessageReader reader;
  for (std::uint64_t seed = 0; seed < test::effort(20000, 2000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    if (random.chance(0.3)) reader = make_reader(std::array{k15, k666, kFloats}[random.below(3)]);
    const Dialect dialect = reader.dialect();
    read_all(test::random_bytes(random, 1 + random.below(60)), reader);
    base::ByteVector packet;
    for (int i = 0; i < 5; ++i) {
      const base::ByteVector message = written(test::random_message(random, dialect), dialect);
      packet.insert(packet.end(), message.begin(), message.end());
    }
    read_all(test::with_flipped_bits(packet, random), reader);
  }
}

void expect_unrepresentable(const ServerMessage& message, const Dialect& dialect, const char* what) {
  base::ByteWriter writer;
  writer.u8(1);
  const base::Status status = write_message(message, dialect, writer);
  ASSERT_FALSE(status.ok()) << what;
  EXPECT_EQ(status.error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(status.error().message(), what);
  EXPECT_EQ(writer.size(), 1u) << "something was appended: " << what;
}

TEST(UnrepresentableMessage, IsRejectedAndAppendsNothing) {
  expect_unrepresentable(EntityUpdate{.number = 1, .model = 256}, k15,
                         "fast update: model 256 exceeds 255, the limit of protocol 15");
  expect_unrepresentable(EntityUpdate{.number = 32000}, k666, "fast update: entity 32000 exceeds 31999");
  expect_unrepresentable(SpawnStatic{{.frame = 256}}, k15,
                         "svc_spawnstatic: frame 256 exceeds 255, the limit of protocol 15");
  expect_unrepresentable(ClientData{.cells = 256}, k15,
                         "svc_clientdata: cells 256 exceeds 255, the limit of protocol 15");
  expect_unrepresentable(Sound{.entity = 8192}, k15,
                         "svc_sound: sound of entity 8192, channel 0 exceeds entity 8191, channel 7");
  expect_unrepresentable(Sound{.sound = 256}, k15,
                         "svc_sound: sound 256 exceeds 255, the limit of protocol 15");
  expect_unrepresentable(StopSound{1, 8}, k666,
                         "svc_stopsound: sound of entity 1, channel 8 exceeds entity 8191, channel 7");
  expect_unrepresentable(SpawnStaticSound{.sound = 256}, k15,
                         "svc_spawnstaticsound: sound 256 exceeds 255, the limit of protocol 15");
  expect_unrepresentable(Particles{.count = 255}, k15,
                         "svc_particle: 255 particles: the count must be at most 254, or 1024");
  expect_unrepresentable(Damage{0, 0, {4096, 0, 0}}, k666,
                         "svc_damage: coordinate 4096 is outside of [-4096, 4095.875]");
  expect_unrepresentable(SetAngle{{std::numeric_limits<float>::infinity(), 0, 0}}, k15,
                         "svc_setangle: angle inf is not finite");
  expect_unrepresentable(Time{std::numeric_limits<float>::quiet_NaN()}, k15,
                         "svc_time: time nan is not finite");
  expect_unrepresentable(Print{std::string_view("a\0b", 3)}, k15, "svc_print: text contains a zero byte");
  const std::vector<std::string_view> names(kMaxSounds + 1, "s"), empty = {""};
  expect_unrepresentable(ServerInfo{.sounds = names}, k15,
                         "svc_serverinfo: sound list has 2049 names, the limit is 2048");
  expect_unrepresentable(ServerInfo{.models = empty}, k15,
                         "svc_serverinfo: model list contains an empty name, which would end the list");
}

}  // namespace
}  // namespace temblor::net
