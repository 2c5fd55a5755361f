#include "bench/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pathrace::bench {
namespace {

constexpr std::chrono::seconds plain_interval{10};

}  // namespace

std::string print_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

Progress::Progress(std::size_t before, std::size_t total)
    : before_(before),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()),
      next_plain_line_(begin_ + plain_interval) {}

std::string Progress::line(std::size_t done) const {
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const std::size_t recorded = before_ + done;
  std::string text = fmt::format("{}/{} trials ({:.0f} %), {} gone", recorded, total_,
                                 100.0 * static_cast<double>(recorded) / static_cast<double>(total_),
                                 print_duration(elapsed));
  if (done > 0 && recorded < total_) {
    const double left = elapsed / static_cast<double>(done) * static_cast<double>(total_ - recorded);
    text += fmt::format(", about {} left", print_duration(left));
  }
  return text;
}

void Progress::update(std::size_t done) {
  if (terminal_) {
    fmt::print(stderr, "\r\x1b[K{}", line(done));
    std::fflush(stderr);
    open_ = true;
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now < next_plain_line_) return;
  next_plain_line_ = now + plain_interval;
  fmt::print(stderr, "{}\n", line(done));
}

void Progress::close() {
  if (open_) fmt::print(stderr, "\n");
  open_ = false;
}

}  // namespace pathrace::bench
