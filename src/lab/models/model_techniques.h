// The entries of the registry for models (registry.cpp).
#pragma once

#include <array>

#include "lab/models/affine_models.h"
#include "lab/models/deltas/deltas.h"
#include "lab/models/flood_fill.h"
#include "lab/models/leaves/models_in_leaves.h"
#include "lab/models/model_sprites.h"
#include "lab/models/models_in_edges.h"
#include "lab/models/small/compiled_triangles.h"
#include "lab/models/small/triangle_masks.h"
#include "lab/models/stack/stack_meshes.h"
#include "lab/models/subdivided_models.h"
#include "lab/models/vertex_boxes.h"

namespace temblor::lab {

constexpr std::string_view kTriangleModels = "Surface Caching Revisited, Quake's Triangle Models, and More";

constexpr std::array kAffineModelsParameters{
    Parameter{"subpixel", 1, 0, 1, "1: vertices at multiples of 1/256 pixel; 0: at whole pixels"},
    Parameter{"perspective", 0, 0, 1,
              "0: texels are linear on the screen; 1: divided by depth at each pixel"}};
constexpr std::array kSubdividedModelsParameters{
    Parameter{"light", 0, 0, 1, "0: one light for each triangle; 1: split with the sides, like texels"}};

constexpr std::array kModelSpritesParameters{
    Parameter{"frames", 2, 1, 60, "frames that a picture is used for, with the one that it is made in"}};

constexpr std::array kModelsInEdgesParameters{
    Parameter{"tree", 0, 0, 1, "0: the edges of a row are a linked list; 1: a balanced tree"},
    Parameter{"triangles", 300000, 1, 1e7, "triangles of a scene's models; one with more is refused"}};

constexpr Technique kModelsInEdges{
    .name = "models-in-edges",
    .title = "Models in an edge list",
    .summary = "Turns the triangles of models into edges and spans, as the world's faces are.",
    .article = kTriangleModels,
    .heading = "Drawing triangle models fast",
    .replaces = "models",
    .expected =
        "Too slow for thousands of small triangles, each of which has few pixels for its edges. A tree "
        "helps, but not enough.",
    .max_wrong_share = 0,
    .parameters = kModelsInEdgesParameters,
    .make_stages = make_models_in_edges,
    .draws_models = true,
    .check_scene = check_models_in_edges};
constexpr std::array kModelsInLeavesParameters{
    Parameter{"cut", 1, 0, 1, "1: cuts triangles at BSP planes; 0: paints a model in its middle's leaf"}};

constexpr Technique kModelsInLeaves{
    .name = "models-in-leaves",
    .title = "Models cut into leaves",
    .summary = "Paints the parts of models leaf by leaf, from back to front, together with the world.",
    .article = "Consider the Alternatives: Quake's Hidden-Surface Removal",
    .heading = "Drawing moving objects",
    .replaces = "scan, spans, models",
    .expected =
        "Does not sort several models in a leaf, and leaves ugly errors within complex models. Cutting takes "
        "time.",
    .max_wrong_share = 0.001,
    .parameters = kModelsInLeavesParameters,
    .make_stages = make_models_in_leaves,
    .draws_models = true};
constexpr Technique kModelSprites{
    .name = "model-sprites",
    .title = "Models as sprites",
    .summary = "Keeps the picture of each model for some frames, and moves it with the model.",
    .article = kTriangleModels,
    .heading = "An idea that didn't work",
    .replaces = "models",
    .expected = "Jerky cardboard cutouts. With two frames for each picture, hardly faster; near, slower.",
    .max_wrong_share = 0,
    .parameters = kModelSpritesParameters,
    .make_stages = make_model_sprites,
    .draws_models = true};
constexpr Technique kVertexBoxes{
    .name = "vertex-boxes",
    .title = "Vertices as boxes",
    .summary = "Draws each vertex of a model as 2x2 pixels, and no triangles.",
    .article = kTriangleModels,
    .heading = "An idea that did work",
    .replaces = "models",
    .expected = "Sometimes the shape of the model, and gaps where its triangles are large.",
    .max_wrong_share = 0,
    .parameters = {},
    .make_stages = make_vertex_boxes,
    .draws_models = true};
constexpr Technique kFloodFill{
    .name = "flood-fill",
    .title = "Filled outlines",
    .summary = "Draws the outline of a model, and floods its inside with the colors of outline and vertices.",
    .article = kTriangleModels,
    .heading = "An idea that did work",
    .replaces = "models",
    .expected = "None: the idea was dropped before anybody tried it. Blobs of about the right colors.",
    .max_wrong_share = 0,
    .parameters = {},
    .make_stages = make_flood_fill,
    .draws_models = true};
constexpr std::array kDeltasParameters{
    Parameter{"seeds", 0, 0, 1, "0: as many seeds as a model needs; 1: only one"}};

constexpr Technique kDeltas{
    .name = "deltas",
    .title = "A walk around the visible side",
    .summary = "Goes from a visible triangle to its neighbors, which reuse the steps along the shared edge.",
    .article = kTriangleModels,
    .heading = "An idea that did work",
    .replaces = "models",
    .expected =
        "None: the idea was dropped before anybody tried it. Back triangles and hidden edges cost little.",
    .max_wrong_share = 0,
    .parameters = kDeltasParameters,
    .make_stages = make_deltas,
    .draws_models = true};
constexpr std::array kStackMeshesParameters{
    Parameter{"stack", 16, 4, 64, "vertices that the stack has room for"},
    Parameter{"group", 64, 0, 64, "vertices that are loaded together, in sixteens; 0: each on its own"}};

constexpr Technique kStackMeshes{
    .name = "stack-meshes",
    .title = "Meshes from a stack",
    .summary = "Sends vertices to a small stack, and draws triangles from there, in an order that needs few.",
    .article = kTriangleModels,
    .heading = "Some more ideas that might work",
    .replaces = "models",
    .expected =
        "Very good use of the cache, because vertices stay in a tiny stack, and commands are read once.",
    .max_wrong_share = 0,
    .parameters = kStackMeshesParameters,
    .make_stages = make_stack_meshes,
    .draws_models = true};
constexpr Technique kAffineModels{
    .name = "affine-models",
    .title = "Models by scan lines",
    .summary = "Draws models of any size by scan lines, with textures that ignore perspective.",
    .article = kTriangleModels,
    .heading = "Drawing triangle models fast",
    .replaces = "models",
    .expected = "Textures bend slightly, and vertices at whole pixels jump. In motion, neither shows.",
    .max_wrong_share = 0,
    .parameters = kAffineModelsParameters,
    .make_stages = make_affine_models,
    .draws_models = true};
constexpr Technique kSubdividedModels{
    .name = "subdivided-models",
    .title = "Models by subdivision",
    .summary = "Draws models of any size by splitting triangles until all sides are a pixel long.",
    .article = kTriangleModels,
    .heading = "An idea that did work",
    .replaces = "models",
    .expected =
        "A fifth faster than scan lines for small triangles. From 12 feet or 30 to 40 feet on, it "
        "looks the same.",
    .max_wrong_share = 0,
    .parameters = kSubdividedModelsParameters,
    .make_stages = make_subdivided_models,
    .draws_models = true};

constexpr std::array kTriangleMasksParameters{
    Parameter{"side", 5, 1, 5, "triangles up to so many pixels high and wide have masks"}};

constexpr Technique kTriangleMasks{
    .name = "triangle-masks",
    .title = "Precalculated masks",
    .summary = "Looks up the pixels of each small triangle in a table of all of them.",
    .article = kTriangleModels,
    .heading = "Some more ideas that might work",
    .replaces = "models",
    .expected = "Faster than subdivision for small triangles, with a table of reasonable size.",
    .max_wrong_share = 0,
    .parameters = kTriangleMasksParameters,
    .make_stages = make_triangle_masks,
    .draws_models = true};

constexpr std::array kCompiledTrianglesParameters{
    Parameter{"side", 5, 1, 5, "triangles up to so many pixels high and wide have code"},
    Parameter{"code", 0, 0, 1, "0: C++ from the build; 1: x86-64 code that is assembled at the start"}};

constexpr Technique kCompiledTriangles{
    .name = "compiled-triangles",
    .title = "Precompiled drawing code",
    .summary = "Calls code that draws the pixels of one shape, for each small triangle.",
    .article = kTriangleModels,
    .heading = "Some more ideas that might work",
    .replaces = "models",
    .expected = "Could be faster than masks, with code of reasonable size.",
    .max_wrong_share = 0,
    .parameters = kCompiledTrianglesParameters,
    .make_stages = make_compiled_triangles,
    .check_level = check_compiled_triangles,
    .draws_models = true};

}  // namespace temblor::lab
