#include "baselines/ompl/plane.hpp"

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/util/Console.h>

#include <cmath>

namespace pathrace::baselines {
namespace {

namespace ob = ompl::base;

class CellProjection final : public ob::ProjectionEvaluator {
 public:
  using ob::ProjectionEvaluator::ProjectionEvaluator;

  unsigned int getDimension() const override { return 2; }
  void defaultCellSizes() override { cellSizes_ = {1.0, 1.0}; }
  void setup() override {
    bounds_ = space_->as<ob::RealVectorStateSpace>()->getBounds();
    ob::ProjectionEvaluator::setup();
  }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    const Point point = point_of(state);
    projection[0] = point.x;
    projection[1] = point.y;
  }
};

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& si, Inspector& inspector)
      : ob::StateValidityChecker(si), inspector_(inspector) {}

  bool isValid(const ob::State* state) const override { return inspector_.may_be(point_of(state)); }
  Inspector& inspector() const { return inspector_; }

 private:
  Inspector& inspector_;
};

class Motions final : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& si, Inspector& inspector)
      : ob::MotionValidator(si), inspector_(inspector) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return inspector_.may_go(point_of(from), point_of(to));
  }

  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    last_valid.second = inspector_.spent() ? 0 : inspector_.space().reach(point_of(from), point_of(to));
    if (last_valid.first != nullptr) {
      si_->getStateSpace()->interpolate(from, to, last_valid.second, last_valid.first);
    }
    return false;
  }

 private:
  Inspector& inspector_;
};

}  // namespace

Plane::Plane(const FreeSpace& space) : ob::RealVectorStateSpace(2) {
  setName("plane");
  ob::RealVectorBounds bounds(2);
  bounds.setLow(space.low());
  bounds.setHigh(0, space.high_x());
  bounds.setHigh(1, space.high_y());
  setBounds(bounds);
}

void Plane::registerProjections() {
  registerDefaultProjection(std::make_shared<CellProjection>(this));
}

double Plane::distance(const ob::State* a, const ob::State* b) const {
  const Point p = point_of(a);
  const Point q = point_of(b);
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  return std::sqrt(dx * dx + dy * dy);
}

void Plane::copyState(ob::State* to, const ob::State* from) const {
  place(to, point_of(from));
}

ob::State* Plane::allocState() const {
  if (!free_.empty()) {
    ob::State* const state = free_.back();
    free_.pop_back();
    return state;
  }
  PlaneState& state = states_.emplace_back();
  state.values = state.xy;
  return &state;
}

void Plane::freeState(ob::State* state) const {
  free_.push_back(state);
}

std::shared_ptr<ob::SpaceInformation> inspected_plane(Inspector& inspector) {
  [[maybe_unused]] static const bool silent = (ompl::msg::noOutputHandler(), true);  // it chats on stdout
  auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<Plane>(inspector.space()));
  si->setStateValidityChecker(std::make_shared<Validity>(si, inspector));
  si->setMotionValidator(std::make_shared<Motions>(si, inspector));
  si->setup();
  return si;
}

Inspector& inspector_of(const ob::SpaceInformation& plane) {
  return static_cast<const Validity&>(*plane.getStateValidityChecker()).inspector();
}

}  // namespace pathrace::baselines
