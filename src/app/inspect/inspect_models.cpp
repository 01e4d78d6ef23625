// Alias models (.mdl) and sprites (.spr).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/models/mdl.h"
#include "formats/models/spr.h"

namespace temblor::app {
namespace {

using formats::Mdl;
using formats::MdlFrame;
using formats::MdlPose;
using formats::MdlVertex;

// Limits of the original engine, which refuses models beyond them or draws them wrong.
constexpr std::size_t kStockVertices = 2000, kStockFrames = 256, kStockSkinHeight = 480, kStockWidthStep = 4;
constexpr std::uint8_t kTransparent = 255;

// Names of the bits of a model's flags, from bit 0 on: the effects that the client shows on it.
constexpr std::array<const char*, 8> kFlagNames = {"rocket trail", "grenade smoke", "gib blood", "rotate",
                                                   "tracer",       "zombie blood",  "tracer 2",  "tracer 3"};
constexpr std::array<const char*, 5> kOrientationNames = {"parallel upright", "facing upright", "parallel",
                                                          "oriented", "parallel oriented"};

// A bounding box in the byte coordinates of a pose.
struct Box {
  std::array<std::uint8_t, 3> mins{255, 255, 255}, maxs{0, 0, 0};

  void add(const MdlVertex& vertex) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mins[axis] = std::min(mins[axis], vertex.position[axis]);
      maxs[axis] = std::max(maxs[axis], vertex.position[axis]);
    }
  }
  bool is_inside(const MdlVertex& low, const MdlVertex& high) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (mins[axis] < low.position[axis] || maxs[axis] > high.position[axis]) return false;
    return true;
  }
};

Box pose_box(const MdlPose& pose) {
  Box box;
  for (const MdlVertex& vertex : pose.vertices) box.add(vertex);
  return box;
}

// Converts a position of one byte per axis to units.
math::Vec3 decode_position(const Mdl& mdl, const std::array<std::uint8_t, 3>& bytes) {
  return mdl.scale * math::Vec3(bytes[0], bytes[1], bytes[2]) + mdl.origin;
}

Inspection list_flags(std::uint32_t flags) {
  Inspection names = Inspection::array();
  for (std::size_t bit = 0; bit < kFlagNames.size(); ++bit)
    if ((flags >> bit & 1) != 0) names.push_back(kFlagNames[bit]);
  return names;
}

// A skin with several pictures is animated; "seconds" is the length of its cycle.
Inspection list_skins(const Mdl& mdl) {
  Inspection skins = Inspection::array();
  for (const formats::MdlSkin& skin : mdl.skins) {
    Inspection entry = {{"pictures", skin.pictures.size()}};
    if (!skin.end_times_s.empty()) entry["seconds"] = skin.end_times_s.back();
    skins.push_back(entry);
  }
  return skins;
}

// A frame with several poses is a group, which animates on its own; "seconds" is the length of its cycle.
Inspection list_frames(const Mdl& mdl) {
  Inspection frames = Inspection::array();
  for (const MdlFrame& frame : mdl.frames) {
    Inspection entry = {{"name", frame.poses.front().name}, {"poses", frame.poses.size()}};
    if (!frame.end_times_s.empty()) entry["seconds"] = frame.end_times_s.back();
    frames.push_back(entry);
  }
  return frames;
}

// Formats "3 (the first is frame 7)". `frames` must not be empty.
std::string format_count_and_first(const std::vector<std::size_t>& frames) {
  return fmt::format("{} (the first is frame {})", frames.size(), frames.front());
}

