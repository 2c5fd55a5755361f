// A store between processes: read while another process writes it, and after that one was killed.
//
// The writer is a forked child. Two pipes keep the two in step; the parent touches SQLite only after the
// fork.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "results/altered_store.hpp"
#include "results/store.hpp"
#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

/// A pipe whose two ends belong to two processes: when one dies, the other does not wait for it.
class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }

  void keep_reading_end() { close_end(1); }
  void keep_writing_end() { close_end(0); }

  bool signal() const { return ::write(ends_[1], "x", 1) == 1; }
  bool wait() const {
    char byte = 0;
    return ::read(ends_[0], &byte, 1) == 1;
  }

 private:
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }

  std::array<int, 2> ends_{};
};

// Appends a row for each signal until nobody signals any more. Never returns into the test runner.
[[noreturn]] void write_rows(const std::filesystem::path& file, const Pipe& done, const Pipe& next) {
  try {
    Store store = Store::create(file, some_identity());
    for (std::uint64_t key = 1;; ++key) {
      store.append({solved_row(key, "a", "trap-u/20/1")});
      if (!done.signal() || !next.wait()) break;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "the writing process: %s\n", error.what());
  }
  ::_exit(1);
}

TEST(StoreProcesses, ReadWhatAnotherHasWrittenAndOutliveItsDeath) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "results.db";
  Pipe done;
  Pipe next;
  const pid_t writer = ::fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) {
    done.keep_writing_end();
    next.keep_reading_end();
    write_rows(file, done, next);
  }
  done.keep_reading_end();
  next.keep_writing_end();
  ASSERT_TRUE(done.wait());
  EXPECT_EQ(Store::open(file, Access::read).size(), 1U);
  EXPECT_THROW(Store::open(file, Access::append), InputError);
  ASSERT_TRUE(next.signal());
  ASSERT_TRUE(done.wait());
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

TEST(StoreProcesses, MissTheRowsOfALogThatWasDeleted) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "results.db";
  Pipe done;
  Pipe next;
  const pid_t writer = ::fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) {
    done.keep_writing_end();
    next.keep_reading_end();
    write_rows(file, done, next);
  }
  done.keep_reading_end();
  next.keep_writing_end();
  ASSERT_TRUE(done.wait());
  ASSERT_TRUE(next.signal());
  ASSERT_TRUE(done.wait());  // the first row's number is written down by now
  ASSERT_EQ(::kill(writer, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(writer, &status, 0), writer);
  ASSERT_TRUE(std::filesystem::remove(folder / "results.db-wal"));

  for (const Access access : {Access::read, Access::append}) {
    expect_line(message_of<AlteredStore>([&] { Store::open(file, access); }),
                {file.string(), "0 trials", "results.db-wal", "results.db-lock"});
  }
  std::filesystem::remove(folder / "results.db-lock");
  EXPECT_EQ(Store::open(file, Access::append).size(), 0U);
}

}  // namespace
}  // namespace pathrace::results
