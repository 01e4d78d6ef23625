// Sounds (.wav).
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/inspect/inspection.h"
#include "formats/sounds/wav.h"

namespace temblor::app {
namespace {

// Quake's sounds are mono, because the game places them in space itself.
Inspection find_wav_problems(const formats::Wav& wav) {
  Inspection problems = Inspection::array();
  if (wav.samples.empty()) {
    problems.push_back("no samples");
    return problems;
  }
  const auto loudest = [](std::int16_t a, std::int16_t b) { return std::abs(int{a}) < std::abs(int{b}); };
  if (*std::max_element(wav.samples.begin(), wav.samples.end(), loudest) == 0) problems.push_back("silent");
  if (wav.channels > 1) problems.push_back("several channels: the game mixes them to mono");
  return problems;
}

}  // namespace

base::Result<Inspection> inspect_wav(base::Bytes bytes) {
  TRY(const formats::Wav wav, formats::read_wav(bytes));
  Inspection inspection{{"frames a second", wav.frames_per_second},
                        {"channels", wav.channels},
                        {"bits", wav.bits},
                        {"seconds", static_cast<double>(wav.frame_count()) / wav.frames_per_second}};
  if (wav.loop) inspection["loop"] = Inspection{{"from frame", wav.loop->start}, {"to frame", wav.loop->end}};
  inspection["problems"] = find_wav_problems(wav);
  return inspection;
}

}  // namespace temblor::app
