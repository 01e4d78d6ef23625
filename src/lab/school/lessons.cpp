#include "lab/lessons.h"

#include <algorithm>
#include <numbers>

#include "lab/school/fixed_point.h"
#include "lab/school/scene.h"
#include "lab/school/two_processors.h"

namespace temblor::lab::school {
namespace {

constexpr Color kWhite{0.95f, 0.95f, 0.95f}, kBlue{0.3f, 0.55f, 0.95f}, kOrange{0.95f, 0.6f, 0.2f},
    kGreen{0.35f, 0.8f, 0.4f};
constexpr float kTurn = std::numbers::pi_v<float> * 2;

View make_view(int width, int height, float field_of_view_deg = 60) {
  return {static_cast<float>(width), static_cast<float>(height), field_of_view_deg};
}

// Two pictures side by side.
template <typename Left, typename Right>
Picture draw_pair(int width, int height, Left draw_left, Right draw_right) {
  Picture pair(width, height);
  const int half = width / 2;
  const Picture left = draw_left(half - 2, height), right = draw_right(half - 2, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < half - 2; ++x) {
      pair.color(x, y) = left.color(x, y);
      pair.color(half + 2 + x, y) = right.color(x, y);
    }
  return pair;
}

Picture draw_lines(int width, int height) {
  Picture picture(width, height);
  const Point center{static_cast<float>(width) / 2, static_cast<float>(height) / 2};
  for (int i = 0; i < 36; ++i) {
    const float angle = kTurn * static_cast<float>(i) / 36, radius = static_cast<float>(height) * 0.45f;
    draw_line(picture, center, {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)},
              interpolate(kBlue, kOrange, static_cast<float>(i) / 35));
  }
  return picture;
}

Corners some_corners(int width, int height) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  return {Point{w * 0.3f, h * 0.08f}, {w * 0.85f, h * 0.45f}, {w * 0.12f, h * 0.92f}};
}

// Every second block of rows has another shade, so that rows can be counted.
Picture draw_spans(int width, int height) {
  Picture picture(width, height);
  for (const Span& span : find_spans(some_corners(width, height), width, height))
    for (int x = span.begin; x < span.end; ++x)
      picture.color(x, span.y) = span.y / 6 % 2 == 0 ? kBlue : kBlue * 0.7f;
  return picture;
}

void draw_wire(Picture& io_picture, const Mesh& mesh, const Matrix& movement, const View& view,
               const Color& color) {
  for (const ScreenTriangle& triangle : project_mesh(mesh, movement, view))
    draw_outline(io_picture, triangle, color);
}

Picture draw_movements(int width, int height) {
  Picture picture(width, height);
  const View view = make_view(width, height);
  const Mesh box = make_box();
  const Matrix away = move_by({0, 0, 11});
  draw_wire(picture, box, away * move_by({-5, 0, 0}), view, kWhite);
  draw_wire(picture, box, away * move_by({-1.6f, 0, 0}) * turn_around_y(0.6f), view, kBlue);
  draw_wire(picture, box, away * move_by({1.4f, 0, 0}) * scale_by(0.6f), view, kOrange);
  draw_wire(picture, box, away * turn_around_y(0.6f) * move_by({4, 0, 0}), view, kGreen);
  return picture;
}

// A row of boxes, one behind another.
template <typename Project>
Picture draw_row(int width, int height, Project project) {
  Picture picture(width, height);
  for (int i = 0; i < 5; ++i)
    for (const auto& triangle : make_box())
      for (std::size_t k = 0; k < 3; ++k) {
        const auto n = static_cast<float>(i);
        const auto place = [&](const Vertex& vertex) {
          return vertex.place + Vector{-2.5f + 1.2f * n, -1 + 0.5f * n, 6 + 4 * n};
        };
        draw_line(picture, project(place(triangle[k])), project(place(triangle[(k + 1) % 3])),
                  interpolate(kOrange, kBlue, n / 4));
      }
  return picture;
}
Picture draw_parallel(int width, int height) {
  const View view = make_view(width, height);
  return draw_row(width, height, [&](const Vector& place) { return project_parallel(place, view, 8); });
}
Picture draw_perspective(int width, int height) {
  const View view = make_view(width, height);
  return draw_row(width, height, [&](const Vector& place) { return project_perspective(place, view); });
}

