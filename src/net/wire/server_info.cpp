#include "net/wire/server_info.h"

#include <array>
#include <string>

namespace temblor::net {
namespace {

using base::ErrorCode;

// If client and server agreed on protocol extensions of FTE, pairs of a four-character code and a bit mask
// precede the protocol number. They change the encoding of other messages, so we only describe and reject
// them.
struct ExtensionBit {
  std::uint32_t bit;
  const char* name;
};
constexpr std::array<ExtensionBit, 8> kFte2Bits = {{{1, "cursor"},
                                                    {2, "voice"},
                                                    {4, "angle delta"},
                                                    {8, "replacement deltas"},
                                                    {16, "max players"},
                                                    {32, "prediction info"},
                                                    {64, "size encoding"},
                                                    {128, "info blobs"}}};

constexpr std::int32_t make_four_character_code(const char (&text)[5]) {
  std::int32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | text[i];
  return word;
}
constexpr std::int32_t kFteX = make_four_character_code("FTEX"), kFte2 = make_four_character_code("FTE2"),
                       kMvd1 = make_four_character_code("MVD1");

bool is_extension(std::int32_t word) {
  return word == kFteX || word == kFte2 || word == kMvd1;
}

std::string describe_extension(std::int32_t word, std::uint32_t mask) {
  if (word != kFte2) return fmt::format("{} {:#x}", word == kFteX ? "FTEX" : "MVD1", mask);
  std::string names;
  for (const ExtensionBit& known : kFte2Bits)
    if (mask & known.bit) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
  return fmt::format("FTE2 {:#x} ({})", mask, names);
}

// Lists all extensions in the error, so that the player sees what the server would have to turn off.
void fail_on_extensions(std::int32_t word, FieldReader& io_fields) {
  std::string names;
  while (io_fields.ok() && is_extension(word)) {
    names += (names.empty() ? "" : " and ") + describe_extension(word, io_fields.u32());
    word = io_fields.i32();
  }
  io_fields.fail(ErrorCode::kUnsupported, "unsupported protocol extensions {}", names);
}

// Rejects flags that we do not know: any of them may change how later messages are encoded.
Dialect read_dialect(FieldReader& io_fields) {
  const std::int32_t number = io_fields.i32();
  if (is_extension(number)) {
    fail_on_extensions(number, io_fields);
    return {};
  }
  const Protocol protocol{number};
  if (protocol != Protocol::kNetQuake && protocol != Protocol::kFitzQuake && protocol != Protocol::kRmq) {
    io_fields.fail(ErrorCode::kUnsupported, "protocol {} is not supported; supported are 15, 666, and 999",
                   number);
    return {};
  }
  Dialect dialect{protocol, 0};
  if (protocol == Protocol::kRmq) dialect.flags = io_fields.u32();
  if (const std::uint32_t unknown = dialect.flags & ~kKnownProtocolFlags; unknown != 0)
    io_fields.fail(ErrorCode::kUnsupported,
                   "flags {:#x} of protocol 999 are not supported; supported are {:#x}", unknown,
                   kKnownProtocolFlags);
  return dialect;
}

// Reads names up to the empty one that ends the list. `what` names the list in errors.
void read_names(std::vector<std::string_view>& out_names, std::size_t max_names, const char* what,
                FieldReader& io_fields) {
  out_names.clear();
  while (io_fields.ok()) {
    const std::string_view name = io_fields.text(what);
    if (name.empty()) return;
    if (out_names.size() == max_names) {
      io_fields.fail(ErrorCode::kTooLarge, "{} has more than {} names", what, max_names);
      return;
    }
    out_names.push_back(name);
  }
}

void write_names(std::span<const std::string_view> names, std::size_t max_names, const char* what,
                 FieldWriter& io_fields) {
  if (names.size() > max_names)
    io_fields.fail("{} has {} names, the limit is {}", what, names.size(), max_names);
  for (const std::string_view name : names) {
    if (name.empty()) io_fields.fail("{} contains an empty name, which would end the list", what);
    io_fields.text(name);
  }
  io_fields.text("");
}

}  // namespace

ServerInfo read_server_info(FieldReader& io_fields, std::vector<std::string_view>& out_models,
                            std::vector<std::string_view>& out_sounds) {
  ServerInfo info;
  info.dialect = read_dialect(io_fields);
  info.max_clients = io_fields.u8();
  if (info.max_clients == 0) io_fields.fail(ErrorCode::kMalformed, "max clients is 0");
  info.game_type = io_fields.u8();
  info.level_name = io_fields.text("level name");
  read_names(out_models, kMaxModels, "model list", io_fields);
  read_names(out_sounds, kMaxSounds, "sound list", io_fields);
  info.models = out_models;
  info.sounds = out_sounds;
  return info;
}

void write_server_info(const ServerInfo& message, FieldWriter& io_fields) {
  io_fields.id(MessageId::kServerInfo);
  io_fields.i32(static_cast<std::int32_t>(message.dialect.protocol));
  if (message.dialect.protocol == Protocol::kRmq) io_fields.u32(message.dialect.flags);
  io_fields.u8(message.max_clients);
  io_fields.u8(message.game_type);
  io_fields.text(message.level_name);
  write_names(message.models, kMaxModels, "model list", io_fields);
  write_names(message.sounds, kMaxSounds, "sound list", io_fields);
}

}  // namespace temblor::net
