// An immutable level: what a .bsp holds, in the shape that the renderer, traces and the game ask for.
// make_level works everything out once; nothing in a Level changes afterwards.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/index.h"
#include "base/result.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "formats/levels/lit.h"
#include "math/vec.h"

namespace temblor::world {

enum class FaceIndex : std::uint32_t {};
enum class LeafIndex : std::uint32_t {};
enum class NodeIndex : std::uint32_t {};
enum class TextureIndex : std::uint32_t {};
enum class ModelIndex : std::uint32_t {};  // 0 is the world

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

struct Plane {
  math::Vec3 normal;
  float distance;
  std::int32_t axis;  // 0-2: the normal is that axis, positive; 3: any other
};

// How far in front of the plane the point lies, in units; negative behind it. Double, so that every query
// agrees about points close to a plane.
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

struct Node {
  std::uint32_t plane;
  std::array<Child, 2> children;  // front, back
  math::Bounds bounds;
  std::uint32_t first_face, face_count;  // the faces that lie in its plane
};

struct Leaf {
  Contents contents;
  std::int32_t visibility_offset;  // -1: sees everything
  math::Bounds bounds;
  std::uint32_t first_marked_face, marked_face_count;  // into Level::marked_faces
  std::array<std::uint8_t, 4> ambient;                 // water, sky, slime, lava
};

enum class FaceKind : std::uint8_t {
  kLit,  // black when it has no samples (light == kNoLight)
  kSky,
  kLiquid,
  kUnlit,  // an ordinary texture, drawn full-bright
};

constexpr std::uint32_t kNoLight = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint8_t kNoStyle = 255;

// A polygon. Its vertices run clockwise seen from its front.
struct Face {
  std::uint32_t plane;
  bool back_side;  // looks against its plane's normal
  FaceKind kind;
  std::uint8_t style_count;            // leading used entries of styles
  std::array<std::uint8_t, 4> styles;  // below kLightStyles (animation.h); unused: kNoStyle
  std::uint32_t first_surfedge, surfedge_count;
  std::uint32_t axes;  // into Level::texture_axes
  TextureIndex texture;
  std::uint32_t light;  // first sample in Level::light (gray) and, x3, Level::light_rgb; or kNoLight
  std::array<std::int32_t, 2> texture_mins;  // s, t of the surface's first texel, multiples of 16
  std::array<std::int32_t, 2>
      texture_extents;  // texels, multiples of 16; light samples are extent / 16 + 1 each way

  std::int32_t light_width() const { return texture_extents[0] / 16 + 1; }
  std::int32_t light_height() const { return texture_extents[1] / 16 + 1; }
};

// s = dot(position, s_axis) + s_offset, in texels of mip 0; t alike.
struct TextureAxes {
  math::Vec3 s_axis;
  float s_offset;
  math::Vec3 t_axis;
  float t_offset;
};

enum class TextureKind : std::uint8_t { kOpaque, kCutout, kSky, kLiquid };

// Always drawable: a texture that the level lacks is a 64 x 64 checker with `missing` set.
struct Texture {
  std::string name;
  TextureKind kind = TextureKind::kOpaque;
  bool missing = false;
  std::uint32_t width = 1, height = 1;  // of mip 0, at least 1, any size
  // Mip level k: (max(1, width >> k)) x (max(1, height >> k)) palette indices, row by row.
  std::array<std::vector<std::uint8_t>, 4> mips;
  // Animation: `frames` is the sequence that this texture belongs to (+0.. or +a..; real levels use either on
  // the world itself), `alternate_frames` the other of the two. Empty when there is none, or one with gaps.
  std::vector<TextureIndex> frames, alternate_frames;
};

struct Model {
  math::Bounds bounds;  // grown by one unit, as players' engines do
  math::Vec3 origin;
  Child head;                              // hull 0
  std::array<std::int32_t, 3> clip_heads;  // hulls 1..3: clipnode, or contents when negative
  std::uint32_t first_face, face_count;
};

struct Clipnode {
  std::uint32_t plane;
  std::array<std::int32_t, 2> children;  // negative: contents
};

// Tells levels apart, whatever their addresses: whoever works something out for a level keeps a copy of its
// identity, and no later level can have the same.
struct LevelIdentity {};

struct Level {
  std::shared_ptr<const LevelIdentity> identity = std::make_shared<const LevelIdentity>();
  std::string name;
  std::vector<formats::Entity> entities;
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
  std::vector<Texture> textures;  // at least one: the last one stands for textures that are not there at all
  std::vector<Model> models;
  std::vector<std::uint8_t> visibility;  // run-length coded rows
  std::uint32_t visible_leaf_count = 0;  // leaves 1..count take part in the PVS
  bool has_light = false;                // false: the level was never lit; every face is drawn full-bright
  std::vector<std::uint8_t> light;       // gray samples
  std::vector<std::uint8_t> light_rgb;   // 3 x light.size(), or empty when the level has no colored light

  const Face& face(FaceIndex index) const { return faces[base::to_size(index)]; }
  const Leaf& leaf(LeafIndex index) const { return leaves[base::to_size(index)]; }
  const Node& node(NodeIndex index) const { return nodes[base::to_size(index)]; }
  const Texture& texture(TextureIndex index) const { return textures[base::to_size(index)]; }
  const Model& world() const { return models[0]; }

  // The vertex where surfedge `position` (an index into surfedges) starts.
  std::uint32_t surfedge_start(std::size_t position) const {
    const std::int32_t edge = surfedges[position];
    return edge >= 0 ? edges[static_cast<std::size_t>(edge)].vertices[0]
                     : edges[static_cast<std::size_t>(-static_cast<std::int64_t>(edge))].vertices[1];
  }
};

// `bsp` was validated by its reader. Colored light, in this order: `lit` when given (its size must match,
// else an error), the BSPX lump RGBLIGHTING (likewise), none. Fails when the entity text does not parse, when
// a face's light lies outside the samples or has a style past 63, or when a face has an extent that no real
// level has (over 2^20 texels).
base::Result<std::shared_ptr<const Level>> make_level(formats::Bsp bsp, std::string name,
                                                      const formats::Lit* lit = nullptr);

}  // namespace temblor::world
