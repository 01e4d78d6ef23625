// Feeds arbitrary bytes to the reader of server messages in any dialect: the first byte chooses the
// protocol, the second its flags. Each message that is read must be written and read back unchanged, up to
// an error or the end.
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

// A reader after the serverinfo message of a game in this dialect.
net::MessageReader make_reader(const net::Dialect& dialect) {
  net::MessageReader reader;
  const base::ByteVector begin = written(net::ServerInfo{.dialect = dialect}, dialect);
  reader.begin(begin);
  CHECK(reader.next().ok());
  return reader;
}

// A reader of protocol 15 also accepts FitzQuake's messages, because game code sends them, but protocol 15
// cannot express them. Protocol 666 can, with the same encodings of numbers.
net::Dialect dialect_to_write(const net::Dialect& read) {
  return read.protocol == net::Protocol::kNetQuake ? net::Dialect{net::Protocol::kFitzQuake, 0} : read;
}

void check_round_trip(const net::ServerMessage& message, const net::Dialect& dialect) {
  const base::ByteVector bytes = written(message, dialect);
  if (bytes.empty()) return;  // the reader skips this kind of message
  net::MessageReader reader = make_reader(dialect);
  reader.begin(bytes);
  const auto back = reader.next();
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->has_value() && (*back)->index() == message.index());
  CHECK(written(**back, dialect) == bytes, "{} changes when it is read back", net::message_name(message));
  CHECK(!reader.next().value().has_value());
}

}  // namespace

int temblor::fuzz::fuzz_message(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  net::MessageReader reader = make_reader(chosen_dialect(data[0], data[1]));
  reader.begin(std::as_bytes(std::span(data, size).subspan(2)));
  while (true) {
    const auto message = reader.next();
    if (!message.ok() || !message->has_value()) return 0;
    check_round_trip(**message, dialect_to_write(reader.dialect()));
  }
}
