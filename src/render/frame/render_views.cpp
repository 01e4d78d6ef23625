#include "render/frame/render_views.h"

#include <algorithm>
#include <memory>
#include <tuple>
#include <vector>

#include "base/check.h"
#include "render/frame/render_frame.h"
#include "render/frame/resolve_settings.h"

namespace temblor::render {

namespace {

// A view on its way through the stages.
struct ViewWork {
  ViewWork(const View& drawn, const Settings& asked, const FrameCaches& caches, ViewCaches& io_own)
      : settings(resolve_settings(asked, *drawn.scene, *drawn.frame)),
        own(io_own),
        frame(*drawn.frame),
        context{*drawn.scene, settings, frame.format(), caches.colors, jobs, own.arenas} {}
  ViewWork(const ViewWork&) = delete;
  ViewWork& operator=(const ViewWork&) = delete;

  Settings settings;
  base::Jobs jobs{1};
  ViewCaches& own;
  FrameBuffer& frame;
  FrameContext context;
  SurfaceRequests requests{};
  FoundSurfaces found{};
  FrameRecord record;
};

// Equal for views that can use the same PreparedSkybox: empty sides have the color of the fog.
auto skybox_key(const Scene& scene) {
  const SkyboxIdentity* identity = scene.skybox != nullptr ? scene.skybox->identity.get() : nullptr;
  const bool has_fog = identity != nullptr && scene.fog.density > 0;
  const math::Vec3 color = has_fog ? scene.fog.color : math::Vec3(0.0f);
  return std::tuple(identity, has_fog, color.x, color.y, color.z);
}

void fill_surface_cache(std::span<const std::unique_ptr<ViewWork>> works, FrameCaches& io_caches) {
  begin_surface_frame(works.front()->context, io_caches.surfaces);
  for (const auto& work : works)
    work->found = find_cached_surfaces(work->context, work->requests, io_caches.surfaces);
  const MarkTables* const marks = io_caches.mark_tables ? &*io_caches.mark_tables : nullptr;
  for (const auto& work : works) {
    const FrameContext& one_thread = work->context;
    work->record.surfaces =
        reserve_missing_surfaces(one_thread, work->requests, work->found, io_caches.surfaces);
    const FrameContext all_threads{one_thread.scene,  one_thread.settings, one_thread.format,
                                   one_thread.colors, *io_caches.jobs,     one_thread.arenas};
    build_surfaces(all_threads, work->record.surfaces, marks);
  }
}

void draw_view(ViewWork& io_work, FrameCaches& io_caches) {
  const FrameContext& context = io_work.context;
  FrameRecord& record = io_work.record;
  draw_surfaces(context, io_caches.skybox, io_work.own, record, io_work.frame);
  draw_over_picture(context, record, io_work.frame);
}

// The caches hold one prepared skybox, so views with the same one are drawn at the same time.
void draw_views(std::span<std::unique_ptr<ViewWork>> io_works, FrameCaches& io_caches) {
  const auto key = [](const std::unique_ptr<ViewWork>& work) { return skybox_key(work->context.scene); };
  std::ranges::stable_sort(io_works, {}, key);
  while (!io_works.empty()) {
    const auto end = std::ranges::upper_bound(io_works, key(io_works.front()), {}, key);
    const auto group = io_works.first(static_cast<std::size_t>(end - io_works.begin()));
    const FrameContext& first = group.front()->context;
    if (first.scene.skybox != nullptr)
      io_caches.skybox.update(*first.scene.skybox, first.scene.fog, first.colors, first.format);
    io_caches.jobs->parallel_for(group.size(), [&](std::size_t i) { draw_view(*group[i], io_caches); });
    io_works = io_works.subspan(group.size());
  }
}

}  // namespace

void render_views(std::span<const View> views, const Settings& settings, FrameCaches& io_caches) {
  if (views.empty()) return;
  Settings for_all = settings, of_one_view = settings;
  for_all.threads = std::max(1, settings.threads);
  of_one_view.threads = 1;
  if (io_caches.views.size() < views.size()) io_caches.views.resize(views.size());
  std::vector<std::unique_ptr<ViewWork>> works;
  for (const View& view : views) {
    io_caches.prepare(*view.scene, for_all);
    ViewCaches& own = io_caches.views[works.size()];
    own.prepare(io_caches.level, *view.frame);
    works.push_back(std::make_unique<ViewWork>(view, of_one_view, io_caches, own));
  }
  io_caches.jobs->parallel_for(works.size(), [&](std::size_t i) {
    ViewWork& work = *works[i];
    work.requests = find_surfaces(work.context, io_caches.level, work.frame, work.record);
  });
  fill_surface_cache(works, io_caches);
  draw_views(works, io_caches);
}

}  // namespace temblor::render
