// Particles: SIMD against scalar kernels, and whole pictures against squares drawn one by one in double
// precision, from the rule alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "render/particles/draw_particles.h"
#include "render/particles/particle_kernels.h"
#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/pictures/frames.h"
#include "support/pictures/some_colors.h"
#include "support/pictures/stage_parts.h"
#include "support/pictures/view_by_hand.h"
#include "support/random.h"

namespace temblor::test {
namespace {

struct Cloud {
  std::vector<float> x, y, z;
  std::vector<std::uint8_t> color;
  void add(const math::Vec3d& place, std::uint8_t index) {
    x.push_back(static_cast<float>(place.x));
    y.push_back(static_cast<float>(place.y));
    z.push_back(static_cast<float>(place.z));
    color.push_back(index);
  }
  render::ParticleCloud view() const { return {x, y, z, color}; }
};

struct Square {
  double left, top, side, depth;
  bool is_near_a_border;  // rounding of single-precision numbers may decide
};

// 128 / z pixels at 320 x 240 and 90 degrees, where a unit at distance 1 is 160 pixels; 1 to 4 pixels of a
// 4:3 picture that is 320 pixels wide.
Square compute_square(const render::ViewFrame& view, const math::Vec3d& place) {
  const math::Vec3d at = view.to_view(place);
  const math::Vec2d center = view.to_screen(at);
  const double growth = std::min(view.width / 320.0, view.height / 240.0);
  const double scale = view.perspective ? view.pixels_per_unit / at.z : view.pixels_per_unit;
  const double exact_side =
      std::clamp(128.0 / 160.0 * scale, std::max(1.0, growth), std::max(1.0, 4 * growth));
  const double side = std::round(exact_side);
  const auto is_whole = [](double number) { return std::abs(number - std::round(number)) < 1e-2; };
  return {std::ceil(center.x - side / 2), std::ceil(center.y - side / 2), side, view.depth(at.z),
          is_whole(center.x - side / 2) || is_whole(center.y - side / 2) || is_whole(exact_side + 0.5) ||
              std::abs(at.z - 8) < 1e-3};
}

// Around the eye, near ones as likely as distant ones; some share a position and so a depth.
Cloud random_cloud(const render::ViewFrame& view, std::size_t count, Random& random) {
  Cloud cloud;
  while (cloud.x.size() < count) {
    if (!cloud.x.empty() && random.chance(0.1)) {
      cloud.add({cloud.x.back(), cloud.y.back(), cloud.z.back()}, static_cast<std::uint8_t>(random.bits()));
      continue;
    }
    const double distance = random.log_uniform(4, 2000);
    const math::Vec3d exact = view.eye_world + view.axes.forward * distance +
                              math::Vec3d(random.in_cube(1.5)) * (random.chance(0.9) ? distance : 2000.0);
    const math::Vec3 place(exact);  // as a cloud holds it
    if (!compute_square(view, place).is_near_a_border)
      cloud.add(place, static_cast<std::uint8_t>(random.bits()));
  }
  return cloud;
}

void draw_slowly(const render::ViewFrame& view, const Cloud& cloud, render::FrameBuffer& io_frame) {
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    const math::Vec3d place(cloud.x[i], cloud.y[i], cloud.z[i]);
    if (view.to_view(place).z < 8) continue;
    const Square square = compute_square(view, place);
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const bool inside = x >= square.left && x < square.left + square.side && y >= square.top &&
                            y < square.top + square.side;
        const std::size_t pixel = static_cast<std::size_t>(y * view.width + x);
        if (!inside || static_cast<float>(square.depth) < io_frame.depth()[pixel]) continue;
        io_frame.depth()[pixel] = static_cast<float>(square.depth);
        if (io_frame.format() == render::PixelFormat::kIndexed)
          io_frame.indexed()[pixel] = cloud.color[i];
        else
          io_frame.rgb()[pixel] = some_tables().rgb[cloud.color[i]];
      }
  }
}

// A background with many depths.
void fill_at_random(render::FrameBuffer& io_frame, Random& random) {
  for (std::uint8_t& pixel : io_frame.indexed()) pixel = static_cast<std::uint8_t>(random.bits());
  for (std::uint32_t& pixel : io_frame.rgb()) pixel = static_cast<std::uint32_t>(random.bits());
  for (float& depth : io_frame.depth()) depth = static_cast<float>(1 / random.log_uniform(4, 4000));
}

void copy_frame(const render::FrameBuffer& from, render::FrameBuffer& io_to) {
  std::copy(from.indexed().begin(), from.indexed().end(), io_to.indexed().begin());
  std::copy(from.rgb().begin(), from.rgb().end(), io_to.rgb().begin());
  std::copy(from.depth().begin(), from.depth().end(), io_to.depth().begin());
}

void draw(const Cloud& cloud, const render::ViewFrame& view, int threads, bool simd_kernels,
          render::FrameBuffer& io_frame) {
  render::Scene scene;
  scene.particles = cloud.view();
  StageParts parts({.threads = threads,
                    .job_backend = base::JobBackend::kStdThread,
                    .simd_kernels = simd_kernels,
                    .band_rows = 32});
  const render::ParticleBands bands = render::place_particles(parts.context(scene, io_frame.format()), view);
  parts.jobs.parallel_for(bands.rects.size(), [&](std::size_t band) {
    render::draw_particles(bands, band, simd_kernels, io_frame);
  });
}

