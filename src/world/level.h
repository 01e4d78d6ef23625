// An immutable level: the contents of a .bsp file in the form that the renderer, traces, and the server need.
//
// make_level() computes everything once; nothing in a Level changes afterwards, so threads share it freely.
// Lists refer to each other by index, and formats::read_bsp() has validated every index:
//
//   Model --> head node --> Node --> Leaf --> marked_faces --> Face --> surfedges --> edges --> vertices
//         \-> clip_heads --> Clipnode                             \--> texture_axes, textures, light samples
//
// Frame-dependent state never goes in here; its owners keep it in arrays by FaceIndex and so on.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/index.h"
#include "base/result.h"
#include "formats/images/colored_texture.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "formats/levels/light_grid.h"
#include "formats/levels/lit.h"
#include "math/vec.h"

namespace temblor::world {

enum class FaceIndex : std::uint32_t {};
enum class LeafIndex : std::uint32_t {};
enum class NodeIndex : std::uint32_t {};
enum class TextureIndex : std::uint32_t {};
enum class ModelIndex : std::uint32_t {};  // 0 is the world

// The contents of a leaf or a point. Entities in a current are pushed along: angles in degrees, or up and
// down. Values are those of the file.
enum class Contents : std::int32_t {
  kEmpty = -1,
  kSolid = -2,
  kWater = -3,
  kSlime = -4,
  kLava = -5,
  kSky = -6,
  kCurrent0 = -9,
  kCurrent90 = -10,
  kCurrent180 = -11,
  kCurrent270 = -12,
  kCurrentUp = -13,
  kCurrentDown = -14,
};

// All points p with dot(p, normal) == distance. The front is where the normal points.
struct Plane {
  math::Vec3 normal;
  float distance;
  std::int32_t axis;  // 0 to 2: the normal is the positive x, y, or z axis; 3: any other normal
};

// Signed distance from the plane in units, positive in front. Computed in double precision, so that all
// queries agree about points close to a plane.
inline double distance_to(const Plane& plane, const math::Vec3d& point) {
  const double along = plane.axis < 3 ? point[plane.axis] : glm::dot(point, math::Vec3d(plane.normal));
  return along - double{plane.distance};
}

// A child of a node: another node, or a leaf.
struct Child {
  std::int32_t value;  // >= 0: node; < 0: leaf ~value
  bool is_leaf() const { return value < 0; }
  LeafIndex leaf() const { return static_cast<LeafIndex>(static_cast<std::uint32_t>(~value)); }
  NodeIndex node() const { return static_cast<NodeIndex>(static_cast<std::uint32_t>(value)); }
};

// An inner node of hull 0: divides a convex part of space by a plane.
struct Node {
  std::uint32_t plane;
  std::array<Child, 2> children;  // front, back
  math::Bounds bounds;
  std::uint32_t first_face, face_count;  // the faces in its plane, on both sides
};

// A convex part of space with the same contents everywhere. Leaf 0 is the solid that all solid space shares.
struct Leaf {
  Contents contents;
  std::int32_t visibility_offset;  // of its PVS row in Level::visibility; -1: sees everything
  math::Bounds bounds;
  std::uint32_t first_marked_face, marked_face_count;  // into Level::marked_faces
  std::array<std::uint8_t, 4> ambient;                 // sound levels of water, sky, slime, lava
};

enum class FaceKind : std::uint8_t {
  kLit,  // black if it has no samples (light == kNoLight)
  kSky,
  kLiquid,
  kUnlit,  // an ordinary texture, drawn full-bright
};

constexpr std::uint32_t kNoLight = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint8_t kNoStyle = 255;

// A light map that does not have its samples at every 16th texel (BSPX LMSHIFT, DECOUPLED_LM).
struct LightMapGrid {
  std::int32_t width, height;  // in samples, at least 1
  // The position in the grid of the face's first texel, and how far it moves for one texel along s and t. The
  // sample at column x, row y lies where the position is (x, y).
  math::Vec2d first, per_s, per_t;
  // How closely the light must be computed: a power of two from 1 to 16. Between multiples of so many texels,
  // light may be interpolated.
  std::int32_t texels;

