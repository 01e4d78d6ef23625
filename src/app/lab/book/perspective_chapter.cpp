#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/lab/book/chapters.h"

namespace temblor::app {
namespace {

std::string describe_texels(const Evidence& evidence) {
  const Range off = evidence.over_levels([](const TechniqueFigures& f) { return f.views.pixels_off; });
  const Range error = evidence.over_levels([](const TechniqueFigures& f) { return f.views.max_texel_error; });
  const auto find_shift = [](const TechniqueFigures& f) {
    return std::max(f.views.texels.turn.mean(), f.views.texels.roll.mean());
  };
  return fmt::format(
      "{} % of pixels show another texel than the exact one; the largest error is {} texels. While the "
      "camera "
      "turns or rolls by 3 degrees, textures shift by {} texels on average (the engine's by {}: rounding).",
      Range{100 * off.low, 100 * off.high}.text(2), error.text(1), evidence.over_levels(find_shift).text(2),
      Evidence(evidence.figures(), 0).over_levels(find_shift).text(2));
}

Verdict judge_affine(const Evidence& evidence) {
  const Range error = evidence.over_levels([](const TechniqueFigures& f) { return f.views.max_texel_error; });
  return {error.high > 1 ? Holds::kYes : Holds::kNo,
          describe_texels(evidence) + " " + describe_time(evidence)};
}

Verdict judge_sixteen_pixels(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  const Range off = evidence.over_levels([](const TechniqueFigures& f) { return f.views.pixels_off; });
  constexpr double kFewPixels = 0.2;
  const bool looks_right = off.high < kFewPixels, is_faster = times.high < 1;
  return {looks_right && is_faster   ? Holds::kYes
          : looks_right || is_faster ? Holds::kPartly
                                     : Holds::kNo,
          describe_texels(evidence) + " " + describe_time(evidence)};
}

// Nearly exact texels, in less time than with a division every 8 pixels.
Verdict judge_equal_z(const Evidence& evidence) {
  constexpr double kLargeError = 0.5;
  const auto error_of = [](const TechniqueFigures& f) { return f.views.max_texel_error; };
  const bool is_right = evidence.over_levels(error_of).high < kLargeError;
  const Range times = evidence.time_ratios(evidence.of("affine-spans:pixels=8").number());
  const bool is_faster = times.high < 1;
  return {is_right && is_faster   ? Holds::kYes
          : is_right || is_faster ? Holds::kPartly
                                  : Holds::kNo,
          fmt::format("{} A frame takes {} times that with a division every 8 pixels. {}",
                      describe_texels(evidence), times.text(2), describe_time(evidence))};
}

constexpr std::array kPerspectiveEntries{
    BookEntry{"affine-spans",
              "Texture coordinates are exact at both ends of a span, and change evenly in between. In "
              "perspective they do not: textures on walls that are seen at an angle bend, and swim as the "
              "viewer moves.",
              "Without division, textures are visibly wrong.",
              "The engine's SIMD code, with fewer divisions.", judge_affine},
    BookEntry{"affine-spans:pixels=16", "Texture coordinates are exact at every 16th pixel.",
              "A division for every 16 pixels looks right, and its time disappears behind the pixels in "
              "between.",
              "The engine's SIMD code, with fewer divisions.", judge_sixteen_pixels},
    BookEntry{"affine-spans:pixels=8", "Texture coordinates are exact at every 8th pixel.",
              "Fewer pixels between divisions make the error smaller.",
              "The engine's SIMD code, with fewer divisions.",
              [](const Evidence& evidence) {
                const auto off = [](const TechniqueFigures& f) { return f.views.pixels_off; };
                const bool is_better = evidence.over_levels(off).high <
                                       evidence.of("affine-spans:pixels=16").over_levels(off).high;
                return Verdict{is_better ? Holds::kYes : Holds::kNo,
                               describe_texels(evidence) + " " + describe_time(evidence)};
              }},
    BookEntry{
        "equal-z-spans",
        "On a flat surface, the pixels of equal distance form parallel lines: the rows of a floor, the "
        "columns of a wall. Along a line, texture coordinates change evenly. One division for each line "
        "fills a table, and pixels between two lines interpolate.",
        "None: the articles only say that a division every 16 pixels was fast enough.",
        "Vectorized as the engine's loop: neighbors in the table are loaded together. Spans of fewer than "
        "16 pixels, and those that would be an eighth of a texel off, are the engine's.",
        judge_equal_z},
};

}  // namespace

BookChapter make_perspective_chapter() {
  return {"perspective", "Textures in perspective",
          "The texel at a pixel follows from a division by depth. Divisions are slow, so few engines of "
          "the time made one for each pixel.",
          kPerspectiveEntries, BookColumns::kTexels};
}

}  // namespace temblor::app