TEST(Particles, AreTheSquaresThatTheRuleSays) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(effort(60, 6)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int width = 1 + static_cast<int>(random.below(400)),
              height = 1 + static_cast<int>(random.below(300));
    render::ViewFrame view =
        make_test_view(width, height, random.uniform(20, 150),
                       math::Vec3(math::Vec3d(random.uniform(-80, 80), random.uniform(0, 360), 0)),
                       math::Vec3d(math::Vec3(random.in_cube(1000))));
    if (random.chance(0.2)) {
      view.perspective = false;
      view.pixels_per_unit = random.uniform(0.05, 6);
    }
    const Cloud cloud = random_cloud(view, 150, random);
    const auto format = seed % 2 == 0 ? render::PixelFormat::kIndexed : render::PixelFormat::kRgb;
    render::FrameBuffer expected(width, height, format), drawn(width, height, format);
    fill_at_random(expected, random);
    copy_frame(expected, drawn);
    draw_slowly(view, cloud, expected);
    draw(cloud, view, 1 + static_cast<int>(seed % 3), seed % 5 != 0, drawn);
    std::size_t wrong_pixels = 0, wrong_depths = 0;
    for (std::size_t i = 0; i < expected.pixel_count(); ++i) {
      wrong_pixels += format == render::PixelFormat::kIndexed ? drawn.indexed()[i] != expected.indexed()[i]
                                                              : drawn.rgb()[i] != expected.rgb()[i];
      wrong_depths +=
          std::abs(drawn.depth()[i] - expected.depth()[i]) > 1e-5f * std::abs(expected.depth()[i]);
    }
    EXPECT_EQ(wrong_pixels, 0u) << width << "x" << height;
    EXPECT_EQ(wrong_depths, 0u);
  }
}

// The number of pixels that one particle straight ahead covers in an empty picture.
std::size_t pixels_at(int width, int height, double fov_deg, double distance) {
  const render::ViewFrame view = make_test_view(width, height, fov_deg, math::Vec3(0.0f), math::Vec3d(0.0));
  Cloud cloud;
  cloud.add({distance, 0, 0}, 7);
  render::FrameBuffer frame(width, height, render::PixelFormat::kIndexed);
  fill_frame(frame, 0);
  std::fill(frame.depth().begin(), frame.depth().end(), std::numeric_limits<float>::lowest());
  draw(cloud, view, 1, true, frame);
  return static_cast<std::size_t>(std::count(frame.indexed().begin(), frame.indexed().end(), 7));
}

TEST(Particles, HaveTheOriginalsSizesAt320) {
  EXPECT_EQ(pixels_at(320, 240, 90, 7.99), 0u);
  EXPECT_EQ(pixels_at(320, 240, 90, 8), 16u);
  EXPECT_EQ(pixels_at(320, 240, 90, 32), 16u);
  EXPECT_EQ(pixels_at(320, 240, 90, 43), 9u);
  EXPECT_EQ(pixels_at(320, 240, 90, 64), 4u);
  EXPECT_EQ(pixels_at(320, 240, 90, 128), 1u);
  EXPECT_EQ(pixels_at(320, 240, 90, 5000), 1u);
}

TEST(Particles, GrowWithThePictureAndTheZoom) {
  EXPECT_EQ(pixels_at(2560, 1920, 90, 64), 16u * 16u);
  EXPECT_EQ(pixels_at(2560, 1920, 90, 5000), 8u * 8u);
  EXPECT_EQ(pixels_at(4000, 1920, 90, 64), 16u * 16u) << "a wider picture sees more at its sides";
  const double twice_as_near_deg = 2 * std::atan(0.5) * 180 / M_PI;
  EXPECT_EQ(pixels_at(640, 480, twice_as_near_deg, 80), pixels_at(640, 480, 90, 40));
}

TEST(Particles, AreTheSameForAnyNumberOfThreads) {
  for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    Random random(5);
    const render::ViewFrame view = make_test_view(640, 480, 90, math::Vec3(0.0f), math::Vec3d(0.0));
    const Cloud cloud = random_cloud(view, 10'000, random);
    render::FrameBuffer start(640, 480, format);
    fill_at_random(start, random);
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 3, 8}) {
      render::FrameBuffer frame(640, 480, format);
      copy_frame(start, frame);
      draw(cloud, view, threads, true, frame);
      hashes.push_back(compute_hash(frame));
    }
    EXPECT_NE(hashes[0], compute_hash(start));
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
  }
}

struct ProjectedBatch {
  std::vector<std::int32_t> left, top, side;
  std::vector<std::uint32_t> depth_bits;
  bool operator==(const ProjectedBatch&) const = default;
};

