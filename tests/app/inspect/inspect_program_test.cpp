// `temblor inspect`: every format, compared with what was written.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "formats/archives/pak.h"
#include "formats/archives/pk3.h"
#include "formats/archives/wad.h"
#include "formats/bspx/light_directions.h"
#include "formats/images/picture.h"
#include "formats/images/wad3_texture.h"
#include "formats/levels/entities.h"
#include "formats/levels/lit.h"
#include "formats/levels/scaled_light.h"
#include "formats/sounds/wav.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/levels/vis_patch_bytes.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/models/small_models.h"
#include "support/programs/progs_builder.h"
#include "support/programs/small_game.h"

namespace temblor::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class InspectProgram : public ::testing::Test {
 protected:
  json inspect(const std::string& name, base::Bytes bytes) {
    folder_.write(name, bytes);
    const ProgramRun run = run_program(folder_.path(), {"inspect", "--json", name});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    json object = json::parse(run.out);
    EXPECT_EQ(object.at("file"), name);
    EXPECT_TRUE(object.at("problems").is_array());
    return object;
  }

  TemporaryFolder folder_;
};

// Some pictures have no header.
TEST_F(InspectProgram, PicturesWithoutAHeader) {
  for (const auto& [name, side] : {std::pair{"pop.lmp", 16}, {"conchars.lmp", 128}}) {
    const base::ByteVector pixels(static_cast<std::size_t>(side * side), std::byte{7});
    const json object = inspect(name, pixels);
    EXPECT_THAT(object.at("format"), HasSubstr("a picture without a header"));
    EXPECT_EQ(object.at("width"), side);
    EXPECT_EQ(object.at("height"), side);
  }
}

TEST_F(InspectProgram, LevelsOfAllVersions) {
  const SmallGame game;
  const formats::Bsp& level = game.level();
  for (const auto version :
       {formats::BspVersion::k29, formats::BspVersion::k2Psb, formats::BspVersion::kBsp2}) {
    const json object = inspect("x.bsp", game.level_bytes(version));
    EXPECT_EQ(object.at("format"), "level");
    EXPECT_EQ(object.at("version"), formats::version_name(version));
    EXPECT_EQ(object.at("counts").at("faces"), level.faces.size());
    EXPECT_EQ(object.at("counts").at("leaves"), level.leaves.size());
    EXPECT_EQ(object.at("counts").at("light samples"), level.lighting.size());
    EXPECT_EQ(object.at("entities").at("info_player_start"), 1);
    EXPECT_EQ(object.at("colored light"), true);
    EXPECT_EQ(object.at("faces with light maps of their own"), 0);
    EXPECT_EQ(object.at("BSPX lumps").at(0).at("name"), "RGBLIGHTING");
    EXPECT_TRUE(object.at("problems").empty()) << object.at("problems");
  }
}

TEST_F(InspectProgram, LightMapsOfOtherScales) {
  const SmallGame game;
  formats::Bsp level = game.level();
  std::vector<formats::ScaledLightMap> maps;
  std::size_t lit = 0;
  for (const formats::BspFace& face : level.faces) {
    maps.push_back({5, face.light_offset, face.styles});
    if (face.light_offset >= 0) ++lit;
  }
  formats::set_scaled_light(maps, level);
  const json object = inspect("x.bsp", formats::write_bsp(level, formats::BspVersion::k29).value());
  EXPECT_EQ(object.at("faces with light maps of their own"), lit);
  EXPECT_TRUE(object.at("problems").empty()) << object.at("problems");
}

TEST_F(InspectProgram, Sounds) {
  formats::Wav wav{.frames_per_second = 11025, .channels = 2, .bits = 16, .samples = {}, .loop = {}};
  wav.samples.assign(2 * 11025, 0);
  wav.loop = formats::WavLoop{100, 200};
  const json object = inspect("x.wav", formats::write_wav(wav));
  EXPECT_EQ(object.at("format"), "sound");
  EXPECT_EQ(object.at("frames a second"), 11025);
  EXPECT_EQ(object.at("channels"), 2);
  EXPECT_EQ(object.at("bits"), 16);
  EXPECT_EQ(object.at("seconds"), 1.0);
  EXPECT_EQ(object.at("loop").at("from frame"), 100);
  EXPECT_EQ(object.at("loop").at("to frame"), 200);
  EXPECT_EQ(object.at("problems"), json::array({"silent", "several channels: the game mixes them to mono"}));
}

