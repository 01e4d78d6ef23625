#include "artgen/pictures/glyphs.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"

namespace temblor::artgen::pictures {
namespace {

// One character is itself, more are a code.
std::optional<std::uint8_t> code_in(std::string_view text) {
  if (text.size() == 1) return static_cast<std::uint8_t>(text[0]);
  std::uint8_t code = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), code);
  if (text.empty() || failure != std::errc() || end != text.data() + text.size()) return {};
  return code;
}

base::Result<Glyph> read_rows(const ScriptLine& line) {
  if (line.below.size() > kGlyphSide) return script_error(line, "a glyph has at most 8 rows");
  Glyph glyph;
  for (std::size_t y = 0; y < line.below.size(); ++y) {
    const ScriptLine& row = line.below[y];
    Arguments nothing_else(row);
    TRY_STATUS(nothing_else.finish());
    if (row.word.size() > kGlyphSide || row.word.find_first_not_of(".x") != std::string::npos)
      return script_error(row, "a row of a glyph is up to 8 dots and x");
    for (std::size_t x = 0; x < row.word.size(); ++x)
      if (row.word[x] == 'x') glyph.rows[y] = static_cast<std::uint8_t>(glyph.rows[y] | 1u << x);
  }
  return glyph;
}

base::Status add_glyph(const ScriptLine& line, Glyphs& io_glyphs) {
  Arguments arguments(line);
  const std::string name = arguments.text(), like = arguments.text("like", "");
  TRY_STATUS(arguments.finish());
  const std::optional<std::uint8_t> code = code_in(name);
  if (!code)
    return script_error(line,
                        fmt::format("'{}' is neither a character nor a code to 255", base::quotable(name)));
  TRY(Glyph glyph, read_rows(line));
  if (!like.empty()) {
    const auto found = code_in(like) ? io_glyphs.find(*code_in(like)) : io_glyphs.end();
    if (found == io_glyphs.end() || !line.below.empty())
      return script_error(line, "like= is a glyph from above, and then there are no rows");
    glyph = found->second;
  }
  if (!io_glyphs.emplace(*code, glyph).second)
    return script_error(line, fmt::format("there is another glyph '{}'", base::quotable(name)));
  return base::Ok{};
}

}  // namespace

base::Result<Glyphs> read_glyphs(std::span<const ScriptLine> lines) {
  Glyphs glyphs;
  for (const ScriptLine& line : lines)
    if (line.word == "glyph") TRY_STATUS(add_glyph(line, glyphs));
  return glyphs;
}

}  // namespace temblor::artgen::pictures
