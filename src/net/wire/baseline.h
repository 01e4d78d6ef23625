// How entities begin: baselines of those that will move, and all there is of those that never do.
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

Baseline read_baseline(FieldReader& io_fields);
// The longer form of FitzQuake: flags first, then two bytes for a high model or frame, opacity and scale.
Baseline read_baseline2(FieldReader& io_fields);

// Whole messages, in the longer form where the dialect has it and the baseline needs it.
void write_spawn_static(const SpawnStatic& message, FieldWriter& io_fields);
void write_spawn_baseline(const SpawnBaseline& message, FieldWriter& io_fields);

}  // namespace temblor::net
