// MD5 models, version 10 (id Tech 4; the 2021 release of Quake has one for each of its alias models): a mesh
// whose vertices hang on the joints of a skeleton, and animations that move the joints.
//
//   NAME.md5mesh  joints    "NAME" PARENT ( position ) ( orientation )     in model space
//                 mesh      shader "NAME"
//                           vert NUMBER ( s t ) FIRST_WEIGHT WEIGHT_COUNT
//                           tri NUMBER VERTEX VERTEX VERTEX              clockwise seen from outside
//                           weight NUMBER JOINT BIAS ( position )        relative to the joint
//   NAME.md5anim  hierarchy "NAME" PARENT FLAGS FIRST_COMPONENT
//                 baseframe ( position ) ( orientation )                 relative to the parent
//                 frame NUMBER { components }
//
// An orientation is a unit quaternion without its w, which is negative. Bit 0 to 5 of a joint's FLAGS: the
// frames have components that replace x, y, z of its position, and x, y, z of its orientation.
//
//   vertex = sum of BIAS * (joint position + joint orientation * weight position) over its weights
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// Limits of a file, far above those of the release.
constexpr std::uint32_t kMaxMd5Joints = 1 << 10, kMaxMd5Meshes = 1 << 6, kMaxMd5Vertices = 1 << 16,
                        kMaxMd5Triangles = 1 << 17, kMaxMd5Weights = 1 << 18, kMaxMd5Frames = 1 << 14;
// Limit of joints times frames, because a frame may be much shorter in the file than in memory.
constexpr std::size_t kMaxMd5JointPoses = 1 << 20;
constexpr float kMaxMd5Number = 1 << 20;  // of all numbers, either sign

// Where a joint is, in model space.
struct Md5JointPose {
  math::Vec3 position{0.0f};
  glm::quat orientation = glm::identity<glm::quat>();
  bool operator==(const Md5JointPose&) const = default;
};

struct Md5Joint {
  std::string name;
  std::int32_t parent = -1;  // an earlier joint; -1: none
  bool operator==(const Md5Joint&) const = default;
};

struct Md5Vertex {
  math::Vec2 texel{0.0f};  // 0 to 1 across the skin, from its upper left corner
  std::uint32_t first_weight = 0, weight_count = 0;
};

struct Md5Weight {
  std::uint32_t joint = 0;
  float bias = 0;
  math::Vec3 position{0.0f};  // relative to the joint
};

// The triangles that share a skin. All indices are in range, and all vertices together have at most as many
// weights as there are.
struct Md5Mesh {
  std::string shader;  // names the skin
  std::vector<Md5Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Md5Weight> weights;
};

struct Md5Model {
  std::vector<Md5Joint> joints;
  std::vector<Md5JointPose> bind_pose;  // by joint
  std::vector<Md5Mesh> meshes;          // at least one
};

struct Md5Animation {
  float frames_per_second = 0;
  std::vector<Md5Joint> joints;
  std::vector<std::vector<Md5JointPose>> poses;  // at least one, by frame; each by joint
};

// Errors name the line. The text ends at its first zero byte.
base::Result<Md5Model> read_md5_model(std::string_view text);
base::Result<Md5Animation> read_md5_animation(std::string_view text);

// Fails unless both have the same joints.
base::Status check_same_skeleton(const Md5Model& model, const Md5Animation& animation);

// Returns the positions of the mesh's vertices. `pose`: by joint of the mesh's model.
std::vector<math::Vec3> skin_vertices(const Md5Mesh& mesh, std::span<const Md5JointPose> pose);

}  // namespace temblor::formats
