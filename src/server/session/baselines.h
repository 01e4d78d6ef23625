// Entities as a level begins with them: what later updates are told against.
#pragma once

#include <string_view>

#include "base/function_ref.h"
#include "net/protocol/server_message.h"
#include "server/game_world.h"
#include "server/session/outbox.h"
#include "vm/machine.h"

namespace temblor::server {

// A field of that name and type, where the program has it.
std::optional<Field<float>> float_field(const vm::Program& program, std::string_view name);
std::optional<Field<math::Vec3>> vector_field(const vm::Program& program, std::string_view name);

// Fields beside the system's that say how an entity looks, where a program has them.
struct LookFields {
  explicit LookFields(const vm::Program& program);
  std::optional<Field<float>> alpha, scale;
};

// Opacity as programs give it: 0 means nothing was said, below 0 invisible. Scale alike.
float alpha_of(const Edict& edict, const LookFields& fields);
float scale_of(const Edict& edict, const LookFields& fields);

// A number as QuakeC holds it, in the range of what it is sent as: what is outside counts as 0.
std::uint16_t sent_u16(float value);
std::uint8_t sent_u8(float value);

// A vector without what is no number: 0 in its place.
math::Vec3 finite(const math::Vec3& value);

// How the entity looks now.
net::Baseline look_of(const Edict& edict, const LookFields& fields);

// Keeps and writes to the signon the baseline of every entity that shows something, and of all players'
// places (as players look, `player_model` being the number of theirs). `after_each`: where the signon may be
// cut.
void take_baselines(GameWorld& io_world, const vm::Program& program, Outbox& io_outbox,
                    base::FunctionRef<void()> after_each);

}  // namespace temblor::server