// Finds poses and groups whose bounding box in the file does not contain their vertices.
void find_wrong_boxes(const Mdl& mdl, Inspection& io_problems) {
  std::vector<std::size_t> poses, groups;
  for (std::size_t i = 0; i < mdl.frames.size(); ++i) {
    const MdlFrame& frame = mdl.frames[i];
    for (const MdlPose& pose : frame.poses) {
      const Box box = pose_box(pose);
      if (!box.is_inside(pose.mins, pose.maxs)) poses.push_back(i);
      if (!frame.end_times_s.empty() && !box.is_inside(frame.mins, frame.maxs) &&
          (groups.empty() || groups.back() != i))
        groups.push_back(i);
    }
  }
  if (!poses.empty())
    io_problems.push_back(
        fmt::format("poses with vertices outside their bounding box: {}", format_count_and_first(poses)));
  if (!groups.empty())
    io_problems.push_back(fmt::format("groups with vertices outside the group's bounding box: {}",
                                      format_count_and_first(groups)));
}

// Finds vertices without triangles, and triangles without area.
void find_unused_parts(const Mdl& mdl, Inspection& io_problems) {
  std::vector<bool> used(mdl.texels.size());
  std::size_t flat = 0;
  for (const formats::MdlTriangle& triangle : mdl.triangles) {
    const auto& [a, b, c] = triangle.vertices;
    flat += a == b || b == c || a == c ? 1 : 0;
    for (const std::uint32_t vertex : triangle.vertices) used[vertex] = true;
  }
  if (const auto unused = std::ranges::count(used, false); unused > 0)
    io_problems.push_back(fmt::format("vertices not used by any triangle: {}", unused));
  if (flat > 0) io_problems.push_back(fmt::format("triangles with a repeated vertex: {}", flat));
}

// Finds texture coordinates outside the skin. Vertices on the seam are shifted by half the skin's width in
// triangles of the back, as when they are drawn.
void find_corners_off_the_skin(const Mdl& mdl, Inspection& io_problems) {
  const auto width = static_cast<std::int32_t>(mdl.skin_width),
             height = static_cast<std::int32_t>(mdl.skin_height);
  std::size_t corners = 0;
  for (const formats::MdlTriangle& triangle : mdl.triangles) {
    for (const std::uint32_t vertex : triangle.vertices) {
      const formats::MdlTexel& texel = mdl.texels[vertex];
      const std::int32_t s = texel.s + (texel.on_seam && !triangle.faces_front ? width / 2 : 0);
      corners += s < 0 || s >= width || texel.t < 0 || texel.t >= height ? 1 : 0;
    }
  }
  if (corners > 0) io_problems.push_back(fmt::format("triangle corners outside the skin: {}", corners));
}

// Finds counts that only engines with higher limits accept, such as this one.
void find_stock_limits(const Mdl& mdl, Inspection& io_problems) {
  const auto more_than = [&](const char* what, std::size_t count, std::size_t limit) {
    if (count > limit)
      io_problems.push_back(fmt::format("{} {}: the original engine allows {}", count, what, limit));
  };
  more_than("vertices", mdl.texels.size(), kStockVertices);
  more_than("frames", mdl.frames.size(), kStockFrames);
  more_than("rows of a skin", mdl.skin_height, kStockSkinHeight);
  if (mdl.skin_width % kStockWidthStep != 0)
    io_problems.push_back(fmt::format("skins are {} texels wide: the original engine needs a multiple of {}",
                                      mdl.skin_width, kStockWidthStep));
}

// Finds bytes after the end of the model, by comparing with the size that it would have if it were written
// again.
void find_tail(std::size_t file_bytes, std::size_t used_bytes, Inspection& io_problems) {
  if (file_bytes > used_bytes)
    io_problems.push_back(
        fmt::format("{} after the last frame", base::counted(file_bytes - used_bytes, "trailing byte")));
}

Inspection count_parts(const Mdl& mdl) {
  std::size_t poses = 0, pictures = 0;
  for (const MdlFrame& frame : mdl.frames) poses += frame.poses.size();
  for (const formats::MdlSkin& skin : mdl.skins) pictures += skin.pictures.size();
  return {{"vertices", mdl.texels.size()}, {"triangles", mdl.triangles.size()}, {"skins", mdl.skins.size()},
          {"skin pictures", pictures},     {"frames", mdl.frames.size()},       {"poses", poses}};
}

