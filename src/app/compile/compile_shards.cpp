#include "app/compile/compile_shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/compile/compile_summary.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "compiler/compile_shard.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Returns the name of a shard's file: castle.vis-2-of-4.
fs::path shard_path(CompileStage stage, const Shard& shard, const LevelPaths& paths) {
  return fs::path(paths.bsp).replace_extension(
      fmt::format(".{}-{}-of-{}", stage_name(stage), shard.number, shard.count));
}

// Returns whether the file's name is exactly that of a shard's file.
bool is_shard_file(const fs::path& file, CompileStage stage, const LevelPaths& paths) {
  // The extension is, for example, ".vis-2-of-4". Comparing with the name that the parsed shard would have
  // rejects variants such as ".vis-02-of-4".
  const std::string ending = file.extension().string();
  const std::string start = fmt::format(".{}-", stage_name(stage)), middle = "-of-";
  const std::size_t between = ending.find(middle, start.size());
  if (!ending.starts_with(start) || between == std::string::npos) return false;
  const base::Result<Shard> shard = parse_shard(fmt::format(
      "{}/{}", ending.substr(start.size(), between - start.size()), ending.substr(between + middle.size())));
  return shard.ok() && shard_path(stage, *shard, paths).filename() == file.filename();
}

// Finds the files of all shards, sorted by name, whatever their count. The readers check that they belong
// together.
base::Result<std::vector<fs::path>> find_shards(CompileStage stage, const LevelPaths& paths) {
  const fs::path folder = paths.bsp.has_parent_path() ? paths.bsp.parent_path() : fs::path(".");
  std::vector<fs::path> found;
  std::error_code failure;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure))
    if (is_shard_file(it->path(), stage, paths)) found.push_back(it->path());
  if (failure) return base::Error{base::ErrorCode::kIo, failure.message(), folder.string()};
  std::sort(found.begin(), found.end());
  if (found.empty())
    return base::Error{
        base::ErrorCode::kNotFound,
        fmt::format("no shards to merge; run compile --only {} --shard K/N first", stage_name(stage)),
        shard_path(stage, {1, 2}, paths).string()};
  return found;
}

// Prints a line if visibility is already complete. Returns whether it is.
bool report_finished_visibility(CompileSession& session) {
  if (session.build().visibility != compiler::VisibilityKind::kFull) return false;
  fmt::print("{}: visibility is complete\n", session.paths().bsp.string());
  return true;
}

// Computes the shard until Ctrl-C, and writes what is done. The file is written before signals are no longer
// deferred, so that a second Ctrl-C cannot lose it.
base::Status write_visibility_shard(const Shard& shard, const fs::path& path, CompileSession& io_session) {
  if (report_finished_visibility(io_session)) return base::Ok{};
  Interrupt& interrupt = io_session.interrupt();
  interrupt.defer();
  compiler::VisibilityShard made;
  {
    Progress line("visibility");
    const auto progress = [&](std::size_t done, std::size_t total) {
      line.update(done, total);
      return !interrupt.was_requested();
    };
    made = compiler::make_visibility_shard(io_session.build(), {shard.number - 1, shard.count},
                                           io_session.jobs(), progress);
  }
  const base::Status written = replace_file(path, made.state);
  interrupt.stop_deferring();
  TRY_STATUS(written);
  if (made.end == compiler::VisibilityEnd::kStopped)
    return base::Error{base::ErrorCode::kIo, "interrupted; --merge uses what was computed so far",
                       path.string()};
  return base::Ok{};
}

