#include "app/lab/card/card_methods.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/lab/card/card_command.h"
#include "base/check.h"

namespace temblor::app {
namespace {

using render_gl::WorldMethod;

constexpr CardMethod kCardMethods[] = {
    {WorldMethod::kBlocks, "blocks", "Surfaces that the CPU builds",
     "The CPU lights surfaces, and the card keeps them in a cache.",
     "VQuake works so. Uploads cost time, and all the more because surfaces need 16 bits per pixel, which "
     "also "
     "take twice as long to build. With 4 MB, the cache does not miss often. At high resolutions, surfaces "
     "need more memory, and the frame buffer leaves less.",
     "Temblor's default. The CPU builds the lit blocks of the visible surfaces as for its own picture, and "
     "the "
     "card copies their texels, so pictures are equal. If the blocks of a frame do not fit into the cache, "
     "it is "
     "drawn in portions."},
    {WorldMethod::kExpandedBlocks, "8 bit expanded", "Surfaces of 8 bits, expanded by the card",
     "The CPU uploads palette indices, and the card stores them as colors.",
     "There was no time to try it: 8-bit surfaces are uploaded, and expanded to 16 bits while the card "
     "stores "
     "them. Better still are cards with palettized textures of 8 bits, which expand them while they draw.",
     "A quarter of the bytes is uploaded, and light has the 64 steps of the color map, as in 256 colors. The "
     "rows of 8 bits keep indices on the card instead, and draw indexed pictures."},
    {WorldMethod::kCardBlocks, "card's blocks", "Surfaces that the card builds",
     "The card draws texture times light into its cache of surfaces.",
     "Nothing is uploaded but light, and surfaces can still hold splatters and dents. But the cache needs as "
     "much memory, and dynamic lights still build surfaces again. Cards must be able to draw into textures.",
     "A block is drawn once, and again when its light changes. Surfaces with marks come from the CPU."},
    {WorldMethod::kLitTextures, "lit textures", "Texture and light in one pass",
     "Each pixel is a texel times its light, both from textures.",
     "Cards with two texture units were new then. This is the second pass without its cost.",
     "The level's textures lie on the card, and so does the light of the visible surfaces, with a sample per "
     "luxel; it is uploaded when it changes. There is no cache to miss. Filters of textures need this "
     "method."},
    {WorldMethod::kLightPass, "light pass", "The light map in a second pass",
     "The card draws textures, and then multiplies the picture by the light.",
     "The light map is drawn over the texture as an alpha texture. It looks as good as surfaces, needs no "
     "memory except for textures and light maps, and takes the same time in every frame. But the card draws "
     "everything twice, and must be able to blend.",
     "GLQuake worked so. Between the passes, colors have 8 bits, so some channels differ a little more."},
    {WorldMethod::kLightPolygons, "light polygons", "Polygons of light that do not match the texture's",
     "Dynamic lights are polygons of their own over the picture of the level.",
     "The polygons of light need not match those of textures, so they can show light that changes.",
     "Light maps stay as they are; each dynamic light is drawn over the faces that it reaches, before the "
     "textures multiply it."},
    {WorldMethod::kGouraud, "vertex light", "Gouraud shading of the level",
     "Light is computed at the vertices of faces only.",
     "It is easy and fast, and will be used widely. The smaller polygons become, the better it looks next to "
     "surfaces. On Quake's large polygons, it is worse.",
     "Shadows within a face disappear, and light is smeared between its vertices: compare the pictures."},
    {WorldMethod::kStyleLayers, "style layers", "Light added by the shader",
     "The shader adds the light maps of a face's styles, and the dynamic lights.",
     "No article describes it: cards could not compute it.",
     "Light maps are uploaded once per level. Lights that flicker, and lights that move, upload nothing and "
     "build nothing again; each pixel costs more."}};

}  // namespace

std::span<const CardMethod> list_card_methods() {
  return kCardMethods;
}

const CardMethod& find_card_method(WorldMethod method) {
  const auto* const found = std::ranges::find(kCardMethods, method, &CardMethod::method);
  CHECK(found != std::end(kCardMethods));
  return *found;
}

std::string describe_card_methods() {
  std::string text = fmt::format(
      "{}: Ways to draw with a graphics card (`temblor lab {}`)\n  From \"Surface Caching Revisited, Quake's "
      "Triangle Models, and More\".\n  Expected: surfaces take the least work of the card; two passes take "
      "the "
      "most.\n",
      kCardName, kCardName);
  for (const CardMethod& method : kCardMethods)
    text += fmt::format("  {}: {}\n", method.name, method.summary);
  return text;
}

}  // namespace temblor::app