TEST_F(InspectProgram, ProblemsOfALevelThatCanBeDrawn) {
  const SmallGame game({.pvs = false, .light = false, .missing_texture = true});
  const json object = inspect("x.bsp", game.level_bytes(formats::BspVersion::k29));
  const std::string problems = object.at("problems").dump();
  EXPECT_THAT(problems, HasSubstr("no PVS"));
  EXPECT_THAT(problems, HasSubstr("no light"));
  EXPECT_THAT(problems, HasSubstr("checker"));
}

TEST_F(InspectProgram, ContentOverridesTheName) {
  const SmallGame game;
  EXPECT_EQ(inspect("level.wad", game.level_bytes(formats::BspVersion::k29)).at("format"), "level");
}

TEST_F(InspectProgram, Md5Models) {
  const std::filesystem::path seeds = std::filesystem::path(TEMBLOR_SOURCE_DIR) / "fuzz/corpus/md5";
  const json model = inspect("arm.md5mesh", read_file(seeds / "arm.md5mesh"));
  EXPECT_EQ(model.at("joints").size(), 2);
  EXPECT_EQ(model.at("meshes").at(0).at("weights"), 4);
  EXPECT_NEAR(model.at("meshes").at(0).at("maxs").at(1).get<double>(), 2, 1e-5);
  const json animation = inspect("arm.md5anim", read_file(seeds / "arm.md5anim"));
  EXPECT_EQ(animation.at("counts").at("frames"), 2);
  EXPECT_EQ(animation.at("joints").at(1).at("name"), "hand");
}

TEST_F(InspectProgram, Md3Models) {
  const json model = inspect("box.md3", write_md3(convert_to_md3(box_mdl(), "models/box")));
  EXPECT_EQ(model.at("format"), "MD3 model");
  EXPECT_EQ(model.at("surfaces").at(0).at("triangles"), 12);
  EXPECT_EQ(model.at("surfaces").at(0).at("shaders").at(0), "models/box");
  EXPECT_EQ(model.at("frames").size(), 1);
}

TEST_F(InspectProgram, LightAndEntities) {
  const formats::Lit lit{std::vector<std::uint8_t>(3 * 77)};
  EXPECT_EQ(inspect("x.lit", formats::write_lit(lit)).at("light samples"), 77);
  const std::vector<std::uint8_t> vectors{128, 128, 255, 128, 128, 0}, too_short{128, 128, 128};
  const json directions = inspect("x.lux", formats::write_lux(vectors));
  EXPECT_EQ(directions.at("format"), "light directions");
  EXPECT_EQ(directions.at("light directions"), 2);
  EXPECT_THAT(directions.at("problems"), ::testing::IsEmpty()) << "byte 0 is nearly -1";
  EXPECT_EQ(inspect("y.lux", formats::write_lux(too_short)).at("problems").size(), 1u);
  const json level = inspect("x.vis", vis_patch_bytes("e1m1.bsp", {1, 2, 3, 4, 5}, {-1})).at("levels").at(0);
  EXPECT_EQ(level.at("level"), "e1m1.bsp");
  EXPECT_EQ(level.at("leaves"), 1);
  EXPECT_EQ(level.at("visibility bytes"), 5);
  const json entities =
      inspect("x.ent", base::as_bytes("{ \"classname\" \"light\" }\n{ }\n{\"classname\" \"light\"}"));
  EXPECT_EQ(entities.at("count"), 3);
  EXPECT_EQ(entities.at("classes").at("light"), 2);
  EXPECT_THAT(entities.at("problems").dump(), HasSubstr("worldspawn"));
}

