// The lines that draw a shape.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "artgen/models/noise.h"
#include "artgen/pictures/lettering.h"
#include "artgen/pictures/words.h"
#include "base/text.h"

namespace temblor::artgen::pictures {
namespace {

using math::Vec2d;

constexpr double kFar = 4096;  // pixels

struct Asked {
  Arguments& arguments;
  Vec2d canvas_size;

  double seed() { return arguments.integer("seed", 1, 0, 1 << 30); }
  std::vector<Vec2d> points(std::size_t fewest) {
    std::vector<Vec2d> points;
    for (std::size_t i = 0; i < fewest; ++i) points.push_back(read_point(arguments));
    while (const std::optional<std::string> text = arguments.text_if_there())
      points.push_back(point_in(arguments, *text));
    return points;
  }
};

double random_at(std::int32_t number, std::int32_t which, double seed) {
  return hash_at(number, which, 0, static_cast<std::uint64_t>(seed));
}

Outline read_box(Asked& asked) {
  const Vec2d a = read_point(asked.arguments), b = read_point(asked.arguments);
  return make_box(glm::min(a, b), glm::max(a, b), asked.arguments.number("round", 0, 0, kFar));
}

Outline read_disc(Asked& asked) {
  const Vec2d middle = read_point(asked.arguments);
  return make_ellipse(middle, Vec2d{asked.arguments.number(0.05, kFar)});
}

Outline read_ellipse(Asked& asked) {
  const Vec2d middle = read_point(asked.arguments), radii = read_point(asked.arguments);
  if (radii.x <= 0 || radii.y <= 0) asked.arguments.complain("an ellipse's radii are above 0");
  return make_ellipse(middle, glm::max(radii, Vec2d{0.05}));
}

Outline read_ring(Asked& asked) {
  const Vec2d middle = read_point(asked.arguments);
  const double radius = asked.arguments.number(0.05, kFar);
  return make_ring(middle, radius, asked.arguments.number("width", 1, 0.05, kFar));
}

Outline read_arc(Asked& asked) {
  const Vec2d middle = read_point(asked.arguments);
  const double radius = asked.arguments.number(0.05, kFar);
  const double width = asked.arguments.number("width", 1, 0.05, kFar);
  const double from = asked.arguments.number("from", 0, -720, 720);
  return make_arc(middle, radius, width, from, asked.arguments.number("until", 180, -720, 720));
}

Outline read_polygon(Asked& asked) {
  return make_polygon(asked.points(3));
}

Outline read_line(Asked& asked) {
  const double width = asked.arguments.number("width", 1, 0.05, kFar);
  const double flare = asked.arguments.number("flare", 1, 0, 10);
  return make_line(asked.points(2), width, flare);
}

Outline read_text(Asked& asked) {
  Arguments& arguments = asked.arguments;
  const std::string text = arguments.text();
  Vec2d place = read_point(arguments);
  LetteringLook look;
  look.height = arguments.number("height", 20, 4, 512);
  look.weight = arguments.number("weight", look.height / 5, 0.5, 128);
  look.flare = arguments.number("flare", 1, 0, 4);
  look.spacing = arguments.number("spacing", look.weight / 2, -64, 64);
  look.narrow = arguments.number("narrow", 1, 0.2, 4);
  const std::string align = arguments.text("align", "left");
  const auto unknown = std::find_if_not(text.begin(), text.end(), has_letter);
  if (unknown != text.end())
    arguments.complain(fmt::format("there is no letter '{}'", base::quotable({&*unknown, 1})));
  else if (text.find_first_not_of(' ') == std::string::npos)
    arguments.complain("a text has letters");
  else {
    if (align == "middle")
      place.x -= text_width(text, look) / 2;
    else if (align == "right")
      place.x -= text_width(text, look);
    else if (align != "left")
      arguments.complain(fmt::format("align={} is none of left, middle, right", base::quotable(align)));
    return make_text(text, place, look);
  }
  return make_box({0, 0}, {1, 1}, 0);
}

Outline read_blob(Asked& asked) {
  const Vec2d middle = read_point(asked.arguments);
  const double radius = asked.arguments.number(0.05, kFar);
  const double rough = asked.arguments.number("rough", 0.2, 0, 2);
  return make_blob(middle, radius, rough, asked.arguments.number("swell", 0.5, 0.05, 10), asked.seed());
}

// A seismograph's trace: quiet at both ends, wildest in the middle.
Outline read_wave(Asked& asked) {
  const Vec2d from = read_point(asked.arguments), to = read_point(asked.arguments);
  const double height = asked.arguments.number("height", 8, 0, kFar);
  const double width = asked.arguments.number("width", 1, 0.05, kFar);
  const std::int32_t swings = asked.arguments.integer("swings", 16, 2, 400);
  const double peak = asked.arguments.number("peak", 0.5, 0, 1);
  const double seed = asked.seed();
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

// A jagged line, halved again and again; thin at its end.
Outline read_crack(Asked& asked) {
  const Vec2d from = read_point(asked.arguments), to = read_point(asked.arguments);
  const double rough = asked.arguments.number("rough", 0.2, 0, 2);
  const double width = asked.arguments.number("width", 2, 0.05, kFar);
  const double seed = asked.seed();
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
  std::vector<Vec2d> rim;
  const auto half_at = [&](std::size_t i) {
    return width / 2 * (1 - static_cast<double>(i) / static_cast<double>(points.size() - 1)) + 0.15;
  };
  const Vec2d along = glm::normalize(to - from + Vec2d{1e-9, 0}), across{-along.y, along.x};
  for (std::size_t i = 0; i < points.size(); ++i) rim.push_back(points[i] + across * half_at(i));
  for (std::size_t i = points.size(); i-- > 0;) rim.push_back(points[i] - across * half_at(i));
  return make_polygon(std::move(rim));
}

// Hills from a height down to the canvas' lower edge.
Outline read_ridge(Asked& asked) {
  const double top = asked.arguments.number(-kFar, kFar);
  const double height = asked.arguments.number("height", 20, 0, kFar);
  const double hill = asked.arguments.number("hill", 40, 1, kFar);
  const auto seed = static_cast<std::uint64_t>(asked.seed());
  std::vector<double> tops;
  for (double x = 0; x <= asked.canvas_size.x + 2; ++x) {
    const double lump = lump_noise({x / hill, 0.5, 0.5}, seed);
    tops.push_back(top + height * (1 - lump * 2 * (1 - std::abs(lump - 0.5))));
  }
  return make_ground(std::move(tops), asked.canvas_size.y + 1);
}

Outline read_fill(Asked& asked) {
  return make_box({-1, -1}, asked.canvas_size + Vec2d{1, 1}, 0);
}

// Grains in a box, of differing size.
Outline read_scatter(Asked& asked) {
  const std::int32_t count = static_cast<std::int32_t>(asked.arguments.number(1, 2000));
  const Vec2d mins = read_point(asked.arguments), maxs = read_point(asked.arguments);
  const auto [small, large] = asked.arguments.range("size", {0.4, 1});
  const double seed = asked.seed();
  std::vector<Outline> grains;
  for (std::int32_t i = 0; i < count; ++i) {
    const Vec2d place = mins + (maxs - mins) * Vec2d{random_at(i, 1, seed), random_at(i, 2, seed)};
    grains.push_back(make_ellipse(place, Vec2d{small + (large - small) * random_at(i, 3, seed)}));
  }
  return joined(std::move(grains));
}

struct ShapeWord {
  std::string_view word;
  Outline (*read)(Asked& asked);
};
constexpr std::array kWords = {
    ShapeWord{"box", read_box},         ShapeWord{"disc", read_disc},   ShapeWord{"ellipse", read_ellipse},
    ShapeWord{"ring", read_ring},       ShapeWord{"arc", read_arc},     ShapeWord{"polygon", read_polygon},
    ShapeWord{"line", read_line},       ShapeWord{"text", read_text},   ShapeWord{"blob", read_blob},
    ShapeWord{"wave", read_wave},       ShapeWord{"crack", read_crack}, ShapeWord{"ridge", read_ridge},
    ShapeWord{"scatter", read_scatter}, ShapeWord{"fill", read_fill},
};

const ShapeWord* find_word(std::string_view word) {
  const auto found =
      std::find_if(kWords.begin(), kWords.end(), [&](const ShapeWord& known) { return known.word == word; });
  return found != kWords.end() ? &*found : nullptr;
}

}  // namespace

bool is_shape_word(std::string_view word) {
  return find_word(word) != nullptr;
}

std::string_view shape_words() {
  return "box, disc, ellipse, ring, arc, polygon, line, text, blob, wave, crack, ridge, scatter, fill";
}

Outline read_outline(std::string_view word, Arguments& io_arguments, Vec2d canvas_size) {
  Asked asked{io_arguments, canvas_size};
  Outline outline = find_word(word)->read(asked);
  if (!io_arguments.has("mirror")) return outline;
  return with_mirror(std::move(outline), io_arguments.number("mirror", 0, -kFar, kFar));
}

}  // namespace temblor::artgen::pictures
