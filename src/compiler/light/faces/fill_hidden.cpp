#include "compiler/light/faces/fill_hidden.h"

#include <algorithm>
#include <vector>

namespace temblor::compiler {

void fill_hidden(int width, int height, std::span<const std::uint8_t> is_hidden,
                 std::span<math::Vec3> io_samples) {
  std::vector<std::uint8_t> unknown(is_hidden.begin(), is_hidden.end());
  const auto left = [&] { return std::count(unknown.begin(), unknown.end(), std::uint8_t{1}); };
  for (auto before = left(); before > 0 && before < static_cast<std::ptrdiff_t>(unknown.size());) {
    const std::vector<std::uint8_t> was_unknown = unknown;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const auto sample = static_cast<std::size_t>(row * width + column);
        if (was_unknown[sample] == 0) continue;
        math::Vec3 sum(0.0f);
        float count = 0;
        for (int y = std::max(0, row - 1); y <= std::min(height - 1, row + 1); ++y)
          for (int x = std::max(0, column - 1); x <= std::min(width - 1, column + 1); ++x) {
            const auto other = static_cast<std::size_t>(y * width + x);
            if (was_unknown[other] != 0) continue;
            sum += io_samples[other];
            ++count;
          }
        if (count == 0) continue;
        io_samples[sample] = sum / count;
        unknown[sample] = 0;
      }
    const auto now = left();
    if (now == before) return;
    before = now;
  }
}

}  // namespace temblor::compiler