TEST_F(InspectProgram, Archives) {
  const formats::Picture picture{2, 3, {255, 1, 2, 3, 4, 255}};
  const base::ByteVector lump = formats::write_picture(picture);
  const std::vector<formats::ArchiveFile> files = {{"a.txt", base::as_bytes("hello")}, {"gfx/b.lmp", lump}};
  const json pak = inspect("x.pak", formats::write_pak(files).value());
  EXPECT_EQ(pak.at("count"), 2);
  EXPECT_EQ(pak.at("files").at(0), (json{{"name", "a.txt"}, {"bytes", 5}}));
  EXPECT_EQ(pak.at("files").at(1).at("name"), "gfx/b.lmp");
  const json pk3 = inspect("x.pk3", formats::write_pk3(files).value());
  EXPECT_EQ(pk3.at("format"), "PK3");
  EXPECT_EQ(pk3.at("files"), pak.at("files"));

  const std::vector<formats::WadLump> lumps = {{"PIC", formats::kWadPicture, lump},
                                               {"BAD", formats::kWadTexture, base::as_bytes("no texture")}};
  const json wad = inspect("x.wad", formats::write_wad(lumps).value());
  EXPECT_EQ(wad.at("count"), 2);
  EXPECT_EQ(wad.at("lumps").at(0).at("bytes"), lump.size());
  EXPECT_THAT(wad.at("problems").dump(), HasSubstr("BAD"));

  formats::Wad3Texture texture{{"{crate", 16, 16, {}}, {}};
  for (unsigned k = 0; k < 4; ++k) texture.texture.mips[k].resize(std::size_t{16u >> k} * (16u >> k));
  const base::ByteVector texture_bytes = formats::write_wad3_texture(texture).value();
  base::ByteVector wad3_bytes =
      formats::write_wad(std::vector<formats::WadLump>{{"{crate", formats::kWad3Texture, texture_bytes}})
          .value();
  wad3_bytes[3] = std::byte{'3'};
  const json wad3 = inspect("y.wad", wad3_bytes);
  EXPECT_EQ(wad3.at("format"), "WAD3");
  EXPECT_EQ(wad3.at("lumps").at(0).at("width"), 16);
  EXPECT_TRUE(wad3.at("problems").empty());
}

TEST_F(InspectProgram, CompiledQuakeC) {
  ProgsBuilder builder;
  const int health = builder.named("health", formats::ProgsType::kFloat);
  builder.builtin("dprint", 25);
  builder.function("main", {1}, 2);
  builder.emit(vm::Opcode::kAddF, health, health, 4);
  builder.emit(vm::Opcode::kDone);
  const json object = inspect("progs.dat", formats::write_progs(builder.progs()));
  EXPECT_EQ(object.at("format"), "compiled QuakeC");
  EXPECT_EQ(object.at("crc"), 5927);
  EXPECT_EQ(object.at("counts").at("statements"), 3);
  EXPECT_EQ(object.at("counts").at("functions"), 3);
  EXPECT_EQ(object.at("functions").at(0),
            json::parse(R"({"name": "dprint", "file": "test.qc", "built in": 25})"));
  EXPECT_EQ(object.at("functions").at(1).at("locals"), 3);
  EXPECT_EQ(object.at("code"), json::array({"main (test.qc)", "     1  ADD_F      health, health, parm0",
                                            "     2  DONE       0"}));
  EXPECT_TRUE(object.at("problems").empty());

  builder.progs().crc = 1;
  builder.function("main");
  builder.emit(vm::Opcode::kDone);
  const std::string problems =
      inspect("other.dat", formats::write_progs(builder.progs())).at("problems").dump();
  EXPECT_THAT(problems, HasSubstr("CRC 1, not 5927"));
  EXPECT_THAT(problems, HasSubstr("functions 2 and 3 are both called"));
}

TEST_F(InspectProgram, PicturesPalettesAndColormaps) {
  const json picture = inspect("x.lmp", formats::write_picture({2, 3, {255, 1, 2, 3, 4, 255}}));
  EXPECT_EQ(picture.at("width"), 2);
  EXPECT_EQ(picture.at("height"), 3);
  EXPECT_EQ(picture.at("transparent pixels"), 2);
  // A picture 29 pixels wide starts with the bytes of a level of version 29.
  EXPECT_EQ(inspect("wide.lmp", formats::write_picture({29, 1, std::vector<std::uint8_t>(29)})).at("format"),
            "picture");

  formats::Palette palette{};
  palette[3] = {0x12, 0xab, 0xff};
  const json colors = inspect("palette.lmp", formats::write_palette(palette));
  EXPECT_EQ(colors.at("colors").size(), 256u);
  EXPECT_EQ(colors.at("colors").at(3), "12abff");

  formats::Colormap colormap;
  for (std::size_t i = 0; i < colormap.rows.size(); ++i) colormap.rows[i] = static_cast<std::uint8_t>(i);
  EXPECT_TRUE(inspect("colormap.lmp", formats::write_colormap(colormap)).at("problems").empty());
  colormap.rows[31 * 256 + 7] = 8;    // normal light
  colormap.rows[63 * 256 + 255] = 0;  // a full-bright color
  EXPECT_EQ(inspect("colormap.lmp", formats::write_colormap(colormap)).at("problems").size(), 2u);
}

