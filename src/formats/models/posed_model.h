// The form in which MD3 and MD5 models are drawn: meshes with the positions and normals of all vertices in
// every pose, and the pictures of their skins.
//
// An MD5 model is skinned once, when it is loaded. The renderer blends two poses linearly, and the blend of
// two skinned poses equals skinning with linearly blended joint matrices, so nothing is lost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "formats/images/picture.h"
#include "formats/models/md3.h"
#include "formats/models/md5.h"
#include "formats/models/mdl.h"
#include "math/vec.h"

namespace temblor::formats {

// Limit of the vertices of all meshes in all poses. 8 bytes are kept for each.
constexpr std::size_t kMaxPosedVertices = kMaxMd3PosedVertices;

// The triangles that share a skin.
struct PosedMesh {
  std::vector<std::string> skins;  // names of skins in the file, by skin number; may be empty
  std::vector<math::Vec2> texels;  // by vertex; 0 to 1 across the skin, which repeats
  std::vector<std::array<std::uint32_t, 3>> triangles;  // clockwise seen from outside
  // Pose by pose, each texels.size().
  std::vector<math::Vec3> positions;
  std::vector<std::uint8_t> normals;  // indices into mdl_normals()
};

// A frame: one pose, or a group of poses that play as an animation, as in MdlFrame.
struct PosedFrame {
  std::uint32_t first_pose = 0, count = 1;
  std::vector<float> end_times_s;  // empty: not a group
};

// A skin: a picture for each mesh, or an animated group of them, as in MdlSkin.
struct PosedSkin {
  std::vector<std::vector<Picture>> pictures;  // by member of the group, then by mesh
  std::vector<float> end_times_s;              // empty: not a group
};

struct PosedModel {
  std::vector<PosedMesh> meshes;
  std::size_t pose_count = 0;      // at least 1
  std::vector<PosedFrame> frames;  // at least one
  std::vector<PosedSkin> skins;    // none until they are loaded
  std::uint32_t flags = 0;         // MdlFlags
  bool random_phase = false;
};

// Both make one frame of each pose, and leave the skins empty. Fail if the animation is for another skeleton,
// the model has no vertices or too many, or its vertices are farther away than kMaxMdlCoordinate.
base::Result<PosedModel> pose_md5(const Md5Model& model, const Md5Animation& animation);
base::Result<PosedModel> pose_md3(const Md3& md3);

// Gives the model the frame groups and effects of the MDL file that it replaces. Its poses correspond to
// those of the file, in order; frames that have none left show the last pose.
void take_frames(const Mdl& mdl, PosedModel& io_model);

// Returns the box around all vertices in all poses.
math::Bounds compute_bounds(const PosedModel& model);

}  // namespace temblor::formats
