#include "artgen/pictures/drawing_settings.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "artgen/models/reading/values.h"
#include "artgen/scripts/ramp_names.h"
#include "base/text.h"

namespace temblor::artgen::pictures {
namespace {

// Nothing if the setting is missing, which means that the ink does not have this part.
std::optional<Tone> read_tone_if_present(Arguments& io_arguments, std::string_view name,
                                         const Tone& defaults) {
  if (!io_arguments.has(name)) return {};
  return read_tone(io_arguments, name, defaults);
}

}  // namespace

math::Vec2d parse_point(Arguments& io_arguments, std::string_view text) {
  const std::optional<std::vector<double>> numbers = parse_numbers(text);
  if (numbers && numbers->size() == 2) return {(*numbers)[0], (*numbers)[1]};
  io_arguments.set_error(fmt::format("'{}' is not X,Y", base::quotable(text)));
  return math::Vec2d{0.0};
}

math::Vec2d read_point(Arguments& io_arguments) {
  return parse_point(io_arguments, io_arguments.text());
}

math::Vec2d read_point(Arguments& io_arguments, std::string_view name, math::Vec2d fallback) {
  if (!io_arguments.has(name)) return fallback;
  return parse_point(io_arguments, io_arguments.text(name, ""));
}

Ramp read_ramp(Arguments& io_arguments, std::string_view name_of_ramp) {
  for (std::size_t i = 0; i < kRampNames.size(); ++i)
    if (kRampNames[i] == name_of_ramp) return static_cast<Ramp>(i);
  io_arguments.set_error(fmt::format("'{}' is not a color ramp; expected one of {}",
                                     base::quotable(name_of_ramp), fmt::join(kRampNames, ", ")));
  return Ramp::kGray;
}

Tone read_tone(Arguments& io_arguments, std::string_view name, Tone fallback) {
  if (!io_arguments.has(name)) return fallback;
  const std::string text = io_arguments.text(name, "");
  const std::size_t colon = text.find(':');
  Tone tone{read_ramp(io_arguments, text.substr(0, colon)), 0.5};
  if (colon == std::string::npos) return tone;
  const std::optional<std::vector<double>> numbers = parse_numbers(text.substr(colon + 1));
  if (!numbers || numbers->size() != 1 || (*numbers)[0] < 0 || (*numbers)[0] > 1)
    io_arguments.set_error(
        fmt::format("{}={} is not RAMP:TONE with a tone from 0 to 1", name, base::quotable(text)));
  else
    tone.tone = (*numbers)[0];
  return tone;
}

Ink read_ink(Arguments& io_arguments) {
  constexpr double kMaxPixels = 1000;
  Ink ink;
  ink.color = read_tone(io_arguments, "color", {});
  ink.to = read_tone(io_arguments, "to", ink.color);
  const std::string blend = io_arguments.text("blend", "down");
  if (blend == "across")
    ink.blend = Blend::kAcross;
  else if (blend == "out")
    ink.blend = Blend::kOut;
  else if (blend != "down")
    io_arguments.set_error(fmt::format("blend={} is not one of down, across, out", base::quotable(blend)));
  ink.opacity = io_arguments.number("opacity", 1, 0, 1);
  ink.raise = io_arguments.number("raise", 0, -kMaxPixels, kMaxPixels);
  ink.light = io_arguments.number("light", 0.35, 0, 2);
  ink.grain = io_arguments.number("grain", 0, 0, 2);
  ink.lump = io_arguments.number("lump", 4, 0.2, kMaxPixels);
  ink.stain = read_tone_if_present(io_arguments, "stain", {});
  ink.stained = io_arguments.number("stained", 0.4, 0, 1);
  ink.stain_lump = io_arguments.number("stain_lump", 6, 0.2, kMaxPixels);
  ink.edge = read_tone_if_present(io_arguments, "edge", {});
  ink.edge_width = io_arguments.number("edge_width", 1, 0, 64);
  ink.glow = read_tone_if_present(io_arguments, "glow", {});
  ink.glow_reach = io_arguments.number("glow_reach", 4, 0.1, kMaxPixels);
  ink.glow_strength = io_arguments.number("glow_strength", 0.8, 0, 1);
  ink.shadow = io_arguments.number("shadow", 0, 0, 64);
  ink.holes = io_arguments.number("holes", 0, 0, 1);
  ink.erases = io_arguments.flag("erase");
  ink.keeps_ramp = io_arguments.flag("keep_ramp");
  ink.seed = static_cast<std::uint64_t>(io_arguments.integer("seed", 1, 0, 1 << 30));
  return ink;
}

Placement read_placement(Arguments& io_arguments) {
  Placement placement;
  placement.at = read_point(io_arguments, "at", {0, 0});
  placement.turn_deg = io_arguments.number("turn", 0, -360, 360);
  placement.scale = io_arguments.number("scale", 1, 0.01, 100);
  return placement;
}

}  // namespace temblor::artgen::pictures