  // The position of a texel that is s, t texels from the face's first one. It may be outside of the grid,
  // where the light is that of the nearest sample.
  math::Vec2d position(double s, double t) const { return first + per_s * s + per_t * t; }
};
constexpr std::uint32_t kStockGrid = std::numeric_limits<std::uint32_t>::max();

// A convex polygon in a plane. Its vertices run clockwise seen from its front. Its light samples are stored
// as one grid after another, row by row:
//
//   light -> | style 0: width x height samples (Level::light_size) | style 1 | ... | style_count - 1 |
//
// The renderer adds the grids, each multiplied by the current value of its light style.
struct Face {
  std::uint32_t plane;
  bool back_side;  // its front is the back of the plane
  FaceKind kind;
  std::uint8_t style_count;            // used entries of `styles`: one grid of light samples each
  std::array<std::uint8_t, 4> styles;  // below kLightStyles (animation.h); unused: kNoStyle
  std::uint32_t first_surfedge, surfedge_count;
  std::uint32_t axes;  // into Level::texture_axes
  TextureIndex texture;
  std::uint32_t light;  // first sample in Level::light (gray) and, x3, Level::light_rgb; or kNoLight
  std::array<std::int32_t, 2> texture_mins;     // s, t of the surface's first texel, multiples of 16
  std::array<std::int32_t, 2> texture_extents;  // size in texels, multiples of 16

  std::uint32_t light_map_grid =
      kStockGrid;  // into Level::light_map_grids; kStockGrid: a sample every 16 texels

  // Size of a stock light map: one sample at each multiple of 16 texels, both ends included.
  std::int32_t light_width() const { return texture_extents[0] / 16 + 1; }
  std::int32_t light_height() const { return texture_extents[1] / 16 + 1; }

  // Larger than the faces of most levels. A hostile file may hold many huge ones, each of which would take
  // memory when it is drawn with light. So the size of the file bounds how many have light.
  bool is_large() const { return std::max(texture_extents[0], texture_extents[1]) > 512; }
};

// Projects positions to texture coordinates: s = dot(position, s_axis) + s_offset, in texels of mip 0, and t
// in the same way. Textures repeat.
struct TextureAxes {
  math::Vec3 s_axis;
  float s_offset;
  math::Vec3 t_axis;
  float t_offset;
};

// From the name: "sky...", "*..." for liquids ("!..." too in Half-Life), "{..." for cutouts whose index 255
// is transparent.
enum class TextureKind : std::uint8_t { kOpaque, kCutout, kSky, kLiquid };

// Always drawable: a texture that is missing from the level is a 64 x 64 checkerboard with `missing` set.
struct Texture {
  std::string name;
  TextureKind kind = TextureKind::kOpaque;
  bool missing = false;
  std::uint32_t width = 1, height = 1;  // of mip 0, at least 1, any size
  // Mip level k: (max(1, width >> k)) x (max(1, height >> k)) palette indices, row by row.
  std::array<std::vector<std::uint8_t>, 4> mips;
  // Set if the texture has colors of its own, which 32-bit frames show. `mips` then holds the nearest palette
  // entries. Shared, because it is large and levels are copied when others are joined to them.
  std::shared_ptr<const formats::TextureColors> colors;
  // Animation: `frames` is the sequence that this texture belongs to (+0.. or +a..; real levels use both on
  // the world itself), `alternate_frames` the other one. Empty if there is no sequence or if it has gaps. See
  // animation.h.
  std::vector<TextureIndex> frames, alternate_frames;

