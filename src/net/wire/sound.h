// Wire formats of sounds. Entity and channel share 16 bits; FitzQuake has flags for wide numbers.
//
//   svc_sound:             flags u8 | [volume u8] [attenuation u8] | (entity << 3 | channel) u16 |
//                          sound u8 | 3 coords
//                          with flag 8: entity u16 and channel u8 instead; with flag 16: sound u16
//   svc_stopsound:         (entity << 3 | channel) u16
//   svc_localsound:        flags u8 | sound u8, or u16 with flag 16
//   svc_spawnstaticsound:  3 coords | sound u8 (wide: u16) | volume u8 | attenuation u8 (64ths)
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

Sound read_sound(FieldReader& io_fields);
StopSound read_stop_sound(FieldReader& io_fields);
// `wide`: FitzQuake's form with a 16-bit sound number.
SpawnStaticSound read_static_sound(bool wide, FieldReader& io_fields);
// Reads a svc_localsound of the 2021 re-release: a sound that is equally loud everywhere.
Sound read_local_sound(FieldReader& io_fields);

// Write whole messages.
void write_sound(const Sound& message, FieldWriter& io_fields);
void write_stop_sound(const StopSound& message, FieldWriter& io_fields);
void write_static_sound(const SpawnStaticSound& message, FieldWriter& io_fields);

}  // namespace temblor::net
