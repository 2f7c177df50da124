#include "schemes/kappa/pins.hpp"

#include <cmath>

namespace kappabench::kappa {
namespace {

constexpr double near_an_end = 0.3;  ///< of the parameter range, for a softened problem
constexpr double at_an_end = 1e-3;   ///< for the problem itself

/// No point can be pinned to the end of an open curve, which is another point.
bool can_pin_start(const State& state, std::size_t i) { return !std::isinf(state.x[i - 1]); }
bool can_pin_end(const State& state, std::size_t i) { return !std::isinf(state.x[i]); }

/// The pinned form if the stationary point lies within `zone` of an end at which |kappa| is largest nearby, else
/// the divided one. A stationary point inside, where the slope vanishes, is told from a softened pin, where it is
/// about that at the end.
Form form_near_end(const ChordChain& chain, const State& state, const Values& values, std::size_t i, double zone) {
  const double last = last_parameter(chain.basis), t = values.t[i];
  const Ends q = ends(chain, state, values.ratios, i);
  const auto slope = [&](double at) { return peak_slope(chain, i, state.e[i], q, at); };
  if (t <= zone * last && can_pin_start(state, i)) {
    const double at_start = slope(0.0);
    if (at_start < 0.0 && slope(t) < 0.3 * at_start) return Form::at_start;
  } else if (t >= (1.0 - zone) * last && can_pin_end(state, i)) {
    const double at_end = slope(last);
    if (at_end > 0.0 && slope(t) > 0.3 * at_end) return Form::at_end;
  }
  return Form::divided;
}

}  // namespace

Setting guess_pins(const ChordChain& chain, const State& state, const Values& values) {
  Setting setting = uniform_setting(chain, Form::divided);
  for (std::size_t i = 1; i <= chain.segments(); ++i)
    setting.form[i] = form_near_end(chain, state, values, i, near_an_end);
  return setting;
}

int correct_pins(const ChordChain& chain, const State& state, const Values& values, Setting& setting) {
  const double last = last_parameter(chain.basis);
  int changed = 0;
  for (std::size_t i = 1; i <= chain.segments(); ++i) {
    const Ends q = ends(chain, state, values.ratios, i);
    Form form = setting.form[i];
    if (form == Form::at_start) {
      if (peak_slope(chain, i, state.e[i], q, 0.0) > 0.0) form = Form::divided;
    } else if (form == Form::at_end) {
      if (peak_slope(chain, i, state.e[i], q, last) < 0.0) form = Form::divided;
    } else {
      form = form_near_end(chain, state, values, i, at_an_end);
    }
    changed += form != setting.form[i];
    setting.form[i] = form;
  }
  return changed;
}

bool pin_worst(const ChordChain& chain, const State& state, const Values& values, Setting& setting) {
  const double last = last_parameter(chain.basis);
  double largest = 0.0;
  std::size_t worst = 0;
  Form form = Form::divided;
  for (std::size_t i = 1; i <= chain.segments(); ++i) {
    const double miss = values.miss[i].norm();
    if (setting.form[i] != Form::divided || miss <= largest) continue;
    const Ends q = ends(chain, state, values.ratios, i);
    const bool start = can_pin_start(state, i) && peak_slope(chain, i, state.e[i], q, 0.0) < 0.0;
    const bool end = can_pin_end(state, i) && peak_slope(chain, i, state.e[i], q, last) > 0.0;
    if (!start && !end) continue;
    largest = miss;
    worst = i;
    form = start && (!end || values.t[i] < 0.5 * last) ? Form::at_start : Form::at_end;
  }
  if (worst == 0) return false;
  setting.form[worst] = form;
  return true;
}

}  // namespace kappabench::kappa
