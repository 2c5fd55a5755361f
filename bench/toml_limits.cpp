#include "bench/toml_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace pathrace::bench {
namespace {

constexpr int most_key_parts = 16;
constexpr int most_brackets = 32;

// One pass over the structure: strings and comments are passed over as TOML delimits them.
class Scan {
 public:
  Scan(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        pass_string(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        take(c);
        ++at_;
      }
    }
  }

 private:
  void take(char c) {
    if (c == '.') {
      if (++parts_ > most_key_parts) fail(fmt::format("a key of more than {} parts", most_key_parts));
      return;
    }
    if (c == '\n') ++line_;
    if (c == '[' || c == '{') ++depth_;
    if (c == ']' || c == '}') --depth_;
    if (depth_ > most_brackets) fail(fmt::format("brackets nested more than {} deep", most_brackets));
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) parts_ = 1;
  }

  void pass_string(char quote) {
    const std::string three(3, quote);
    if (text_.substr(at_, 3) == three) {
      pass_until(three, quote == '"');
      for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == quote; ++i)
        ++at_;  // quotes before the end
    } else {
      pass_until(std::string(1, quote), quote == '"');
    }
  }

  // Up to behind the closing `end`; a string of one line ends with it, closed or not.
  void pass_until(const std::string& end, bool escapes) {
    for (at_ += end.size(); at_ < text_.size(); ++at_) {
      if (text_.substr(at_, end.size()) == end) {
        at_ += end.size();
        return;
      }
      if (text_[at_] == '\n' && end.size() == 1) return;
      if (text_[at_] == '\\' && escapes) ++at_;
      if (at_ < text_.size() && text_[at_] == '\n') ++line_;
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}; expected a campaign", file_, line_, what));
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  int parts_ = 1;  // of the key at hand; a number with a point counts, too
  int depth_ = 0;
};

}  // namespace

void require_shallow_toml(std::string_view text, const std::string& file) {
  Scan(text, file).run();
}

}  // namespace pathrace::bench
