// Built-in functions of the older style, in which the program asks for the view: clearscene, setproperty,
// addentities, renderscene. The engine draws its own view, so most properties have no effect.
#include "client/hud_program/program_call.h"
#include "math/angles.h"

namespace temblor::client {
namespace {

// Numbers of view properties. Components follow their vectors.
enum Property {
  kMin = 1,
  kSize = 4,
  kViewport = 7,
  kFov = 8,
  kFovY = 10,
  kOrigin = 11,
  kAngles = 15,
  kDrawWorld = 19,
  kDrawEngineBar = 20,
  kDrawCrosshair = 21,
  kViewAngles = 33,
  kVirtualSize = 204,
  kPixelSize = 205
};

base::Status clearscene(ProgramCall& io_call) {
  io_call.program.view.draws_bar = io_call.program.view.draws_crosshair = false;
  return base::Ok{};
}

// setproperty(property, value): returns 1 for those that the engine knows.
base::Status setproperty(ProgramCall& io_call) {
  const int property = io_call.whole(0);
  if (property == kDrawEngineBar) io_call.program.view.draws_bar = io_call.number(1) != 0;
  if (property == kDrawCrosshair) io_call.program.view.draws_crosshair = io_call.number(1) != 0;
  return io_call.return_number(property >= kMin && property <= kDrawCrosshair ? 1 : 0);
}

// Component `axis` of a vector; the whole vector for axis -1.
base::Status return_part(ProgramCall& io_call, const math::Vec3& vector, int axis) {
  if (axis < 0) {
    io_call.machine.return_vector(vector);
    return base::Ok{};
  }
  return io_call.return_number(vector[axis]);
}

base::Status getproperty(ProgramCall& io_call) {
  const HudMoment& moment = io_call.program.moment;
  const math::Vec2 virtual_size = io_call.program.canvas.virtual_size();
  const int property = io_call.whole(0);
  if (property >= kMin && property < kSize)
    return return_part(io_call, math::Vec3(0.0f), property - kMin - 1);
  if (property >= kSize && property < kViewport)
    return return_part(io_call, math::Vec3(virtual_size, 0), property - kSize - 1);
  if (property >= kFov && property <= kFovY)
    return property == kFov ? return_part(io_call, {moment.fov_deg, moment.fov_deg, 0}, -1)
                            : io_call.return_number(moment.fov_deg);
  if (property >= kOrigin && property < kAngles)
    return return_part(io_call, moment.view_origin, property - kOrigin - 1);
  if (property >= kAngles && property < kDrawWorld)
    return return_part(io_call, moment.view_angles_deg, property - kAngles - 1);
  if (property == kDrawEngineBar) return io_call.return_number(io_call.program.view.draws_bar ? 1 : 0);
  if (property == kDrawCrosshair) return io_call.return_number(io_call.program.view.draws_crosshair ? 1 : 0);
  if (property >= kViewAngles && property < kViewAngles + 4)
    return return_part(io_call, moment.view_angles_deg, property - kViewAngles - 1);
  if (property == kVirtualSize) return return_part(io_call, math::Vec3(virtual_size, 0), -1);
  if (property == kPixelSize)
    return return_part(io_call, {static_cast<float>(moment.width), static_cast<float>(moment.height), 0}, -1);
  return return_part(io_call, math::Vec3(property == kDrawWorld ? 1.0f : 0.0f), -1);
}

// renderscene(): the view covers everything that was drawn before it.
base::Status renderscene(ProgramCall& io_call) {
  if (!io_call.program.may_draw) return io_call.error("draws outside of a frame");
  io_call.program.canvas.clear();
  io_call.program.view.is_rendered = true;
  return base::Ok{};
}

base::Status getresolution(ProgramCall& io_call) {
  const HudMoment& moment = io_call.program.moment;
  return return_part(io_call, {static_cast<float>(moment.width), static_cast<float>(moment.height), 1}, -1);
}

}  // namespace

std::span<const ProgramEntry> program_view() {
  static constexpr ProgramEntry kEntries[] = {
      {300, "clearscene", clearscene},       {303, "setproperty", setproperty},
      {0, "setviewprop", setproperty},       {304, "renderscene", renderscene},
      {309, "getproperty", getproperty},     {0, "getviewprop", getproperty},
      {608, "getresolution", getresolution},
  };
  return kEntries;
}

}  // namespace temblor::client
