#include "client/lines/world_text.h"

#include <algorithm>
#include <string_view>

#include "math/angles.h"

namespace temblor::client {
namespace {

// Strokes go from point to point of this grid; a space lifts the pen. A letter is twice as high as wide.
//
//   a b c
//   d e f
//   g h i
//   j k l
//   m n o
struct Glyph {
  char letter;
  std::string_view strokes;
};
constexpr Glyph kGlyphs[] = {
    {'A', "mdbfo gi"}, {'B', "abfhg hlnma"}, {'C', "cbdjno"},    {'D', "abflnma"},  {'E', "camo gh"},
    {'F', "cam gh"},   {'G', "cbdjnoih"},    {'H', "am co gi"},  {'I', "ac bn mo"}, {'J', "clnj"},
    {'K', "am cgo"},   {'L', "amo"},         {'M', "maeco"},     {'N', "maoc"},     {'O', "bdjnlfb"},
    {'P', "mabfhg"},   {'Q', "bdjnlfb ko"},  {'R', "mabfhg ho"}, {'S', "cbdhlnm"},  {'T', "ac bn"},
    {'U', "ajnlc"},    {'V', "anc"},         {'W', "amkoc"},     {'X', "ao cm"},    {'Y', "ahc hn"},
    {'Z', "acmo"},     {'0', "bdjnlfb fj"},  {'1', "dbn mo"},    {'2', "dbfmo"},    {'3', "achlnj"},
    {'4', "nbjl"},     {'5', "caghlnm"},     {'6', "cbdjnlhg"},  {'7', "acm"},      {'8', "bdhfb hjnlh"},
    {'9', "fhdbfln"},  {'.', "nn"},          {',', "kn"},        {':', "ee kk"},    {';', "ee kn"},
    {'-', "gi"},       {'+', "gi ek"},       {'=', "df jl"},     {'_', "mo"},       {'/', "cm"},
    {'\\', "ao"},      {'(', "cejo"},        {')', "aflm"},      {'[', "bamn"},     {']', "bcon"},
    {'<', "fgl"},      {'>', "dij"},         {'!', "bh nn"},     {'?', "dbfhk nn"}, {'\'', "be"},
    {'"', "ad cf"},    {'*', "ej gi dl"},    {'%', "cm aa oo"},  {'|', "bn"},       {'#', "am co df jl"},
};
constexpr std::string_view kNoGlyph = "acoma";
constexpr float kLetterWidth = 0.5f, kAdvance = 0.75f;  // of the height

std::string_view find_strokes(char letter) {
  const char capital = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  const auto* const found = std::ranges::find(kGlyphs, capital, &Glyph::letter);
  return found == std::end(kGlyphs) ? kNoGlyph : found->strokes;
}

}  // namespace

void append_text_lines(const WorldText& text, const math::Vec3& camera_angles_deg,
                       std::vector<render::Line>& io_lines) {
  const math::Basis axes = math::basis_from_angles(camera_angles_deg);
  const math::Vec3 right = math::Vec3(axes.right) * text.size, down = math::Vec3(axes.up) * -text.size;
  const float width = static_cast<float>(text.text.size()) * kAdvance - (kAdvance - kLetterWidth);
  math::Vec3 corner = text.origin_world - right * (width / 2) - down * 0.5f;
  for (const char letter : text.text) {
    const auto place = [&](char point) {
      const int number = point - 'a';
      return corner + right * (static_cast<float>(number % 3) / 2 * kLetterWidth) +
             down * (static_cast<float>(number / 3) / 4);
    };
    const std::string_view strokes = static_cast<unsigned char>(letter) > ' ' ? find_strokes(letter) : "";
    for (std::size_t i = 0; i + 1 < strokes.size(); ++i)
      if (strokes[i] != ' ' && strokes[i + 1] != ' ')
        io_lines.push_back({place(strokes[i]), place(strokes[i + 1]), {255, 255, 255}, text.is_depth_tested});
    corner += right * kAdvance;
  }
}

}  // namespace temblor::client
