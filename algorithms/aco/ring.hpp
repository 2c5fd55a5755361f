// Rings: each member knows the next.
#pragma once

namespace pathrace::algorithms {

/// A base of `Member`, which begins as a ring of its own. Members stay where they are.
template <typename Member>
class Ring {
 public:
  Ring() = default;
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  /// Into the ring of `other`, right before it. While nobody goes round.
  void join(Member& other) {
    Ring* last = &other;
    while (last->next_ != &other) last = last->next_;
    last->next_ = self();
    next_ = &other;
  }

 protected:
  ~Ring() = default;

  Member* next() const { return next_; }

 private:
  Member* self() { return static_cast<Member*>(this); }

  Member* next_ = self();
};

}  // namespace pathrace::algorithms
