// The fuzz targets. Each one feeds arbitrary bytes to a reader, writer, or state machine, and CHECKs what
// must hold for every input. It always returns 0; an input that violates a CHECK ends the program. The
// function of target NAME is in targets/*/NAME_fuzz.cpp, and its seeds are the files in corpus/NAME.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::fuzz {

using TargetFunction = int (*)(const std::uint8_t* data, std::size_t size);

struct Target {
  const char* name;
  TargetFunction run;
};

// The targets of this program, sorted by name.
std::span<const Target> all_targets();

int fuzz_bsp(const std::uint8_t* data, std::size_t size);
int fuzz_brush_list(const std::uint8_t* data, std::size_t size);
int fuzz_build(const std::uint8_t* data, std::size_t size);
int fuzz_captions(const std::uint8_t* data, std::size_t size);
int fuzz_channel(const std::uint8_t* data, std::size_t size);
int fuzz_client_message(const std::uint8_t* data, std::size_t size);
int fuzz_colormap(const std::uint8_t* data, std::size_t size);
int fuzz_console(const std::uint8_t* data, std::size_t size);
int fuzz_dem(const std::uint8_t* data, std::size_t size);
int fuzz_demo(const std::uint8_t* data, std::size_t size);
int fuzz_delta(const std::uint8_t* data, std::size_t size);
int fuzz_entities(const std::uint8_t* data, std::size_t size);
int fuzz_frame(const std::uint8_t* data, std::size_t size);
int fuzz_handshake(const std::uint8_t* data, std::size_t size);
int fuzz_jpeg(const std::uint8_t* data, std::size_t size);
int fuzz_level(const std::uint8_t* data, std::size_t size);
int fuzz_light_cache(const std::uint8_t* data, std::size_t size);
int fuzz_light_grid(const std::uint8_t* data, std::size_t size);
int fuzz_light_lumps(const std::uint8_t* data, std::size_t size);
int fuzz_light_shard(const std::uint8_t* data, std::size_t size);
int fuzz_lit(const std::uint8_t* data, std::size_t size);
int fuzz_lux(const std::uint8_t* data, std::size_t size);
int fuzz_localization(const std::uint8_t* data, std::size_t size);
int fuzz_locations(const std::uint8_t* data, std::size_t size);
int fuzz_lockstep_packet(const std::uint8_t* data, std::size_t size);
int fuzz_map(const std::uint8_t* data, std::size_t size);
int fuzz_md3(const std::uint8_t* data, std::size_t size);
int fuzz_md5(const std::uint8_t* data, std::size_t size);
int fuzz_mdl(const std::uint8_t* data, std::size_t size);
int fuzz_message(const std::uint8_t* data, std::size_t size);
int fuzz_pak(const std::uint8_t* data, std::size_t size);
int fuzz_palette(const std::uint8_t* data, std::size_t size);
int fuzz_picture(const std::uint8_t* data, std::size_t size);
int fuzz_pk3(const std::uint8_t* data, std::size_t size);
int fuzz_png(const std::uint8_t* data, std::size_t size);
int fuzz_progs(const std::uint8_t* data, std::size_t size);
int fuzz_demo_writer(const std::uint8_t* data, std::size_t size);
int fuzz_prt(const std::uint8_t* data, std::size_t size);
int fuzz_pts(const std::uint8_t* data, std::size_t size);
int fuzz_replay(const std::uint8_t* data, std::size_t size);
int fuzz_sav(const std::uint8_t* data, std::size_t size);
int fuzz_spr(const std::uint8_t* data, std::size_t size);
int fuzz_tga(const std::uint8_t* data, std::size_t size);
int fuzz_vis_patch(const std::uint8_t* data, std::size_t size);
int fuzz_visibility_state(const std::uint8_t* data, std::size_t size);
int fuzz_wad(const std::uint8_t* data, std::size_t size);
int fuzz_wav(const std::uint8_t* data, std::size_t size);

}  // namespace temblor::fuzz
