#include "net/protocol/client_message.h"

#include <fmt/format.h>

#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {
namespace {

enum ClientMessageId : std::uint8_t { kNop = 1, kDisconnect = 2, kMove = 3, kStringCommand = 4 };

const char* name_of_id(unsigned id) {
  constexpr const char* kNames[] = {"clc_nop", "clc_disconnect", "clc_move", "clc_stringcmd"};
  return id >= kNop && id <= kStringCommand ? kNames[id - 1] : nullptr;
}

// A move's angles are 16-bit in both newer protocols, whatever flags 999 has for the server's own.
Dialect dialect_of_moves(Protocol protocol) {
  return protocol == Protocol::kNetQuake ? Dialect{} : Dialect{Protocol::kRmq, kShortAngle};
}

Move read_move(FieldReader& io_fields) {
  FieldReader& f = io_fields;
  Move move;
  move.time_s = f.finite("the time");
  move.angles_deg = f.angles_deg();
  move.forward = f.i16();
  move.side = f.i16();
  move.up = f.i16();
  move.buttons = f.u8();
  move.impulse = f.u8();
  return move;
}

StringCommand read_string_command(FieldReader& io_fields) {
  const StringCommand command{io_fields.text("the text")};
  if (command.text.size() >= kMaxCommandBytes)
    io_fields.refuse(base::ErrorCode::kTooLarge, "a text of {} bytes, the most is {}", command.text.size(),
                     kMaxCommandBytes - 1);
  return command;
}

ClientMessage read_body(unsigned id, FieldReader& io_fields) {
  switch (id) {
    case kNop:
      return Nop{};
    case kDisconnect:
      return Disconnect{};
    case kMove:
      return read_move(io_fields);
    case kStringCommand:
      return read_string_command(io_fields);
    default:
      io_fields.refuse(base::ErrorCode::kUnsupported, "no such message is known");
      return Nop{};
  }
}

base::Error error_of(const FieldReader& fields, unsigned id, std::size_t offset, std::size_t have) {
  const char* name = name_of_id(id);
  const std::string place =
      fmt::format("offset {}: {}", offset, name != nullptr ? name : fmt::format("message {}", id));
  if (fields.refusal()) return base::error(fields.refusal()->code, "{}: {}", place, fields.refusal()->what);
  return base::malformed("{}: message ends after {} of {} bytes", place, have, 1 + fields.bytes_wanted());
}

class ClientMessageWriter {
 public:
  explicit ClientMessageWriter(FieldWriter& io_fields) : f_(io_fields) {}

  void operator()(const Nop&) { f_.u8(kNop); }
  void operator()(const Disconnect&) { f_.u8(kDisconnect); }
  void operator()(const Move& move) {
    f_.u8(kMove);
    f_.finite(move.time_s, "time");
    f_.angles_deg(move.angles_deg);
    f_.i16(move.forward);
    f_.i16(move.side);
    f_.i16(move.up);
    f_.u8(move.buttons);
    f_.u8(move.impulse);
  }
  void operator()(const StringCommand& command) {
    if (command.text.size() >= kMaxCommandBytes)
      f_.refuse("a text of {} bytes, the most is {}", command.text.size(), kMaxCommandBytes - 1);
    f_.u8(kStringCommand);
    f_.text(command.text);
  }

 private:
  FieldWriter& f_;
};

}  // namespace

const char* name_of(const ClientMessage& message) {
  return name_of_id(static_cast<unsigned>(message.index()) + 1);
}

base::Result<std::optional<ClientMessage>> ClientMessageReader::next() {
  const std::size_t start = reader_.offset(), have = reader_.remaining();
  if (have == 0) return std::optional<ClientMessage>{};
  const std::uint8_t id = reader_.u8();
  FieldReader fields(reader_, dialect_of_moves(protocol_));
  const ClientMessage message = read_body(id, fields);
  if (fields.ok()) return std::optional<ClientMessage>(message);
  reader_ = base::ByteReader({});
  return error_of(fields, id, start, have);
}

base::Status write_client_message(const ClientMessage& message, Protocol protocol,
                                  base::ByteWriter& io_writer) {
  const std::size_t start = io_writer.size();
  FieldWriter fields(io_writer, dialect_of_moves(protocol));
  std::visit(ClientMessageWriter(fields), message);
  if (!fields.refusal()) return base::Ok{};
  io_writer.truncate(start);
  return base::error(fields.refusal()->code, "{}: {}", name_of(message), fields.refusal()->what);
}

}  // namespace temblor::net
