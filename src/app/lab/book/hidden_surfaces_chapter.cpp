#include <fmt/format.h>

#include <array>

#include "app/lab/book/chapters.h"

namespace temblor::app {
namespace {

constexpr auto pixels_written = [](const TechniqueFigures& figures) { return figures.views.pixels_written; };

Verdict judge_engine(const Evidence& evidence) {
  constexpr double kUnlevel = 6;  // the article's bad example: 5 frames per second after an average of 30
  const Range level = evidence.levelness();
  const bool is_once = evidence.over_levels(pixels_written).high < 1.0001;
  return {is_once && level.high < kUnlevel ? Holds::kYes : Holds::kNo,
          fmt::format("Each pixel is drawn {}. The slowest hundredth of frames takes {} times the median. {}",
                      is_once ? "once" : "more than once", level.text(1), describe_wrong(evidence))};
}

// The painter writes the whole background first, and each pixel at least once more.
Verdict judge_painter(const Evidence& evidence) {
  const Range written = evidence.over_levels(pixels_written);
  const Range overdraw{100 * (written.low - 2), 100 * (written.high - 2)};
  const Holds holds = overdraw.low > 25 && overdraw.high < 100   ? Holds::kYes
                      : overdraw.high < 25 || overdraw.low > 100 ? Holds::kNo
                                                                 : Holds::kPartly;
  return {holds, fmt::format("Overdraw is {} %. {} {}", overdraw.text(0), describe_time(evidence),
                             describe_wrong(evidence))};
}

Verdict judge_painter_without_pvs(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("painter").number());
  return {times.high > kSameTime ? Holds::kYes : Holds::kNo,
          fmt::format("Without the set, a frame takes {} times as long as with it.", times.text(2))};
}

Verdict judge_z_buffer(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  constexpr double kMuch = 3;
  return {times.low > kMuch        ? Holds::kYes
          : times.high > kSameTime ? Holds::kPartly
                                   : Holds::kNo,
          describe_time(evidence) + " " + describe_wrong(evidence)};
}

Verdict judge_z_buffer_order(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("z-buffer").number());
  return {
      times.high > kSameTime ? Holds::kYes : Holds::kNo,
      fmt::format("Drawing from back to front takes {} times as long as from front to back.", times.text(2))};
}

Verdict judge_beam_tree(const Evidence& evidence) {
  const Range times = evidence.time_ratios(), level = evidence.levelness();
  const double engine_level = Evidence(evidence.figures(), 0).levelness().high;
  const bool is_slow = times.high > kSameTime, is_unlevel = level.high > kSameTime * engine_level;
  return {
      is_slow && is_unlevel   ? Holds::kYes
      : is_slow || is_unlevel ? Holds::kPartly
                              : Holds::kNo,
      fmt::format("{} The slowest hundredth of frames takes {} times the median (engine: at most {:.1f}).",
                  describe_time(evidence), level.text(1), engine_level)};
}

Verdict judge_independent(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("intersecting-edges").number());
  const bool is_wrong = evidence.wrong_shares().high > 0, is_fast = times.low < 1;
  return {is_wrong && is_fast   ? Holds::kYes
          : is_wrong || is_fast ? Holds::kPartly
                                : Holds::kNo,
          fmt::format("A frame takes {} times as long as with intersecting edges. {}", times.text(2),
                      describe_wrong(evidence))};
}

Verdict judge_abutting(const Evidence& evidence) {
  constexpr double kReliable = 0.001;
  const double wrong = evidence.wrong_shares().high;
  return {wrong > kReliable ? Holds::kYes
          : wrong > 0       ? Holds::kPartly
                            : Holds::kNo,
          describe_wrong(evidence) + " " + describe_time(evidence)};
}

// For a rule of abutting edges that is left out.
Verdict judge_rule(const Evidence& evidence) {
  const double wrong = evidence.wrong_shares().high;
  const double with_rule = evidence.of("abutting-edges").wrong_shares().high;
  return {wrong > with_rule ? Holds::kYes : Holds::kNo,
          fmt::format("{} With the rule, at most {:.3f} % are wrong.", describe_wrong(evidence),
                      100 * with_rule)};
}

