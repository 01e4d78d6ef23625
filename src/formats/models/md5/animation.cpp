// NAME.md5anim: the joints at each frame.
#include <fmt/format.h>

#include <array>
#include <bit>

#include "base/text.h"
#include "formats/models/md5.h"
#include "formats/models/md5/joints.h"
#include "formats/models/md5/scanner.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kComponents = 6;  // of a joint: x, y, z of its position and of its orientation

// How the frames move a joint.
struct Track {
  std::uint32_t flags = 0;  // bit k: the frames have component k
  std::uint32_t first_component = 0;
  std::array<float, kComponents> base{};  // relative to the parent
};

struct AnimationHeader {
  std::uint32_t frame_count = 0, joint_count = 0, component_count = 0;
};

AnimationHeader read_header(Md5Scanner& io_scanner, Md5Animation& out_animation) {
  AnimationHeader header;
  read_md5_header(io_scanner);
  io_scanner.expect("numFrames");
  header.frame_count = static_cast<std::uint32_t>(io_scanner.whole_number(1, kMaxMd5Frames));
  io_scanner.expect("numJoints");
  header.joint_count = io_scanner.count(kMaxMd5Joints);
  if (std::size_t{header.frame_count} * header.joint_count > kMaxMd5JointPoses)
    io_scanner.fail(
        fmt::format("{} frames of {} joints are too many", header.frame_count, header.joint_count));
  io_scanner.expect("frameRate");
  out_animation.frames_per_second = io_scanner.number();
  io_scanner.expect("numAnimatedComponents");
  header.component_count = io_scanner.count(kMaxMd5Joints * kComponents);
  return header;
}

std::vector<Track> read_hierarchy(Md5Scanner& io_scanner, const AnimationHeader& header,
                                  Md5Animation& out_animation) {
  std::vector<Track> tracks;
  io_scanner.expect("hierarchy");
  io_scanner.expect("{");
  for (std::size_t number = 0; number < header.joint_count && io_scanner.ok(); ++number) {
    out_animation.joints.push_back(read_md5_joint(io_scanner, number));
    Track track;
    track.flags = static_cast<std::uint32_t>(io_scanner.whole_number(0, (1 << kComponents) - 1));
    const auto used = static_cast<std::uint32_t>(std::popcount(track.flags));
    const std::int32_t first = io_scanner.whole_number(0, static_cast<std::int32_t>(header.component_count));
    track.first_component = static_cast<std::uint32_t>(first);
    if (track.first_component + used > header.component_count)
      io_scanner.fail(fmt::format("joint {} has components {} to {}, but frames have {}", number, first,
                                  track.first_component + used, header.component_count));
    tracks.push_back(track);
  }
  io_scanner.expect("}");
  return tracks;
}

// Passes over the box of each frame.
void skip_bounds(Md5Scanner& io_scanner, const AnimationHeader& header) {
  if (!io_scanner.accept("bounds")) return;
  io_scanner.expect("{");
  for (std::uint32_t frame = 0; frame < header.frame_count && io_scanner.ok(); ++frame) {
    io_scanner.vec3();
    io_scanner.vec3();
  }
  io_scanner.expect("}");
}

void read_base_frame(Md5Scanner& io_scanner, std::vector<Track>& io_tracks) {
  io_scanner.expect("baseframe");
  io_scanner.expect("{");
  for (Track& track : io_tracks) {
    if (!io_scanner.ok()) break;
    const math::Vec3 position = io_scanner.vec3(), orientation = io_scanner.vec3();
    track.base = {position.x, position.y, position.z, orientation.x, orientation.y, orientation.z};
  }
  io_scanner.expect("}");
}

// Computes the joints' places in model space from the components of one frame.
std::vector<Md5JointPose> make_pose(const std::vector<Track>& tracks, const std::vector<Md5Joint>& joints,
                                    const std::vector<float>& components) {
  std::vector<Md5JointPose> pose;
  pose.reserve(tracks.size());
  for (std::size_t number = 0; number < tracks.size(); ++number) {
    const Track& track = tracks[number];
    std::array<float, kComponents> values = track.base;
    std::size_t next = track.first_component;
    for (std::size_t component = 0; component < kComponents; ++component)
      if ((track.flags >> component & 1) != 0) values[component] = components[next++];
    Md5JointPose joint{{values[0], values[1], values[2]},
                       complete_orientation({values[3], values[4], values[5]})};
    if (joints[number].parent >= 0) {
      const Md5JointPose& parent = pose[static_cast<std::size_t>(joints[number].parent)];
      joint.position = parent.position + parent.orientation * joint.position;
      joint.orientation = glm::normalize(parent.orientation * joint.orientation);
    }
    pose.push_back(joint);
  }
  return pose;
}

}  // namespace

base::Result<Md5Animation> read_md5_animation(std::string_view text) {
  Md5Scanner scanner(text);
  Md5Animation animation;
  const AnimationHeader header = read_header(scanner, animation);
  std::vector<Track> tracks = read_hierarchy(scanner, header, animation);
  skip_bounds(scanner, header);
  read_base_frame(scanner, tracks);
  std::vector<float> components(header.component_count);
  for (std::size_t frame = 0; frame < header.frame_count && scanner.ok(); ++frame) {
    scanner.expect_element("frame", frame);
    scanner.expect("{");
    for (float& component : components) {
      if (!scanner.ok()) break;
      component = scanner.number();
    }
    scanner.expect("}");
    if (scanner.ok()) animation.poses.push_back(make_pose(tracks, animation.joints, components));
  }
  if (!scanner.ok()) return scanner.error();
  return animation;
}

base::Status check_same_skeleton(const Md5Model& model, const Md5Animation& animation) {
  if (model.joints.size() != animation.joints.size())
    return base::malformed("the animation has {}, but the model has {}",
                           base::counted(animation.joints.size(), "joint"), model.joints.size());
  for (std::size_t number = 0; number < model.joints.size(); ++number) {
    if (model.joints[number] == animation.joints[number]) continue;
    return base::malformed(
        "joint {} is \"{}\" below joint {} in the animation, but \"{}\" below joint {} in the model", number,
        base::quotable(animation.joints[number].name), animation.joints[number].parent,
        base::quotable(model.joints[number].name), model.joints[number].parent);
  }
  return base::Ok{};
}

}  // namespace temblor::formats
