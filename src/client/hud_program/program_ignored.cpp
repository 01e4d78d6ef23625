// Built-in functions that a HUD does without. Programs that also run in engines with a whole client in game
// code call them; they do nothing here, and return 0 or their name.
#include "client/hud_program/program_call.h"

namespace temblor::client {
namespace {

base::Status ignored(ProgramCall& io_call) {
  io_call.machine.return_vector(math::Vec3(0.0f));
  return base::Ok{};
}

// precache_model(name) and similar functions: the name.
base::Status named(ProgramCall& io_call) {
  io_call.machine.return_string(io_call.machine.parameter_string(0));
  return base::Ok{};
}

}  // namespace

std::span<const ProgramEntry> program_ignored() {
  static constexpr ProgramEntry kEntries[] = {
      {2, "setorigin", ignored},
      {3, "setmodel", ignored},
      {4, "setsize", ignored},
      {19, "precache_sound", named},
      {20, "precache_model", named},
      {68, "precache_file", named},
      {301, "addentities", ignored},
      {302, "addentity", ignored},
      {305, "dynamiclight_add", ignored},
      {306, "R_BeginPolygon", ignored},
      {307, "R_PolygonVertex", ignored},
      {308, "R_EndPolygon", ignored},
      {319, "freepic", ignored},
      {333, "setmodelindex", ignored},
      {335, "particleeffectnum", ignored},
      {336, "trailparticles", ignored},
      {337, "pointparticles", ignored},
      {345, "getinputstate", ignored},
      {346, "setsensitivityscaler", ignored},
      {351, "SetListener", ignored},
      {356, "findfont", ignored},
      {357, "loadfont", ignored},
      {359, "sendevent", ignored},
      {371, "deltalisten", ignored},
      {372, "dynamiclight_get", ignored},
      {373, "dynamiclight_set", ignored},
      {374, "particleeffectquery", ignored},
      {375, "adddecal", ignored},
      {376, "setcustomskin", ignored},
      {502, "boxparticles", ignored},
      {631, "getbindmaps", ignored},
      {632, "setbindmaps", ignored},
  };
  return kEntries;
}

}  // namespace temblor::client
