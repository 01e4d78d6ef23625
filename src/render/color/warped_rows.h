// The rows of a liquid's texture, warped as stock Quake does: s is displaced by a sine of t, and t by a sine
// of s. Lit liquids are built into surface blocks from these; other liquids are warped while they are drawn
// (spans/repeat_spans.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include "base/arena.h"
#include "world/level.h"

namespace temblor::render {

// Stock Quake's liquids: an amplitude of 8 texels and a period of 128 texels, moving by 20 texels per second.
constexpr float kTurbulence_texels = 8;
constexpr double kTurn_texels = 128;
inline double compute_turbulence_phase(double time_s) {
  constexpr double kTexelsPerSecond = 20;
  return std::fmod(time_s * kTexelsPerSecond, kTurn_texels);
}

class WarpedRows {
 public:
  // Rows start at texel (s, t) of the mip level, which may be a fine one, and are `width` texels long.
  WarpedRows(const world::Texture& texture, int mip, std::int64_t s, std::int64_t t, std::size_t width,
             float phase_texels, base::Arena& arena)
      : scale_(std::exp2(mip)),
        width_(std::max<std::int64_t>(1, static_cast<std::int64_t>(texture.width / scale_))),
        height_(std::max<std::int64_t>(1, static_cast<std::int64_t>(texture.height / scale_))),
        s_(s),
        t_(t),
        phase_(double{phase_texels}),
        row_(arena.allocate<std::int32_t>(width)),
        down_(arena.allocate<std::int32_t>(width)) {
    for (std::size_t x = 0; x < width; ++x)
      down_[x] = static_cast<std::int32_t>(find_shift(s_ + static_cast<std::int64_t>(x)) % height_ * width_);
  }

  // The numbers of the texels of row y in the mip level; valid until the next call.
  std::span<const std::int32_t> row(std::int32_t y) {
    const auto width = static_cast<std::size_t>(width_);
    const auto first_line = static_cast<std::int32_t>(wrap(t_ + y, height_) * width_);
    const auto texture_texels = static_cast<std::int32_t>(width_ * height_);
    auto column = static_cast<std::size_t>(wrap(s_ + find_shift(t_ + y), width_));
    // Runs that do not cross the edge of the texture: the compiler makes vectors of them.
    for (std::size_t done = 0, run = 0; done < row_.size(); done += run, column = 0) {
      run = std::min(row_.size() - done, width - column);
      const std::int32_t* const down = &down_[done];
      std::int32_t* const out = &row_[done];
      for (std::size_t i = 0; i < run; ++i) {
        const std::int32_t line = first_line + down[i];
        const std::int32_t wrapped_line = line < texture_texels ? line : line - texture_texels;
        out[i] = wrapped_line + static_cast<std::int32_t>(column + i);
      }
    }
    return row_;
  }

 private:
  // The displacement of one coordinate at the middle of a texel of the other one, in whole texels: the middle
  // of texel n is moved into texel n + shift.
  std::int64_t find_shift(std::int64_t texel) const {
    const double at = (static_cast<double>(texel) + 0.5) * scale_ + phase_;
    const double shift =
        double{kTurbulence_texels} * (1 + std::sin(at * (2 * std::numbers::pi / kTurn_texels))) / scale_;
    return static_cast<std::int64_t>(std::floor(0.5 + shift));
  }
  static std::int64_t wrap(std::int64_t texel, std::int64_t size) {
    texel %= size;
    return texel < 0 ? texel + size : texel;
  }

  double scale_;  // texels of mip 0 in one
  std::int64_t width_, height_, s_, t_;
  double phase_;
  std::span<std::int32_t> row_;
  std::span<std::int32_t> down_;  // by column: the displacement of t, as texels of whole rows of the texture
};

}  // namespace temblor::render
