#include "app/lab/book/space_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/bench/measurement_output.h"
#include "app/files/atomic_write.h"
#include "app/files/picture_file.h"
#include "app/html/html.h"
#include "app/lab/space_figures.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;
using lab::space::BattleOptions;
using lab::space::BattleShapes;
using lab::space::DepthSorting;

constexpr FrameSize kSpacePictureSize{640, 400};
// Neighbors are half as far apart as the largest solids are wide.
constexpr double kCrowdedSpacing = 1;

struct SpacePicture {
  const char *file, *caption;
  BattleOptions battle;
};

constexpr SpacePicture kSpacePictures[] = {
    {"space-convex.png", "100 convex solids.", {.solids = 100}},
    {"space-concave.png", "100 concave solids.", {.solids = 100, .shapes = BattleShapes::kConcave}},
    {"space-10000.png",
     "10,000 convex and concave solids.",
     {.solids = 10000, .shapes = BattleShapes::kBoth}},
    {"space-crowded.png",
     "300 solids that intersect, sorted like solids that do not: one comparison where a face begins decides "
     "for its whole row, although another face crosses it farther right.",
     {.solids = 300, .spacing = kCrowdedSpacing}},
    {"space-intersecting.png",
     "The same, with depths compared at every interval, and spans split where solids cross.",
     {.solids = 300, .spacing = kCrowdedSpacing, .sorting = DepthSorting::kIntersecting}}};

render::FrameBuffer draw_page_picture(const BattleOptions& battle) {
  return draw_space({.battle = battle, .size = kSpacePictureSize});
}

// The share of pixels that differ from a picture with depths compared at every interval, which is exact.
double find_wrong_share(BattleOptions battle) {
  const render::FrameBuffer drawn = draw_page_picture(battle);
  battle.sorting = DepthSorting::kIntersecting;
  const render::FrameBuffer exact = draw_page_picture(battle);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < drawn.pixel_count(); ++i) wrong += drawn.rgb()[i] != exact.rgb()[i];
  return static_cast<double>(wrong) / static_cast<double>(drawn.pixel_count());
}

std::string make_verdict() {
  const double apart = find_wrong_share({.solids = 1000, .shapes = BattleShapes::kBoth});
  const double crowded = find_wrong_share({.solids = 300, .spacing = kCrowdedSpacing});
  const bool holds = apart == 0;
  return fmt::format(
      "<h3>Our measurement: the claim <span class=\"{}\">{}</span></h3>\n<p>Among 1,000 solids that never "
      "touch, convex and concave, {:.2f} % of pixels show a wrong face. Among 300 that intersect, {:.2f} % "
      "do.</p>\n",
      holds ? "good" : "no", holds ? "holds" : "does not hold", 100 * apart, 100 * crowded);
}

std::string make_table(const SpaceCurve& curve) {
  std::string html = fmt::format(
      "<h3>{} solids</h3>\n<table>\n<tr><th class=\"n\">solids</th><th class=\"n\">frame, ms</th><th "
      "class=\"n\">edges</th><th class=\"n\">spans</th><th class=\"n\">comparisons</th><th "
      "class=\"n\">surfaces per pixel</th><th class=\"n\">ns per edge</th></tr>\n",
      curve.shapes == BattleShapes::kConvex ? "Convex" : "Concave");
  for (const SpaceFigures& f : curve.figures)
    html += fmt::format(
        "<tr><td class=\"n\">{}</td><td class=\"n\">{:.2f}</td><td class=\"n\">{:.0f}</td><td "
        "class=\"n\">{:.0f}</td><td class=\"n\">{:.0f}</td><td class=\"n\">{:.2f}</td><td "
        "class=\"n\">{:.0f}</td></tr>\n",
        f.solids, f.ms, f.edges, f.spans, f.comparisons, f.depth_complexity, f.ns_per_edge());
  return html + "</table>\n";
}

constexpr const char* kSpaceExplanation =
    "<p class=\"soft\"><code>temblor lab run space</code></p>\n"
    "<p>The article ends with a small program that needs no level: solids that move freely, drawn with an "
    "edge "
    "list that is sorted by 1/z. This is that program as a scene. Polygons become edges, and edges are "
    "sorted "
    "by x in each row. From left to right, each edge puts its surface into a stack or takes it out; the "
    "nearest surface is on top, and the background, with the stars, is below all others. Where the top "
    "changes, a span ends. So every pixel is written once. Start with <code>Battle::draw</code> in "
    "<code>src/lab/space_battle.cpp</code>.</p>\n"
    "<h3>The article's claim</h3>\n<p>One comparison of 1/z where a surface begins is right for objects that "
    "never touch, convex or concave, such as those of a space battle. <span class=\"soft\">(Sorted Spans in "
    "Action, \"1/z span sorting in action\")</span></p>\n";

std::string make_space_page(const SpaceScene& scene) {
  const std::vector<SpaceCurve> curves = measure_space_curves(scene);
  std::string html =
      begin_page("The space battle",
                 std::string(kPlotStyle) + "a { color: var(--bar); } .no { color: var(--alarm); }") +
      "<p><a href=\"index.html\">The laboratory's book</a></p>\n<h1>The space battle</h1>\n" +
      kSpaceExplanation + make_verdict() + draw_plot(plot_space_curves(scene, curves));
  for (const SpaceCurve& curve : curves) html += make_table(curve);
  for (const SpacePicture& picture : kSpacePictures)
    html += fmt::format(
        "<figure><img class=\"wide\" alt=\"{0}\" src=\"{1}\"/><figcaption>{0}</figcaption></figure>\n",
        escape_html(picture.caption), picture.file);
  return html + "</body>\n</html>\n";
}

}  // namespace

base::Status write_space_page(const fs::path& folder, const FrameSize& size) {
  for (const SpacePicture& picture : kSpacePictures)
    TRY_STATUS(write_picture_file((folder / picture.file).string(), draw_page_picture(picture.battle), {}));
  return replace_file(folder / "space.html",
                      base::as_bytes(make_space_page({.battle = {}, .size = size, .fov_deg = 90})));
}

}  // namespace temblor::app
