// Baselines: how each entity looks when the level starts. Snapshots contain only what differs from them. The
// functions that convert QuakeC's numbers to what messages can hold are here, too.
#pragma once

#include <string_view>

#include "base/function_ref.h"
#include "net/protocol/server_message.h"
#include "server/game/game_world.h"
#include "server/game/outbox.h"
#include "vm/machine.h"

namespace temblor::server {

// The program's field of this name and type, if it has one.
std::optional<Field<float>> float_field(const vm::Program& program, std::string_view name);
std::optional<Field<math::Vec3>> vector_field(const vm::Program& program, std::string_view name);

// Optional fields that change how an entity looks.
struct LookFields {
  explicit LookFields(const vm::Program& program);
  std::optional<Field<float>> alpha, scale;
};

// Opacity, 0 to 1. In the field, 0 stands for 1, and negative values for invisible.
float sent_alpha(const Edict& edict, const LookFields& fields);
// Size relative to the model, above 0 and below 16. In the field, 0 stands for 1.
float sent_scale(const Edict& edict, const LookFields& fields);

// A QuakeC number in the range of the type that it is sent as. Values out of range count as 0.
std::uint16_t sent_u16(float value);
std::uint8_t sent_u8(float value);

// The vector, with 0 for components that are not finite.
math::Vec3 finite(const math::Vec3& value);

// The entity as it looks now.
net::Baseline make_baseline(const Edict& edict, const LookFields& fields);

// Stores the baseline of every visible entity and of all player slots (as players look), and writes them to
// the signon. `after_each` runs after each message: the signon may be split there.
void take_baselines(GameWorld& io_world, const vm::Program& program, Outbox& io_outbox,
                    base::FunctionRef<void()> after_each);

}  // namespace temblor::server
