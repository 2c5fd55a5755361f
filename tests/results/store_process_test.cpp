// A store between processes: read while another process writes it, and after that one was killed.
//
// The writer is a forked child. Two pipes keep the two in step; the parent touches SQLite only after the
// fork.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>

#include "results/store.hpp"
#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends_[0]);
    ::close(ends_[1]);
  }

  void signal() const {
    const char byte = 'x';
    if (::write(ends_[1], &byte, 1) != 1) std::abort();
  }
  void wait() const {
    char byte = 0;
    if (::read(ends_[0], &byte, 1) != 1) std::abort();
  }

 private:
  std::array<int, 2> ends_{};
};

TEST(StoreProcesses, ReadWhatAnotherHasWrittenAndOutliveItsDeath) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "results.db";
  const Pipe done;
  const Pipe next;
  const pid_t writer = ::fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) {
    Store store = Store::create(file, some_identity());
    for (std::uint64_t key = 1;; ++key) {
      store.append({solved_row(key, "a", "trap-u/20/1")});
      done.signal();
      next.wait();
    }
  }
  done.wait();
  EXPECT_EQ(Store::open(file, Access::read).size(), 1U);
  EXPECT_THROW(Store::open(file, Access::append), InputError);
  next.signal();
  done.wait();
  EXPECT_EQ(all_rows(Store::open(file, Access::read)).size(), 2U);
  ASSERT_EQ(::kill(writer, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(writer, &status, 0), writer);

  Store store = Store::open(file, Access::append);
  EXPECT_EQ(store.keys(), (std::unordered_set<std::uint64_t>{1, 2}));
  store.append({solved_row(3, "a", "trap-u/20/1")});
  const std::vector<TrialRow> rows = all_rows(store);
  ASSERT_EQ(rows.size(), 3U);
  for (std::uint64_t i = 0; i < 3; ++i) expect_same(rows[i], solved_row(i + 1, "a", "trap-u/20/1"));
}

}  // namespace
}  // namespace pathrace::results
