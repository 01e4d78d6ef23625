#include "net/protocol/message_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "net/wire/baseline.h"
#include "net/wire/client_data.h"
#include "net/wire/entity_update.h"
#include "net/wire/field_reader.h"
#include "net/wire/message_id.h"
#include "net/wire/particles.h"
#include "net/wire/server_info.h"
#include "net/wire/sound.h"
#include "net/wire/temp_entity.h"

namespace temblor::net {
namespace {

ServerMessage fail_unknown_id(MessageId id, FieldReader& io_fields) {
  if (message_name(id) != nullptr)
    io_fields.fail(base::ErrorCode::kUnsupported, "message of the 2021 re-release, which is not supported");
  else
    io_fields.fail(base::ErrorCode::kUnsupported, "unknown message");
  return Nop{};
}

// g++ 12 warns about uninitialized padding if these two are built as temporaries.
LightStyle read_light_style(FieldReader& io_fields) {
  LightStyle style;
  style.style = io_fields.u8();
  style.pattern = io_fields.text("pattern");
  return style;
}

UpdateName read_update_name(FieldReader& io_fields) {
  UpdateName update;
  update.client = io_fields.u8();
  update.name = io_fields.text("name");
  return update;
}

// The count is signed on the wire. Each text has at least one byte, so the packet's size limits the list.
BotChat read_bot_chat(FieldReader& io_fields, std::vector<std::string_view>& out_texts) {
  BotChat chat;
  chat.client = io_fields.u8();
  out_texts.clear();
  for (int left = io_fields.i16(); left > 0 && io_fields.ok(); --left)
    out_texts.push_back(io_fields.text("text"));
  chat.texts = out_texts;
  return chat;
}

ServerMessage read_any_temp_entity(FieldReader& io_fields) {
  const std::uint8_t kind = io_fields.u8();
  if (kind <= static_cast<std::uint8_t>(TempEntityKind::kBeam))
    return read_temp_entity(TempEntityKind{kind}, io_fields);
  return read_foreign_temp_entity(kind, io_fields);
}

// Reads every message except those with lists.
ServerMessage read_body(MessageId id, FieldReader& io_fields) {
  FieldReader& f = io_fields;
  switch (id) {
    case MessageId::kNop:
      return Nop{};
    case MessageId::kDisconnect:
      return Disconnect{};
    case MessageId::kUpdateStat:
      return UpdateStat{f.u8(), f.i32()};
    case MessageId::kVersion:
      return Version{f.i32()};
    case MessageId::kSetView:
      return SetView{f.entity()};
    case MessageId::kSound:
      return read_sound(f);
    case MessageId::kTime:
      return Time{f.finite("time")};
    case MessageId::kPrint:
      return Print{f.text("text")};
    case MessageId::kStuffText:
      return StuffText{f.text("text")};
    case MessageId::kSetAngle:
      return SetAngle{f.angles_deg()};
    case MessageId::kLightStyle:
      return read_light_style(f);
    case MessageId::kUpdateName:
      return read_update_name(f);
    case MessageId::kUpdateFrags:
      return UpdateFrags{f.u8(), f.i16()};
    case MessageId::kClientData:
      return read_client_data(f);
    case MessageId::kStopSound:
      return read_stop_sound(f);
    case MessageId::kUpdateColors:
      return UpdateColors{f.u8(), f.u8()};
    case MessageId::kParticles:
      return read_particles(f);
    case MessageId::kDamage:
      return Damage{f.u8(), f.u8(), f.coords()};
    case MessageId::kSpawnStatic:
      return SpawnStatic{read_baseline(f)};
    case MessageId::kSpawnBaseline:
      return SpawnBaseline{f.entity(), read_baseline(f)};
    case MessageId::kTempEntity:
      return read_any_temp_entity(f);
    case MessageId::kSetPause:
      return SetPause{f.u8() != 0};
    case MessageId::kSignonNumber:
      return SignonNumber{f.u8()};
    case MessageId::kCenterPrint:
      return CenterPrint{f.text("text")};
    case MessageId::kKilledMonster:
      return KilledMonster{};
    case MessageId::kFoundSecret:
      return FoundSecret{};
    case MessageId::kSpawnStaticSound:
      return read_static_sound(false, f);
    case MessageId::kIntermission:
      return Intermission{};
    case MessageId::kFinale:
      return Finale{f.text("text")};
    case MessageId::kCdTrack:
      return CdTrack{f.u8(), f.u8()};
    case MessageId::kSellScreen:
      return SellScreen{};
    case MessageId::kCutScene:
      return CutScene{f.text("text")};
    case MessageId::kSkybox:
      return Skybox{f.text("name")};
    case MessageId::kBonusFlash:
      return BonusFlash{};
    case MessageId::kFog:
      return read_fog(f);
    case MessageId::kSpawnBaseline2:
      return SpawnBaseline{f.entity(), read_baseline2(f)};
    case MessageId::kSpawnStatic2:
      return SpawnStatic{read_baseline2(f)};
    case MessageId::kSpawnStaticSound2:
      return read_static_sound(true, f);
    case MessageId::kAchievement:
      skip_achievement_or_effect(f);
      return Ignored{static_cast<std::uint8_t>(id)};
    case MessageId::kLocalSound:
      return read_local_sound(f);
    case MessageId::kLevelCompleted:
    case MessageId::kBackToLobby:
      return Ignored{static_cast<std::uint8_t>(id)};
    case MessageId::kServerInfo:
    case MessageId::kBotChat:
    case MessageId::kEntityUpdate:
      break;
  }
  const auto number = static_cast<std::uint8_t>(id);
  return id >= MessageId::kEntityUpdate ? ServerMessage(read_entity_update(number, f))
                                        : fail_unknown_id(id, f);
}

std::string describe(std::uint8_t id) {
  const char* name = message_name(MessageId{id});
  return name != nullptr ? name : fmt::format("message {}", id);
}

// `have`: bytes from the start of the message to the end of the packet.
base::Error make_read_error(const FieldReader& fields, std::uint8_t id, std::size_t offset,
                            std::size_t have) {
  const std::string place = fmt::format("offset {}: {}", offset, describe(id));
  if (fields.error()) return base::error(fields.error()->code, "{}: {}", place, fields.error()->what);
  return base::malformed("{}: message ends after {} of {} bytes", place, have, 1 + fields.bytes_needed());
}

}  // namespace

void MessageReader::begin(base::Bytes bytes, std::size_t offset_in_file) {
  reader_ = base::ByteReader(bytes);
  offset_in_file_ = offset_in_file;
  last_ids_ = {};
  is_at_unknown_ = false;
}

// Appends the messages before it, because one of them may be longer than this reader knows.
base::Error MessageReader::add_last_messages(base::Error error) const {
  std::string names;
  for (const std::uint8_t id : last_ids_)
    if (id != 0) names += fmt::format("{}{}", names.empty() ? "" : ", ", describe(id));
  error.what += names.empty() ? " (the first message of its packet)" : fmt::format(" (after {})", names);
  return error;
}

base::Result<std::optional<ServerMessage>> MessageReader::next() {
  const std::size_t start = reader_.offset(), have = reader_.remaining();
  if (have == 0) return std::optional<ServerMessage>{};
  const std::uint8_t id = reader_.u8();
  FieldReader fields(reader_, dialect_);
  // These two refer to lists that live in this reader, so read_body() cannot read them.
  const bool is_server_info = MessageId{id} == MessageId::kServerInfo;
  const ServerMessage message = is_server_info ? read_server_info(fields, models_, sounds_)
                                : MessageId{id} == MessageId::kBotChat
                                    ? ServerMessage(read_bot_chat(fields, chat_texts_))
                                    : read_body(MessageId{id}, fields);
  if (!fields.ok()) {
    reader_ = base::ByteReader({});
    base::Error error = make_read_error(fields, id, offset_in_file_ + start, have);
    is_at_unknown_ = error.code == base::ErrorCode::kUnsupported && !is_server_info;
    return is_at_unknown_ ? add_last_messages(std::move(error)) : error;
  }
  std::rotate(last_ids_.begin(), last_ids_.begin() + 1, last_ids_.end());
  last_ids_.back() = id;
  if (is_server_info) dialect_ = std::get<ServerInfo>(message).dialect;
  return std::optional<ServerMessage>(message);
}

}  // namespace temblor::net
