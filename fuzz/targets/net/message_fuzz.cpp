// Any bytes in any dialect: messages, each of which is written again and read back the same, until an error
// or the end. The first byte chooses the protocol, the second its flags.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "fuzz/targets.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"

using namespace temblor;

namespace {

net::Dialect chosen_dialect(std::uint8_t protocol, std::uint8_t flags) {
  switch (protocol % 3) {
    case 0:
      return {net::Protocol::kNetQuake, 0};
    case 1:
      return {net::Protocol::kFitzQuake, 0};
    default:
      return {net::Protocol::kRmq, flags & net::kKnownProtocolFlags};
  }
}

base::ByteVector written(const net::ServerMessage& message, const net::Dialect& dialect) {
  base::ByteWriter writer;
  const base::Status status = net::write_message(message, dialect, writer);
  CHECK(status.ok(), "{}", status.error().message());
  return std::move(writer).take();
}

// A reader that a game of this dialect has begun on.
net::MessageReader reader_of(const net::Dialect& dialect) {
  net::MessageReader reader;
  const base::ByteVector begin = written(net::ServerInfo{.dialect = dialect}, dialect);
  reader.begin(begin);
  CHECK(reader.next().ok());
  return reader;
}

// Protocol 15 cannot say all that is read in it (FitzQuake's messages, from game code): 666 can, in the same
// encodings of numbers.
net::Dialect dialect_to_write(const net::Dialect& read) {
  return read.protocol == net::Protocol::kNetQuake ? net::Dialect{net::Protocol::kFitzQuake, 0} : read;
}

void check_round_trip(const net::ServerMessage& message, const net::Dialect& dialect) {
  const base::ByteVector bytes = written(message, dialect);
  if (bytes.empty()) return;  // it is one that is only read over
  net::MessageReader reader = reader_of(dialect);
  reader.begin(bytes);
  const auto back = reader.next();
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->has_value() && (*back)->index() == message.index());
  CHECK(written(**back, dialect) == bytes, "{} changes when it is read back", net::name_of(message));
  CHECK(!reader.next().value().has_value());
}

}  // namespace

int temblor::fuzz::fuzz_message(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  net::MessageReader reader = reader_of(chosen_dialect(data[0], data[1]));
  reader.begin(std::as_bytes(std::span(data, size).subspan(2)));
  while (true) {
    const auto message = reader.next();
    if (!message.ok() || !message->has_value()) return 0;
    check_round_trip(**message, dialect_to_write(reader.dialect()));
  }
}
