#include "net/transport/control.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

constexpr std::size_t kControlHeaderBytes = 4;
constexpr std::uint32_t kControl = 0x80000000;
constexpr std::string_view kGame = "QUAKE";

struct Command {
  std::uint8_t id;
  const char* name;
};
// In the order of ControlPacket.
constexpr std::array<Command, std::variant_size_v<ControlPacket>> kCommands = {{
    {0x01, "CCREQ_CONNECT"},
    {0x02, "CCREQ_SERVER_INFO"},
    {0x03, "CCREQ_PLAYER_INFO"},
    {0x04, "CCREQ_RULE_INFO"},
    {0x05, "CCREQ_RCON"},
    {0x81, "CCREP_ACCEPT"},
    {0x82, "CCREP_REJECT"},
    {0x83, "CCREP_SERVER_INFO"},
    {0x84, "CCREP_PLAYER_INFO"},
    {0x85, "CCREP_RULE_INFO"},
    {0x86, "CCREP_RCON"},
}};

std::uint8_t read_game(FieldReader& io_fields) {
  const std::string_view game = io_fields.text("game name");
  if (io_fields.ok() && game != kGame)
    io_fields.fail(base::ErrorCode::kUnsupported, "game is '{}', expected 'QUAKE'", base::quotable(game));
  return io_fields.u8();
}

// Braced lists are evaluated left to right, so the fields are read in the order of the structs.
ControlPacket read_body(std::uint8_t id, FieldReader& io_fields) {
  FieldReader& f = io_fields;
  switch (id) {
    case 0x01:
      return ConnectRequest{read_game(f)};
    case 0x02:
      return ServerInfoRequest{read_game(f)};
    case 0x03:
      return PlayerInfoRequest{f.u8()};
    case 0x04:
      return RuleInfoRequest{f.text("rule name")};
    case 0x05:
      return RemoteCommandRequest{f.text("password"), f.text("command")};
    case 0x81:
      return AcceptReply{f.i32()};
    case 0x82:
      return RejectReply{f.text("reason")};
    case 0x83:
      return ServerInfoReply{
          f.text("address"), f.text("host name"), f.text("map name"), f.u8(), f.u8(), f.u8()};
    case 0x84:
      return PlayerInfoReply{f.u8(), f.text("name"), f.i32(), f.i32(), f.i32(), f.text("address")};
    default:
      return RemoteCommandReply{f.text("text")};
  }
}

// A reply without any fields marks the end of the list.
ControlPacket read_rule_info(FieldReader& io_fields, bool is_end) {
  if (is_end) return RuleInfoReply{};
  return RuleInfoReply{io_fields.text("rule name"), io_fields.text("value")};
}

// Visitor that writes the fields of a packet.
class ControlWriter {
 public:
  explicit ControlWriter(FieldWriter& io_fields) : f_(io_fields) {}

  void operator()(const ConnectRequest& p) { game(p.net_protocol); }
  void operator()(const ServerInfoRequest& p) { game(p.net_protocol); }
  void operator()(const PlayerInfoRequest& p) { f_.u8(p.player); }
  void operator()(const RuleInfoRequest& p) { f_.text(p.previous); }
  void operator()(const RemoteCommandRequest& p) {
    f_.text(p.password);
    f_.text(p.command);
  }
  void operator()(const AcceptReply& p) { f_.i32(p.port); }
  void operator()(const RejectReply& p) { f_.text(p.reason); }
  void operator()(const ServerInfoReply& p) {
    f_.text(p.address);
    f_.text(p.host_name);
    f_.text(p.map);
    f_.u8(p.players);
    f_.u8(p.max_players);
    f_.u8(p.net_protocol);
  }
  void operator()(const PlayerInfoReply& p) {
    f_.u8(p.player);
    f_.text(p.name);
    f_.i32(p.colors);
    f_.i32(p.frags);
    f_.i32(p.connected_s);
    f_.text(p.address);
  }
  void operator()(const RuleInfoReply& p) {
    if (p.rule.empty()) return;
    f_.text(p.rule);
    f_.text(p.value);
  }
  void operator()(const RemoteCommandReply& p) { f_.text(p.text); }

 private:
  void game(std::uint8_t net_protocol) {
    f_.text(kGame);
    f_.u8(net_protocol);
  }

  FieldWriter& f_;
};

}  // namespace

const char* packet_name(const ControlPacket& packet) {
  return kCommands[packet.index()].name;
}

base::Result<ControlPacket> read_control_packet(base::Bytes packet) {
  if (!is_control_packet(packet) || packet.size() <= kControlHeaderBytes)
    return base::malformed("not a control packet ({} bytes)", packet.size());
  const std::uint32_t word = read_big_endian(packet);
  if (word != (kControl | packet.size()))
    return base::malformed("control packet of {} bytes has the header {:#x}", packet.size(), word);
  base::ByteReader bytes(packet.subspan(kControlHeaderBytes));
  const std::uint8_t id = bytes.u8();
  const Command* known = nullptr;
  for (const Command& command : kCommands)
    if (command.id == id) known = &command;
  if (known == nullptr)
    return base::error(base::ErrorCode::kUnsupported, "unknown control command {:#x}", id);
  FieldReader fields(bytes, Dialect{});
  const ControlPacket read =
      id == 0x85 ? read_rule_info(fields, bytes.remaining() == 0) : read_body(id, fields);
  if (fields.error()) return base::error(fields.error()->code, "{}: {}", known->name, fields.error()->what);
  if (!fields.ok()) return base::malformed("{}: packet ends after {} bytes", known->name, packet.size());
  return read;
}

base::Result<base::ByteVector> write_control_packet(const ControlPacket& packet) {
  base::ByteWriter body;
  FieldWriter fields(body, Dialect{});
  fields.u8(kCommands[packet.index()].id);
  std::visit(ControlWriter(fields), packet);
  const std::size_t size = kControlHeaderBytes + body.size();
  if (size > kMaxControlBytes) fields.fail("{} bytes exceed the limit of {}", size, kMaxControlBytes);
  if (fields.error())
    return base::error(fields.error()->code, "{}: {}", packet_name(packet), fields.error()->what);
  const auto header = big_endian_bytes(kControl | static_cast<std::uint32_t>(size));
  base::ByteVector whole(size);
  std::copy(header.begin(), header.end(), whole.begin());
  std::copy(body.view().begin(), body.view().end(), whole.begin() + kControlHeaderBytes);
  return whole;
}

}  // namespace temblor::net
