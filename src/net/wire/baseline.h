// Wire format of svc_spawnbaseline and svc_spawnstatic:
//
//   original:   [number u16, baseline only] model u8 | frame u8 | colormap u8 | skin u8 | 3 x (coord, angle)
//   FitzQuake:  [number u16, baseline only] flags u8 | model u8/u16 | frame u8/u16 | colormap u8 | skin u8 |
//               3 x (coord, angle) | [alpha u8] | [scale u8]
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

// Read the fields after the entity number.
Baseline read_baseline(FieldReader& io_fields);
// FitzQuake's form.
Baseline read_baseline2(FieldReader& io_fields);

// Write whole messages. They use FitzQuake's form only if the dialect has it and the baseline needs it.
void write_spawn_static(const SpawnStatic& message, FieldWriter& io_fields);
void write_spawn_baseline(const SpawnBaseline& message, FieldWriter& io_fields);

}  // namespace temblor::net
