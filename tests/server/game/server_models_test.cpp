// The boxes that setmodel gives to entities, by the kind of model.
#include "server/game/server_models.h"

#include <gtest/gtest.h>

#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/programs/small_game.h"

namespace temblor::server {
namespace {

TEST(ServerModels, HaveTheBoxesOfTheirKind) {
  const test::SmallGame game;
  game.folder().write("id1/progs/box.mdl", formats::write_mdl(test::box_mdl()));
  game.folder().write("id1/models/box.md3", test::write_md3(test::convert_to_md3(test::box_mdl(), "none")));
  const test::Md5Sample column = test::bending_column(6, 4, 3, "none");
  game.folder().write("id1/progs/column.md5mesh", column.mesh);
  game.folder().write("id1/progs/column.md5anim", column.animation);
  game.folder().write("id1/models/bad.md3", std::string_view("IDP3"));
  const assets::Library library(vfs::FileSystem::open(game.path()).value());
  const math::Bounds mdl = load_server_model(library, "progs/box.mdl").value().box;
  EXPECT_EQ(mdl.mins, math::Vec3(-16));
  const math::Bounds md3 = load_server_model(library, "models/box.md3").value().box;
  EXPECT_EQ(md3.mins, math::Vec3(-127.5f));
  EXPECT_EQ(md3.maxs, math::Vec3(127.5f));
  EXPECT_GT(load_server_model(library, "progs/column.md5mesh").value().box.maxs.z, 80);
  EXPECT_FALSE(load_server_model(library, "models/bad.md3").ok());
  EXPECT_EQ(load_server_model(library, "models/none.md3").error().code, base::ErrorCode::kNotFound);
}

}  // namespace
}  // namespace temblor::server
