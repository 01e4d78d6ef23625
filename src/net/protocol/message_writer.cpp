#include "net/protocol/message_writer.h"

#include <variant>

#include "net/wire/baseline.h"
#include "net/wire/client_data.h"
#include "net/wire/entity_update.h"
#include "net/wire/field_writer.h"
#include "net/wire/particles.h"
#include "net/wire/server_info.h"
#include "net/wire/sound.h"
#include "net/wire/temp_entity.h"

namespace temblor::net {
namespace {

// Visitor that writes a message with its number.
class ServerMessageWriter {
 public:
  explicit ServerMessageWriter(FieldWriter& io_fields) : f_(io_fields) {}

  void operator()(const Nop&) { f_.id(MessageId::kNop); }
  void operator()(const Disconnect&) { f_.id(MessageId::kDisconnect); }
  void operator()(const UpdateStat& message) {
    f_.id(MessageId::kUpdateStat);
    f_.u8(message.stat);
    f_.i32(message.value);
  }
  void operator()(const Version& message) {
    f_.id(MessageId::kVersion);
    f_.i32(message.version);
  }
  void operator()(const SetView& message) {
    f_.id(MessageId::kSetView);
    f_.entity(message.entity);
  }
  void operator()(const Sound& message) { write_sound(message, f_); }
  void operator()(const Time& message) {
    f_.id(MessageId::kTime);
    f_.finite(message.time_s, "time");
  }
  void operator()(const Print& message) { text(MessageId::kPrint, message.text); }
  void operator()(const StuffText& message) { text(MessageId::kStuffText, message.text); }
  void operator()(const CenterPrint& message) { text(MessageId::kCenterPrint, message.text); }
  void operator()(const SetAngle& message) {
    f_.id(MessageId::kSetAngle);
    f_.angles_deg(message.angles_deg);
  }
  void operator()(const ServerInfo& message) { write_server_info(message, f_); }
  void operator()(const LightStyle& message) {
    numbered_text(MessageId::kLightStyle, message.style, message.pattern);
  }
  void operator()(const UpdateName& message) {
    numbered_text(MessageId::kUpdateName, message.client, message.name);
  }
  void operator()(const UpdateFrags& message) {
    f_.id(MessageId::kUpdateFrags);
    f_.u8(message.client);
    f_.i16(message.frags);
  }
  void operator()(const UpdateColors& message) {
    bytes(MessageId::kUpdateColors, message.client, message.colors);
  }
  void operator()(const ClientData& message) { write_client_data(message, f_); }
  void operator()(const StopSound& message) { write_stop_sound(message, f_); }
  void operator()(const Particles& message) { write_particles(message, f_); }
  void operator()(const Damage& message) {
    bytes(MessageId::kDamage, message.armor, message.blood);
    f_.coords(message.from);
  }
  void operator()(const SpawnStatic& message) { write_spawn_static(message, f_); }
  void operator()(const SpawnBaseline& message) { write_spawn_baseline(message, f_); }
  void operator()(const EntityUpdate& message) { write_entity_update(message, f_); }
  void operator()(const TempEntity& message) { write_temp_entity(message, f_); }
  void operator()(const SetPause& message) {
    f_.id(MessageId::kSetPause);
    f_.u8(message.paused ? 1 : 0);
  }
  void operator()(const SignonNumber& message) {
    f_.id(MessageId::kSignonNumber);
    f_.u8(message.number);
  }
  void operator()(const KilledMonster&) { f_.id(MessageId::kKilledMonster); }
  void operator()(const FoundSecret&) { f_.id(MessageId::kFoundSecret); }
  void operator()(const SpawnStaticSound& message) { write_static_sound(message, f_); }
  void operator()(const Intermission&) { f_.id(MessageId::kIntermission); }
  void operator()(const SellScreen&) { f_.id(MessageId::kSellScreen); }
  void operator()(const Finale& message) { text(MessageId::kFinale, message.text); }
  void operator()(const CutScene& message) { text(MessageId::kCutScene, message.text); }
  void operator()(const CdTrack& message) { bytes(MessageId::kCdTrack, message.track, message.loop_track); }
  // Only FitzQuake and later have these.
  void operator()(const Skybox& message) {
    if (is_extended(f_.dialect())) text(MessageId::kSkybox, message.name);
  }
  void operator()(const BonusFlash&) {
    if (is_extended(f_.dialect())) f_.id(MessageId::kBonusFlash);
  }
  void operator()(const Fog& message) {
    if (is_extended(f_.dialect())) write_fog(message, f_);
  }
  void operator()(const BotChat& message) {
    f_.id(MessageId::kBotChat);
    f_.u8(message.client);
    f_.i16(static_cast<std::int16_t>(message.texts.size()));
    for (const std::string_view text : message.texts) f_.text(text);
  }
  void operator()(const Ignored&) {}

 private:
  void bytes(MessageId id, std::uint8_t first, std::uint8_t second) {
    f_.id(id);
    f_.u8(first);
    f_.u8(second);
  }
  void text(MessageId id, std::string_view text) {
    f_.id(id);
    f_.text(text);
  }
  void numbered_text(MessageId id, std::uint8_t number, std::string_view text) {
    f_.id(id);
    f_.u8(number);
    f_.text(text);
  }

  FieldWriter& f_;
};

}  // namespace

base::Status write_message(const ServerMessage& message, const Dialect& dialect,
                           base::ByteWriter& io_writer) {
  const std::size_t start = io_writer.size();
  FieldWriter fields(io_writer, dialect);
  std::visit(ServerMessageWriter(fields), message);
  if (!fields.error()) return base::Ok{};
  io_writer.truncate(start);
  return base::error(fields.error()->code, "{}: {}", message_name(message), fields.error()->what);
}

}  // namespace temblor::net