TEST_F(InspectProgram, Models) {
  const formats::Mdl mdl = small_mdl();
  const json object = inspect("x.mdl", formats::write_mdl(mdl));
  EXPECT_EQ(object.at("format"), "model");
  // Its bytes go from 0 to 255 along each axis.
  EXPECT_EQ(object.at("mins"), (json{-8.0, -4.0, 2.5}));
  EXPECT_EQ(object.at("maxs"), (json{-8 + 255 * 0.5, -4 + 255 * 0.25, 2.5 + 255}));
  EXPECT_EQ(object.at("eye"), (json{1.0, 2.0, 3.0}));
  EXPECT_EQ(object.at("skin width"), 7);
  EXPECT_EQ(object.at("flags"), (json{"rotate", "tracer 3"}));
  EXPECT_EQ(object.at("counts"), (json{{"vertices", 4},
                                       {"triangles", 4},
                                       {"skins", 2},
                                       {"skin pictures", 3},
                                       {"frames", 2},
                                       {"poses", 4}}));
  EXPECT_EQ(object.at("skins").at(0), (json{{"pictures", 1}}));
  EXPECT_EQ(object.at("skins").at(1), (json{{"pictures", 2}, {"seconds", 1.0}}));
  EXPECT_EQ(object.at("frames").at(0), (json{{"name", "stand"}, {"poses", 1}}));
  EXPECT_EQ(object.at("frames").at(1), (json{{"name", "run1"}, {"poses", 3}, {"seconds", 0.5}}));
  // A width of seven texels is not a multiple of four; everything else is valid.
  EXPECT_EQ(object.at("problems").size(), 1u) << object.at("problems");
  EXPECT_THAT(object.at("problems").dump(), HasSubstr("7 texels wide"));
}

TEST_F(InspectProgram, ProblemsOfAModelThatCanBeDrawn) {
  formats::Mdl mdl = small_mdl();
  const auto inspect_problems = [&](const formats::Mdl& model, std::size_t tail_bytes = 0) {
    base::ByteVector bytes = formats::write_mdl(model);
    bytes.resize(bytes.size() + tail_bytes);
    return inspect("x.mdl", bytes).at("problems").dump();
  };
  mdl.skin_width = 4;
  mdl.skins = {{{std::vector<std::uint8_t>(4 * 3)}, {}}};
  mdl.texels = {{false, 0, 0}, {true, 1, 0}, {true, 1, 2}, {false, 3, 2}};
  EXPECT_EQ(inspect_problems(mdl), "[]");
  EXPECT_THAT(inspect_problems(mdl, 5), HasSubstr("5 trailing bytes after the last frame"));

  formats::Mdl lying = mdl;
  lying.frames[1].poses[2].maxs.position[1] = 254;
  lying.frames[1].maxs.position[2] = 254;
  EXPECT_THAT(inspect_problems(lying), HasSubstr("outside their bounding box: 1 (the first is frame 1)"));
  EXPECT_THAT(inspect_problems(lying),
              HasSubstr("outside the group's bounding box: 1 (the first is frame 1)"));

  formats::Mdl idle = mdl;
  idle.triangles = {{true, {0, 1, 1}}};
  EXPECT_THAT(inspect_problems(idle), HasSubstr("vertices not used by any triangle: 2"));
  EXPECT_THAT(inspect_problems(idle), HasSubstr("triangles with a repeated vertex: 1"));

  // Vertex 1 is on the seam, and 2 of the 4 triangles face the back: one of those uses it.
  formats::Mdl off_skin = mdl;
  off_skin.texels[1].s = 2;
  EXPECT_THAT(inspect_problems(off_skin), HasSubstr("outside the skin: 1\""));

  formats::Mdl large = mdl;
  large.texels.resize(2001);
  for (formats::MdlFrame& frame : large.frames)
    for (formats::MdlPose& pose : frame.poses) pose.vertices.resize(2001);
  large.flags |= 1u << 14;
  EXPECT_THAT(inspect_problems(large), HasSubstr("2001 vertices: the original engine allows 2000"));
  EXPECT_THAT(inspect_problems(large), HasSubstr("unknown bits"));
}

