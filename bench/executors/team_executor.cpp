#include "bench/executors/team_executor.hpp"

#include <chrono>
#include <thread>
#include <utility>

namespace pathrace::bench {
namespace {

// What the calling thread is to an executor, until the end of a scope. Parts may be inside of each other.
class Part {
 public:
  /// Who leads no team runs a chunk; of no executor, if it is that of a loop outside of teams.
  Part(const TeamExecutor* executor, Team* led) : executor_(executor), led_(led) { innermost = this; }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() { innermost = outer_; }

  /// The calling thread's innermost part in what this executor runs; null if it has none.
  static Part* in(const TeamExecutor* executor) {
    Part* part = innermost;
    while (part != nullptr && part->executor_ != executor) part = part->outer_;
    return part;
  }
  static bool none() { return innermost == nullptr; }
  Team* led() const { return led_; }
  /// True the first time.
  bool begins() { return std::exchange(fresh_, false); }

 private:
  static thread_local Part* innermost;

  Part* outer_ = innermost;
  const TeamExecutor* executor_;
  Team* led_;
  bool fresh_ = true;
};
thread_local Part* Part::innermost = nullptr;

}  // namespace

void TeamExecutor::with_team(const std::function<void()>& body) {
  if (threads_ == 1 || Part::in(this) != nullptr) return body();
  gather([&body](Team&) { body(); });
}

void TeamExecutor::run_chunks(std::size_t count, std::size_t grain, ChunkBody body) {
  Chunks chunks(count, grain, body, census_);
  Part* const part = Part::in(this);
  const bool works = part != nullptr && part->led() == nullptr;
  if (threads_ == 1 || chunks.size() == 1 || works) return chunks.run_inline();
  if (part == nullptr) {
    run_apart(chunks);
  } else {
    if (part->begins()) call_helpers(*part->led());
    run_in(*part->led(), chunks);
  }
  chunks.rethrow();
}

void TeamExecutor::start() {
  using namespace std::chrono_literals;
  if (threads_ == 1 || !shares_.exist() || !outermost()) return;
  gather([this](Team& team) {
    call_helpers(team);
    constexpr int patience = 1000;
    for (int k = 0; k < patience && arrived_ < threads_ - 1; ++k) std::this_thread::sleep_for(20us);
  });
}

bool TeamExecutor::outermost() {
  return Part::none();
}

void TeamExecutor::run_apart(Chunks& chunks, std::size_t k) {
  const Part part(nullptr, nullptr);
  chunks.run(k);
}

void TeamExecutor::lead_team(Team& team, const Lead& lead) const {
  struct Dismissal {
    Team& team;
    ~Dismissal() { team.dismiss(); }
  };
  const Part part(this, &team);
  const Dismissal at_the_end{team};
  lead(team);
}

void TeamExecutor::run_in(Team& team, Chunks& chunks) const {
  const Part part(this, nullptr);
  team.run(chunks);
}

void TeamExecutor::serve(Team& team) const {
  const Part part(this, nullptr);
  team.serve();
}

}  // namespace pathrace::bench
