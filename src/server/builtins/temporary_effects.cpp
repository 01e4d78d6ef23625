// DP_TE_STANDARDEFFECTBUILTINS: the short effects of the original, each as one call instead of a few writes.
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// Shown to everyone who can see the place.
base::Status show(Call& io_call, const net::TempEntity& effect) {
  io_call.game.outbox.write_at_place(effect, effect.origin);
  return base::Ok{};
}

// te_gunshot(place) and similar functions.
template <net::TempEntityKind kKind>
base::Status at_place(Call& io_call) {
  return show(io_call, {.kind = kKind, .origin = io_call.vector(0)});
}

// te_explosion2(place, first_color, colors)
base::Status te_explosion2(Call& io_call) {
  return show(io_call, {.kind = net::TempEntityKind::kExplosion2,
                        .origin = io_call.vector(0),
                        .color_start = static_cast<std::uint8_t>(io_call.whole(1)),
                        .color_count = static_cast<std::uint8_t>(io_call.whole(2))});
}

// te_lightning1(owner, start, end) and similar functions. A beam may be seen far from its start, so everyone
// gets it.
template <net::TempEntityKind kKind>
base::Status beam(Call& io_call) {
  TRY(const vm::EntityIndex owner, io_call.entity(0));
  io_call.game.outbox.write_at_place(net::TempEntity{.kind = kKind,
                                                     .origin = io_call.vector(1),
                                                     .end = io_call.vector(2),
                                                     .entity = static_cast<std::uint16_t>(owner)},
                                     std::nullopt);
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> temporary_effect_builtins() {
  using Kind = net::TempEntityKind;
  static constexpr BuiltinEntry kEntries[] = {
      {418, "te_gunshot", at_place<Kind::kGunshot>},
      {419, "te_spike", at_place<Kind::kSpike>},
      {420, "te_superspike", at_place<Kind::kSuperSpike>},
      {421, "te_explosion", at_place<Kind::kExplosion>},
      {422, "te_tarexplosion", at_place<Kind::kTarExplosion>},
      {423, "te_wizspike", at_place<Kind::kWizSpike>},
      {424, "te_knightspike", at_place<Kind::kKnightSpike>},
      {425, "te_lavasplash", at_place<Kind::kLavaSplash>},
      {426, "te_teleport", at_place<Kind::kTeleport>},
      {427, "te_explosion2", te_explosion2},
      {428, "te_lightning1", beam<Kind::kLightning1>},
      {429, "te_lightning2", beam<Kind::kLightning2>},
      {430, "te_lightning3", beam<Kind::kLightning3>},
      {431, "te_beam", beam<Kind::kBeam>},
  };
  return kEntries;
}

}  // namespace temblor::server