  // The largest mip level: 0, or below 0 for pictures with more texels than the level's texture.
  int finest_mip() const { return colors ? -colors->detail : 0; }
  // The palette indices of a mip level, finest_mip() to 3.
  const std::vector<std::uint8_t>& indices(int mip) const {
    return mip < 0 ? colors->fine_indices[static_cast<std::size_t>(-mip - 1)]
                   : mips[static_cast<std::size_t>(mip)];
  }
};

// A brush model: the world, or the shape of an entity such as a door, at the position where the mapper drew
// it.
struct Model {
  math::Bounds bounds;  // expanded by one unit on every side, as in the original
  math::Vec3 origin;
  Child head;                              // hull 0
  std::array<std::int32_t, 3> clip_heads;  // hulls 1 to 3: a clipnode, or contents if negative
  std::uint32_t first_face, face_count;
};

// The keys of a Half-Life level's brush entity that matter without game code: for movement, which client and
// server share, and for drawing.
struct BrushEntity {
  // Never solid: func_illusionary, func_water, and doors that turn, since those do not open.
  bool is_passable = false;
  // func_water: the space of its model is this liquid. kEmpty: none.
  Contents liquid = Contents::kEmpty;
  math::Vec3 origin{0.0f};  // of the model
  // "rendermode" 5 adds the model to the picture; 1 draws it in one color.
  bool is_additive = false;
  std::optional<formats::Rgb> color;
};

// A node of the clip hulls. Unlike a Node it has no bounds and no faces, and its leaves are just contents.
struct Clipnode {
  std::uint32_t plane;
  std::array<std::int32_t, 2> children;  // negative: contents
};

// The boxes by which a level's clip hulls 1 to 3 were expanded, each around the origin of a trace. The map
// compiler chooses them, so they depend on the version of the file.
using HullBoxes = std::array<math::Bounds, 3>;
// The boxes of Quake: a player, a large monster; hull 3 is not used.
constexpr HullBoxes kQuakeHulls = {
    {{{-16, -16, -24}, {16, 16, 32}}, {{-32, -32, -24}, {32, 32, 64}}, {{-32, -32, -24}, {32, 32, 64}}}};
// The boxes of Half-Life (version 30): a standing player, a large monster, a ducking player.
constexpr HullBoxes kHalfLifeHulls = {
    {{{-16, -16, -36}, {16, 16, 36}}, {{-32, -32, -32}, {32, 32, 32}}, {{-16, -16, -18}, {16, 16, 18}}}};

// Distinguishes levels. A cache for a level keeps a copy of the level's identity pointer; as long as it does,
// no other level can have the same identity.
struct LevelIdentity {};

struct Level {
  std::shared_ptr<const LevelIdentity> identity = std::make_shared<const LevelIdentity>();
  std::string name;
  std::vector<formats::Entity> entities;
  // From a file of version 30: made for Half-Life, with its hulls and classes of entities.
  bool is_half_life = false;
  HullBoxes hull_boxes = kQuakeHulls;
  std::vector<Plane> planes;
  std::vector<Node> nodes;
  std::vector<Leaf> leaves;
  std::vector<Clipnode> clipnodes;
  std::vector<Face> faces;
  std::vector<FaceIndex> marked_faces;
  std::vector<math::Vec3> vertices;
  std::vector<formats::BspEdge> edges;
  std::vector<std::int32_t> surfedges;  // negative: edge -value, end to start
  std::vector<TextureAxes> texture_axes;
  std::vector<Texture> textures;  // at least one; the last one is the placeholder for missing textures
  std::vector<Model> models;
  std::vector<BrushEntity> brush_entities;  // by model in Half-Life's levels, empty in others
  std::vector<std::uint8_t> visibility;     // run-length encoded rows
  std::uint32_t visible_leaf_count = 0;     // leaves 1 to count take part in the PVS
  bool has_light = false;                   // false: the level was never lit; every face is drawn full-bright
  std::vector<std::uint8_t> light;          // gray samples, 0 to 255
  std::vector<std::uint8_t> light_rgb;      // 3 x light.size(), or empty if the level has no colored light
  std::vector<LightMapGrid> light_map_grids;
  std::optional<formats::LightGrid> light_grid;  // of open space, for models; most levels have none
  std::vector<std::string> notes;                // faults of the file that were passed over

  const Face& face(FaceIndex index) const { return faces[base::to_size(index)]; }
  // The size of a face's light map in samples.
  std::array<std::int32_t, 2> light_size(const Face& face) const {
    if (face.light_map_grid == kStockGrid) return {face.light_width(), face.light_height()};
    return {light_map_grids[face.light_map_grid].width, light_map_grids[face.light_map_grid].height};
  }
  const Leaf& leaf(LeafIndex index) const { return leaves[base::to_size(index)]; }
  const Node& node(NodeIndex index) const { return nodes[base::to_size(index)]; }
  const Texture& texture(TextureIndex index) const { return textures[base::to_size(index)]; }
  const Model& world() const { return models[0]; }

  // Returns the vertex where surfedge `position` (an index into surfedges) starts. The vertices of a face are
  // the starts of its surfedges. A negative surfedge is the reverse of edge -value, so that two faces can
  // share an edge.
  std::uint32_t surfedge_start(std::size_t position) const {
    const std::int32_t edge = surfedges[position];
    return edge >= 0 ? edges[static_cast<std::size_t>(edge)].vertices[0]
                     : edges[static_cast<std::size_t>(-static_cast<std::int64_t>(edge))].vertices[1];
  }
};

// By index into Bsp::miptexes; may be shorter.
using ColoredTextures = std::vector<std::optional<formats::ColoredTexture>>;

// Makes a level from `bsp`, which read_bsp() must have validated. Colored light comes from `lit` if given,
// else from the BSPX lump RGBLIGHTING, else there is none. `lit` must have the right size; a lump of another
// size is ignored, with a note, and so are a damaged light grid and faults of the entity text. Light maps
// come from DECOUPLED_LM, else from LMSHIFT, else from the faces; damaged lumps are ignored, with a note. A
// face whose light is outside of the samples has none, with a note. `colored` replaces the texels of the
// textures of bsp.miptexes with the same index; each must fit its texture's size. A light style above 63 is
// style 0. A face larger than any real level's (over 2^20 texels) is left out, with a note. Large faces have
// no light if others share the light samples too often, with a note.
base::Result<std::shared_ptr<const Level>> make_level(formats::Bsp bsp, std::string name,
                                                      const formats::Lit* lit = nullptr,
                                                      ColoredTextures colored = {});

}  // namespace temblor::world
