#include "artgen/pictures/glyphs.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"

namespace temblor::artgen::pictures {
namespace {

// A single character stands for itself, so "8" is a digit and "08" a code.
std::optional<std::uint8_t> parse_code(std::string_view text) {
  if (text.size() == 1) return static_cast<std::uint8_t>(text[0]);
  std::uint8_t code = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), code);
  if (text.empty() || failure != std::errc() || end != text.data() + text.size()) return {};
  return code;
}

// Missing rows and dots are empty.
base::Result<Glyph> read_rows(const ScriptLine& line) {
  if (line.below.size() > kGlyphSide) return script_error(line, "a glyph has at most 8 rows");
  Glyph glyph;
  for (std::size_t y = 0; y < line.below.size(); ++y) {
    const ScriptLine& row = line.below[y];
    Arguments nothing_else(row);
    TRY_STATUS(nothing_else.finish());
    if (row.keyword.size() > kGlyphSide || row.keyword.find_first_not_of(".x") != std::string::npos)
      return script_error(row, "a glyph's row is up to 8 characters, each . or x");
    for (std::size_t x = 0; x < row.keyword.size(); ++x)
      if (row.keyword[x] == 'x') glyph.rows[y] = static_cast<std::uint8_t>(glyph.rows[y] | 1u << x);
  }
  return glyph;
}

base::Status add_glyph(const ScriptLine& line, Glyphs& io_glyphs) {
  Arguments arguments(line);
  const std::string name = arguments.text(), like = arguments.text("like", "");
  TRY_STATUS(arguments.finish());
  const std::optional<std::uint8_t> code = parse_code(name);
  if (!code)
    return script_error(
        line, fmt::format("'{}' is neither a character nor a code up to 255", base::quotable(name)));
  TRY(Glyph glyph, read_rows(line));
  if (!like.empty()) {
    const auto found = parse_code(like) ? io_glyphs.find(*parse_code(like)) : io_glyphs.end();
    if (found == io_glyphs.end() || !line.below.empty())
      return script_error(line, "like= must name a glyph defined above, and the copy has no rows");
    glyph = found->second;
  }
  if (!io_glyphs.emplace(*code, glyph).second)
    return script_error(line, fmt::format("glyph '{}' is already defined", base::quotable(name)));
  return base::Ok{};
}

}  // namespace

base::Result<Glyphs> read_glyphs(std::span<const ScriptLine> lines) {
  Glyphs glyphs;
  for (const ScriptLine& line : lines)
    if (line.keyword == "glyph") TRY_STATUS(add_glyph(line, glyphs));
  return glyphs;
}

}  // namespace temblor::artgen::pictures