TEST_F(InspectProgram, Sprites) {
  formats::Spr spr = small_spr();
  const json object = inspect("x.spr", formats::write_spr(spr));
  EXPECT_EQ(object.at("format"), "sprite");
  EXPECT_EQ(object.at("orientation"), "parallel oriented");
  EXPECT_EQ(object.at("counts"), (json{{"frames", 2}, {"pictures", 3}}));
  EXPECT_EQ(object.at("frames").at(0),
            (json{{"pictures", 1}, {"left", -1}, {"up", 1}, {"width", 3}, {"height", 2}}));
  EXPECT_EQ(object.at("frames").at(1).at("seconds"), 0.75);
  EXPECT_TRUE(object.at("problems").empty()) << object.at("problems");

  spr.max_width = 2;
  spr.frames[1].pictures[1].texels = {255, 255};
  base::ByteVector bytes = formats::write_spr(spr);
  bytes.push_back(std::byte{1});
  const std::string problems = inspect("x.spr", bytes).at("problems").dump();
  EXPECT_THAT(problems, HasSubstr("larger than the header's maximum: 1 (the first is frame 0)"));
  EXPECT_THAT(problems, HasSubstr("transparent pictures: 1 (the first is frame 1)"));
  EXPECT_THAT(problems, HasSubstr("1 trailing byte after"));
}

TEST_F(InspectProgram, Maps) {
  const std::string text = entity_text("worldspawn", "", walls_text({-64, -64, 0}, {64, 64, 64}, "wall")) +
                           point_text("light", {0, 0, 8}) + entity_text("func_door", "", "{\n}\n");
  const json object = inspect("x.map", base::as_bytes(text));
  EXPECT_EQ(object.at("format"), "map");
  EXPECT_EQ(object.at("counts"), (json{{"entities", 3}, {"brushes", 7}, {"sides", 36}, {"textures", 1}}));
  EXPECT_EQ(object.at("texture alignment, by sides"), (json{{"standard", 36}}));
  EXPECT_EQ(object.at("classes"), (json{{"func_door", 1}, {"light", 1}, {"worldspawn", 1}}));
  const std::string problems = object.at("problems").dump();
  EXPECT_THAT(problems, HasSubstr("no info_player_start"));
  EXPECT_THAT(problems, HasSubstr("entity 2, brush 0, line"));
}

TEST_F(InspectProgram, TextHasTheSameContents) {
  const SmallGame game;
  const ProgramRun run = run_program(game.path(), {"inspect", "id1/maps/small.bsp"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.out, HasSubstr("version: 29\n"));
  EXPECT_THAT(run.out, HasSubstr(fmt::format("  faces: {}\n", game.level().faces.size())));
  EXPECT_THAT(run.out, HasSubstr("  info_player_start: 1\n"));
  EXPECT_THAT(run.out, HasSubstr("problems: none\n"));
}

TEST_F(InspectProgram, RejectedFileIsAnErrorInBothForms) {
  folder_.write("x.bsp", "BSP2 and nothing else");
  const ProgramRun run = run_program(folder_.path(), {"inspect", "--json", "x.bsp"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_FALSE(json::parse(run.out).at("error").get<std::string>().empty());
}

TEST_F(InspectProgram, NamesInAnyEncodingGiveValidJson) {
  const std::vector<formats::ArchiveFile> files = {{"caf\xe9.txt", {}}};
  EXPECT_EQ(inspect("x.pak", formats::write_pak(files).value()).at("count"), 1);
}

TEST_F(InspectProgram, StockFiles) {
  DATA_FOLDER_OR_SKIP(data);
  const std::filesystem::path base = std::filesystem::absolute(data);
  for (const char* name :
       {"id1/maps/start.bsp", "id1/maps/start.lit", "id1/gfx.wad", "id1/gfx/palette.lmp",
        "id1/gfx/colormap.lmp", "id1/gfx/conback.lmp", "id1/progs/player.mdl", "id1/progs/s_explod.spr"}) {
    const ProgramRun run = run_program(base, {"inspect", "--json", name});
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_EQ(json::parse(run.out).at("file"), name);
  }
}

}  // namespace
}  // namespace temblor::test
