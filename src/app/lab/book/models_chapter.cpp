#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/lab/book/chapters.h"
#include "lab/registry.h"

namespace temblor::app {
namespace {

constexpr auto wrong_outline = [](const TechniqueFigures& f) { return f.views.models.outline_share(); };
constexpr auto texels_off = [](const TechniqueFigures& f) { return f.views.models.off_share(); };

Range in_percent(Range shares) {
  return {100 * shares.low, 100 * shares.high};
}

std::string describe_models(const Evidence& evidence) {
  const Range texels =
      evidence.over_levels([](const TechniqueFigures& f) { return f.views.models.mean_texels(); });
  return fmt::format(
      "Wrong outline: {} % of the models' pixels. Texels are {} off on average; {} % are more than two off.",
      in_percent(evidence.over_levels(wrong_outline)).text(1), texels.text(2),
      in_percent(evidence.over_levels(texels_off)).text(1));
}

// Frame time, divided by that of affine models.
Range compare_with_affine(const Evidence& evidence) {
  return evidence.time_ratios(evidence.of("affine-models").number());
}

std::string describe_against_affine(const Evidence& evidence) {
  return fmt::format("A frame takes {} times that of scan lines. {}", compare_with_affine(evidence).text(2),
                     describe_models(evidence));
}

Verdict judge_affine_models(const Evidence& evidence) {
  constexpr double kFewTexels = 0.05;
  const Range off = evidence.over_levels(texels_off);
  return {off.high < kFewTexels  ? Holds::kYes
          : off.low < kFewTexels ? Holds::kPartly
                                 : Holds::kNo,
          describe_models(evidence) + " " + describe_time(evidence)};
}

// For a variant that should take more time than affine models.
Verdict judge_slower_than_affine(const Evidence& evidence) {
  const Range times = compare_with_affine(evidence);
  return {times.low > kSameTime    ? Holds::kYes
          : times.high > kSameTime ? Holds::kPartly
                                   : Holds::kNo,
          describe_against_affine(evidence)};
}

// For a variant that should take less.
Verdict judge_faster_than_affine(const Evidence& evidence) {
  const Range times = compare_with_affine(evidence);
  return {times.high < 1 / kSameTime  ? Holds::kYes
          : times.low < 1 / kSameTime ? Holds::kPartly
                                      : Holds::kNo,
          describe_against_affine(evidence)};
}

// Trees should be faster than lists, and still much slower than scan lines.
Verdict judge_edge_tree(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("models-in-edges").number());
  const bool helps = times.low<1 / kSameTime, is_slow = compare_with_affine(evidence).high> kSameTime;
  return {helps && is_slow   ? Holds::kYes
          : helps || is_slow ? Holds::kPartly
                             : Holds::kNo,
          fmt::format("A frame takes {} times that with a list. {}", times.text(2),
                      describe_against_affine(evidence))};
}

Verdict judge_split_light(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("subdivided-models").number());
  return {
      times.high > kSameTime ? Holds::kYes : Holds::kNo,
      fmt::format("A frame takes {} times that of flat light. {}", times.text(2), describe_models(evidence))};
}

Verdict judge_boxes(const Evidence& evidence) {
  constexpr double kSmall = 0.1, kLarge = 0.3;
  const Range wrong = evidence.over_levels(wrong_outline);
  const bool has_gaps = wrong.high > kLarge, is_erratic = wrong.low < kSmall;
  return {has_gaps && is_erratic   ? Holds::kYes
          : has_gaps || is_erratic ? Holds::kPartly
                                   : Holds::kNo,
          describe_against_affine(evidence)};
}

// Blobs should be faster than triangles, with about the right outline.
Verdict judge_flood(const Evidence& evidence) {
  constexpr double kSmallError = 0.1;
  const bool is_fast = compare_with_affine(evidence).low < 1 / kSameTime;
  const bool looks_right = evidence.over_levels(wrong_outline).low < kSmallError;
  return {is_fast && looks_right   ? Holds::kYes
          : is_fast || looks_right ? Holds::kPartly
                                   : Holds::kNo,
          describe_against_affine(evidence)};
}

// Painted models should be right in outline, and wrong where their triangles need another order.
Verdict judge_leaves(const Evidence& evidence) {
  constexpr double kVisible = 0.005;
  const bool looks_wrong = evidence.over_levels(texels_off).high > kVisible;
  return {looks_wrong ? Holds::kYes : Holds::kNo, describe_against_affine(evidence)};
}

