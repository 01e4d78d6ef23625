// Sounds that start, stop, or never end.
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

Sound read_sound(FieldReader& io_fields);
StopSound read_stop_sound(FieldReader& io_fields);
// `wide`: FitzQuake's form, with two bytes for the sound's number.
SpawnStaticSound read_static_sound(bool wide, FieldReader& io_fields);
// Of the 2021 re-release, heard without a place: read over.
void skip_local_sound(FieldReader& io_fields);

// Whole messages.
void write_sound(const Sound& message, FieldWriter& io_fields);
void write_stop_sound(const StopSound& message, FieldWriter& io_fields);
void write_static_sound(const SpawnStaticSound& message, FieldWriter& io_fields);

}  // namespace temblor::net
