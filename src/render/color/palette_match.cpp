#include "render/color/palette_match.h"

#include <algorithm>
#include <limits>

namespace temblor::render {
namespace {

// If the whole palette is full-bright, every entry except 255 may be a result.
std::size_t count_lit(int first_fullbright) {
  constexpr std::size_t kNoColor = formats::kTransparentIndex;
  return first_fullbright > 0 ? std::min(static_cast<std::size_t>(first_fullbright), kNoColor) : kNoColor;
}

int squared(int x) {
  return x * x;
}

}  // namespace

PaletteMatch::PaletteMatch(const formats::Palette& palette, int first_fullbright)
    : first_fullbright_(first_fullbright),
      searches_(std::make_shared<const Searches>(palette, count_lit(first_fullbright),
                                                 formats::kTransparentIndex)) {}

std::uint8_t PaletteMatch::find_by_trying(formats::Rgb color, bool fullbright) const {
  return (fullbright ? searches_->any : searches_->lit).find_by_trying(color);
}

const formats::NearestColor& PaletteMatch::Search::make() const {
  std::call_once(once_, [&] {
    owner_ = std::make_unique<const formats::NearestColor>(palette_, 0, count_);
    made_.store(owner_.get(), std::memory_order_release);
  });
  return *owner_;
}

std::uint8_t PaletteMatch::Search::find_by_trying(formats::Rgb color) const {
  std::size_t found = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < count_; ++i) {
    const formats::Rgb& entry = palette_[i];
    const int distance = squared(entry.r - color.r) + squared(entry.g - color.g) + squared(entry.b - color.b);
    if (distance >= least) continue;
    least = distance;
    found = i;
  }
  return static_cast<std::uint8_t>(found);
}

}  // namespace temblor::render
