// Finds the palette entry that looks most like a color, for indexed pixels.
//
// The result is a full-bright entry only if a full-bright entry is part of the color: otherwise light would
// appear between two dark colors. It is never entry 255, which stands for "clear" in pictures.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"

namespace temblor::render {

// Copies share what they have prepared. Thread-safe.
class PaletteMatch {
 public:
  PaletteMatch(const formats::Palette& palette, int first_fullbright);

  // `fullbright`: whether a full-bright entry is part of the color. The first call for each prepares the
  // search, which allocates, and takes half a millisecond; frames in true color never do.
  std::uint8_t operator()(formats::Rgb color, bool fullbright) const {
    return (fullbright ? searches_->any : searches_->lit).get().find(color);
  }
  // The same result without preparation, for one or two colors.
  std::uint8_t find_by_trying(formats::Rgb color, bool fullbright) const;

  bool is_fullbright(std::size_t index) const { return static_cast<int>(index) >= first_fullbright_; }

 private:
  // A search among the first `count` entries, made when it is needed for the first time.
  class Search {
   public:
    Search(const formats::Palette& palette, std::size_t count) : palette_(palette), count_(count) {}
    const formats::NearestColor& get() const {
      const formats::NearestColor* const made = made_.load(std::memory_order_acquire);
      return made != nullptr ? *made : make();
    }
    std::uint8_t find_by_trying(formats::Rgb color) const;

   private:
    const formats::NearestColor& make() const;

    formats::Palette palette_;
    std::size_t count_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<const formats::NearestColor> owner_;
    mutable std::atomic<const formats::NearestColor*> made_ = nullptr;
  };
  struct Searches {
    Searches(const formats::Palette& palette, std::size_t lit_count, std::size_t any_count)
        : lit(palette, lit_count), any(palette, any_count) {}
    Search lit, any;
  };

  int first_fullbright_;
  std::shared_ptr<const Searches> searches_;
};

}  // namespace temblor::render