Verdict judge_intersecting(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  const bool is_right = evidence.wrong_shares().high == 0;
  return {is_right && times.low > kSameTime ? Holds::kYes : Holds::kPartly,
          describe_time(evidence) + " " + describe_wrong(evidence)};
}

Verdict judge_unsplit(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("abutting-edges").number());
  const Range saved = evidence.over_levels([](const TechniqueFigures& f) {
    return f.views.edges_saved / (f.views.edges_saved + f.measurement.edges.p50);
  });
  return {
      times.high < 1  ? Holds::kYes
      : times.low < 1 ? Holds::kPartly
                      : Holds::kNo,
      fmt::format("{} % of edges need no sorting. A frame takes {} times as long as with split faces. {}",
                  Range{100 * saved.low, 100 * saved.high}.text(0), times.text(2), describe_wrong(evidence))};
}

Verdict judge_cached(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("abutting-edges").number());
  const Range hits = evidence.over_levels([](const TechniqueFigures& f) {
    const double all = f.views.cache_hits + f.views.comparisons;
    return all == 0 ? 0 : f.views.cache_hits / all;
  });
  return {times.low > 1    ? Holds::kYes
          : times.high > 1 ? Holds::kPartly
                           : Holds::kNo,
          fmt::format("{} % of the orders were known from before. A frame takes {} times as long as with "
                      "abutting edges.",
                      Range{100 * hits.low, 100 * hits.high}.text(0), times.text(2))};
}

constexpr std::string_view kOwnStages = "These are the engine's own stages.";
constexpr std::string_view kEngineSpans = "The spans are drawn by the engine's own SIMD code.";
constexpr std::string_view kDepthEdges =
    "It shares the engine's code for edges and spans, but does not reuse the order of the row above.";

