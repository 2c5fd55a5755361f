// Values into a statement, one after the other.
#pragma once

#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace pathrace::results {

/// Binds values from left to right. Text is borrowed: it outlives the statement's next execution.
/// tryReset, since a reset reports the failure of the execution before once more.
class Binder {
 public:
  explicit Binder(SQLite::Statement& statement) : statement_(statement) { statement_.tryReset(); }

  Binder& text(const std::string& value) {
    statement_.bindNoCopy(++index_, value);
    return *this;
  }
  Binder& name(std::string_view value) {
    statement_.bind(++index_, std::string(value));
    return *this;
  }
  Binder& integer(std::int64_t value) {
    statement_.bind(++index_, value);
    return *this;
  }
  Binder& count(std::uint64_t value) {
    constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return value <= largest ? integer(static_cast<std::int64_t>(value)) : name(std::to_string(value));
  }
  Binder& real(double value) {
    statement_.bind(++index_, value);
    return *this;
  }
  Binder& real(const std::optional<double>& value) { return value ? real(*value) : null(); }
  Binder& integer(const std::optional<int>& value) { return value ? integer(std::int64_t{*value}) : null(); }
  Binder& flag(const std::optional<bool>& value) { return value ? integer(std::int64_t{*value}) : null(); }
  Binder& count(const std::optional<std::uint64_t>& value) { return value ? count(*value) : null(); }
  Binder& null() {
    statement_.bind(++index_);
    return *this;
  }

 private:
  SQLite::Statement& statement_;
  int index_ = 0;
};

}  // namespace pathrace::results
