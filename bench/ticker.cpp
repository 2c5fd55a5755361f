#include "bench/ticker.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <system_error>

#include "bench/progress.hpp"

namespace pathrace::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds first_line{1000};
constexpr std::chrono::milliseconds interval{500};
constexpr std::string_view wipe = "\r\x1b[K";

void add_count(std::string& text, std::string_view what, std::uint64_t count,
               const std::optional<std::uint64_t>& limit) {
  if (limit) {
    text += fmt::format(", {} of {} {}", count, *limit, what);
  } else if (count > 0) {
    text += fmt::format(", {} {}", count, what);
  }
}

}  // namespace

std::string describe_progress(const Meter& meter) {
  const Work work = meter.work();
  const Budget& budget = meter.budget();
  std::string text = fmt::format("plans, {} gone", print_duration(meter.elapsed_s()));
  if (budget.wall_s) text += fmt::format(" of {}", print_duration(*budget.wall_s));
  add_count(text, "evaluations", work.evaluations, budget.evaluations);
  add_count(text, "iterations", work.iterations, budget.iterations);
  add_count(text, "checks", work.checks, budget.checks);
  if (std::isfinite(meter.best_cost())) text += fmt::format(", best {:.2f}", meter.best_cost());
  return text;
}

Ticker::Ticker(bool shown) : since_(Clock::now()) {
  if (!shown) return;
  try {
    thread_ = std::thread([this] { tick(); });
  } catch (const std::system_error&) {  // no thread to be had: it goes on in silence
  }
}

Ticker::~Ticker() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Ticker::say(const std::string& what) {
  const std::lock_guard lock(mutex_);
  what_ = what;
  since_ = Clock::now();
}

std::string Ticker::line() const {
  if (meter_ != nullptr) return describe_progress(*meter_);
  const double gone = std::chrono::duration<double>(Clock::now() - since_).count();
  return what_.empty() ? "" : fmt::format("{}, {} gone", what_, print_duration(gone));
}

void Ticker::tick() {
  std::unique_lock lock(mutex_);
  bool open = false;
  auto next = Clock::now() + first_line;
  while (!wake_.wait_until(lock, next, [this] { return over_; })) {
    fmt::print(stderr, "{}{}", wipe, line());
    std::fflush(stderr);
    open = true;
    next = Clock::now() + interval;
  }
  if (!open) return;
  fmt::print(stderr, "{}", wipe);
  std::fflush(stderr);
}

Ticker::Watch::Watch(Ticker* ticker, const Meter& meter) : ticker_(ticker) {
  if (ticker_ == nullptr) return;
  const std::lock_guard lock(ticker_->mutex_);
  ticker_->meter_ = &meter;
}

Ticker::Watch::~Watch() {
  if (ticker_ == nullptr) return;
  const std::lock_guard lock(ticker_->mutex_);
  ticker_->meter_ = nullptr;
}

}  // namespace pathrace::bench
