#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/lab/book/chapters.h"

namespace temblor::app {
namespace {

constexpr auto mean_error = [](const TechniqueFigures& figures) { return figures.views.light.error.mean(); };

// The largest change of light at a point of the world while the camera turns or rolls.
constexpr auto largest_shift = [](const TechniqueFigures& figures) {
  return std::max(figures.views.light.turn.largest, figures.views.light.roll.largest);
};

std::string describe_light(const Evidence& evidence) {
  return fmt::format(
      "Light is {} of 64 steps wrong on average, and shifts by up to {} steps while the view turns.",
      evidence.over_levels(mean_error).text(2), evidence.over_levels(largest_shift).text(1));
}

// A change of light of less than a step is rounding.
constexpr double kSteadyStep = 1.5;

Verdict judge_one_pass(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  return {times.low > kSameTime    ? Holds::kYes
          : times.high > kSameTime ? Holds::kPartly
                                   : Holds::kNo,
          describe_time(evidence) + " " + describe_light(evidence)};
}

Verdict judge_gouraud(const Evidence& evidence) {
  const bool is_wrong = evidence.over_levels(mean_error).low > 1;
  const bool shifts = evidence.over_levels(largest_shift).low > kSteadyStep;
  return {is_wrong && shifts   ? Holds::kYes
          : is_wrong || shifts ? Holds::kPartly
                               : Holds::kNo,
          describe_light(evidence) + " " + describe_time(evidence)};
}

// For a variant of Gouraud shading that should shift less, but still shift.
Verdict judge_steadier(const Evidence& evidence) {
  const double shift = evidence.over_levels(largest_shift).high;
  const double plain = evidence.of("gouraud").over_levels(largest_shift).high;
  return {shift >= plain        ? Holds::kNo
          : shift > kSteadyStep ? Holds::kYes
                                : Holds::kPartly,
          fmt::format("{} Without it, by up to {:.1f}.", describe_light(evidence), plain)};
}

// For a variant that should be closer to the light map, in more time.
Verdict judge_finer(const Evidence& evidence) {
  const Evidence plain = evidence.of("gouraud");
  const bool is_better = evidence.over_levels(mean_error).high < plain.over_levels(mean_error).high;
  const bool is_slower = evidence.time_ratios(plain.number()).high > kSameTime;
  return {is_better && is_slower   ? Holds::kYes
          : is_better || is_slower ? Holds::kPartly
                                   : Holds::kNo,
          fmt::format("{} {} Plain Gouraud shading is {} steps wrong.", describe_light(evidence),
                      describe_time(evidence), plain.over_levels(mean_error).text(2))};
}

Verdict judge_phong(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("gouraud").number());
  return {times.low > kSameTime    ? Holds::kYes
          : times.high > kSameTime ? Holds::kPartly
                                   : Holds::kNo,
          fmt::format("It takes {} times as long as Gouraud shading. {}", times.text(2),
                      describe_light(evidence))};
}

Verdict judge_ray_light(const Evidence& evidence) {
  const auto rays = [](const TechniqueFigures& figures) { return figures.views.rays; };
  return {evidence.time_ratios().low > 5 ? Holds::kYes : Holds::kNo,
          fmt::format("{} rays for each pixel. {} {}", evidence.over_levels(rays).text(1),
                      describe_time(evidence), describe_light(evidence))};
}

// The article's limit of what is tolerable is not a number; a frame that takes twice the time is ours.
Verdict judge_rebuilt(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  return {times.low > kSameTime && times.high < 2 ? Holds::kYes
          : times.high > kSameTime                ? Holds::kPartly
                                                  : Holds::kNo,
          describe_time(evidence)};
}

// Turns should take less of the extra time than building all surfaces does.
Verdict judge_turns(const Evidence& evidence) {
  const Range times = evidence.time_ratios(), all = evidence.of("rebuilt-surfaces").time_ratios();
  return {times.high < all.high && times.low < all.low ? Holds::kYes : Holds::kNo,
          fmt::format("{} With all surfaces, it is {}.", describe_time(evidence), all.text(2))};
}

// Content of surfaces that is built once should cost nothing in later frames.
Verdict judge_kept(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  return {times.high <= kSameTime  ? Holds::kYes
          : times.low <= kSameTime ? Holds::kPartly
                                   : Holds::kNo,
          describe_time(evidence) + " Surfaces are built before the measurement."};
}

// Moving patterns build each surface again, like surfaces whose light always changes.
Verdict judge_moving(const Evidence& evidence) {
  const Range times = evidence.time_ratios(), rebuilt = evidence.of("rebuilt-surfaces").time_ratios();
  return {times.high < 2  ? Holds::kYes
          : times.low < 2 ? Holds::kPartly
                          : Holds::kNo,
          fmt::format("{} To build the surfaces without a pattern, it takes {} times.",
                      describe_time(evidence), rebuilt.text(2))};
}

constexpr std::string_view kEngineBuilds = "The engine's loops build and draw.";
constexpr std::string_view kPatternLoop = "Vectorized; noise is looked up in registers, its color in memory.";
constexpr std::string_view kVectorized = "Vectorized; texels come from registers where they fit.";

constexpr std::array kLightEntries{
    BookEntry{
        "gouraud",
        "Light is computed at the vertices of each face and interpolated over the screen: down its edges, "
        "then across each row.",
        "Large faces look bland, shadows have no edges, and light shifts while the view turns, is clipped, "
        "or rolls.",
        kVectorized, judge_gouraud, true},
    BookEntry{
        "gouraud:perspective=1", "Light is interpolated on the face instead of the screen.",
        "That ends the shift with the view and with clipping, and faces with more than three vertices still "
        "change as they rotate.",
        kVectorized, judge_steadier, true},
    BookEntry{
        "gouraud:triangles=1", "Faces are cut into triangles, over which light is even.",
        "Triangles do not change as they rotate, but the shift with the view and with clipping remains.",
        kVectorized, judge_steadier, true},
    BookEntry{"gouraud:spot=1", "Each face gets one more vertex, where it is brightest.",
              "Highlights look much better, for more polygons.", kVectorized, judge_finer, true},
    BookEntry{"gouraud:perspective=1,cut=64", "Faces are cut into squares of 64 texels.",
              "Small polygons make light right, and drawing slow.",
              "Vectorized; each row tests every square.", judge_finer, true},
    BookEntry{"gouraud:perspective=1,cut=16",
              "Faces are cut into squares of 16 texels, the distance of the light map's samples.",
              "Small polygons make light right, and drawing slow.",
              "Vectorized; each row tests every square.", judge_finer, true},
    BookEntry{"phong",
              "The level's own lights shine on each pixel, by distance and angle. Nothing casts shadows.",
              "Better than Gouraud shading, and too slow.", "Vectorized over pixels.", judge_phong},
    BookEntry{
        "one-pass", "The texture and the light map are both read for each pixel, and no surface is built.",
        "Such a loop is complicated, and cannot be as fast as one that builds surfaces and one that draws "
        "them.",
        "Vectorized; the light map's cells come from registers.", judge_one_pass},
    BookEntry{
        "ray-light",
        "A ray goes from each pixel to each lamp, sun, part of the sky, and glowing surface that may reach "
        "it: a light map without samples between which light is interpolated. Light from other walls "
        "is missing.",
        "Rays for each pixel give the best light of all techniques, and are too slow.",
        "Embree follows packets of 16 rays; lights that are too weak or behind a face get none.",
        judge_ray_light},
    BookEntry{
        "rebuilt-surfaces", "All surfaces in view are built in each frame, as if their light always changed.",
        "The cache is of no use, and a frame takes the time of building and drawing: noticeably longer, and "
        "tolerable.",
        kEngineBuilds, judge_rebuilt},
    BookEntry{"rebuilt-surfaces:every=2", "Half of the surfaces are built in each frame.",
              "Relighting takes half the time if surfaces take turns.", kEngineBuilds, judge_turns},
    BookEntry{"rebuilt-surfaces:every=3", "A third of the surfaces is built in each frame.",
              "Relighting takes less time if surfaces take turns.", kEngineBuilds, judge_turns},
    BookEntry{"procedural-texels",
              "Each surface gets grain from three layers of smooth noise when it is built.",
              "Computed textures can be part of surfaces. They are cached with them, so they cost much "
              "less than effects that are drawn over each frame.",
              kPatternLoop, judge_kept},
    BookEntry{"procedural-texels:pattern=1",
              "Water runs down the walls: streaks of noise that move darken them and shine.",
              "Surfaces whose content moves are built again in each frame, which is tolerable.", kPatternLoop,
              judge_moving},
    BookEntry{"procedural-texels:pattern=2",
              "Fire rises on the walls. It is added after the light, so it glows in the dark.",
              "Surfaces whose content moves are built again in each frame, which is tolerable.", kPatternLoop,
              judge_moving},
    BookEntry{"marked-surfaces",
              "Each face gets four translucent marks: holes, soot, and stains, as shots leave them.",
              "Splatters with any translucency are drawn into the surface when it is built, and cost nothing "
              "afterwards.",
              kEngineBuilds, judge_kept},
};

}  // namespace

BookChapter make_world_light_chapter() {
  return {
      "world-light", "Light on the world",
      "The engine multiplies texture and light once, when a face is first seen, and keeps the result as a "
      "surface. The techniques of this chapter light each pixel of each frame instead. Light is in steps, "
      "the 64 rows of the colormap.",
      kLightEntries, BookColumns::kLight};
}

}  // namespace temblor::app
