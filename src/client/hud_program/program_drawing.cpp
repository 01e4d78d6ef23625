// Built-in functions that draw pictures, rectangles, and lines.
#include "client/hud_program/program_call.h"

namespace temblor::client {
namespace {

// Drawing takes longer than an instruction, also outside of the frame.
base::Status check_may_draw(const ProgramCall& call) {
  constexpr std::uint64_t kCost = 8;
  call.machine.charge(kCost);
  if (call.program.may_draw) return base::Ok{};
  return call.error("draws outside of a frame");
}

// drawpic(position, picture, size, rgb, alpha, flag): draws nothing if there is no such picture, and returns
// 0.
base::Status drawpic(ProgramCall& io_call) {
  TRY_STATUS(check_may_draw(io_call));
  const formats::Picture* const picture = io_call.program.pictures.find(io_call.text(1));
  TRY_STATUS(io_call.return_number(picture != nullptr ? 1 : 0));
  if (picture == nullptr) return base::Ok{};
  return io_call.program.canvas.draw_picture(*picture,
                                             {math::Vec2(io_call.vector(0)), math::Vec2(io_call.vector(2))},
                                             {{0, 0}, {1, 1}}, read_color(io_call, 3));
}

// drawsubpic(position, size, picture, source_position, source_size, rgb, alpha, flag): sources are 0 to 1.
base::Status drawsubpic(ProgramCall& io_call) {
  TRY_STATUS(check_may_draw(io_call));
  const formats::Picture* const picture = io_call.program.pictures.find(io_call.text(2));
  if (picture == nullptr) return base::Ok{};
  return io_call.program.canvas.draw_picture(
      *picture, {math::Vec2(io_call.vector(0)), math::Vec2(io_call.vector(1))},
      {math::Vec2(io_call.vector(3)), math::Vec2(io_call.vector(4))}, read_color(io_call, 5));
}

// drawfill(position, size, rgb, alpha, flag)
base::Status drawfill(ProgramCall& io_call) {
  TRY_STATUS(check_may_draw(io_call));
  TRY_STATUS(io_call.return_number(1));
  return io_call.program.canvas.fill({math::Vec2(io_call.vector(0)), math::Vec2(io_call.vector(1))},
                                     read_color(io_call, 2));
}

// drawline(width, from, to, rgb, alpha, flag)
base::Status drawline(ProgramCall& io_call) {
  TRY_STATUS(check_may_draw(io_call));
  const HudMoment& moment = io_call.program.moment;
  io_call.machine.charge(static_cast<std::uint64_t>(moment.width + moment.height) / 2);  // its longest
  return io_call.program.canvas.draw_line(io_call.number(0), math::Vec2(io_call.vector(1)),
                                          math::Vec2(io_call.vector(2)), read_color(io_call, 3));
}

// drawsetcliparea(x, y, width, height)
base::Status drawsetcliparea(ProgramCall& io_call) {
  io_call.program.canvas.set_clip(
      {{io_call.number(0), io_call.number(1)}, {io_call.number(2), io_call.number(3)}});
  return base::Ok{};
}
base::Status drawresetcliparea(ProgramCall& io_call) {
  io_call.program.canvas.reset_clip();
  return base::Ok{};
}

base::Status iscachedpic(ProgramCall& io_call) {
  return io_call.return_number(io_call.program.pictures.find(io_call.text(0)) != nullptr ? 1 : 0);
}

// precache_pic(name, flags): the name, or the empty string if there is no such picture.
base::Status precache_pic(ProgramCall& io_call) {
  const bool is_there = io_call.program.pictures.find(io_call.text(0)) != nullptr;
  io_call.machine.return_string(is_there ? io_call.machine.parameter_string(0) : vm::kEmptyString);
  return base::Ok{};
}

// drawgetimagesize(name): in virtual pixels, which are the picture's; zeros if there is no such picture.
base::Status drawgetimagesize(ProgramCall& io_call) {
  const formats::Picture* const picture = io_call.program.pictures.find(io_call.text(0));
  io_call.machine.return_vector(picture == nullptr ? math::Vec3(0.0f)
                                                   : math::Vec3(static_cast<float>(picture->width),
                                                                static_cast<float>(picture->height), 0));
  return base::Ok{};
}

}  // namespace

std::span<const ProgramEntry> program_drawing() {
  static constexpr ProgramEntry kEntries[] = {
      {315, "drawline", drawline},
      {316, "iscachedpic", iscachedpic},
      {317, "precache_pic", precache_pic},
      {318, "drawgetimagesize", drawgetimagesize},
      {0, "draw_getimagesize", drawgetimagesize},
      {322, "drawpic", drawpic},
      {323, "drawfill", drawfill},
      {324, "drawsetcliparea", drawsetcliparea},
      {325, "drawresetcliparea", drawresetcliparea},
      {328, "drawsubpic", drawsubpic},
  };
  return kEntries;
}

}  // namespace temblor::client
