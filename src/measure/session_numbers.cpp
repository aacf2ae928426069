// SPDX-License-Identifier: BSD-3-Clause
#include "measure/session_numbers.h"

#include <cmath>

#include "io/documents/light_field_params.h"

namespace hogelscope {

namespace {

/// Calls `action` with each number, which it may change.
template <class Action>
class NumberVisitor : public ParameterVisitor {
 public:
  explicit NumberVisitor(const Action& action) : m_action(action) {}

  void visit(Session& session, std::size_t state) {
    TwinParams& twin = session.twin;
    all(session.display, twin.lensArray, twin.colour, twin.leakage, twin.light, twin.random,
        twin.random.shift, twin.random.gain, session.lightField, session.sampling, session.depth,
        session.optimise);
    CameraState& own = session.cameras.at(state);
    all(own.camera, own.intrinsics, own.pupil, own.stereo, own.distortion, own.psf);
    m_within = "lightField.";
    if (session.lightField.content.isGiven()) describe(*this, session.lightField.content);
    describe(*this, session.lightField.live);
  }

 private:
  template <class... Params>
  void all(Params&... params) {
    (describe(*this, params), ...);
  }
  void group(std::string_view name, std::string_view) override {
    m_group = m_within + std::string(name);
  }
  void numbers(const Field& field, std::span<double> values, bool) override {
    each(field, values, false);
  }
  void integers(const Field& field, std::span<int> values, bool) override {
    each(field, values, true);
  }
  void flag(const Field&, bool&) override {}
  void text(const Field&, std::string&) override {}
  void choice(const Field&, int&) override {}

  template <class Number>
  void each(const Field& field, std::span<Number> values, bool isWhole) {
    SessionNumber number{m_group + "." + std::string(field.name),
                         std::string(field.label),
                         std::string(field.unit),
                         field.range,
                         isWhole,
                         field.counts};
    number.count = values.size();
    for (number.index = 0; number.index < values.size(); ++number.index) {
      number.value = double(values[number.index]);
      m_action(number, values[number.index]);
    }
  }

  const Action& m_action;
  std::string m_within;
  std::string m_group;
};

}  // namespace

std::vector<SessionNumber> numbersOf(const Session& session, std::size_t state) {
  std::vector<SessionNumber> numbers;
  const auto add = [&numbers](const SessionNumber& number, auto& /*value*/) {
    numbers.push_back(number);
  };
  Session visited = session;
  NumberVisitor(add).visit(visited, state);
  return numbers;
}

void setNumber(Session& session, std::size_t state, const SessionNumber& which, double value) {
  const auto set = [&](const SessionNumber& number, auto& own) {
    if (number.name != which.name || number.index != which.index) return;
    if constexpr (std::is_same_v<decltype(own), int&>)
      own = int(std::lround(value));
    else
      own = value;
  };
  NumberVisitor(set).visit(session, state);
}

}  // namespace hogelscope