// Computes the shard in slices of kSaveEvery and saves it after each one. An interrupted run resumes from the
// same file.
base::Status write_light_shard(const Shard& shard, const fs::path& path, CompileSession& io_session) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kSaveEvery{120};
  Interrupt& interrupt = io_session.interrupt();
  const compiler::Build& build = io_session.build();
  Progress line("light");
  compiler::LightShardBytes made;
  if (base::Result<base::ByteVector> begun = vfs::read_disk_file(path); begun.ok())
    made.bytes = std::move(begun).value();
  interrupt.defer();
  while (!made.is_finished) {
    const Clock::time_point start = Clock::now();
    const auto progress = [&](std::size_t done, std::size_t total) {
      line.update(done, total);
      return !interrupt.was_requested() && Clock::now() - start < kSaveEvery;
    };
    const base::ByteVector begun = std::move(made.bytes);
    TRY(made, compiler::make_light_shard(build, {shard.number - 1, shard.count}, io_session.light_options(),
                                         begun, io_session.jobs(), progress));
    TRY_STATUS(replace_file(path, made.bytes));
    if (interrupt.was_requested() && !made.is_finished)
      return base::Error{base::ErrorCode::kIo, "interrupted; run the same command to resume", path.string()};
  }
  interrupt.stop_deferring();
  return base::Ok{};
}

// Turns a usage error into a file error: if shards do not belong together, the files are wrong, not the
// command line.
template <typename T>
base::Result<T> as_file_error(base::Result<T> result) {
  if (result.ok() || result.error().code != base::ErrorCode::kUsage) return result;
  base::Error error = result.error();
  error.code = base::ErrorCode::kMalformed;
  return error;
}

// Merges the shards into the session's build.
base::Status merge(CompileStage stage, std::span<const compiler::NamedShard> shards,
                   CompileSession& io_session) {
  if (stage == CompileStage::kVisibility) {
    TRY(const compiler::MergedVisibility merged,
        as_file_error(compiler::merge_visibility_shards(shards, io_session.build())));
    fmt::print("{}: visibility of {} of {} portals computed{}\n", io_session.paths().bsp.string(),
               merged.finished_portals, merged.portals,
               merged.finished_portals == merged.portals ? "" : "; run the shards again for the rest");
    return base::Ok{};
  }
  compiler::Warnings warnings;
  base::Status merged = compiler::merge_light_shards(shards, io_session.light_options(), io_session.jobs(),
                                                     io_session.build(), warnings);
  print_warnings(warnings);
  return as_file_error(std::move(merged));
}

// Returns an error if the stage is visibility and the level leaks, because such a level has no visibility.
base::Status check_closed(CompileStage stage, const compiler::CompileReport& report,
                          const CompileSession& session) {
  if (stage != CompileStage::kVisibility || !report.leak) return base::Ok{};
  return base::Error{base::ErrorCode::kMalformed,
                     describe_leak(*report.leak) + "; run compile --only bsp to see the path",
                     session.paths().bsp.string()};
}

}  // namespace

base::Status run_shard(CompileStage stage, const Shard& shard, CompileSession& io_session) {
  TRY(const compiler::CompileReport report, io_session.run_bsp());
  TRY_STATUS(check_closed(stage, report, io_session));
  const fs::path path = shard_path(stage, shard, io_session.paths());
  if (stage == CompileStage::kVisibility) return write_visibility_shard(shard, path, io_session);
  return write_light_shard(shard, path, io_session);
}

base::Status merge_shards(CompileStage stage, CompileSession& io_session) {
  TRY(const compiler::CompileReport report, io_session.run_bsp());
  TRY_STATUS(check_closed(stage, report, io_session));
  const auto write = [&] { return write_level(io_session.build(), report.leak, io_session.paths(), {}); };
  if (stage == CompileStage::kVisibility && report_finished_visibility(io_session)) return write();
  TRY(const std::vector<fs::path> files, find_shards(stage, io_session.paths()));
  std::vector<base::ByteVector> bytes;
  for (const fs::path& file : files) {
    TRY(base::ByteVector shard, vfs::read_disk_file(file));
    bytes.push_back(std::move(shard));
  }
  std::vector<compiler::NamedShard> shards;
  for (std::size_t i = 0; i < files.size(); ++i) shards.push_back({bytes[i], files[i].string()});
  const fs::path all_of_them =
      fs::path(io_session.paths().bsp).replace_extension(fmt::format(".{}-*", stage_name(stage)));
  TRY_STATUS(merge(stage, shards, io_session).with_file(all_of_them.string()));
  TRY_STATUS(write());
  // Remove the shards only now: until the level is written, they are the only copy of the work.
  std::error_code ignored;
  for (const fs::path& file : files) fs::remove(file, ignored);
  return base::Ok{};
}

}  // namespace temblor::app
