#include "net/protocol/client_message.h"

#include <fmt/format.h>

#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {
namespace {

enum ClientMessageId : std::uint8_t { kNop = 1, kDisconnect = 2, kMove = 3, kStringCommand = 4 };

const char* find_message_name(unsigned id) {
  constexpr const char* kNames[] = {"clc_nop", "clc_disconnect", "clc_move", "clc_stringcmd"};
  return id >= kNop && id <= kStringCommand ? kNames[id - 1] : nullptr;
}

// Both newer protocols send the angles of a move in 16 bits; the flags of 999 apply to server messages only.
Dialect choose_move_dialect(Protocol protocol) {
  return protocol == Protocol::kNetQuake ? Dialect{} : Dialect{Protocol::kRmq, kShortAngle};
}

Move read_move(FieldReader& io_fields) {
  FieldReader& f = io_fields;
  Move move;
  move.time_s = f.finite("time");
  move.angles_deg = f.angles_deg();
  move.forward = f.i16();
  move.side = f.i16();
  move.up = f.i16();
  move.buttons = f.u8();
  move.impulse = f.u8();
  return move;
}

StringCommand read_string_command(FieldReader& io_fields) {
  const StringCommand command{io_fields.text("text")};
  if (command.text.size() >= kMaxCommandBytes)
    io_fields.fail(base::ErrorCode::kTooLarge, "text of {} bytes exceeds the limit of {}",
                   command.text.size(), kMaxCommandBytes - 1);
  return command;
}

// Reads the fields after the message number. An unknown number is an error, since the length is unknown.
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
      io_fields.fail(base::ErrorCode::kUnsupported, "unknown message");
      return Nop{};
  }
}

// `have`: bytes from the start of the message to the end of the packet.
base::Error make_read_error(const FieldReader& fields, unsigned id, std::size_t offset, std::size_t have) {
  const char* name = find_message_name(id);
  const std::string place =
      fmt::format("offset {}: {}", offset, name != nullptr ? name : fmt::format("message {}", id));
  if (fields.error()) return base::error(fields.error()->code, "{}: {}", place, fields.error()->what);
  return base::malformed("{}: message ends after {} of {} bytes", place, have, 1 + fields.bytes_needed());
}

// Visitor that writes a message with its number.
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
      f_.fail("text of {} bytes exceeds the limit of {}", command.text.size(), kMaxCommandBytes - 1);
    f_.u8(kStringCommand);
    f_.text(command.text);
  }

 private:
  FieldWriter& f_;
};

}  // namespace

const char* message_name(const ClientMessage& message) {
  return find_message_name(static_cast<unsigned>(message.index()) + 1);
}

base::Result<std::optional<ClientMessage>> ClientMessageReader::next() {
  const std::size_t start = reader_.offset(), have = reader_.remaining();
  if (have == 0) return std::optional<ClientMessage>{};
  const std::uint8_t id = reader_.u8();
  FieldReader fields(reader_, choose_move_dialect(protocol_));
  const ClientMessage message = read_body(id, fields);
  if (fields.ok()) return std::optional<ClientMessage>(message);
  reader_ = base::ByteReader({});  // the length of the bad message is unknown
  return make_read_error(fields, id, start, have);
}

base::Status write_client_message(const ClientMessage& message, Protocol protocol,
                                  base::ByteWriter& io_writer) {
  const std::size_t start = io_writer.size();
  FieldWriter fields(io_writer, choose_move_dialect(protocol));
  std::visit(ClientMessageWriter(fields), message);
  if (!fields.error()) return base::Ok{};
  io_writer.truncate(start);
  return base::error(fields.error()->code, "{}: {}", message_name(message), fields.error()->what);
}

}  // namespace temblor::net