// Walks should save time, and show the same picture.
Verdict judge_deltas(const Evidence& evidence) {
  constexpr double kSmallError = 0.01;
  const bool is_fast = compare_with_affine(evidence).low < 1 / kSameTime;
  const bool looks_right = evidence.over_levels(wrong_outline).high < kSmallError;
  return {is_fast && looks_right   ? Holds::kYes
          : is_fast || looks_right ? Holds::kPartly
                                   : Holds::kNo,
          describe_against_affine(evidence)};
}

// Sprites should be hardly faster than triangles, and look wrong.
Verdict judge_sprites(const Evidence& evidence) {
  constexpr double kMuchFaster = 0.7, kVisible = 0.02;
  const bool is_slow = evidence.time_ratios().high > kMuchFaster;
  const bool looks_wrong = evidence.over_levels(wrong_outline).high > kVisible;
  return {is_slow && looks_wrong   ? Holds::kYes
          : is_slow || looks_wrong ? Holds::kPartly
                                   : Holds::kNo,
          describe_time(evidence) + " " + describe_models(evidence)};
}

Verdict judge_masks(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("subdivided-models").number());
  return {times.high < 1 / kSameTime  ? Holds::kYes
          : times.low < 1 / kSameTime ? Holds::kPartly
                                      : Holds::kNo,
          fmt::format("A frame takes {} times that of subdivision. {}", times.text(2),
                      describe_against_affine(evidence))};
}

// Over the levels with models that a stack draws: the engine draws those that reach behind the eye.
Range over_stacks(const Evidence& evidence, base::FunctionRef<double(const ViewFigures&)> value) {
  Range range;
  bool is_first = true;
  for (const LevelFigures& level : evidence.figures().levels) {
    const ViewFigures& views = level.techniques[evidence.number()].views;
    if (views.stack.vertices == 0) continue;
    const double here = value(views);
    range.low = is_first ? here : std::min(range.low, here);
    range.high = is_first ? here : std::max(range.high, here);
    is_first = false;
  }
  return range;
}

Range find_loads(const Evidence& evidence) {
  return over_stacks(evidence, [](const ViewFigures& views) { return views.loads_per_vertex(); });
}

Range find_misses(const Evidence& evidence, std::uint64_t lab::Counts::*misses) {
  return over_stacks(
      evidence, [=](const ViewFigures& views) { return views.misses_per_triangle(views.stack.*misses); });
}

std::string describe_stack(const Evidence& evidence) {
  const auto misses = [&](std::uint64_t lab::Counts::*counted) {
    return find_misses(evidence, counted).text(2);
  };
  return fmt::format(
      "A vertex is sent {} times. In the Pentium's cache, simulated, vertices have {} misses per triangle "
      "instead of {}; in one of 32 KB, {} instead of {}. {}",
      find_loads(evidence).text(2), misses(&lab::Counts::stack_misses), misses(&lab::Counts::list_misses),
      misses(&lab::Counts::stack_misses_today), misses(&lab::Counts::list_misses_today),
      describe_against_affine(evidence));
}

// A stack should have fewer cache misses than a list of vertices, and so save time.
Verdict judge_stack(const Evidence& evidence) {
  const Range list = find_misses(evidence, &lab::Counts::list_misses);
  const bool is_local = find_misses(evidence, &lab::Counts::stack_misses).high < list.low / kSameTime;
  const bool is_fast = compare_with_affine(evidence).low < 1 / kSameTime;
  return {is_local && is_fast   ? Holds::kYes
          : is_local || is_fast ? Holds::kPartly
                                : Holds::kNo,
          describe_stack(evidence)};
}

// More places should need fewer pushes.
Verdict judge_larger_stack(const Evidence& evidence) {
  const bool needs_fewer = find_loads(evidence).high < find_loads(evidence.of("stack-meshes")).low;
  return {needs_fewer ? Holds::kYes : Holds::kNo, describe_stack(evidence)};
}

// Code for each shape should be faster than masks.
Verdict judge_compiled(const Evidence& evidence) {
  const Range times = evidence.time_ratios(evidence.of("triangle-masks").number());
  return {times.high < 1 / kSameTime  ? Holds::kYes
          : times.low < 1 / kSameTime ? Holds::kPartly
                                      : Holds::kNo,
          fmt::format("A frame takes {} times that of masks. {}", times.text(2),
                      describe_against_affine(evidence))};
}

