#include <fmt/format.h>

#include <array>

#include "app/lab/book/chapters.h"

namespace temblor::app {
namespace {

Verdict judge_leaf_faces(const Evidence& evidence) {
  const auto tests = [](const TechniqueFigures& figures) { return figures.views.planes_tested; };
  const Range here = evidence.over_levels(tests);
  const Range nodes = Evidence(evidence.figures(), 0).over_levels(tests);
  return {here.low > nodes.high   ? Holds::kYes
          : here.high > nodes.low ? Holds::kPartly
                                  : Holds::kNo,
          fmt::format("{} planes are tested, on nodes {}. {}", here.text(0), nodes.text(0),
                      describe_time(evidence))};
}

// A technique that should find fewer faces than the engine, in more time.
Verdict judge_portals(const Evidence& evidence) {
  const auto faces = [](const TechniqueFigures& figures) { return figures.measurement.faces_drawn.p50; };
  const Range ours = evidence.over_levels(faces);
  const Range engine = Evidence(evidence.figures(), 0).over_levels(faces);
  const Range times = evidence.time_ratios();
  const bool are_fewer = ours.high<engine.high, is_slower = times.low> kSameTime;
  return {are_fewer && is_slower   ? Holds::kYes
          : are_fewer || is_slower ? Holds::kPartly
                                   : Holds::kNo,
          fmt::format("{} faces come into the edge list, with the potentially visible set {}. {} {}",
                      ours.text(0), engine.text(0), describe_time(evidence), describe_wrong(evidence))};
}

constexpr std::array kVisibleEntries{
    BookEntry{"leaf-faces",
              "Faces lie on the planes of the BSP tree's nodes. The engine tests once per node on which side "
              "of its plane the eye is, which settles all faces in that plane. Here, each visible leaf goes "
              "through its own list of faces and tests the plane of each.",
              "The same faces with more tests.",
              "The walk and the clipping are the engine's; faces of several leaves are tested once.",
              judge_leaf_faces},
    BookEntry{
        "portals",
        "Two leaves that touch have an opening between them, a portal. From the eye's leaf, the view "
        "goes on through each portal that it can see, and its window gets narrower with each: a "
        "rectangle around what is visible through all of them. Faces of leaves that no window reaches "
        "are not drawn. No set has to be computed in advance. The inside of a fence is solid, so things "
        "behind it are missing.",
        "Fewer faces, but more work in each frame to find them. The precomputed set is faster.",
        "Portals are found once per level; windows of a leaf that is reached twice are joined.",
        judge_portals},
    BookEntry{"portals:octagon=1",
              "The same with windows that also have diagonal sides, which fit portals better.",
              "Tighter windows let fewer faces through, and take longer to clip.", "As with rectangles.",
              judge_portals},
    BookEntry{"portals:pvs=1", "Only leaves of the potentially visible set are entered.",
              "Both together leave the fewest faces.", "As with all leaves.", judge_portals},
};

}  // namespace

BookChapter make_visible_faces_chapter() {
  return {
      "visible-faces", "Which faces may be visible",
      "Before anything is sorted, an engine finds the faces that may be in view: those in the leaves that "
      "can be seen from the eye's leaf, in the frustum, with their fronts to the eye. The techniques of "
      "this chapter find them in other ways, and the engine's own stages draw them.",
      kVisibleEntries};
}

}  // namespace temblor::app
