#include "core/run_referee.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "core/world_motion.hpp"

namespace pathrace {
namespace {

constexpr double slack = 1e-9;  // of rounding, in units, and as a share of V_robot

std::string text(Point p) {
  return fmt::format("{},{}", p.x, p.y);
}

double apart(Point p, Point q) {
  return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
}

// The least distance between a point and what moves straight from `from` to `to`.
double swept(Point from, Point to, Point point) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double squared = dx * dx + dy * dy;
  if (squared == 0) return apart(from, point);
  const double share = ((point.x - from.x) * dx + (point.y - from.y) * dy) / squared;
  const double t = std::clamp(share, 0.0, 1.0);
  return apart({from.x + t * dx, from.y + t * dy}, point);
}

bool drives_into(Point from, Point to, Point point, double reach) {
  const double least = swept(from, to, point);
  return least < reach - slack && least < apart(from, point) - slack;
}

std::string step_fault(const World& world, const std::vector<Point>& points, std::size_t k) {
  const Point to = points[k];
  const double low = world.robot_radius - slack;
  const bool inside = to.x >= low && to.y >= low && to.x <= world.width - low && to.y <= world.height - low;
  if (!inside) return fmt::format("step {} ends at {}, outside the workspace", k, text(to));  // and NaN
  const double length = apart(points[k - 1], to);
  if (length > world.robot_step * (1 + slack)) {
    return fmt::format("step {} is {} long, longer than V_robot = {}", k, length, world.robot_step);
  }
  return "";
}

class Replay {
 public:
  Replay(const World& world, const std::vector<Point>& points)
      : world_(world), points_(points), motion_(world), before_(world.discs) {}

  RunJudgement judge() {
    judgement_.fault = first_fault();
    judgement_.metrics.world_hash = motion_.hash_to_the_end();
    if (judgement_.fault.empty() && judgement_.metrics.world_hash != world_.hash) {
      judgement_.fault = fmt::format("the world moved otherwise than its id says: hash {}, expected {}",
                                     hex(judgement_.metrics.world_hash), hex(world_.hash));
    }
    return std::move(judgement_);
  }

 private:
  bool arrived(std::size_t k) const { return apart(points_[k], motion_.goal()) <= world_.arrival; }

  std::string first_fault() {
    if (points_.empty()) return "the run is empty";
    if (points_.front() != world_.start) {
      return fmt::format("begins at {}, not at the start {}", text(points_.front()), text(world_.start));
    }
    if (points_.size() - 1 > world_.max_steps) {
      return fmt::format("took {} steps, more than {}", points_.size() - 1, world_.max_steps);
    }
    note_clearance(points_.front(), points_.front());
    for (std::size_t k = 1; k < points_.size(); ++k) {
      if (arrived(k - 1)) return fmt::format("went on after it had arrived with step {}", k - 1);
      std::string fault = step_fault(world_, points_, k);
      if (!fault.empty()) return fault;
      move_world(points_[k - 1]);
      drive(k);
    }
    judgement_.arrived = arrived(points_.size() - 1);
    judgement_.metrics.oscillations = oscillations();
    return "";
  }

  void move_world(Point robot) {
    motion_.advance(robot);
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Disc& disc = motion_.discs()[i];
      const double reach = disc.radius + world_.robot_radius;
      if (drives_into(before_[i].centre, disc.centre, robot, reach)) ++judgement_.metrics.struck;
      note_gap(swept(before_[i].centre, disc.centre, robot) - reach);
      before_[i] = disc;
    }
  }

  void drive(std::size_t k) {
    const Point from = points_[k - 1];
    const Point to = points_[k];
    ++judgement_.metrics.steps;
    judgement_.metrics.travelled += apart(from, to);
    for (std::size_t i = 0; i < before_.size(); ++i) {
      if (!drives_into(from, to, before_[i].centre, before_[i].radius + world_.robot_radius)) continue;
      if (judgement_.metrics.collisions++ == 0) {
        judgement_.collision = fmt::format("step {}, from {:.6g},{:.6g} to {:.6g},{:.6g} into disc {}", k,
                                           from.x, from.y, to.x, to.y, i);
      }
    }
    note_clearance(from, to);
  }

  void note_clearance(Point from, Point to) {
    for (const Disc& disc : before_) {
      note_gap(swept(from, to, disc.centre) - disc.radius - world_.robot_radius);
    }
  }

  void note_gap(double gap) {
    judgement_.metrics.min_clearance = std::min(judgement_.metrics.min_clearance.value_or(gap), gap);
  }

  std::uint64_t oscillations() const {
    std::uint64_t count = 0;
    std::vector<bool> left(points_.size(), false);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      bool back = false;
      for (std::size_t i = 0; i < k; ++i) {
        const bool near = apart(points_[i], points_[k]) <= world_.robot_step / 2;
        back = back || (near && left[i]);
        left[i] = left[i] || !near;
      }
      if (back) ++count;
    }
    return count;
  }

  const World& world_;
  const std::vector<Point>& points_;
  WorldMotion motion_;
  std::vector<Disc> before_;
  RunJudgement judgement_;
};

}  // namespace

RunJudgement judge_run(const World& world, const std::vector<Point>& points) {
  return Replay(world, points).judge();
}

}  // namespace pathrace
