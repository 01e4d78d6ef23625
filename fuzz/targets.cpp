#include "fuzz/targets.h"

namespace temblor::fuzz {
namespace {

constexpr Target kTargets[] = {
    {"bsp", fuzz_bsp},
    {"build", fuzz_build},
    {"channel", fuzz_channel},
    {"client_message", fuzz_client_message},
    {"colormap", fuzz_colormap},
    {"console", fuzz_console},
    {"delta", fuzz_delta},
    {"dem", fuzz_dem},
    {"demo", fuzz_demo},
    {"demo_writer", fuzz_demo_writer},
    {"entities", fuzz_entities},
    {"frame", fuzz_frame},
    {"handshake", fuzz_handshake},
    {"level", fuzz_level},
    {"light_cache", fuzz_light_cache},
    {"light_grid", fuzz_light_grid},
    {"light_lumps", fuzz_light_lumps},
    {"light_shard", fuzz_light_shard},
    {"lit", fuzz_lit},
    {"localization", fuzz_localization},
    {"locations", fuzz_locations},
    {"map", fuzz_map},
    {"md3", fuzz_md3},
    {"md5", fuzz_md5},
    {"mdl", fuzz_mdl},
    {"message", fuzz_message},
    {"pak", fuzz_pak},
    {"palette", fuzz_palette},
    {"picture", fuzz_picture},
    {"pk3", fuzz_pk3},
    {"png", fuzz_png},
    {"progs", fuzz_progs},
    {"pts", fuzz_pts},
    {"sav", fuzz_sav},
    {"spr", fuzz_spr},
    {"tga", fuzz_tga},
    {"vis_patch", fuzz_vis_patch},
    {"visibility_state", fuzz_visibility_state},
    {"wad", fuzz_wad},
    {"wav", fuzz_wav},
};

}  // namespace

std::span<const Target> all_targets() {
  return kTargets;
}

}  // namespace temblor::fuzz
