#include "artgen/sounds/music/voices.h"

#include <array>

namespace temblor::artgen {

std::span<const VoiceWord> voice_words() {
  static constexpr std::array<VoiceWord, 7> kWords = {{
      {"tone", make_tone},
      {"fm", make_fm},
      {"noise", make_noise},
      {"grains", make_grains},
      {"strike", make_strike},
      {"pluck", make_pluck},
      {"throat", make_throat},
  }};
  return kWords;
}

}  // namespace temblor::artgen
