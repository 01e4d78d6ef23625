#include "net/wire/server_info.h"

#include <array>
#include <string>

namespace temblor::net {
namespace {

using base::ErrorCode;

// In front of the protocol's number stand pairs of a word of four characters and a mask where client and
// server agreed on FTE's extensions, which change what other messages look like.
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

constexpr std::int32_t four_characters(const char (&text)[5]) {
  std::int32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | text[i];
  return word;
}
constexpr std::int32_t kFteX = four_characters("FTEX"), kFte2 = four_characters("FTE2"),
                       kMvd1 = four_characters("MVD1");

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

void refuse_extensions(std::int32_t word, FieldReader& io_fields) {
  std::string names;
  while (io_fields.ok() && is_extension(word)) {
    names += (names.empty() ? "" : " and ") + describe_extension(word, io_fields.u32());
    word = io_fields.i32();
  }
  io_fields.refuse(ErrorCode::kUnsupported, "uses the protocol extensions {}, which are not supported",
                   names);
}

Dialect read_dialect(FieldReader& io_fields) {
  const std::int32_t number = io_fields.i32();
  if (is_extension(number)) {
    refuse_extensions(number, io_fields);
    return {};
  }
  const Protocol protocol{number};
  if (protocol != Protocol::kNetQuake && protocol != Protocol::kFitzQuake && protocol != Protocol::kRmq) {
    io_fields.refuse(ErrorCode::kUnsupported, "protocol {} is not known; known are 15, 666 and 999", number);
    return {};
  }
  Dialect dialect{protocol, 0};
  if (protocol == Protocol::kRmq) dialect.flags = io_fields.u32();
  if (const std::uint32_t unknown = dialect.flags & ~kKnownProtocolFlags; unknown != 0)
    io_fields.refuse(ErrorCode::kUnsupported, "protocol 999's flags {:#x} are not known; known are {:#x}",
                     unknown, kKnownProtocolFlags);
  return dialect;
}

void read_names(std::vector<std::string_view>& out_names, std::size_t most, const char* what,
                FieldReader& io_fields) {
  out_names.clear();
  while (io_fields.ok()) {
    const std::string_view name = io_fields.text(what);
    if (name.empty()) return;
    if (out_names.size() == most) {
      io_fields.refuse(ErrorCode::kTooLarge, "{} has more than {} names", what, most);
      return;
    }
    out_names.push_back(name);
  }
}

void write_names(std::span<const std::string_view> names, std::size_t most, const char* what,
                 FieldWriter& io_fields) {
  if (names.size() > most) io_fields.refuse("{} has {} names, more than {}", what, names.size(), most);
  for (const std::string_view name : names) {
    if (name.empty()) io_fields.refuse("{} has an empty name, which would end it", what);
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
  if (info.max_clients == 0) io_fields.refuse(ErrorCode::kMalformed, "a game for 0 players");
  info.game_type = io_fields.u8();
  info.level_name = io_fields.text("the level's name");
  read_names(out_models, kMaxModels, "the list of models", io_fields);
  read_names(out_sounds, kMaxSounds, "the list of sounds", io_fields);
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
  write_names(message.models, kMaxModels, "the list of models", io_fields);
  write_names(message.sounds, kMaxSounds, "the list of sounds", io_fields);
}

}  // namespace temblor::net
