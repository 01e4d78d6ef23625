#include "client/effects/light_colors.h"

#include "client/session/interpolated_entity.h"

namespace temblor::client {

math::Vec3 choose_glow_color(std::uint8_t effects, std::optional<TrailKind> trail) {
  constexpr math::Vec3 kBlue{0.45f, 0.6f, 1.0f}, kRed{1.0f, 0.35f, 0.3f}, kPurple{0.8f, 0.4f, 1.0f},
      kGreen{0.5f, 1.0f, 0.4f};
  const bool blue = effects & kEffectBlue, red = effects & kEffectRed;
  if (blue && red) return kPurple;
  if (blue) return kBlue;
  if (red) return kRed;
  if (!trail) return kWhiteLight;
  switch (*trail) {
    case TrailKind::kRocket:
    case TrailKind::kGrenade:
    case TrailKind::kTracer2:
      return kBlastLight;
    case TrailKind::kTracer:
      return kGreen;
    case TrailKind::kVoor:
      return kPurple;
    case TrailKind::kBlood:
    case TrailKind::kThinBlood:
      break;
  }
  return kWhiteLight;
}

}  // namespace temblor::client
