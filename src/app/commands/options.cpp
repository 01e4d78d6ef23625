#include "app/commands/options.h"

#include <array>
#include <charconv>
#include <cmath>

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr int kMaxSide = 8192;

// Parses all of `text` as a number; nothing if any character is left over.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

base::Result<FrameSize> parse_size(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x != std::string_view::npos) {
    const auto width = parse_number<int>(text.substr(0, x));
    const auto height = parse_number<int>(text.substr(x + 1));
    if (width && height && *width >= 1 && *width <= kMaxSide && *height >= 1 && *height <= kMaxSide)
      return FrameSize{*width, *height};
  }
  return base::error(ErrorCode::kUsage, "\"{}\" is not WIDTHxHEIGHT, each 1 to {} pixels", text, kMaxSide);
}

base::Result<FrameRange> parse_frame_range(std::string_view text) {
  // Without a colon, the text is the end of a range that begins at 0. Both ends may be left out, but not at
  // once.
  FrameRange range{0, kMaxFrames};
  const std::size_t colon = text.find(':');
  const std::string_view first = colon == std::string_view::npos ? "" : text.substr(0, colon);
  const std::string_view end = colon == std::string_view::npos ? text : text.substr(colon + 1);
  const auto first_number = parse_number<std::size_t>(first), end_number = parse_number<std::size_t>(end);
  range.first = first_number.value_or(0);
  range.end = end_number.value_or(kMaxFrames);
  const bool parsed = (first_number || first.empty()) && (end_number || (end.empty() && !first.empty()));
  if (parsed && range.first < range.end && range.end <= kMaxFrames) return range;
  return base::error(ErrorCode::kUsage, "\"{}\" is neither a number of frames nor a range A:B with A < B",
                     text);
}

base::Result<math::Vec3> parse_vec3(std::string_view text) {
  std::array<float, 3> parts{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t comma = i < 2 ? rest.find(',') : rest.size();
    const auto number = parse_number<float>(rest.substr(0, comma));
    if (comma == std::string_view::npos || !number || !std::isfinite(*number))
      return base::error(ErrorCode::kUsage, "\"{}\" is not three numbers separated by commas", text);
    parts[i] = *number;
    if (i < 2) rest.remove_prefix(comma + 1);
  }
  return math::Vec3(parts[0], parts[1], parts[2]);
}

base::Result<render::PixelFormat> parse_color(std::string_view text) {
  for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb})
    if (text == pixel_format_name(format)) return format;
  return base::error(ErrorCode::kUsage, "\"{}\" is neither indexed nor rgb", text);
}

base::Result<RendererKind> parse_renderer(std::string_view text) {
  if (text == "cpu") return RendererKind::kCpu;
  if (text == "gl") return RendererKind::kGl;
  return base::error(ErrorCode::kUsage, "\"{}\" is neither cpu nor gl", text);
}

const char* pixel_format_name(render::PixelFormat format) {
  return format == render::PixelFormat::kIndexed ? "indexed" : "rgb";
}

// Later settings override earlier ones: --set in order, then --show and --threads.
base::Status apply_options(const CommonOptions& options, std::optional<int> threads,
                           command::Variables& io_variables) {
  auto as_usage = [](const char* option, base::Status status) -> base::Status {
    if (status.ok()) return status;
    return base::error(ErrorCode::kUsage, "{}: {}; `temblor settings` lists all variables", option,
                       status.error().what);
  };
  for (const std::string& assignment : options.assignments)
    TRY_STATUS(as_usage("--set", io_variables.set_assignment(assignment)));
  if (!options.show.empty()) TRY_STATUS(as_usage("--show", io_variables.set("r_show", options.show)));
  if (threads) TRY_STATUS(as_usage("--threads", io_variables.set("r_threads", std::to_string(*threads))));
  return base::Ok{};
}

}  // namespace temblor::app