template <typename Project>
ProjectedBatch project(Project kernel, const render::ParticleProjection& projection, const Cloud& cloud) {
  const std::size_t count = cloud.x.size();
  ProjectedBatch out{std::vector<std::int32_t>(count), std::vector<std::int32_t>(count),
                     std::vector<std::int32_t>(count), std::vector<std::uint32_t>(count)};
  std::vector<float> depth(count);
  kernel(projection, {cloud.x.data(), cloud.y.data(), cloud.z.data(), count, out.left.data(), out.top.data(),
                      out.side.data(), depth.data()});
  for (std::size_t i = 0; i < count; ++i) out.depth_bits[i] = std::bit_cast<std::uint32_t>(depth[i]);
  return out;
}

// Numbers of all sizes, and NaN.
float odd_number(Random& random) {
  constexpr float kOdd[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max(), 0.0f};
  if (random.chance(0.05)) return kOdd[random.below(std::size(kOdd))];
  const double number = random.log_uniform(1e-3, random.chance(0.1) ? 1e30 : 4e3);
  return static_cast<float>(random.chance(0.5) ? number : -number);
}

TEST(ParticleKernels, ProjectTheSameOnEveryInstructionSet) {
  for_each_simd_target([] {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      Cloud cloud;
      for (std::size_t count = random.below(70); cloud.x.size() < count;) {
        cloud.add({}, 0);
        for (std::vector<float>* axis : {&cloud.x, &cloud.y, &cloud.z}) axis->back() = odd_number(random);
      }
      const math::Basis axes = math::basis_from_angles(random.in_cube(180));
      render::ParticleProjection p{};
      for (int i = 0; i < 3; ++i) {
        p.eye[i] = static_cast<float>(random.uniform(-500, 500));
        p.right[i] = static_cast<float>(axes.right[i]);
        p.up[i] = static_cast<float>(axes.up[i]);
        p.forward[i] = static_cast<float>(axes.forward[i]);
      }
      p.perspective = seed % 4 != 0;
      p.pixels_per_unit = static_cast<float>(random.uniform(1, 1000));
      p.width = 640;
      p.height = 480;
      p.center_x = 319.5f;
      p.center_y = 239.5f;
      p.side_at_one_unit = 0.8f * p.pixels_per_unit;
      p.min_side = 2;
      p.max_side = 8;
      EXPECT_EQ(project(render::project_particles_simd, p, cloud),
                project(render::project_particles_scalar, p, cloud));
    }
  });
}

template <typename Pixel>
struct ParticleCanvas {
  static constexpr std::size_t kWidth = 61, kRows = 40;  // of exactly this size: the sanitizer sees more
  std::vector<Pixel> pixels = std::vector<Pixel>(kWidth * kRows);
  std::vector<float> depth = std::vector<float>(kWidth * kRows);
  bool operator==(const ParticleCanvas&) const = default;
  render::ParticleTarget target() { return {pixels.data(), depth.data(), kWidth}; }
};

template <typename Pixel>
ParticleCanvas<Pixel> random_canvas(Random& random) {
  ParticleCanvas<Pixel> canvas;
  for (Pixel& pixel : canvas.pixels) pixel = static_cast<Pixel>(random.bits());
  for (float& depth : canvas.depth) depth = static_cast<float>(random.below(6));
  return canvas;
}

// Few different depths, so that many are equal to what is there; also in the last columns and rows.
template <typename Pixel>
std::vector<render::ParticleRect> random_rects(Random& random) {
  using C = ParticleCanvas<Pixel>;
  std::vector<render::ParticleRect> rects(random.below(60));
  for (render::ParticleRect& rect : rects) {
    const std::size_t width = 1 + random.below(C::kWidth), height = 1 + random.below(20);
    const std::size_t x = random.chance(0.3) ? C::kWidth - width : random.below(C::kWidth - width + 1);
    const std::size_t y = random.chance(0.3) ? C::kRows - height : random.below(C::kRows - height + 1);
    rect = {static_cast<float>(random.below(6)), static_cast<std::uint16_t>(x),
            static_cast<std::uint16_t>(y),       static_cast<std::uint16_t>(width),
            static_cast<std::uint16_t>(height),  static_cast<std::uint32_t>(random.bits())};
  }
  return rects;
}

template <typename Pixel, typename Kernel>
void expect_twins(Kernel vector, Kernel plain) {
  for_each_simd_target([&] {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(effort(300, 50)); ++seed) {
      Random random(seed);
      ParticleCanvas<Pixel> by_simd = random_canvas<Pixel>(random), by_scalar = by_simd;
      const std::vector<render::ParticleRect> rects = random_rects<Pixel>(random);
      vector(rects.data(), rects.size(), by_simd.target());
      plain(rects.data(), rects.size(), by_scalar.target());
      ASSERT_EQ(by_simd, by_scalar) << "seed " << seed;
    }
  });
}

TEST(ParticleKernels, DrawTheSameOnEveryInstructionSet) {
  expect_twins<std::uint8_t>(render::draw_particles_u8_simd, render::draw_particles_u8_scalar);
  expect_twins<std::uint32_t>(render::draw_particles_u32_simd, render::draw_particles_u32_scalar);
}

}  // namespace
}  // namespace temblor::test
