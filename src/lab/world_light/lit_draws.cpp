#include "lab/world_light/lit_draws.h"

#include <algorithm>

#include "render/color/own_colors.h"
#include "render/spans/kernel_planes.h"

namespace temblor::lab {

namespace {

constexpr int kFinestMip = -3, kMips = 7;

bool is_lit_here(const render::FrameContext& context, const render::SurfaceRequests& requests,
                 const render::BlockRequest& request) {
  if (request.draw >= requests.first_deferred || context.settings.light_view != render::LightView::kLit)
    return false;
  if (context.level().face(request.face).kind != world::FaceKind::kLit) return false;
  return context.is_indexed() || render::own_colors(*request.texture, request.mip).glow == nullptr;
}

// Copies textures, each mip level once.
class TextureCopies {
 public:
  explicit TextureCopies(const render::FrameContext& context)
      : context_(context),
        copies_(context.arena().allocate_filled(context.level().textures.size() * kMips, TileTexture{})) {}

  const TileTexture& find(const render::BlockRequest& request) {
    TileTexture& copy = copies_[base::to_size(request.contents.texture) * kMips +
                                static_cast<std::size_t>(request.mip - kFinestMip)];
    if (copy.texels == nullptr) copy = make(*request.texture, request.mip);
    return copy;
  }

 private:
  TileTexture make(const world::Texture& texture, int mip) const {
    const std::uint8_t* const indices = texture.indices(mip).data();
    const std::uint32_t* const own = render::own_colors(texture, mip).colors;
    const auto side = [&](std::uint32_t texels) {
      return static_cast<std::int32_t>(std::max(1u, render::at_mip(texels, mip)));
    };
    TileTexture copy{nullptr, side(texture.width), side(texture.height)};
    if (context_.is_indexed())
      copy.texels = make_copy<std::uint8_t>(copy, [&](std::size_t texel) { return indices[texel]; });
    else if (own != nullptr)
      copy.texels = make_copy<std::uint32_t>(copy, [&](std::size_t texel) { return own[texel]; });
    else
      copy.texels = make_copy<std::uint32_t>(
          copy, [&](std::size_t texel) { return context_.colors.surface_rgb[indices[texel]]; });
    return copy;
  }

  // `convert` maps a texel's position in the mip level, row by row, to a Texel as it is drawn.
  template <typename Texel, typename Convert>
  const Texel* make_copy(const TileTexture& size, Convert convert) const {
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    const std::size_t stride = width + kMarginColumns;
    const std::span<Texel> copy =
        context_.arena().allocate<Texel>(stride * (height + kMarginRows) + render::kTexelPadding);
    Texel* out = copy.data();
    for (std::size_t row = 0; row < height; ++row, out += stride) {
      for (std::size_t column = 0; column < width; ++column) out[column] = convert(row * width + column);
      for (std::size_t column = width; column < stride; ++column) out[column] = out[column - width];
    }
    for (std::size_t row = 0; row < kMarginRows; ++row, out += stride)
      std::copy_n(out - height * stride, stride, out);
    std::fill_n(out, render::kTexelPadding, Texel{0});
    return copy.data();
  }

  const render::FrameContext& context_;
  std::span<TileTexture> copies_;
};

// The texel of the texture at the first texel of a tile.
std::int32_t find_first_texel(std::int32_t face_min, int tile, int mip, std::int32_t size) {
  const std::int32_t texel = render::at_mip(face_min + tile * render::kTileTexels, mip);
  return (texel % size + size) % size;
}

}  // namespace

LitDraws choose_lit_draws(const render::FrameContext& context, const render::SurfaceRequests& requests) {
  TextureCopies textures(context);
  base::ArenaVector<render::BlockRequest> left(context.arena(), requests.blocks.size());
  base::ArenaVector<std::uint32_t> own(context.arena(), requests.blocks.size());
  const std::span<LitDraw> all = context.arena().allocate_filled(requests.draws.size(), LitDraw{});
  for (const render::BlockRequest& request : requests.blocks) {
    if (!is_lit_here(context, requests, request)) {
      left.push_back(request);
      continue;
    }
    const world::Face& face = context.level().face(request.face);
    const TileTexture& texture = textures.find(request);
    all[request.draw] = {&request, texture,
                         find_first_texel(face.texture_mins[0], request.tile_s, request.mip, texture.width),
                         find_first_texel(face.texture_mins[1], request.tile_t, request.mip, texture.height)};
    own.push_back(request.draw);
    requests.draws[request.draw].block.shape =
        render::surface_shape(face, request.tile_s, request.tile_t, request.mip);
  }
  return {all, own.view(), {requests.draws, requests.first_deferred, left.view()}};
}

void LitPreparation::run(const render::FrameContext& context, std::span<const std::uint32_t> own,
                         Prepare prepare) {
  constexpr std::size_t kDrawsPerJob = 32;
  const std::size_t jobs = (own.size() + kDrawsPerJob - 1) / kDrawsPerJob;
  render::FrameArenas::grow(arenas_, jobs);
  context.jobs.parallel_for(jobs, [&](std::size_t job) {
    arenas_[job].reset();
    for (std::size_t i = job; i < own.size(); i += jobs) prepare(own[i], arenas_[job]);
  });
}

std::size_t LitPreparation::used_bytes() const {
  std::size_t bytes = 0;
  for (const base::Arena& arena : arenas_) bytes += arena.used_bytes();
  return bytes;
}

LitSpans make_lit_spans(const render::FrameContext& context, const render::ViewFrame& view,
                        const render::SurfaceDraw& draw, const LitDraw& lit) {
  return {.depth = render::kernel_plane(draw.depth),
          .s = render::kernel_plane(draw.s),
          .t = render::kernel_plane(draw.t),
          .perspective = view.perspective,
          .last_s = draw.block.shape.width - 1,
          .last_t = draw.block.shape.height - 1,
          .texture = lit.texture,
          .first_s = lit.first_s,
          .first_t = lit.first_t,
          .colormap = context.colors.colormap.rows.data(),
          .spans = nullptr,
          .span_count = 0};
}

void draw_lit_band(const BandPicture& picture, std::span<const LitDraw> draws, DrawOwn draw_own,
                   render::FrameBuffer& io_frame) {
  const bool indexed = picture.context.is_indexed();
  const render::KernelTarget target{
      indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data(),
      picture.sources.fill_depth ? io_frame.depth().data() : nullptr,
      static_cast<std::size_t>(io_frame.width())};
  const render::Band& band = picture.band;
  for (std::size_t position = 0; position < band.draws.size(); ++position) {
    const std::uint32_t number = band.draws[position];
    if (draws[number].request != nullptr) {
      draw_own(number, band.spans_at(position), target);
      continue;
    }
    render::Band one = band;
    one.draws = band.draws.subspan(position, 1);
    one.span_begin = band.span_begin.subspan(position, 2);
    one.sums = band.sums.subspan(position, 1);
    render::draw_band_spans(picture.context, picture.view, one, picture.sources, io_frame);
  }
}

}  // namespace temblor::lab
