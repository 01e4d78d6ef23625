#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/lab/book/book_content.h"

namespace temblor::app {
namespace {

constexpr std::string_view kAlternatives = "Consider the Alternatives",
                           kSortedSpans = "Sorted Spans in Action", kSurfaces = "Surface Caching",
                           kModels = "Triangle Models", kBigPicture = "The Big Picture";

std::string show_kilobytes(double bytes) {
  return fmt::format("{:.0f} KB", bytes / 1024);
}

// The painter's own background is one of the pixels it writes.
std::string show_overdraw(const BookFigures& figures) {
  const Range written = Evidence(figures, 0).of("painter").over_levels([](const TechniqueFigures& f) {
    return f.views.pixels_written;
  });
  return Range{100 * (written.low - 2), 100 * (written.high - 2)}.text(0) + " %";
}

std::string show_freeze(const BookFigures& figures, lab::wire::Method method) {
  if (figures.wire.freezes.empty()) return "not measured";
  const double ping_ms = choose_plotted_ping(figures.wire);
  return fmt::format("{:.0f} ms", figures.wire.freeze(method, ping_ms).frozen_ms());
}

std::string show_slower_servers(const BookFigures& figures) {
  std::string text;
  for (const WireFreeze& freeze : figures.wire.slower)
    text += fmt::format(", {:.0f} ms at {:.0f} ticks per second", freeze.frozen_ms(), 1000 / freeze.tick_ms);
  return text;
}

// A player is 56 units tall, so a foot is about 12 to 16 units.
std::string show_visible_distance(const BookFigures& figures) {
  const double units = figures.visible_distance_units;
  return units == 0 ? "not measured"
                    : fmt::format("{:.0f} units, or {:.0f} to {:.0f} feet", units, units / 16, units / 12);
}

constexpr std::array kNumbers{
    ArticleNumber{kAlternatives, "Faces in the potentially visible set for each face that is seen",
                  "5 in places",
                  [](const BookFigures& f) {
                    const Distribution& ratio = f.engine.faces_in_pvs_per_seen;
                    return fmt::format("{:.1f} (median), {:.1f} (worst)", ratio.p50, ratio.max);
                  }},
    ArticleNumber{kAlternatives, "Overdraw of the painter's algorithm with that set", "50 %", show_overdraw},
    ArticleNumber{kAlternatives, "Average frame rate, divided by that of the slowest tenth, without leveling",
                  "6",
                  [](const BookFigures& f) {
                    return Evidence(f, 0).of("painter").levelness().text(1) + " (slowest hundredth)";
                  }},
    ArticleNumber{kSortedSpans, "Times that sorted edges draw a pixel", "1",
                  [](const BookFigures& f) {
                    return Evidence(f, 0)
                        .over_levels([](const TechniqueFigures& t) { return t.views.pixels_written; })
                        .text(2);
                  }},
    ArticleNumber{kAlternatives, "Depth buffer at 320x200", "128 KB",
                  [](const BookFigures&) { return show_kilobytes(320 * 200 * sizeof(float)); }},
    ArticleNumber{
        kSurfaces, "Cycles to build a texel of a surface", "2.25",
        [](const BookFigures& f) { return fmt::format("{:.2f}", f.engine.cycles_per_texel_built); }},
    ArticleNumber{
        kSurfaces, "Cycles to draw a pixel from a surface", "7.5",
        [](const BookFigures& f) { return fmt::format("{:.2f}", f.engine.cycles_per_pixel_drawn); }},
    ArticleNumber{kSurfaces, "Frames per second at 640x400", "40",
                  [](const BookFigures& f) { return fmt::format("{:.0f}", f.engine.fps_640x400); }},
    ArticleNumber{kSurfaces, "Texels that a frame of 320x200 reads", "64,000",
                  [](const BookFigures& f) { return fmt::format("{:.0f}", f.engine.texels_read_320x200); }},
    ArticleNumber{kSurfaces, "Surface cache that is enough at 320x200", "600 KB",
                  [](const BookFigures& f) { return show_kilobytes(f.engine.cache_bytes_320x200); }},
    ArticleNumber{kSurfaces, "Surface cache that is enough at 640x480", "a little more than 1 MB",
                  [](const BookFigures& f) { return show_kilobytes(f.engine.cache_bytes_640x480); }},
    ArticleNumber{kSortedSpans, "Cycles to find 1/z at a pixel", "6",
                  [](const BookFigures& f) {
                    return f.engine.cycles_per_depth > 0 ? fmt::format("{:.1f}", f.engine.cycles_per_depth)
                                                         : "no counter of cycles";
                  }},
    ArticleNumber{kAlternatives, "Time that filling the depth buffer adds to a frame, at 640x400", "10 %",
                  [](const BookFigures& f) {
                    return fmt::format("{:.0f} %", std::round(100 * f.engine.time_to_fill_depth) + 0.0);
                  }},
    ArticleNumber{kModels, "Time of scan lines, divided by that of subdivision", "1.2",
                  [](const BookFigures& f) {
                    const Evidence affine = Evidence(f, 0).of("affine-models");
                    return affine.time_ratios(affine.of("subdivided-models").number()).text(2);
                  },
                  true},
    ArticleNumber{kModels, "Distance at which it becomes visible, at 320x200", "12 to 40 feet",
                  show_visible_distance, true},
    ArticleNumber{kBigPicture, "Freeze after a lost packet, with everything reliable, at a ping of 200 ms",
                  "several hundred milliseconds",
                  [](const BookFigures& f) { return show_freeze(f, lab::wire::Method::kReliable); }},
    ArticleNumber{kBigPicture, "Freeze after a lost packet, with whole states", "100 ms or less",
                  [](const BookFigures& f) {
                    return show_freeze(f, lab::wire::Method::kWholeState) + show_slower_servers(f);
                  }},
};

}  // namespace

std::span<const ArticleNumber> list_article_numbers() {
  return kNumbers;
}

}  // namespace temblor::app
