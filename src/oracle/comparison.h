// Compares a drawn frame with the oracle, pixel by pixel, and counts differences.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "formats/images/palette.h"
#include "oracle/rays/camera_rays.h"
#include "oracle/rays/face_color.h"
#include "oracle/rays/ray_scene.h"
#include "render/frame_buffer.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace temblor::oracle {

struct Tally {
  std::uint64_t pixels = 0;
  // The face. Each of `pixels` is one of these.
  std::uint64_t same_face = 0;
  std::uint64_t tied = 0;       // another face in the same place (coplanar faces of two models)
  std::uint64_t near_edge = 0;  // the oracle sees the renderer's face within one pixel from here
  std::uint64_t wrong_face = 0;
  std::uint64_t on_brush_models = 0;  // where the oracle sees one
  // The color, where the faces agree and the definition determines it.
  std::uint64_t colors = 0, right_colors = 0;
  // 1/z, where the faces agree.
  std::uint64_t depths = 0, right_depths = 0;
  // The first few wrong pixels, one readable line each.
  static constexpr std::size_t kMaxFindings = 12;
  std::vector<std::string> findings;

  double face_agreement() const { return share(same_face + tied, pixels); }
  double color_agreement() const { return share(right_colors, colors); }
  double depth_agreement() const { return share(right_depths, depths); }
  std::string summary() const;
  void add(const Tally& other);

 private:
  static double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

// The part of the world that may be drawn: the faces that its leaves list. (Compilers leave some faces that
// no leaf lists, where liquid meets solid.)
class VisibleSet {
 public:
  // All leaves: without the PVS.
  explicit VisibleSet(const world::Level& level);
  // The leaves that the eye's leaf may see: all that a renderer that trusts the PVS has to draw.
  VisibleSet(const world::Level& level, const math::Vec3& eye_world);

  bool has_face(world::FaceIndex face) const { return faces_[base::to_size(face)]; }
  bool has_leaf(world::LeafIndex leaf) const { return leaves_[base::to_size(leaf)]; }

 private:
  void show_faces_of_leaves(const world::Level& level);

  std::vector<bool> leaves_, faces_;
};

// One frame and everything that its pixels depend on; all references must outlive it. The frame must have
// been drawn with Settings::force_mip = 0, Show::kPicture, and depth.
class Comparison {
 public:
  struct Drawn {
    const render::FrameBuffer& frame;
    std::span<const render::PixelFace> pixel_faces;
    const formats::Palette& palette;
    const formats::Colormap& colormap;
    bool use_pvs;
  };
  Comparison(const PreparedLevel& prepared, const render::Scene& scene, const Drawn& drawn);

  void pixel(int x, int y, Tally& io_tally) const;
  Tally whole_frame() const;

 private:
  std::optional<Hit> nearest(const Ray& ray) const;
  struct TexelRange {
    TexelPosition first, last;  // both belong to it
  };
  static constexpr double kNearPlane = 1.0 / 16;  // nothing nearer is drawn, units

  bool is_shown(const Ray& ray, const Hit& hit) const;
  bool has_holes(const Hit& hit) const;
  std::optional<Hit> covering(int x, int y, const Hit& opaque) const;
  std::optional<TexelRange> find_texels(int x, int y, const Hit& hit) const;
  bool is_same(const std::optional<Hit>& hit, const render::PixelFace& drawn) const;
  bool is_tied(const Ray& ray, const std::optional<Hit>& hit, const render::PixelFace& drawn) const;
  bool seen_within_a_pixel(int x, int y, const render::PixelFace& drawn) const;
  void judge_depth(int x, int y, const Hit& hit, Tally& io_tally) const;
  void judge_color(int x, int y, const Hit& hit, Tally& io_tally) const;
  std::optional<bool> is_right_color(int x, int y, const Hit& hit) const;
  bool matches_color(std::size_t position, const Hit& hit, TexelPosition texel) const;
  bool is_in_texture(std::size_t position, const Hit& hit) const;
  math::Vec2d texture_position_at(double x_px, double y_px, const Hit& hit) const;
  world::TextureIndex find_texture(const Hit& hit) const;
  std::string describe(int x, int y, const std::optional<Hit>& hit, const render::PixelFace& drawn) const;
  std::string describe_color(int x, int y, const Hit& hit) const;

  std::size_t pixel_index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(drawn_.frame.width()) +
           static_cast<std::size_t>(x);
  }

  const PreparedLevel& prepared_;
  const world::Level& level_;
  const render::Scene& scene_;
  Drawn drawn_;
  RayScene ray_scene_;
  CameraRays rays_;
  VisibleSet visible_;
};

}  // namespace temblor::oracle