Picture draw_boxes(int width, int height, float field_of_view_deg) {
  Picture picture(width, height);
  const View view = make_view(width, height, field_of_view_deg);
  for (int i = -3; i <= 3; ++i)
    draw_wire(picture, make_box(), move_by({static_cast<float>(i) * 3, 0, 8}), view, kWhite);
  return picture;
}
Picture draw_fields_of_view(int width, int height) {
  return draw_pair(
      width, height, [](int w, int h) { return draw_boxes(w, h, 40); },
      [](int w, int h) { return draw_boxes(w, h, 90); });
}

// The floor begins behind the eye.
Picture draw_clipping(int width, int height) {
  Picture picture(width, height);
  const View view{static_cast<float>(width), static_cast<float>(height), 60, 1.4f};
  for (int row = 0; row < 12; ++row) {
    Mesh tiles;
    for (int column = -4; column < 4; ++column) {
      const auto x = static_cast<float>(column), z = static_cast<float>(row) - 2;
      add_quad(tiles, {{{x, -1, z + 1}, {x + 1, -1, z + 1}, {x + 1, -1, z}, {x, -1, z}}}, kWhite);
    }
    draw_wire(picture, tiles, move_by({0, 0, 0}), view, row == 3 ? kOrange : kWhite * 0.7f);
  }
  return picture;
}

const Matrix kBoxPlace = move_by({0, -0.1f, 4}) * turn_around_x(-0.5f) * turn_around_y(0.7f);

bool faces_us(const ScreenTriangle& t) {
  return (t[1].at.x - t[0].at.x) * (t[2].at.y - t[0].at.y) -
             (t[2].at.x - t[0].at.x) * (t[1].at.y - t[0].at.y) >
         0;
}

// Calls fill(picture, triangle in the picture, triangle in space) for the sides of a box that face us.
template <typename Fill>
Picture draw_box(int width, int height, Fill fill) {
  Picture picture(width, height);
  for (const auto& triangle : make_box())
    for (const ScreenTriangle& part : project_triangle(triangle, kBoxPlace, make_view(width, height)))
      if (faces_us(part)) fill(picture, part, triangle);
  return picture;
}

Picture draw_flat_box(int width, int height) {
  return draw_box(width, height, [](Picture& io_picture, const ScreenTriangle& part, const auto& triangle) {
    const float light = find_light(
        {kBoxPlace * triangle[0].place, kBoxPlace * triangle[1].place, kBoxPlace * triangle[2].place},
        normalize({0.2f, 0.7f, -0.6f}));
    fill_flat(io_picture, part, triangle[0].color * light);
  });
}

// Each corner is as bright as it is high.
Picture draw_gouraud_box(int width, int height) {
  return draw_box(width, height, [](Picture& io_picture, ScreenTriangle part, const auto& triangle) {
    for (std::size_t i = 0; i < 3; ++i)
      part[i].color = triangle[i].color * (0.6f + 0.4f * triangle[i].place.y * triangle[i].place.x);
    fill_gouraud(io_picture, part);
  });
}

template <typename Fill>
Picture draw_floor(int width, int height, Fill fill) {
  Picture picture(width, height);
  for (const ScreenTriangle& triangle :
       project_mesh(make_floor(8, 32), move_by({0, 0, 0.3f}), make_view(width, height)))
    fill(picture, triangle);
  return picture;
}

Picture draw_affine_and_exact(int width, int height) {
  const Picture bricks = make_bricks();
  const auto draw = [&](auto fill) {
    return [&bricks, fill](int w, int h) {
      return draw_box(w, h, [&](Picture& io_picture, const ScreenTriangle& part, const auto&) {
        fill(io_picture, part, bricks);
      });
    };
  };
  return draw_pair(width, height, draw(fill_affine), draw(fill_textured));
}

Picture draw_mip_levels(int width, int height) {
  const std::vector<Picture> levels = make_mip_levels(make_bricks());
  return draw_pair(
      width, height,
      [&](int w, int h) {
        return draw_floor(w, h,
                          [&](Picture& io, const ScreenTriangle& t) { fill_textured(io, t, levels[0]); });
      },
      [&](int w, int h) {
        return draw_floor(w, h,
                          [&](Picture& io, const ScreenTriangle& t) { fill_mip_mapped(io, t, levels); });
      });
}

