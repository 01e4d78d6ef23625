// Wire format of svc_temp_entity, short effects without an entity:
//
//   kind u8 | 3 coords                          most kinds
//   kind u8 | entity u16 | 3 coords | 3 coords  beams: start and end
//   kind u8 | 3 coords | u8 | u8                kExplosion2: first palette color and number of colors
//
// Effects that DarkPlaces sends to clients of every protocol: kinds of svc_temp_entity above the original's,
// and svc_effect. Layouts follow the specifications of its extensions (DP_TE_..., DP_SV_EFFECT); a test runs
// the server itself.
//
//   50 blood, 51 spark       3 coords | velocity 3 x i8 | count u8
//   52 blood shower          2 x 3 coords | speed coord | count u16
//   53 colored explosion     3 coords | red, green, blue u8
//   54 particle cube         3 x 3 coords | count u16 | color u8 | gravity u8 | speed coord
//   55 rain, 56 snow         3 x 3 coords | count u16 | color u8
//   57 to 59, 70             3 coords: gunshot, spike, superspike, and explosion with quad damage
//   72 flash, 75 plasma      3 coords
//   73 colored flash         3 coords | radius u8 | time u8 | red, green, blue u8
//   74 flame jet             3 coords | velocity 3 coords | count u8
//   svc_effect               3 coords | model u8 | first frame u8 | frames u8 | frame rate u8
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

// Reads the fields after the kind.
TempEntity read_temp_entity(TempEntityKind kind, FieldReader& io_fields);
void write_temp_entity(const TempEntity& message, FieldWriter& io_fields);

// Reads the fields of a kind that only DarkPlaces sends. Kinds with an original counterpart become that,
// blood becomes particles, and the others are read and ignored. An unknown kind is an error, because its
// length is unknown.
ServerMessage read_foreign_temp_entity(std::uint8_t kind, FieldReader& io_fields);
// Reads the fields of message 52: the name of an achievement (2021 re-release), or else an effect.
void skip_achievement_or_effect(FieldReader& io_fields);

}  // namespace temblor::net
