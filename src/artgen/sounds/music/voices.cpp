#include "artgen/sounds/music/voices.h"

#include <array>

namespace temblor::artgen {

std::span<const VoiceKeyword> voice_keywords() {
  static constexpr std::array<VoiceKeyword, 7> kKeywords = {{
      {"tone", make_tone},
      {"fm", make_fm},
      {"noise", make_noise},
      {"grains", make_grains},
      {"strike", make_strike},
      {"pluck", make_pluck},
      {"throat", make_throat},
  }};
  return kKeywords;
}

}  // namespace temblor::artgen
