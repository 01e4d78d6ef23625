// Writes MD3 and MD5 files from their public descriptions, because no tool that we can install does.
#pragma once

#include <cstdint>
#include <string>

#include "base/bytes.h"
#include "formats/models/md3.h"
#include "formats/models/md5.h"
#include "formats/models/mdl.h"

namespace temblor::test {

// A file with one surface header after the other, and without tags.
base::ByteVector write_md3(const formats::Md3& md3);

// Converts each pose of the MDL file to a frame of one surface with this shader. Exact if the file's scale
// and origin are multiples of formats::kMd3Units, and its skin's sides are powers of two. Normals are not
// those of the file, but all along x.
formats::Md3 convert_to_md3(const formats::Mdl& mdl, const std::string& shader);

// The texts of an .md5mesh and an .md5anim.
struct Md5Sample {
  std::string mesh, animation;
};

// The places of joints relative to their parents, by frame and joint.
using Md5Frames = std::vector<std::vector<formats::Md5JointPose>>;

std::string write_md5_mesh(const formats::Md5Model& model);
// Writes all six components of each joint in each frame.
std::string write_md5_animation(const std::vector<formats::Md5Joint>& joints, const Md5Frames& frames);

// Converts an MDL file exactly: each vertex hangs on a joint of its own. It must have at most kMaxMd5Joints
// vertices, those on the seam twice.
Md5Sample convert_to_md5(const formats::Mdl& mdl, const std::string& shader);

// A column along z, 96 units high and 24 wide, that is bent by a chain of three joints to and fro. It has
// 2 * sides * rings triangles, of which each ring of vertices hangs on two joints, and no caps. Its skin goes
// once around it.
Md5Sample bending_column(std::uint32_t sides, std::uint32_t rings, std::uint32_t frames,
                         const std::string& shader);

}  // namespace temblor::test
