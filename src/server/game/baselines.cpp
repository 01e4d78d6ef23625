#include "server/game/baselines.h"

#include <algorithm>
#include <cmath>

namespace temblor::server {
namespace {

// Players' baselines have this model even before anybody has joined.
constexpr std::string_view kPlayerModel = "progs/player.mdl";

// 0 if no model has this name.
std::uint16_t find_model_number(const GameWorld& world, std::string_view name) {
  for (std::size_t i = 1; i < world.models.size(); ++i)
    if (world.models[i].name == name) return static_cast<std::uint16_t>(i);
  return 0;
}

}  // namespace

std::optional<Field<float>> float_field(const vm::Program& program, std::string_view name) {
  const formats::ProgsDefinition* field = program.find_field(name);
  if (!field || field->type != formats::ProgsType::kFloat) return std::nullopt;
  return Field<float>{field->offset};
}

std::optional<Field<math::Vec3>> vector_field(const vm::Program& program, std::string_view name) {
  const formats::ProgsDefinition* field = program.find_field(name);
  if (!field || field->type != formats::ProgsType::kVector) return std::nullopt;
  return Field<math::Vec3>{field->offset};
}

LookFields::LookFields(const vm::Program& program)
    : alpha(float_field(program, "alpha")), scale(float_field(program, "scale")) {}

// The comparison is written so that NaN gives 1, too.
float sent_alpha(const Edict& edict, const LookFields& fields) {
  const float alpha = fields.alpha ? edict[*fields.alpha] : 0.0f;
  return alpha == 0 || !(alpha <= 1) ? 1.0f : std::max(alpha, 0.0f);
}

float sent_scale(const Edict& edict, const LookFields& fields) {
  const float scale = fields.scale ? edict[*fields.scale] : 0.0f;
  return scale > 0 && scale < 16 ? scale : 1.0f;
}

std::uint16_t sent_u16(float value) {
  return value >= 0 && value < 65536 ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
}

std::uint8_t sent_u8(float value) {
  // Game code relies on the upper bits of larger numbers getting lost (weapon 4096 is the axe).
  return static_cast<std::uint8_t>(sent_u16(value) & 255);
}

math::Vec3 finite(const math::Vec3& value) {
  math::Vec3 result = value;
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(result[axis])) result[axis] = 0;
  return result;
}

net::Baseline make_baseline(const Edict& edict, const LookFields& fields) {
  return {.model = sent_u16(edict[field::kModelIndex]),
          .frame = sent_u16(edict[field::kFrame]),
          .colormap = sent_u8(edict[field::kColorMap]),
          .skin = sent_u8(edict[field::kSkin]),
          .origin = finite(edict[field::kOrigin]),
          .angles_deg = finite(edict[field::kAngles]),
          .alpha = sent_alpha(edict, fields),
          .scale = sent_scale(edict, fields)};
}

// Entities without a model get no baseline: clients start from zeros. Colormaps are only for players, whose
// number they are.
void take_baselines(GameWorld& io_world, const vm::Program& program, Outbox& io_outbox,
                    base::FunctionRef<void()> after_each) {
  const LookFields fields(program);
  const std::uint16_t player_model = find_model_number(io_world, kPlayerModel);
  for (std::uint32_t number = 0; number < io_world.edicts.count(); ++number) {
    const vm::EntityIndex index{number};
    EdictState& state = io_world.edicts.state(index);
    if (state.is_free) continue;
    const bool is_player = number >= 1 && number <= io_world.edicts.client_count();
    net::Baseline baseline = make_baseline(io_world.edicts[index], fields);
    if (!is_player && baseline.model == 0) continue;
    baseline.colormap = is_player ? static_cast<std::uint8_t>(number) : std::uint8_t{0};
    if (is_player) baseline.model = player_model;
    state.baseline = baseline;
    io_outbox.write(net::SpawnBaseline{static_cast<std::uint16_t>(number), baseline}, io_outbox.signon());
    after_each();
  }
}

}  // namespace temblor::server
