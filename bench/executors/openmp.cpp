// One parallel region for a planner's whole call, or for a loop outside of one; its threads form a team.
//
// Traps: the runtime's settings (dynamic adjustment, nesting depth) belong to the calling thread and not to
// the process, so they are set before each region. By default only the outermost region gets threads, and
// a planner's loop inside a parallel campaign would silently be serial. A region inside one of the same
// executor would get a second team beside the first, n * n threads for n asked, so it runs inline. Inner
// teams of libgomp are not pooled: each inner region starts its threads anew.
#include <omp.h>

#include <exception>
#include <utility>

#include "bench/executors/team.hpp"

namespace pathrace::bench {
namespace {

class OpenMpExecutor final : public Executor {
 public:
  explicit OpenMpExecutor(int threads) : threads_(threads) {}

  std::string_view name() const override { return "openmp"; }
  int threads() const override { return threads_; }

  void with_team(const std::function<void()>& body) override {
    if (threads_ == 1 || works() || leads()) return body();
    open_region([&body](Team&) { body(); });
  }

 private:
  // What the calling thread is to which executor.
  struct Role {
    const OpenMpExecutor* executor = nullptr;
    Team* led = nullptr;  // null for who runs a chunk
  };

  bool works() const { return role.executor == this && role.led == nullptr; }
  bool leads() const { return role.executor == this && role.led != nullptr; }

  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    Chunks chunks(count, grain, body, census_);
    if (threads_ == 1 || chunks.size() == 1 || works()) return chunks.run_inline();
    const auto run = [&](Team& team) {
      const Role before = std::exchange(role, Role{this, nullptr});
      team.run(chunks);
      role = before;
    };
    leads() ? run(*role.led) : open_region(run);
    chunks.rethrow();
  }

  // Calls lead(team) on this thread while the others of the region serve.
  template <typename Lead>
  void open_region(const Lead& lead) {
    omp_set_dynamic(0);  // the number asked for, also above the number of cores
    omp_set_max_active_levels(omp_get_supported_active_levels());
    Team team;
    std::exception_ptr failure;  // must not leave the region
#pragma omp parallel num_threads(threads_)
    {
      const bool leader = omp_get_thread_num() == 0;
      const Role before = std::exchange(role, Role{this, leader ? &team : nullptr});
      if (leader) {
        try {
          lead(team);
        } catch (...) {
          failure = std::current_exception();
        }
        team.dismiss();
      } else {
        team.serve();
      }
      role = before;
    }
    if (failure) std::rethrow_exception(failure);
  }

  static thread_local Role role;

  int threads_;
};

thread_local OpenMpExecutor::Role OpenMpExecutor::role;

}  // namespace

std::unique_ptr<Executor> make_openmp_executor(int threads) {
  return std::make_unique<OpenMpExecutor>(threads);
}

}  // namespace pathrace::bench
