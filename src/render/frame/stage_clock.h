// Measures how long each stage of a frame takes.
#pragma once

#include <chrono>
#include <cstdint>
#include <numeric>

#include "render/frame_stats.h"

namespace temblor::render {

// Ticks of the time-stamp counter on x86-64; 0 on other processors.
inline std::uint64_t read_cycles() {
#if defined(__x86_64__)
  return __builtin_ia32_rdtsc();
#else
  return 0;
#endif
}

// Attributes the time since the previous call (or the construction) to a stage. One thread per clock.
class StageClock {
 public:
  explicit StageClock(StageTimes& io_times) : times_(io_times) {}

  void end(Stage stage) { book(stage, next_lap(), 1); }

  // Passes the stage's result through: `x = clock.end(Stage::kView, make_view(...))`. Arguments are evaluated
  // before the call, so the stage has run when the time is taken.
  template <typename Result>
  Result end(Stage stage, Result result) {
    end(stage);
    return result;
  }

  // For stages that took turns, perhaps on several threads: divides the elapsed time among the stages in
  // proportion to `parts`.
  void end_in_parts(const StageTimes& parts) {
    const Lap lap = next_lap();
    const double all_ms = std::accumulate(parts.ms.begin(), parts.ms.end(), 0.0);
    if (!(all_ms > 0)) return;
    for (std::size_t i = 0; i < kStages; ++i) book(static_cast<Stage>(i), lap, parts.ms[i] / all_ms);
  }

 private:
  struct Lap {
    double ms, cycles;
  };
  Lap next_lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::uint64_t cycles = read_cycles();
    const Lap lap{std::chrono::duration<double, std::milli>(now - last_).count(),
                  static_cast<double>(cycles - last_cycles_)};
    last_ = now;
    last_cycles_ = cycles;
    return lap;
  }
  void book(Stage stage, const Lap& lap, double share) {
    times_.ms[static_cast<std::size_t>(stage)] += share * lap.ms;
    times_.cycles[static_cast<std::size_t>(stage)] += share * lap.cycles;
  }

  StageTimes& times_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::uint64_t last_cycles_ = read_cycles();
};

}  // namespace temblor::render
