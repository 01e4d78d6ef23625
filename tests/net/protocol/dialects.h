// Single messages as bytes, and readers set to a dialect.
#pragma once

#include <initializer_list>
#include <utility>

#include "base/check.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"

namespace temblor::test {

inline constexpr net::Dialect k15{};
inline constexpr net::Dialect k666{net::Protocol::kFitzQuake, 0};
inline constexpr net::Dialect k999{net::Protocol::kRmq, net::kInt32Coord | net::kShortAngle};

inline base::ByteVector pack_bytes(std::initializer_list<int> numbers) {
  base::ByteVector bytes;
  for (const int number : numbers) bytes.push_back(static_cast<std::byte>(number));
  return bytes;
}

// CHECKs that the dialect can represent the message.
inline base::ByteVector written(const net::ServerMessage& message, const net::Dialect& dialect) {
  base::ByteWriter writer;
  CHECK(write_message(message, dialect, writer).ok());
  return std::move(writer).take();
}

// A reader that has read a ServerInfo of this dialect.
inline net::MessageReader make_reader(const net::Dialect& dialect) {
  net::MessageReader reader;
  const base::ByteVector begin = written(net::ServerInfo{.dialect = dialect}, dialect);
  reader.begin(begin);
  CHECK(reader.next().ok());
  return reader;
}

}  // namespace temblor::test
