// Built-in functions that draw letters of the console's character set.
#include <algorithm>

#include "client/hud/panel.h"
#include "client/hud_program/program_call.h"

namespace temblor::client {
namespace {

// Letters of a text with its color codes: "^" and a digit, "^x" and three hexadecimal digits, "^^" for one
// "^". Calls `letter(code, rgb)` for each.
template <typename Letter>
base::Status for_each_letter(std::string_view text, bool has_codes, Letter letter) {
  static constexpr float kColors[10][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},       {0, 0, 1},
                                           {0, 1, 1}, {1, 0, 1}, {1, 1, 1}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}};
  const auto hex = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
  };
  math::Vec3 rgb(1.0f);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (has_codes && text[i] == '^' && next >= '0' && next <= '9') {
      const float* const channels = kColors[next - '0'];
      rgb = {channels[0], channels[1], channels[2]};
      ++i;
      continue;
    }
    if (has_codes && text[i] == '^' && next == 'x' && i + 4 < text.size() && hex(text[i + 2]) >= 0 &&
        hex(text[i + 3]) >= 0 && hex(text[i + 4]) >= 0) {
      for (int axis = 0; axis < 3; ++axis)
        rgb[axis] = static_cast<float>(hex(text[i + 2 + static_cast<std::size_t>(axis)])) / 15.0f;
      i += 4;
      continue;
    }
    if (has_codes && text[i] == '^' && next == '^') ++i;
    TRY_STATUS(letter(static_cast<std::uint8_t>(text[i]), rgb));
  }
  return base::Ok{};
}

// Characters are parts of one picture of 16 x 16 characters. Spaces draw nothing.
base::Status draw_letter(ProgramCall& io_call, std::uint8_t code, const VirtualRect& area,
                         const ProgramColor& color) {
  constexpr int kShape = 127, kPerRow = 16;
  constexpr float kSide = 1.0f / kPerRow;  // of a character, in the picture
  if ((code & kShape) == ' ' || code == 0) return base::Ok{};
  const math::Vec2 corner(static_cast<float>(code % kPerRow) * kSide,
                          static_cast<float>(code / kPerRow) * kSide);
  return io_call.program.canvas.draw_picture(io_call.program.services.pictures.characters(), area,
                                             {corner, {kSide, kSide}}, color);
}

base::Status draw_letters(ProgramCall& io_call, bool has_codes) {
  if (!io_call.program.may_draw) return io_call.error("draws outside of a frame");
  TRY_STATUS(io_call.return_number(1));
  io_call.machine.charge(io_call.text(1).size());
  math::Vec2 place(io_call.vector(0));
  const math::Vec2 size(io_call.vector(2));
  const ProgramColor color = read_color(io_call, 3);
  return for_each_letter(io_call.text(1), has_codes, [&](std::uint8_t code, const math::Vec3& rgb) {
    const base::Status drawn =
        draw_letter(io_call, code, {place, size}, {color.rgb * rgb, color.alpha, color.mode});
    place.x += size.x;
    return drawn;
  });
}

// drawstring(position, text, size, rgb, alpha, flag), and the same without color codes.
base::Status drawstring(ProgramCall& io_call) {
  return draw_letters(io_call, true);
}
base::Status drawrawstring(ProgramCall& io_call) {
  return draw_letters(io_call, false);
}

// drawcharacter(position, code, size, rgb, alpha, flag)
base::Status drawcharacter(ProgramCall& io_call) {
  if (!io_call.program.may_draw) return io_call.error("draws outside of a frame");
  TRY_STATUS(io_call.return_number(1));
  return draw_letter(io_call, static_cast<std::uint8_t>(io_call.whole(1) & 255),
                     {math::Vec2(io_call.vector(0)), math::Vec2(io_call.vector(2))}, read_color(io_call, 3));
}

// stringwidth(text, has_codes, size): without a size, that of letters of 8 x 8.
base::Status stringwidth(ProgramCall& io_call) {
  int letters = 0;
  TRY_STATUS(for_each_letter(io_call.text(0), io_call.number(1) != 0, [&](std::uint8_t, const math::Vec3&) {
    ++letters;
    return base::Status(base::Ok{});
  }));
  const float width = io_call.count() > 2 ? io_call.vector(2).x : static_cast<float>(kCharacterSide);
  return io_call.return_number(width * static_cast<float>(letters));
}

}  // namespace

std::span<const ProgramEntry> program_text_drawing() {
  static constexpr ProgramEntry kEntries[] = {
      {320, "drawcharacter", drawcharacter},
      {321, "drawrawstring", drawrawstring},
      {326, "drawstring", drawstring},
      {327, "stringwidth", stringwidth},
  };
  return kEntries;
}

}  // namespace temblor::client
