#include "schemes/kappa/chain_part.hpp"

namespace kappabench::kappa {

std::size_t number_in(const ChordChain& chain, const Window& w, std::size_t k) {
  const std::size_t i = w.begin + k - 1;
  return chain.closed ? (i + chain.segments() - 1) % chain.segments() + 1 : i;
}

ChainPart part_of(const ChordChain& chain, const State& state, const Setting& setting, const Window& w) {
  ChainPart part{.chain = {.basis = chain.basis,
                           .closed = false,
                           .chord = {},
                           .a = {},
                           .end = {},
                           .size = {},
                           .least_area = chain.least_area},
                 .state = {},
                 .setting = {.form = std::vector<Form>(w.length + 2, Form::divided)}};
  for (std::size_t k = 0; k <= w.length + 1; ++k) {
    const std::size_t i = number_in(chain, w, k);
    if (k <= w.length) {
      part.chain.chord.push_back(chain.chord[i]);
      part.state.x.push_back(state.x[i]);
    }
    part.chain.a.push_back(chain.a[i]);
    part.chain.end.push_back(chain.end[i]);
    part.chain.size.push_back(chain.size[i]);
    part.state.e.push_back(state.e[i]);
    part.setting.form[k] = setting.form[i];
  }
  return part;
}

void put_back(const ChordChain& chain, const Window& w, const State& part, const Setting& part_setting, State& state,
              Setting& setting) {
  for (std::size_t k = 1; k <= w.length; ++k) {
    const std::size_t i = number_in(chain, w, k);
    state.e[i] = part.e[k];
    if (k < w.length) state.x[i] = part.x[k];
    setting.form[i] = part_setting.form[k];
  }
  state.close(chain);
}

}  // namespace kappabench::kappa
