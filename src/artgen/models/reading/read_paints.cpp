#include <fmt/format.h>

#include "artgen/models/reading/read_parts.h"
#include "artgen/scripts/ramp_names.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// Gray after an error.
Ramp read_ramp(Arguments& io_arguments) {
  const std::string name = io_arguments.text();
  for (std::size_t i = 0; i < kRampNames.size(); ++i)
    if (kRampNames[i] == name) return static_cast<Ramp>(i);
  io_arguments.set_error(fmt::format("'{}' is not a color ramp; expected one of {}", base::quotable(name),
                                     fmt::join(kRampNames, ", ")));
  return Ramp::kGray;
}

// A `spots` or `stripes` line.
base::Status read_layer(const ScriptLine& line, Paint& io_paint) {
  Arguments arguments(line);
  const bool is_stripes = line.keyword == "stripes";
  PaintLayer layer;
  layer.ramp = read_ramp(arguments);
  std::tie(layer.low, layer.high) = arguments.range("bright", {0.2, 0.6});
  layer.amount = arguments.number("amount", is_stripes ? 0.5 : 0.3, 0, 1);
  layer.grain = arguments.number("grain", 4, 0.1, 1000);
  if (is_stripes) {
    layer.every = arguments.number("every", 4, 0.1, 1000);
    layer.axis = math::Vec3d(arguments.vector("axis", {0, 0, 1}));
    layer.waver = arguments.number("waver", 0, 0, 1000);
  }
  io_paint.layers.push_back(layer);
  return arguments.finish();
}

}  // namespace

base::Status read_paint(const ScriptLine& line, std::vector<Paint>& io_paints) {
  Arguments arguments(line);
  Paint paint;
  paint.name = arguments.text();
  paint.ramp = read_ramp(arguments);
  std::tie(paint.low, paint.high) = arguments.range("bright", {0.15, 0.7});
  paint.noise = arguments.number("noise", 0.3, 0, 2);
  paint.grain = arguments.number("grain", 4, 0.1, 1000);
  paint.wear = arguments.number("wear", 0, 0, 2);
  paint.shade = arguments.number("shade", 1, 0, 1);
  TRY_STATUS(arguments.finish());
  for (const ScriptLine& below : line.below) {
    if (below.keyword != "spots" && below.keyword != "stripes")
      return script_error(below, "only 'spots' and 'stripes' lines can be under a paint");
    TRY_STATUS(read_layer(below, paint));
  }
  for (Paint& known : io_paints) {
    if (known.name != paint.name) continue;
    known = std::move(paint);
    return base::Ok{};
  }
  io_paints.push_back(std::move(paint));
  return base::Ok{};
}

}  // namespace temblor::artgen
