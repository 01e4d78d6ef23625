#include "net/wire/temp_entity.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "net/wire/message_id.h"

namespace temblor::net {
namespace {

bool is_beam(TempEntityKind kind) {
  return kind == TempEntityKind::kLightning1 || kind == TempEntityKind::kLightning2 ||
         kind == TempEntityKind::kLightning3 || kind == TempEntityKind::kBeam;
}

constexpr std::uint8_t kBloodColor = 73;  // as game code draws it with particle()
constexpr std::uint16_t kMaxBlood = 254;  // svc_particle's most, except for an explosion

// A burst as game code would make it with particle(). Whole units of velocity become its sixteenths.
Particles read_blood(FieldReader& io_fields) {
  Particles blood;
  blood.origin = io_fields.coords();
  for (int axis = 0; axis < 3; ++axis) blood.direction[axis] = static_cast<float>(io_fields.i8()) / 16;
  blood.count = std::min<std::uint16_t>(io_fields.u8(), kMaxBlood);
  blood.color = kBloodColor;
  return blood;
}

// An effect of DarkPlaces, besides blood. `fields` follow the kind: c is a coordinate, b a byte; the first
// three are the place.
struct ForeignEffect {
  std::uint8_t kind;
  std::string_view fields;
  std::optional<TempEntityKind> shown_as{};  // none: the effect is skipped
};
constexpr auto kForeignEffects = std::to_array<ForeignEffect>({{51, "cccbbbb"},
                                                               {52, "cccccccbb"},
                                                               {53, "cccbbb", TempEntityKind::kExplosion},
                                                               {54, "cccccccccbbbbc"},
                                                               {55, "cccccccccbbb"},
                                                               {56, "cccccccccbbb"},
                                                               {57, "ccc", TempEntityKind::kGunshot},
                                                               {58, "ccc", TempEntityKind::kSpike},
                                                               {59, "ccc", TempEntityKind::kSuperSpike},
                                                               {70, "ccc", TempEntityKind::kExplosion},
                                                               {72, "ccc"},
                                                               {73, "cccbbbbb"},
                                                               {74, "ccccccb"},
                                                               {75, "ccc"}});

void skip_fields(std::string_view fields, FieldReader& io_fields) {
  for (const char field : fields) {
    if (field == 'c')
      io_fields.coord();
    else
      io_fields.u8();
  }
}

}  // namespace

TempEntity read_temp_entity(TempEntityKind kind, FieldReader& io_fields) {
  TempEntity entity;
  entity.kind = kind;
  if (is_beam(entity.kind)) {
    entity.entity = io_fields.entity();
    entity.origin = io_fields.coords();
    entity.end = io_fields.coords();
    return entity;
  }
  entity.origin = io_fields.coords();
  if (entity.kind == TempEntityKind::kExplosion2) {
    entity.color_start = io_fields.u8();
    entity.color_count = io_fields.u8();
  }
  return entity;
}

void write_temp_entity(const TempEntity& message, FieldWriter& io_fields) {
  io_fields.id(MessageId::kTempEntity);
  io_fields.u8(static_cast<std::uint8_t>(message.kind));
  if (is_beam(message.kind)) io_fields.entity(message.entity);
  io_fields.coords(message.origin);
  if (is_beam(message.kind)) io_fields.coords(message.end);
  if (message.kind == TempEntityKind::kExplosion2) {
    io_fields.u8(message.color_start);
    io_fields.u8(message.color_count);
  }
}

ServerMessage read_foreign_temp_entity(std::uint8_t kind, FieldReader& io_fields) {
  constexpr std::uint8_t kBlood = 50;
  const Ignored ignored{static_cast<std::uint8_t>(MessageId::kTempEntity)};
  if (kind == kBlood) return read_blood(io_fields);
  const auto effect = std::ranges::find(kForeignEffects, kind, &ForeignEffect::kind);
  if (effect == kForeignEffects.end()) {
    io_fields.fail(base::ErrorCode::kUnsupported, "unknown kind of effect {}", kind);
    return ignored;
  }
  TempEntity entity;
  entity.origin = io_fields.coords();
  skip_fields(effect->fields.substr(3), io_fields);
  if (!effect->shown_as) return ignored;
  entity.kind = *effect->shown_as;
  return entity;
}

// The names of achievements begin with these letters. An effect that begins like them would be at a place
// with coordinates of over 2000 and 1000 units, and is worth the risk.
void skip_achievement_or_effect(FieldReader& io_fields) {
  if (io_fields.next_is("ACH_")) {
    io_fields.text("achievement name");
    return;
  }
  skip_fields("cccbbbb", io_fields);
}

}  // namespace temblor::net