constexpr std::array kSurfaceEntries{
    BookEntry{
        "bsp-edges",
        "The edges of all faces go into one list. A scan from top to bottom keeps the edges that cross "
        "the current row in order from left to right, and a stack of the surfaces that cover the current "
        "pixel. When another surface comes to the top of the stack, a span ends. The BSP tree numbers "
        "the surfaces from front to back, so the scan compares whole numbers instead of depths.",
        "Every pixel is drawn once, so the slowest frames cost little more than the average ones. A "
        "steady 15 frames per second are better than an average of 30 with drops to 5.",
        kOwnStages, judge_engine},
    BookEntry{
        "painter",
        "Faces are drawn from back to front, each over those before it, as a painter puts the foreground "
        "over the background. BSP order is such an order. Everything hidden is drawn in full, and then "
        "drawn over.",
        "Even with the potentially visible set, half as many pixels again as the screen has are drawn "
        "(50 % overdraw).",
        kEngineSpans, judge_painter},
    BookEntry{
        "painter:pvs=0",
        "The same, without the set of leaves that can be seen from the eye's leaf. All faces inside the "
        "frustum are drawn.",
        "The set makes drawing faster, most of all in the most complex places.", kEngineSpans,
        judge_painter_without_pvs},
    BookEntry{"z-buffer",
              "Each pixel has a depth. A pixel of a face is drawn if it is nearer than the depth that is "
              "there, so faces may come in any order. Here, they come from front to back, and most hidden "
              "pixels fail the test.",
              "A test for each pixel of each face costs too much for the world. Only models, which are small "
              "and hard to sort, are worth it.",
              "SIMD tests 16 pixels at once (8 without AVX-512).", judge_z_buffer},
    BookEntry{"z-buffer:order=1",
              "The same from back to front: nearly all tests pass, and every hidden pixel is drawn.",
              "The order matters: tests that fail are cheaper than pixels that are drawn over.",
              "SIMD tests 16 pixels at once (8 without AVX-512).", judge_z_buffer_order},
    BookEntry{
        "beam-tree",
        "Faces come from front to back. A tree of lines divides the screen into parts that are already "
        "covered and parts that are still open. Each face is cut along these lines. Its pieces in open "
        "parts are visible, and their outlines become new lines.",
        "Each pixel is drawn once, but keeping the tree has considerable overhead, and some views cost "
        "far more than others.",
        "Profiled. Pieces are spans, which are compared eight rows at a time; each band of rows has its "
        "own tree.",
        judge_beam_tree},
    BookEntry{"span-sorting",
              "Each face is turned into spans at once. Every row has a list of the nearest spans so far, in "
              "order from left to right, and each new span is clipped against it.",
              "The spans are the same as with edge sorting. Sorting them can cost more, because neighbors "
              "cannot share the work for their common edge, which is nearly half of all work for edges.",
              kEngineSpans, judge_slower},
    BookEntry{"span-sorting:depth=1",
              "The same without BSP order: where two spans meet, 1/z at the pixel decides.",
              "Comparing whole numbers is faster than computing depths.", kEngineSpans, judge_slower},
    BookEntry{
        "independent-edges",
        "Edges are sorted as by the engine, but 1/z decides which surface is in front, at the pixel "
        "where it begins. That is enough for objects that never touch, such as ships in a space battle. "
        "Where a wall begins on a floor, both have the same depth, and rounding decides.",
        "The simplest and fastest kind of sorted spans, and wrong where surfaces touch.", kDepthEdges,
        judge_independent},
    BookEntry{"abutting-edges",
              "If two depths are nearly equal, the surface that comes nearer to the right is in front. If a "
              "surface ends at an edge that its neighbor shares, the neighbor takes its place in the stack "
              "without a comparison.",
              "It could be made reliable, if edges were not shared: an error spreads from surface to "
              "surface.",
              kDepthEdges, judge_abutting},
    BookEntry{"abutting-edges:gradient=0",
              "Without the rule for surfaces that touch: the first comparison decides, as rounding has it.",
              "The rule is needed where walls meet floors.", kDepthEdges, judge_rule},
    BookEntry{"abutting-edges:mesh=0", "Without the place of the neighbor: each surface is compared again.",
              "Sharing makes errors spread, so without it there are fewer.", kDepthEdges,
              [](const Evidence& evidence) {
                const double wrong = evidence.wrong_shares().high;
                const double shared = evidence.of("abutting-edges").wrong_shares().high;
                return Verdict{wrong < shared    ? Holds::kYes
                               : wrong == shared ? Holds::kPartly
                                                 : Holds::kNo,
                               fmt::format("{} With sharing: at most {:.3f} %.", describe_wrong(evidence),
                                           100 * shared)};
              }},
    BookEntry{"intersecting-edges",
              "1/z is compared at both ends of every span. If the order differs, the surfaces cross, and the "
              "span is cut there. No order of the faces is needed at all.",
              "The slowest and most complicated kind, but it always works.", kDepthEdges, judge_intersecting},
    BookEntry{"unsplit-edges",
              "A compiler cuts faces at the planes of the BSP tree, so that they have an order. Depths need "
              "none, so here the parts of a face are joined again: fewer edges are sorted, by 1/z. Each part "
              "has its own light map, so spans are cut at the parts' borders at last.",
              "Faster than with split faces, but not by as much as hoped, and less reliable.",
              "It shares the engine's code for edges and spans.", judge_unsplit},
    BookEntry{
        "cached-order",
        "If a face lies in front of the plane of another, it is in front of it from everywhere. A table "
        "keeps such pairs from frame to frame, and only the others are compared.",
        "A result that is kept needs no computing, but a comparison of 1/z is so short that looking it "
        "up takes longer.",
        "The table needs no locks; an entry is one number.", judge_cached},
};

}  // namespace

BookChapter make_hidden_surfaces_chapter() {
  return {"hidden-surfaces", "Which surface is in front",
          "Each pixel must show the nearest of the faces behind it. All techniques of this chapter get "
          "the same faces, and nearly all draw the same picture. They differ in when they find out which "
          "face is in front: before drawing, at the ends of spans, or at each pixel. Where a picture differs "
          "although its faces are right, a face has another mip level, which depends on its spans.",
          kSurfaceEntries};
}

}  // namespace temblor::app