constexpr std::string_view kEnginesLoops =
    "The engine's own SIMD code, which was profiled and tuned (docs/decisions/alias-triangles.md).";

// The last entry, because not all machines can run it.
constexpr std::string_view kAssembledEntry = "compiled-triangles:code=1";

constexpr std::array kModelEntries{
    BookEntry{
        "models-in-edges",
        "The triangles of all models become edges, which are sorted by column on each row. Where one "
        "begins or ends, the nearest triangle is found by its depth, so each pixel is drawn once.",
        "An edge list that serves 200 to 300 large polygons well is far too slow for 2,000 to 3,000 tiny "
        "triangles.",
        "The engine's SIMD code transforms vertices and draws spans. Edges of neighbors are not shared.",
        judge_slower_than_affine},
    BookEntry{"models-in-edges:tree=1", "The edges of a row are a balanced tree instead of a linked list.",
              "Trees would help, but the work for each edge and row remains.", "As with a list.",
              judge_edge_tree},
    BookEntry{
        "models-in-leaves",
        "There is no depth buffer. Triangles are cut at the planes of the BSP tree, and the world is painted "
        "from back to front with each leaf's parts in their turn. Within a leaf, farther models and farther "
        "triangles come first. So triangles of one leaf that need another order are wrong, and a model "
        "covers each door in its leaf.",
        "Models that are in one leaf are not sorted, and complex models have ugly errors.",
        "Transforms are the engine's SIMD code. The tree is descended only from where it divides the model. "
        "Cutting and painting are scalar: a painted row has a few pixels. Profiled: most time is painting.",
        judge_leaves},
    BookEntry{
        "models-in-leaves:cut=0", "A whole model is painted in the leaf of its middle.",
        "The article's engine cut its models. Without cuts, walls hide parts in other leaves, or fail to.",
        "As with cuts.", judge_leaves},
    BookEntry{"model-sprites",
              "A model is drawn into a picture of its own, which is moved with the model in the next frame. "
              "Half of the models get a new picture in each frame.",
              "One drawing and two sprites in two frames are hardly faster than two drawings, and even that "
              "looks like cardboard.",
              "Pictures are as small as their models, and their loop is vectorized. Models that may reach "
              "behind the eye are drawn as triangles.",
              judge_sprites},
    BookEntry{"model-sprites:frames=3", "Each picture is used for three frames.",
              "With more than one reuse, models look like jerky cardboard cutouts.", "As with two frames.",
              judge_sprites},
    BookEntry{"vertex-boxes",
              "Each vertex is drawn as 2x2 pixels, on whichever side of the model it is. From far away, the "
              "boxes together form the model.",
              "Sometimes it works well, but there are gaps where triangles are large.",
              "The engine's SIMD code transforms the vertices. Boxes are drawn one by one.", judge_boxes},
    BookEntry{
        "flood-fill",
        "The edges between front and back triangles are drawn as lines, which have the right texels. Colors "
        "then spread from there, and from single vertices, over the inside. Holes are filled, and the "
        "vertices of hidden parts show through.",
        "None: the article calls it a half-formed idea. Far models are indistinct blobs, so another way of "
        "drawing blobs might do.",
        "The engine's SIMD code transforms vertices, and pictures are copied with vectors. Outlines and "
        "floods are scalar, because each pixel follows from its neighbor.",
        judge_flood},
    BookEntry{
        "deltas",
        "The nearest front triangle is the seed. From there, triangles are visited across edges that they "
        "share, as far as the visible side reaches. The steps along an edge are computed once for both of "
        "its "
        "triangles. Front triangles that are not reached get seeds of their own.",
        "None: the article calls it a half-formed idea, and gives no details.",
        "The engine's SIMD code transforms vertices and draws rows. The walk and the edges are scalar: each "
        "step depends on the one before.",
        judge_deltas},
    BookEntry{"deltas:seeds=1",
              "Each model has one seed. Parts that only touch the rest at the back are missing.",
              "One visible seed point is picked.", "As with many seeds.", judge_deltas},
    BookEntry{"affine-models",
              "Triangles are drawn by scan lines, at all distances. Texels change evenly along the screen.",
              "Triangles are small or far away, so perspective would add little.", kEnginesLoops,
              judge_affine_models},
    BookEntry{"affine-models:perspective=1", "The same, with a division at each pixel.",
              "Perspective is work that affine texels avoid.", kEnginesLoops, judge_slower_than_affine},
    BookEntry{"affine-models:subpixel=0",
              "Vertices are rounded to whole pixels, so edges jump while a model moves.",
              "Whole pixels are faster: fractions would need additional steps for each triangle.",
              kEnginesLoops, judge_faster_than_affine},
    BookEntry{
        "subdivided-models",
        "A triangle is halved until no side is longer than a pixel, and each new corner is drawn. The "
        "engine draws the smallest models in this way.",
        "A model takes a sixth less time than with scan lines, as long as its triangles are small.",
        "The engine's own code. It is scalar, because each step depends on the one before. Triangles of "
        "more than 1024 pixels are drawn by scan lines.",
        judge_faster_than_affine},
    BookEntry{"subdivided-models:light=1", "Light is halved with the sides, like texels.",
              "One light for each small triangle was enough, and saved time.",
              "Like the engine's code, with a lookup of light at each pixel.", judge_split_light},
    BookEntry{
        "triangle-masks",
        "With corners at whole pixels, there are only so many triangles of up to 5x5 pixels. The pixels "
        "of each are in a table. Larger triangles are drawn by scan lines.",
        "Masks could be faster than subdivision, and the table is small enough.",
        "Triangles are set up one at a time, with the four values of a pixel as one vector. Profiled: "
        "setting "
        "up takes half of the time.",
        judge_masks},
    BookEntry{
        "stack-meshes",
        "When a model is loaded, its triangles become a stream of commands: push a vertex on a stack of 16, "
        "pop some, draw a triangle with vertices from the stack. Vertices are stored in the order of the "
        "pushes. A push transforms its vertex, and no list of transformed vertices is written. A vertex that "
        "left the stack too early is sent again, and so are those of a model in several bands of the "
        "picture.",
        "The vertices are in a tiny stack that is always in the cache, and the stream is read from start to "
        "end.",
        "The engine's SIMD code transforms and draws, for 64 pushes and their triangles at a time. Profiled: "
        "transforms and the search for front faces are repeated in each band.",
        judge_stack},
    BookEntry{"stack-meshes:group=0", "One command after another, each with one vertex or one triangle.",
              "As above: this is how the article describes it.",
              "Vertices and triangles are scalar, and rows are drawn by the engine's SIMD code.",
              judge_stack},
    BookEntry{"stack-meshes:stack=64", "The stack has room for 64 vertices instead of 16.",
              "A larger stack needs fewer vertices twice (Bar-Yehuda and Gotsman).", "As with 16.",
              judge_larger_stack},
    BookEntry{
        "compiled-triangles",
        "Masks that only differ in their place are one shape, and there are 346 shapes. Each has a function "
        "of "
        "its own, with a statement for each pixel, in C++ that a program writes while Temblor is built. "
        "Triangles at the edge of the screen are drawn by their masks. The picture is that of masks.",
        "Precompiled code could be faster, and its memory looks reasonable.",
        "Triangles are set up as for masks. Runs of pixels, as a second form, are slower. Profiled: the code "
        "saves a quarter of the instructions for a pixel. Tests of depth are predicted as badly as in a "
        "loop, "
        "and calls worse.",
        judge_compiled},
    BookEntry{
        kAssembledEntry,
        "The same functions as x86-64 code, which the library asmjit assembles at the start, in a few "
        "milliseconds. Hidden pixels are computed, too, but not stored, so no test of depth is predicted.",
        "As with C++.",
        "Each pixel takes 21 instructions in palette colors. In full color, its three channels are lit at "
        "once. With jumps over hidden pixels, as a second form, frames take up to 6% longer.",
        judge_compiled},
};

std::span<const BookEntry> list_model_entries() {
  static_assert(kModelEntries.back().technique == kAssembledEntry);
  const std::span<const BookEntry> all = kModelEntries;
  const bool can_assemble = lab::parse_choice(kAssembledEntry).value().check_level(world::Level{}).ok();
  return can_assemble ? all : all.first(all.size() - 1);
}

}  // namespace

BookChapter make_models_chapter() {
  return {"models",
          "Triangle models",
          "Models have hundreds of triangles, most of them of a few pixels. Here, copies of one model stand "
          "before the camera, without the world. Their pixels are compared with an exact picture: a ray "
          "through the middle of each, in double precision.",
          list_model_entries(),
          BookColumns::kModels,
          true};
}

}  // namespace temblor::app
