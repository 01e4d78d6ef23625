// Bursts of particles, and fog: what the air is full of.
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

Particles read_particles(FieldReader& io_fields);
Fog read_fog(FieldReader& io_fields);

// Whole messages. A count of particles is at most 254, or 1024.
void write_particles(const Particles& message, FieldWriter& io_fields);
void write_fog(const Fog& message, FieldWriter& io_fields);

}  // namespace temblor::net
