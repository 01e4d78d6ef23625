// Wire formats of svc_particle and svc_fog:
//
//   particle:  3 coords | direction 3 x i8 (16ths) | count u8 (255 means 1024) | color u8
//   fog:       density u8 (255ths) | red, green, blue u8 | fade i16 (hundredths of a second)
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

Particles read_particles(FieldReader& io_fields);
Fog read_fog(FieldReader& io_fields);

// Write whole messages. Fails if the count of particles is over 254 and not 1024.
void write_particles(const Particles& message, FieldWriter& io_fields);
void write_fog(const Fog& message, FieldWriter& io_fields);

}  // namespace temblor::net
