// Reads the lines that draw a shape; docs/art-scripts.md lists their settings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "artgen/models/noise.h"
#include "artgen/pictures/drawing_settings.h"
#include "artgen/pictures/lettering.h"
#include "base/text.h"

namespace temblor::artgen::pictures {
namespace {

using math::Vec2d;

// Limits all coordinates and sizes, in pixels.
constexpr double kMaxCoordinate = 4096;

// The input of a shape reader.
struct ShapeArguments {
  Arguments& arguments;
  Vec2d canvas_size;

  double seed() { return arguments.integer("seed", 1, 0, 1 << 30); }
  // All remaining positional values as points; at least `min_count` are required.
  std::vector<Vec2d> points(std::size_t min_count) {
    std::vector<Vec2d> points;
    for (std::size_t i = 0; i < min_count; ++i) points.push_back(read_point(arguments));
    while (const std::optional<std::string> text = arguments.text_if_present())
      points.push_back(parse_point(arguments, *text));
    return points;
  }
};

// A random number in [0, 1) for element `number` of a shape; `which` selects one of several independent
// numbers.
double random_at(std::int32_t number, std::int32_t which, double seed) {
  return hash_at(number, which, 0, static_cast<std::uint64_t>(seed));
}

Outline read_box(ShapeArguments& input) {
  const Vec2d a = read_point(input.arguments), b = read_point(input.arguments);
  return make_box(glm::min(a, b), glm::max(a, b), input.arguments.number("round", 0, 0, kMaxCoordinate));
}

Outline read_disc(ShapeArguments& input) {
  const Vec2d middle = read_point(input.arguments);
  return make_ellipse(middle, Vec2d{input.arguments.number(0.05, kMaxCoordinate)});
}

Outline read_ellipse(ShapeArguments& input) {
  const Vec2d middle = read_point(input.arguments), radii = read_point(input.arguments);
  if (radii.x <= 0 || radii.y <= 0) input.arguments.set_error("an ellipse's radii must be above 0");
  return make_ellipse(middle, glm::max(radii, Vec2d{0.05}));
}

Outline read_ring(ShapeArguments& input) {
  const Vec2d middle = read_point(input.arguments);
  const double radius = input.arguments.number(0.05, kMaxCoordinate);
  return make_ring(middle, radius, input.arguments.number("width", 1, 0.05, kMaxCoordinate));
}

Outline read_arc(ShapeArguments& input) {
  const Vec2d middle = read_point(input.arguments);
  const double radius = input.arguments.number(0.05, kMaxCoordinate);
  const double width = input.arguments.number("width", 1, 0.05, kMaxCoordinate);
  const double from = input.arguments.number("from", 0, -720, 720);
  return make_arc(middle, radius, width, from, input.arguments.number("until", 180, -720, 720));
}

Outline read_polygon(ShapeArguments& input) {
  return make_polygon(input.points(3));
}

Outline read_line(ShapeArguments& input) {
  const double width = input.arguments.number("width", 1, 0.05, kMaxCoordinate);
  const double flare = input.arguments.number("flare", 1, 0, 10);
  return make_line(input.points(2), width, flare);
}

Outline read_text(ShapeArguments& input) {
  Arguments& arguments = input.arguments;
  const std::string text = arguments.text();
  Vec2d position = read_point(arguments);
  LetteringStyle style;
  style.height = arguments.number("height", 20, 4, 512);
  style.weight = arguments.number("weight", style.height / 5, 0.5, 128);
  style.flare = arguments.number("flare", 1, 0, 4);
  style.spacing = arguments.number("spacing", style.weight / 2, -64, 64);
  style.narrow = arguments.number("narrow", 1, 0.2, 4);
  const std::string align = arguments.text("align", "left");
  const auto unknown = std::find_if_not(text.begin(), text.end(), has_letter);
  if (unknown != text.end())
    arguments.set_error(fmt::format("the lettering has no '{}'", base::quotable({&*unknown, 1})));
  else if (text.find_first_not_of(' ') == std::string::npos)
    arguments.set_error("the text is empty");
  else {
    if (align == "middle")
      position.x -= measure_text(text, style) / 2;
    else if (align == "right")
      position.x -= measure_text(text, style);
    else if (align != "left")
      arguments.set_error(fmt::format("align={} is not one of left, middle, right", base::quotable(align)));
    return make_text(text, position, style);
  }
  // After an error, any valid shape will do.
  return make_box({0, 0}, {1, 1}, 0);
}

Outline read_blob(ShapeArguments& input) {
  const Vec2d middle = read_point(input.arguments);
  const double radius = input.arguments.number(0.05, kMaxCoordinate);
  const double rough = input.arguments.number("rough", 0.2, 0, 2);
  return make_blob(middle, radius, rough, input.arguments.number("swell", 0.5, 0.05, 10), input.seed());
}

// A seismograph trace: a zigzag that is quiet at both ends and strongest at `peak`, with a Gaussian envelope.
Outline read_wave(ShapeArguments& input) {
  const Vec2d from = read_point(input.arguments), to = read_point(input.arguments);
  const double height = input.arguments.number("height", 8, 0, kMaxCoordinate);
  const double width = input.arguments.number("width", 1, 0.05, kMaxCoordinate);
  const std::int32_t swings = input.arguments.integer("swings", 16, 2, 400);
  const double peak = input.arguments.number("peak", 0.5, 0, 1);
  const double seed = input.seed();
  const Vec2d along = to - from;
  const double length = std::max(glm::length(along), 1e-6);
  const Vec2d across{-along.y / length, along.x / length};
  std::vector<Vec2d> points = {from};
  for (std::int32_t i = 1; i < swings; ++i) {
    const double share = static_cast<double>(i) / swings, off = (share - peak) * 4;
    const double swing = height * (0.06 + std::exp(-off * off)) * (0.35 + 0.65 * random_at(i, 1, seed));
    points.push_back(from + along * share + across * ((i & 1) != 0 ? -swing : swing));
  }
  points.push_back(to);
  return make_trace(points, width);
}

// A jagged line: five times, each segment is split at its middle, which moves sideways at random (midpoint
// displacement). The crack narrows toward its end.
Outline read_crack(ShapeArguments& input) {
  const Vec2d from = read_point(input.arguments), to = read_point(input.arguments);
  const double rough = input.arguments.number("rough", 0.2, 0, 2);
  const double width = input.arguments.number("width", 2, 0.05, kMaxCoordinate);
  const double seed = input.seed();
  std::vector<Vec2d> points = {from, to};
  for (std::int32_t level = 0; level < 5; ++level) {
    std::vector<Vec2d> finer;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vec2d along = points[i + 1] - points[i];
      const double off = rough * (random_at(static_cast<std::int32_t>(i), level, seed) - 0.5);
      finer.push_back(points[i]);
      finer.push_back((points[i] + points[i + 1]) * 0.5 + Vec2d{-along.y, along.x} * off);
    }
    finer.push_back(points.back());
    points = std::move(finer);
  }
  // A polygon around the line: along one side and back along the other.
  std::vector<Vec2d> rim;
  const auto half_at = [&](std::size_t i) {
    return width / 2 * (1 - static_cast<double>(i) / static_cast<double>(points.size() - 1)) + 0.15;
  };
  const Vec2d along = glm::normalize(to - from + Vec2d{1e-9, 0}), across{-along.y, along.x};
  for (std::size_t i = 0; i < points.size(); ++i) rim.push_back(points[i] + across * half_at(i));
  for (std::size_t i = points.size(); i-- > 0;) rim.push_back(points[i] - across * half_at(i));
  return make_polygon(std::move(rim));
}

// A row of hills that starts at height `top` and is filled down to the canvas' lower edge.
Outline read_ridge(ShapeArguments& input) {
  const double top = input.arguments.number(-kMaxCoordinate, kMaxCoordinate);
  const double height = input.arguments.number("height", 20, 0, kMaxCoordinate);
  const double hill = input.arguments.number("hill", 40, 1, kMaxCoordinate);
  const auto seed = static_cast<std::uint64_t>(input.seed());
  std::vector<double> tops;
  for (double x = 0; x <= input.canvas_size.x + 2; ++x) {
    const double lump = lump_noise({x / hill, 0.5, 0.5}, seed);
    tops.push_back(top + height * (1 - lump * 2 * (1 - std::abs(lump - 0.5))));
  }
  return make_ground(std::move(tops), input.canvas_size.y + 1);
}

Outline read_fill(ShapeArguments& input) {
  return make_box({-1, -1}, input.canvas_size + Vec2d{1, 1}, 0);
}

// Random discs of different sizes in a box.
Outline read_scatter(ShapeArguments& input) {
  const std::int32_t count = static_cast<std::int32_t>(input.arguments.number(1, 2000));
  const Vec2d mins = read_point(input.arguments), maxs = read_point(input.arguments);
  const auto [small, large] = input.arguments.range("size", {0.4, 1});
  const double seed = input.seed();
  std::vector<Outline> grains;
  for (std::int32_t i = 0; i < count; ++i) {
    const Vec2d position = mins + (maxs - mins) * Vec2d{random_at(i, 1, seed), random_at(i, 2, seed)};
    grains.push_back(make_ellipse(position, Vec2d{small + (large - small) * random_at(i, 3, seed)}));
  }
  return join_outlines(std::move(grains));
}

struct ShapeKeyword {
  std::string_view keyword;
  Outline (*read)(ShapeArguments& input);
};
constexpr std::array kKeywords = {
    ShapeKeyword{"box", read_box},         ShapeKeyword{"disc", read_disc},
    ShapeKeyword{"ellipse", read_ellipse}, ShapeKeyword{"ring", read_ring},
    ShapeKeyword{"arc", read_arc},         ShapeKeyword{"polygon", read_polygon},
    ShapeKeyword{"line", read_line},       ShapeKeyword{"text", read_text},
    ShapeKeyword{"blob", read_blob},       ShapeKeyword{"wave", read_wave},
    ShapeKeyword{"crack", read_crack},     ShapeKeyword{"ridge", read_ridge},
    ShapeKeyword{"scatter", read_scatter}, ShapeKeyword{"fill", read_fill},
};

const ShapeKeyword* find_keyword(std::string_view word) {
  const auto found = std::find_if(kKeywords.begin(), kKeywords.end(),
                                  [&](const ShapeKeyword& known) { return known.keyword == word; });
  return found != kKeywords.end() ? &*found : nullptr;
}

}  // namespace

bool is_shape_keyword(std::string_view word) {
  return find_keyword(word) != nullptr;
}

std::string_view shape_keywords() {
  return "box, disc, ellipse, ring, arc, polygon, line, text, blob, wave, crack, ridge, scatter, fill";
}

Outline read_outline(std::string_view word, Arguments& io_arguments, Vec2d canvas_size) {
  ShapeArguments input{io_arguments, canvas_size};
  Outline outline = find_keyword(word)->read(input);
  if (!io_arguments.has("mirror")) return outline;
  return add_mirror_image(std::move(outline),
                          io_arguments.number("mirror", 0, -kMaxCoordinate, kMaxCoordinate));
}

}  // namespace temblor::artgen::pictures
