#include "lab/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "base/words.h"
#include "lab/hidden_surfaces/beam_tree.h"
#include "lab/hidden_surfaces/depth_edges.h"
#include "lab/hidden_surfaces/painter.h"
#include "lab/hidden_surfaces/span_sorting.h"
#include "lab/hidden_surfaces/z_buffer.h"
#include "lab/models/model_techniques.h"
#include "lab/perspective/affine_spans.h"
#include "lab/perspective/equal_z_spans.h"
#include "lab/unsplit_world/unsplit_edges.h"
#include "lab/visible_faces/leaf_faces.h"
#include "lab/visible_faces/portals.h"
#include "lab/world_light/effects/marked_surfaces.h"
#include "lab/world_light/effects/procedural_texels.h"
#include "lab/world_light/gouraud.h"
#include "lab/world_light/lamps/lamp_stages.h"
#include "lab/world_light/one_pass.h"
#include "lab/world_light/phong.h"
#include "lab/world_light/rays/ray_light.h"
#include "lab/world_light/rebuilt_surfaces.h"

namespace temblor::lab {

namespace {

using base::ErrorCode;

constexpr std::array<Parameter, 0> kNoParameters{};
constexpr std::array kPainterParameters{
    Parameter{"pvs", 1, 0, 1, "1: draws the potentially visible set; 0: everything in the frustum"}};
constexpr std::array kZBufferParameters{
    Parameter{"order", 0, 0, 1, "0: faces from front to back; 1: from back to front"}};
constexpr std::array kBeamTreeParameters{
    Parameter{"bands", 1, 0, 1, "1: a tree for each band of rows; 0: one tree for the frame"},
    Parameter{"nodes", 4e5, 0, 4e6, "nodes of a frame's trees; then faces are clipped span by span"}};
constexpr std::array kSpanSortingParameters{
    Parameter{"depth", 0, 0, 1, "0: compares spans by BSP order; 1: by 1/z"}};
constexpr std::array kAbuttingParameters{
    Parameter{"epsilon", 1e-5, 0, 0.1, "relative difference of 1/z up to which surfaces touch"},
    Parameter{"gradient", 1, 0, 1,
              "1: of touching surfaces, the one that comes nearer to the right is in front"},
    Parameter{"mesh", 1, 0, 1, "1: across a shared edge, a surface takes the place of its neighbor"}};
constexpr std::array kCachedOrderParameters{
    Parameter{"pairs", 65536, 2, 1 << 24, "places of the cache, rounded up to a power of two"},
    Parameter{"keep", 1, 0, 1, "1: keeps pairs for the next frame; 0: empties the cache before each frame"}};
constexpr std::array kPortalParameters{
    Parameter{"octagon", 0, 0, 1, "0: windows are rectangles; 1: octagons"},
    Parameter{"pvs", 0, 0, 1, "1: only leaves of the potentially visible set; 0: all"},
    Parameter{"portals", 2e5, 0, 1e6, "portals of a level; one with more is refused"}};

constexpr std::array kAffineParameters{Parameter{
    "pixels", 8192, 1, 8192, "pixels between two divisions; 8192: only the ends of a span are exact"}};

constexpr std::array kEqualZParameters{
    Parameter{"texels", 0.125, 0, 16, "spans that would be farther off are divided at each pixel"}};

constexpr std::array kGouraudParameters{
    Parameter{"perspective", 0, 0, 1, "0: light is linear on the screen; 1: on the wall"},
    Parameter{"triangles", 0, 0, 1, "1: cuts faces into triangles first"},
    Parameter{"spot", 0, 0, 1, "1: cuts faces at the brightest point of the light map"},
    Parameter{"cut", 0, 0, 256, "cuts faces into a grid of this many texels, at least 16; 0: does not"}};
constexpr std::array kPhongParameters{
    Parameter{"lights", 8, 1, 64, "lights of a face, the brightest ones"},
    Parameter{"smooth", 0, 0, 180, "degrees between faces up to which they share normals; 0: each its own"}};
constexpr std::array kRayLightParameters{
    Parameter{"lights", 128, 1, 1024, "lights of a face, the brightest ones"}};
constexpr std::array kRebuiltParameters{
    Parameter{"every", 1, 1, 16, "each frame builds one of so many surfaces, in turns; 1: all"}};
constexpr std::array kProceduralParameters{
    Parameter{"pattern", 0, 0, 2, "0: noise, built once; 1: water that runs down walls; 2: fire on walls"},
    Parameter{"every", 1, 1, 16, "water and fire: each frame builds one of so many surfaces, in turns"}};
constexpr std::array kMarkedParameters{Parameter{"marks", 4, 0, 16, "translucent marks on each face"}};
constexpr std::array kOnePassParameters{
    Parameter{"bilinear", 1, 0, 1, "1: light between four samples, as in surfaces; 0: the nearest sample"}};

constexpr std::string_view kBigPicture = "Quake's 3-D Engine: The Big Picture";
constexpr std::string_view kAlternatives = "Consider the Alternatives: Quake's Hidden-Surface Removal";
constexpr std::string_view kSurfaceCaching = "Quake's Lighting Model: Surface Caching";
constexpr std::string_view kSortedSpans = "Sorted Spans in Action";

render::FrameStages make_engine(std::span<const double> /*values*/, Counter* counter) {
  render::FrameStages stages;
  if (counter == nullptr) return stages;
  stages.find_visible_faces = [=](const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::LevelTables& tables) {
    const render::VisibleFaces visible = render::find_visible_faces(context, view, tables);
    counter->add({.planes_tested = count_planes_tested(context, view, visible)});
    return visible;
  };
  return stages;
}

constexpr std::array kTechniques{
    Technique{
        .name = "bsp-edges",
        .title = "Edges sorted by BSP order",
        .summary = "The engine: one list of edges, scanned row by row; BSP order decides what is in front.",
        .article = kSortedSpans,
        .heading = "Quake and sorted spans",
        .replaces = "nothing",
        .expected = "Draws every pixel once. The slowest frames are not much slower than the others.",
        .max_wrong_share = 0,
        .parameters = kNoParameters,
        .make_stages = make_engine},
    Technique{.name = "painter",
              .title = "Painter's algorithm",
              .summary = "Draws whole faces from back to front, each over those before it.",
              .article = kAlternatives,
              .heading = "Leveling and improving performance",
              .replaces = "scan, spans",
              .expected =
                  "Half as many pixels again as the screen has. In places, the potentially visible set "
                  "has five times as many faces as can be seen, and the frame rate drops there. Brush "
                  "models that overlap in a circle have no right order.",
              .max_wrong_share = 0.001,
              .parameters = kPainterParameters,
              .make_stages = make_painter},
    Technique{.name = "z-buffer",
              .title = "Depth buffer for the world",
              .summary = "Compares the depth of each pixel with what has been drawn there.",
              .article = kAlternatives,
              .heading = "Sorted spans",
              .replaces = "scan, spans",
              .expected = "Tests each pixel of every face, so it is too slow for the world.",
              .max_wrong_share = 0,
              .parameters = kZBufferParameters,
              .make_stages = make_z_buffer},
    Technique{
        .name = "beam-tree",
        .title = "Beam tree",
        .summary = "Takes faces from front to back, and splits each by the outlines of those before it.",
        .article = kAlternatives,
        .heading = "Sorted spans",
        .replaces = "scan",
        .expected = "Draws every pixel once, but splitting faces costs much time. Some views cost far "
                    "more than others.",
        .max_wrong_share = 0.001,
        .parameters = kBeamTreeParameters,
        .make_stages = make_beam_tree},
    Technique{.name = "span-sorting",
              .title = "Span sorting",
              .summary = "Turns each face into spans, and clips them against the nearest spans of their row.",
              .article = kAlternatives,
              .heading = "Edges versus spans",
              .replaces = "scan",
              .expected =
                  "Finds the same spans as edge sorting, with more time for sorting, because neighbors "
                  "share no edges.",
              .max_wrong_share = 0.001,
              .parameters = kSpanSortingParameters,
              .make_stages = make_span_sorting},
    Technique{
        .name = "independent-edges",
        .title = "Edges sorted by 1/z, independent",
        .summary = "Compares depths once, where a surface begins. Surfaces that touch get into disorder.",
        .article = kSortedSpans,
        .heading = "Independent span sorting",
        .replaces = "scan",
        .expected = "The fastest of the three kinds, and wrong where walls meet floors.",
        .max_wrong_share = 0.1,
        .parameters = kNoParameters,
        .make_stages = make_independent_edges},
    Technique{.name = "abutting-edges",
              .title = "Edges sorted by 1/z, abutting",
              .summary = "Nearly equal depths are decided by which surface comes nearer to the right.",
              .article = kSortedSpans,
              .heading = "Abutting span sorting",
              .replaces = "scan",
              .expected = "Right almost everywhere, and as slow as BSP order. An error spreads to neighbors "
                          "across shared edges.",
              .max_wrong_share = 0.001,
              .parameters = kAbuttingParameters,
              .make_stages = make_abutting_edges},
    Technique{.name = "intersecting-edges",
              .title = "Edges sorted by 1/z, intersecting",
              .summary = "Compares depths at both ends of every span, and splits spans where surfaces cross.",
              .article = kSortedSpans,
              .heading = "Intersecting span sorting",
              .replaces = "scan",
              .expected = "Needs no order at all. The slowest of the three kinds.",
              .max_wrong_share = 0,
              .parameters = kNoParameters,
              .make_stages = make_intersecting_edges},
    Technique{.name = "unsplit-edges",
              .title = "Unsplit world",
              .summary = "Joins faces that BSP planes have split, and sorts their edges by 1/z.",
              .article = kSortedSpans,
              .heading = "Quake and sorted spans",
              .replaces = "scan",
              .expected =
                  "Faster than with split faces, but not by as much as hoped. Here, spans are cut again "
                  "at the parts' light maps.",
              .max_wrong_share = 0.001,
              .parameters = kNoParameters,
              .make_stages = make_unsplit_edges},
    Technique{
        .name = "cached-order",
        .title = "Cached order of faces",
        .summary = "Looks up which of two faces is in front, and compares 1/z only if the order may change.",
        .article = kSortedSpans,
        .heading = "Abutting span sorting",
        .replaces = "scan",
        .expected = "Slower than abutting edges: to look up a result takes longer than to compute it.",
        .max_wrong_share = 0.001,
        .parameters = kCachedOrderParameters,
        .make_stages = make_cached_order},
    Technique{.name = "leaf-faces",
              .title = "Front-face tests on leaves",
              .summary = "Every visible leaf tests which of its faces the eye is in front of.",
              .article = kSortedSpans,
              .heading = "Quake and sorted spans",
              .replaces = "visibility",
              .expected = "The same faces with more tests: faces in one plane are tested one by one.",
              .max_wrong_share = 0,
              .parameters = kNoParameters,
              .make_stages = make_leaf_faces},
    Technique{
        .name = "portals",
        .title = "Portals",
        .summary = "Finds the leaves in view through the openings between them, without a precomputed PVS.",
        .article = kAlternatives,
        .heading = "Creative flux",
        .replaces = "visibility",
        .expected = "Fewer faces than the PVS, because the window narrows with the view. It takes more time "
                    "to find them in each frame. Fences are solid, so it misses things behind them.",
        .max_wrong_share = 0.001,
        .parameters = kPortalParameters,
        .make_stages = make_portal_stages,
        .check_level = check_portals},
    Technique{.name = "affine-spans",
              .title = "Textures without perspective",
              .summary = "Divides at a few pixels of a span, and steps texels evenly in between.",
              .article = kBigPicture,
              .heading = "The client",
              .replaces = "spans",
              .expected =
                  "A division every 16 pixels looks like one at each pixel, and hides the division's time. "
                  "Without any, textures bend and swim.",
              .max_wrong_share = 0,
              .parameters = kAffineParameters,
              .make_stages = make_affine_spans},
    Technique{.name = "equal-z-spans",
              .title = "Textures along lines of equal z",
              .summary = "Divides once for each line of equal distance on a surface, and not at its pixels.",
              .article = kBigPicture,
              .heading = "The client",
              .replaces = "spans",
              .expected = "Nearly exact, with few divisions. It saves time where a division takes more than "
                          "looking up its result.",
              .max_wrong_share = 0,
              .parameters = kEqualZParameters,
              .make_stages = make_equal_z_spans},
    Technique{.name = "gouraud",
              .title = "Gouraud shading of the world",
              .summary = "Interpolates light between the vertices of each face, on the screen.",
              .article = kSurfaceCaching,
              .heading = "Problems with Gouraud shading",
              .replaces = "surfaces, spans",
              .expected = "Bland on large faces, without shadows. Light shifts while the view turns.",
              .max_wrong_share = 0,
              .parameters = kGouraudParameters,
              .make_stages = make_gouraud},
    Technique{.name = "phong",
              .title = "Phong shading of the world",
              .summary = "Computes the light of each pixel from the level's lights, without shadows.",
              .article = kSurfaceCaching,
              .heading = "The quest for alternative lighting",
              .replaces = "surfaces, spans",
              .expected = "Better highlights than Gouraud shading, and too slow.",
              .max_wrong_share = 0,
              .parameters = kPhongParameters,
              .make_stages = make_phong,
              .check_level = check_lamps},
    Technique{
        .name = "one-pass",
        .title = "Texture and light in one pass",
        .summary = "Looks up texture and light map for each pixel. Without surfaces, there are no marks.",
        .article = kSurfaceCaching,
        .heading = "Size and speed",
        .replaces = "surfaces, spans",
        .expected = "Needs no memory for surfaces. Its inner loop is complicated, and slower than both "
                    "loops of surfaces together.",
        .max_wrong_share = 0,
        .parameters = kOnePassParameters,
        .make_stages = make_one_pass},
    Technique{.name = "ray-light",
              .title = "Light by rays for each pixel",
              .summary = "Follows a ray from each pixel to each of the level's lights, with Embree.",
              .article = kSurfaceCaching,
              .heading = "The quest for alternative lighting",
              .replaces = "surfaces, spans",
              .expected = "The best light, with sharp shadows, and too slow. Here, light from other walls "
                          "is missing.",
              .max_wrong_share = 0,
              .parameters = kRayLightParameters,
              .make_stages = make_ray_light,
              .check_level = check_ray_light},
    Technique{.name = "rebuilt-surfaces",
              .title = "Surfaces that are built again",
              .summary = "Builds surfaces in each frame, as if their light always changed.",
              .article = kSurfaceCaching,
              .heading = "Two final notes on surface caching",
              .replaces = "surfaces",
              .expected = "A frame takes as long as building and drawing surfaces together: noticeably "
                          "longer, and tolerable. Half of the surfaces in each frame take half of that.",
              .max_wrong_share = 0,
              .parameters = kRebuiltParameters,
              .make_stages = make_rebuilt_surfaces},
    Technique{.name = "procedural-texels",
              .title = "Procedural texels in surfaces",
              .summary = "Computes noise, water, or fire onto each surface when it is built.",
              .article = kSurfaceCaching,
              .heading = "Two final notes on surface caching",
              .replaces = "surfaces",
              .expected = "Cached with the surface, so a frame takes no longer. Patterns that move take the "
                          "time of building.",
              .max_wrong_share = 0,
              .parameters = kProceduralParameters,
              .make_stages = make_procedural_texels,
              .changes_texels = true},
    Technique{
        .name = "marked-surfaces",
        .title = "Marks in surfaces",
        .summary = "Paints translucent marks onto each surface when it is built.",
        .article = kSurfaceCaching,
        .heading = "Two final notes on surface caching",
        .replaces = "surfaces",
        .expected = "Cached with the surface, so a frame takes no longer, however many marks there are.",
        .max_wrong_share = 0,
        .parameters = kMarkedParameters,
        .make_stages = make_marked_surfaces,
        .changes_texels = true},
    kModelsInEdges,
    kModelsInLeaves,
    kModelSprites,
    kFloodFill,
    kDeltas,
    kVertexBoxes,
    kAffineModels,
    kSubdividedModels,
    kTriangleMasks,
    kStackMeshes,
    kCompiledTriangles,
};

// Parses "NAME=VALUE" into the value of that parameter.
base::Status set_parameter(std::string_view text, Choice& io_choice) {
  const Technique& technique = *io_choice.technique;
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const auto found = std::ranges::find(technique.parameters, name, &Parameter::name);
  if (found == technique.parameters.end()) {
    if (technique.parameters.empty())
      return base::error(ErrorCode::kUnsupported, "{} has no parameters, so \"{}\" cannot be set",
                         technique.name, base::quotable(text));
    std::vector<std::string_view> names;
    std::ranges::transform(technique.parameters, std::back_inserter(names), &Parameter::name);
    return base::error(ErrorCode::kUnsupported, "{} has no parameter \"{}\"; it has {}", technique.name,
                       base::quotable(name), fmt::join(names, ", "));
  }
  const std::optional<double> value =
      base::parse_number<double>(text.substr(std::min(equals + 1, text.size())));
  const auto is_whole = [](double number) { return std::trunc(number) == number; };
  const bool must_be_whole = is_whole(found->min) && is_whole(found->max);
  // "nan" is neither below nor above the bounds.
  const bool is_inside = value && *value >= found->min && *value <= found->max;
  if (!is_inside || (must_be_whole && !is_whole(*value)))
    return base::error(ErrorCode::kUnsupported, "{}: \"{}\" must be {}=N, with {}N from {} to {}",
                       technique.name, base::quotable(text), name, must_be_whole ? "a whole " : "",
                       found->min, found->max);
  io_choice.values[static_cast<std::size_t>(found - technique.parameters.begin())] = *value;
  return base::Ok{};
}

}  // namespace

std::span<const Technique> list_techniques() {
  return kTechniques;
}

Choice make_default_choice(std::size_t number) {
  Choice choice{&kTechniques[number], {}};
  std::ranges::transform(choice.technique->parameters, std::back_inserter(choice.values), &Parameter::value);
  return choice;
}

base::Result<Choice> parse_choice(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto found = std::ranges::find(kTechniques, text.substr(0, colon), &Technique::name);
  if (found == kTechniques.end())
    return base::error(ErrorCode::kUnsupported, "there is no technique \"{}\"; `temblor lab list` lists them",
                       base::quotable(text.substr(0, colon)));
  Choice choice = make_default_choice(static_cast<std::size_t>(found - kTechniques.begin()));
  for (const std::string_view word : base::split_words(text.substr(std::min(colon + 1, text.size())), ","))
    TRY_STATUS(set_parameter(word, choice));
  return choice;
}

}  // namespace temblor::lab