// A bright spot in the middle of a side.
Picture draw_light_maps(int width, int height) {
  const Picture bricks = make_bricks();
  Picture light(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const float away = std::hypot(static_cast<float>(x) - 31.5f, static_cast<float>(y) - 31.5f) / 32;
      light.color(x, y) = kWhite * std::clamp(1.2f - away, 0.15f, 1.0f);
    }
  return draw_box(width, height, [&](Picture& io_picture, const ScreenTriangle& part, const auto&) {
    fill_multi_textured(io_picture, part, bricks, light, 1);
  });
}

Picture draw_blended(int width, int height) {
  Picture picture = draw_flat_box(width, height);
  Mesh pane;
  add_quad(pane, {{{-1.6f, 0.9f, 2}, {0.4f, 0.9f, 2}, {0.4f, -0.7f, 2}, {-1.6f, -0.7f, 2}}}, kBlue);
  for (const ScreenTriangle& t : project_mesh(pane, move_by({0, 0, 0}), make_view(width, height)))
    fill_blended(picture, t, kBlue, 0.5f);
  return picture;
}

// Left, the spans in floating point; right, orange pixels are those that fixed point draws differently.
Picture draw_fixed_point(int width, int height) {
  return draw_pair(width, height, draw_spans, [](int w, int h) {
    Picture picture(w, h);
    for (const Span& span : find_spans(some_corners(w, h), w, h))
      for (int x = span.begin; x < span.end; ++x) picture.color(x, span.y) = kOrange;
    for (const Span& span : find_spans_in_fixed_point(some_corners(w, h)))
      for (int x = span.begin; x < span.end; ++x) {
        const bool in_both = picture.color(x, span.y).red == kOrange.red;
        picture.color(x, span.y) = in_both ? kBlue * 0.7f : kOrange;
      }
    return picture;
  });
}