// Each frame shows the size and the offset of its first picture.
Inspection list_sprite_frames(const formats::Spr& spr) {
  Inspection frames = Inspection::array();
  for (const formats::SprFrame& frame : spr.frames) {
    const formats::SprPicture& first = frame.pictures.front();
    Inspection entry = {{"pictures", frame.pictures.size()},
                        {"left", first.left},
                        {"up", first.up},
                        {"width", first.width},
                        {"height", first.height}};
    if (!frame.end_times_s.empty()) entry["seconds"] = frame.end_times_s.back();
    frames.push_back(entry);
  }
  return frames;
}

Inspection find_sprite_problems(const formats::Spr& spr, std::size_t file_bytes) {
  Inspection problems = Inspection::array();
  std::vector<std::size_t> larger, invisible;
  for (std::size_t i = 0; i < spr.frames.size(); ++i) {
    for (const formats::SprPicture& picture : spr.frames[i].pictures) {
      if (picture.width > spr.max_width || picture.height > spr.max_height) larger.push_back(i);
      if (std::ranges::count(picture.texels, kTransparent) == std::ssize(picture.texels))
        invisible.push_back(i);
    }
  }
  if (!larger.empty())
    problems.push_back(
        fmt::format("pictures larger than the header's maximum: {}", format_count_and_first(larger)));
  if (!invisible.empty())
    problems.push_back(fmt::format("fully transparent pictures: {}", format_count_and_first(invisible)));
  find_tail(file_bytes, formats::write_spr(spr).size(), problems);
  return problems;
}

}  // namespace

base::Result<Inspection> inspect_mdl(base::Bytes bytes) {
  TRY(const Mdl mdl, formats::read_mdl(bytes));
  Box box;
  for (const MdlFrame& frame : mdl.frames)
    for (const MdlPose& pose : frame.poses)
      for (const MdlVertex& vertex : pose.vertices) box.add(vertex);
  const math::Vec3 low = decode_position(mdl, box.mins), high = decode_position(mdl, box.maxs);
  Inspection problems = Inspection::array();
  find_wrong_boxes(mdl, problems);
  find_unused_parts(mdl, problems);
  find_corners_off_the_skin(mdl, problems);
  find_stock_limits(mdl, problems);
  if (const std::uint32_t unknown = mdl.flags >> kFlagNames.size(); unknown != 0)
    problems.push_back(fmt::format("unknown bits in flags {:#x}", mdl.flags));
  find_tail(bytes.size(), formats::write_mdl(mdl).size(), problems);
  return Inspection{{"mins", make_json(glm::min(low, high))},
                    {"maxs", make_json(glm::max(low, high))},
                    {"bounding radius", mdl.bounding_radius},
                    {"eye", make_json(mdl.eye)},
                    {"skin width", mdl.skin_width},
                    {"skin height", mdl.skin_height},
                    {"random phase", mdl.random_phase},
                    {"flags", list_flags(mdl.flags)},
                    {"counts", count_parts(mdl)},
                    {"skins", list_skins(mdl)},
                    {"frames", list_frames(mdl)},
                    {"problems", problems}};
}

base::Result<Inspection> inspect_spr(base::Bytes bytes) {
  TRY(const formats::Spr spr, formats::read_spr(bytes));
  std::size_t pictures = 0;
  for (const formats::SprFrame& frame : spr.frames) pictures += frame.pictures.size();
  return Inspection{{"orientation", kOrientationNames[static_cast<std::size_t>(spr.orientation)]},
                    {"bounding radius", spr.bounding_radius},
                    {"largest width", spr.max_width},
                    {"largest height", spr.max_height},
                    {"beam length", spr.beam_length},
                    {"random phase", spr.random_phase},
                    {"counts", {{"frames", spr.frames.size()}, {"pictures", pictures}}},
                    {"frames", list_sprite_frames(spr)},
                    {"problems", find_sprite_problems(spr, bytes.size())}};
}

}  // namespace temblor::app