// Three beams, each in front of the next: over at one end, under at the other.
std::vector<ScreenTriangle> make_beams(int width, int height) {
  const Color colors[] = {kBlue, kOrange, kGreen};
  std::vector<ScreenTriangle> beams;
  for (int i = 0; i < 3; ++i) {
    Mesh beam;
    add_quad(beam, {{{-1.1f, 0.6f, 3}, {1.3f, 0.6f, 5}, {1.3f, 0.25f, 5}, {-1.1f, 0.25f, 3}}}, colors[i]);
    const float angle = kTurn * static_cast<float>(i) / 3, c = std::cos(angle), s = std::sin(angle);
    const Matrix roll{{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (const ScreenTriangle& t : project_mesh(beam, roll, make_view(width, height))) beams.push_back(t);
  }
  return beams;
}

Picture draw_depth(int width, int height) {
  return draw_pair(
      width, height,
      [](int w, int h) {
        Picture picture(w, h);
        std::vector<ScreenTriangle> beams = make_beams(w, h);
        sort_back_to_front(beams);
        for (const ScreenTriangle& t : beams) fill_flat(picture, t, t[0].color);
        return picture;
      },
      [](int w, int h) {
        Picture picture(w, h);
        for (const ScreenTriangle& t : make_beams(w, h)) fill_with_depth_buffer(picture, t, t[0].color);
        return picture;
      });
}

// Time goes to the right. Each run has two rows, one for each processor.
Picture draw_two_processors(int width, int height) {
  constexpr int kFrames = 6;
  Picture picture(width, height);
  const FrameRun runs[] = {run_in_turns(kFrames, width, height), run_overlapped(kFrames, width, height)};
  double end_ms = 0;
  for (const FrameRun& run : runs)
    for (const WorkTime& work : run.times) end_ms = std::max(end_ms, work.end_ms);
  for (int number = 0; number < 2; ++number)
    for (const WorkTime& work : runs[number].times) {
      const int row = number * 3 + (number == 1 && work.is_drawing ? 1 : 0);
      const int first_row = (row + 1) * height / 7;
      const int end_row = (row + 2) * height / 7 - std::min(4, height / 14);
      // One pixel is left between bars, but each bar has at least one: next to a very slow frame, the
      // others are short.
      const int begin = std::min(static_cast<int>(work.begin_ms / end_ms * width), width - 1);
      const int end = std::max(static_cast<int>(work.end_ms / end_ms * width) - 1, begin + 1);
      for (int y = first_row; y < end_row; ++y)
        for (int x = begin; x < end; ++x) picture.color(x, y) = work.is_drawing ? kOrange : kBlue;
    }
  return picture;
}

constexpr Lesson kLessons[] = {
    {"lines", "Interpolation",
     "A line between two points changes by the same amount with each step. One addition per step is enough.",
     "interpolation.h", "draw_line", draw_lines},
    {"spans", "Scan conversion",
     "A triangle is a stack of horizontal spans. Two of its edges are interpolated from row to row, and the "
     "pixels between them are inside.",
     "spans.cpp", "find_spans", draw_spans},
    {"movement", "Vectors and matrices",
     "One box moved, turned, and made smaller. A matrix holds any such movement, and a product of matrices "
     "does "
     "several at once. Order matters: the green box was moved before it was turned.",
     "space.h", "operator*", draw_movements},
    {"parallel", "Parallel projection",
     "Depth is left out, so boxes have the same size at any distance. Plans and editors use it.",
     "projection.h", "project_parallel", draw_parallel},
    {"perspective", "Perspective projection",
     "The same boxes. Places are divided by their depth, so things shrink with distance.", "projection.h",
     "project_perspective", draw_perspective},
    {"field-of-view", "Field of view and aspect",
     "40 and 90 degrees from top to bottom. A wide angle shows more, smaller, and stretched at the sides.",
     "projection.h", "find_picture_distance", draw_fields_of_view},
    {"clipping", "Clipping to the near plane",
     "The floor goes on behind the eye, where projection would turn it upside down. Polygons are cut at the "
     "near plane first; the orange row was.",
     "clipping.h", "clip_to_near_plane", draw_clipping},
    {"flat", "Flat light", "Each side has one color, brighter the more it faces the light: a dot product.",
     "scene.cpp", "find_light", draw_flat_box},
    {"gouraud", "Gouraud",
     "Light at the corners, interpolated in between. Look along the diagonals: two triangles do not make an "
     "even side.",
     "triangles.cpp", "fill_gouraud", draw_gouraud_box},
    {"textured", "Textures",
     "Left, texture coordinates are interpolated in the picture, and the bricks bend. Right, s/z, t/z, and "
     "1/z "
     "are, and a division per pixel makes them straight.",
     "triangles.cpp", "fill_textured", draw_affine_and_exact},
    {"mip-mapped", "Mip levels",
     "Left, far pixels pick single texels from many, and flicker. Right, they read a smaller copy of the "
     "texture.",
     "triangles.cpp", "fill_mip_mapped", draw_mip_levels},
    {"multi-textured", "Several textures",
     "Bricks that repeat, times light that does not. Quake's surfaces are made this way.", "triangles.cpp",
     "fill_multi_textured", draw_light_maps},
    {"blended", "Blending", "A pane in front of the box: half its own color, half of those behind it.",
     "triangles.cpp", "fill_blended", draw_blended},
    {"fixed-point", "Fixed point",
     "Left, floating point. Right, the same triangle with whole numbers only; pixels that differ are orange, "
     "and there are hardly any.",
     "fixed_point.cpp", "find_spans_in_fixed_point", draw_fixed_point},
    {"depth", "Depth sorting and depth buffer",
     "Three beams, each over the next. Left, sorted from back to front: no order is right. Right, each pixel "
     "keeps its depth, and no order is needed.",
     "triangles.cpp", "fill_with_depth_buffer", draw_depth},
    {"two-processors", "Game and drawing on two processors",
     "Blue: the game computes its next state. Orange: a frame is drawn. Above, in turns; below, both at "
     "once, "
     "six frames each.",
     "two_processors.cpp", "run_overlapped", draw_two_processors},
};

}  // namespace

std::span<const Lesson> list_lessons() {
  return kLessons;
}

}  // namespace temblor::lab::school
