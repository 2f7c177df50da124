#include "schemes/pkappa/local.hpp"

#include <algorithm>

#include "schemes/pkappa/published_start.hpp"
#include "schemes/pkappa/spans.hpp"

namespace kappabench::pkappa {

void LocalReport::add(const WindowReport& window) {
  ++windows;
  iterations += window.iterations;
  fallbacks += window.fell_back;
  reverted += window.second_stage_reverted;
  unsound += window.checks.empty() || !all_sound(window.checks);
  unfinished += !window.converged;
}

namespace {

/// The points that the segments of a spline through `points` pass: all but the ends of an open curve.
std::span<const Vec2> passed_points(std::span<const Vec2> points, bool closed) {
  return closed ? points : points.subspan(1, points.size() - 2);
}

/// The `count` consecutive segments from `first` on, with wrap-around, and what they pass.
template <Continuity K>
Window<K> window_of(const Spline<K>& spline, std::span<const Vec2> points, bool closed, std::size_t first,
                    std::size_t count) {
  const std::size_t n = spline.t.size();
  const std::span<const Vec2> passed = passed_points(points, closed);
  Window<K> window{.first = !closed && first == 0 ? Freedom::end_point : Freedom::none,
                   .last = !closed && first + count == n ? Freedom::end_point : Freedom::none};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % n;
    window.start.control.push_back(spline.control[i]);
    window.start.t.push_back(spline.t[i]);
    window.points.push_back(passed[i]);
    window.chords.push_back(chord_at(points, closed ? i : i + 1));
  }
  return window;
}

/// Solves for the segments of a window, and leaves the others as they are.
template <Continuity K>
WindowReport solve_range(Spline<K>& spline, std::span<const Vec2> points, bool closed, std::size_t first,
                         std::size_t count, const WindowSettings& settings) {
  const std::size_t n = spline.t.size();
  Window<K> window = window_of<K>(spline, points, closed, first, count);
  const WindowReport report = solve_window<K>(window, settings);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % n;
    spline.control[i] = window.start.control[k];
    spline.t[i] = window.start.t[k];
  }
  return report;
}

/// Of segments as they are; `cyclic`: they are a whole closed curve.
template <Continuity K>
std::vector<SegmentCheck> checks_of(const Window<K>& window, bool cyclic) {
  constexpr int degree = Layout<K>::degree;
  return check_segments<degree>(std::span<const ControlPolygon<degree>>(window.start.control), window.start.t,
                                window.points, window.chords, cyclic, fine_gauss_rule());
}

/// In the sound unit, whatever unit they were minimised in: with each segment's energy over its own chords, a window
/// can be held against a wider one.
template <Continuity K>
Judgement judge(const Window<K>& window, bool cyclic, const Weights& weights) {
  SegmentEnergy<Layout<K>::degree> energy(fine_gauss_rule());
  Judgement judgement{.sound = all_sound(checks_of<K>(window, cyclic)), .energy = 0.0};
  for (std::size_t i = 0; i < window.points.size(); ++i)
    judgement.energy += energy.terms(window.start.control[i], window.start.t[i]).weighted(weights.in(window.chords[i]));
  return judgement;
}

/// The most segments that a window is widened to.
constexpr std::size_t widest = 15;

/// Solves a wider window, and keeps what is better. Returns whether all in it is good.
template <Continuity K>
bool improve(Spline<K>& spline, std::span<const Vec2> points, bool closed, std::size_t first, std::size_t count,
             const WindowSettings& settings, LocalReport& report) {
  Spline<K> attempt = spline;
  const WindowReport window = solve_range<K>(attempt, points, closed, first, count, settings);
  report.add(window);
  const bool cyclic = closed && count == spline.t.size();
  const auto judged = [&](const Spline<K>& s) {
    return judge<K>(window_of<K>(s, points, closed, first, count), cyclic, settings.reduced_weights());
  };
  constexpr double clearly = 0.999;
  if (!better(judged(attempt), judged(spline), clearly)) return false;
  ++report.widened;
  spline = std::move(attempt);
  return all_good(window.checks);
}

/// Solves the window of an insertion, three segments: the last ones of an open spline, or those round the first point
/// of a closed one. What a frozen segment makes impossible may be possible without it: a bad window is widened.
template <Continuity K>
void solve_and_widen(Spline<K>& spline, std::span<const Vec2> points, bool closed, const WindowSettings& settings,
                     LocalReport& report) {
  constexpr std::size_t usual = 3, wide = 7;
  const std::size_t n = spline.t.size();
  const auto first = [&](std::size_t count) { return closed ? n - count / 2 : n - count; };
  const std::size_t least = std::min(n, usual);
  const WindowReport window = solve_range<K>(spline, points, closed, first(least), least, settings);
  report.add(window);
  if (!settings.robust || all_good(window.checks)) return;
  for (std::size_t count = usual + 2; count <= std::min(n, wide); count += 2)
    if (improve<K>(spline, points, closed, first(count), count, settings, report)) return;
}

/// What the insertions left behind and none of the later windows mended: solves ever wider windows round the segments
/// that are not good.
template <Continuity K>
void mend(Spline<K>& spline, std::span<const Vec2> points, bool closed, const WindowSettings& settings,
          LocalReport& report) {
  if (!settings.robust) return;
  const std::size_t n = spline.t.size();
  const std::vector<SegmentCheck> checks = checks_of<K>(window_of<K>(spline, points, closed, 0, n), closed);
  std::size_t tried = 0;  // the segments before it: each was well inside of a window that all widths were tried for
  for (std::size_t i = 0; i < n; ++i) {
    if (checks[i].good() || i < tried) continue;
    tried = i + widest / 3;
    for (std::size_t count = 7; count <= widest; count += 4) {
      const std::size_t reach = count / 2, here = std::min(count, n);
      const std::size_t first = closed ? (i + n - std::min(reach, n)) % n : std::min(i - std::min(i, reach), n - here);
      if (improve<K>(spline, points, closed, first, here, settings, report) || here == n) break;
    }
  }
}

/// Inserts the last of `points` into the open spline through the others: Eq. (7) with the start of Section 5.2.1.
template <Continuity K>
void append(Spline<K>& spline, std::span<const Vec2> points, const WindowSettings& settings, LocalReport& report) {
  constexpr int degree = Layout<K>::degree;
  const std::size_t n = points.size() - 2;  // segments, with the new one
  const Vec2& next = points.back();
  if (n == 1) {
    const double t = chord_parameter(points[0], points[1], points[2]);
    spline = {{first_segment<degree>(points[0], points[1], points[2], t)}, {t}};
  } else {
    const double z = 0.5 * (1.0 + spline.t.back());
    auto& before = spline.control.back();
    before = part<degree>(before, 0.0, z);
    spline.t.back() /= z;
    const double t = chord_parameter(before.col(degree), points[n], next);
    spline.control.push_back(last_segment<K>(before, points[n], next, t));
    spline.t.push_back(t);
  }
  if (n >= 3) make_parametric<K>(spline.control[n - 3], spline.control[n - 2]);

  solve_and_widen<K>(spline, points, false, settings, report);
}

template <Continuity K>
void reverse(Spline<K>& spline) {
  std::ranges::reverse(spline.control);
  std::ranges::reverse(spline.t);
  for (auto& control : spline.control) control = control.rowwise().reverse().eval();
  for (double& t : spline.t) t = 1.0 - t;
}

template <Continuity K>
void edit(Spline<K>& spline, std::span<const Vec2> edited, bool closed, const Move& move,
          const WindowSettings& settings, LocalReport& report) {
  const auto n = static_cast<std::ptrdiff_t>(spline.t.size());
  if (closed) {
    report.add(solve_range<K>(spline, edited, closed, static_cast<std::size_t>((move.point + n - 1) % n), 3, settings));
    return;
  }
  spline.control.front().col(0) = edited.front();
  spline.control.back().template rightCols<1>() = edited.back();
  const std::ptrdiff_t own = std::clamp<std::ptrdiff_t>(move.point - 1, 0, n - 1);
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(own - 1, 0), last = std::min(own + 1, n - 1);
  report.add(solve_range<K>(spline, edited, closed, static_cast<std::size_t>(first),
                            static_cast<std::size_t>(last - first + 1), settings));
}

/// Replaces an end segment by two: the new one, which starts at the end point, and what is left of the old one.
template <Continuity K>
void insert_after_start(Spline<K>& spline, std::span<const Vec2> edited, const WindowSettings& settings,
                        LocalReport& report) {
  constexpr int degree = Layout<K>::degree;
  const double y = 0.5 * spline.t.front();
  auto& right = spline.control.front();
  right = part<degree>(right, y, 1.0);
  spline.t.front() = (spline.t.front() - y) / (1.0 - y);
  const double t = chord_parameter(edited[0], edited[1], right.col(0));
  const ControlPolygon<degree> added = first_segment<degree>(edited[0], edited[1], right.col(0), t);
  spline.control.insert(spline.control.begin(), added);
  spline.t.insert(spline.t.begin(), t);
  const std::size_t count = std::min<std::size_t>(3, spline.t.size());
  report.add(solve_range<K>(spline, edited, false, 0, count, settings));
}

template <Continuity K>
void edit(Spline<K>& spline, std::span<const Vec2> edited, bool closed, const Insert& insert,
          const WindowSettings& settings, LocalReport& report) {
  const auto before = static_cast<std::size_t>(insert.before), last = edited.size() - 1;
  if (!closed && before == last) return append<K>(spline, edited, settings, report);
  if (!closed && before == 1) return insert_after_start<K>(spline, edited, settings, report);
  if (!closed && (before == 0 || before + 1 == last)) {
    const std::vector<Vec2> backwards(edited.rbegin(), edited.rend());
    reverse<K>(spline);
    before == 0 ? append<K>(spline, backwards, settings, report)
                : insert_after_start<K>(spline, backwards, settings, report);
    return reverse<K>(spline);
  }
  // Segments and the points they pass have the same numbers in `passed`, which has the new point already.
  const std::span<const Vec2> passed = passed_points(edited, closed);
  const std::size_t at = closed ? before : before - 1, n = spline.t.size();
  const std::size_t left = (at + n - 1) % n, right = at % n;
  const Spline<K> three = between<K>(spline.control[left], spline.t[left], passed[at > 0 ? at - 1 : n], passed[at],
                                     spline.control[right], spline.t[right], passed[(at + 1) % (n + 1)]);
  spline.control[left] = three.control[0];
  spline.t[left] = three.t[0];
  spline.control[right] = three.control[2];
  spline.t[right] = three.t[2];
  spline.control.insert(spline.control.begin() + static_cast<std::ptrdiff_t>(at), three.control[1]);
  spline.t.insert(spline.t.begin() + static_cast<std::ptrdiff_t>(at), three.t[1]);
  report.add(solve_range<K>(spline, edited, closed, (at + n) % (n + 1), 3, settings));
}

template <Continuity K>
void edit(Spline<K>& spline, std::span<const Vec2> edited, bool closed, const Erase& erase,
          const WindowSettings& settings, LocalReport& report) {
  const auto n = static_cast<std::ptrdiff_t>(spline.t.size());
  const std::ptrdiff_t gone = closed ? erase.point : std::clamp<std::ptrdiff_t>(erase.point - 1, 0, n - 1);
  spline.control.erase(spline.control.begin() + gone);
  spline.t.erase(spline.t.begin() + gone);
  if (!closed) {
    spline.control.front().col(0) = edited.front();
    spline.control.back().template rightCols<1>() = edited.back();
  }
  const std::ptrdiff_t left = n - 1;
  const std::ptrdiff_t first = closed ? (gone - 2 + 2 * left) % left : std::max<std::ptrdiff_t>(gone - 2, 0);
  const std::ptrdiff_t last = closed ? first + std::min<std::ptrdiff_t>(4, left) - 1 : std::min(gone + 1, left - 1);
  report.add(solve_range<K>(spline, edited, closed, static_cast<std::size_t>(first),
                            static_cast<std::size_t>(last - first + 1), settings));
}

}  // namespace

template <Continuity K>
Spline<K> construct_open(std::span<const Vec2> points, const WindowSettings& settings, LocalReport& report) {
  Spline<K> spline;
  for (std::size_t n = 3; n <= points.size(); ++n) append<K>(spline, points.first(n), settings, report);
  mend<K>(spline, points, false, settings, report);
  return spline;
}

template <Continuity K>
Spline<K> construct_closed(std::span<const Vec2> points, const WindowSettings& settings, LocalReport& report) {
  // The open curve on to the first point again, whose segment then comes between the last and the first.
  std::vector<Vec2> round(points.begin(), points.end());
  round.push_back(points.front());
  Spline<K> open;
  for (std::size_t n = 3; n <= round.size(); ++n)
    append<K>(open, std::span<const Vec2>(round).first(n), settings, report);
  const Spline<K> three = between<K>(open.control.back(), open.t.back(), points.back(), points.front(),
                                     open.control.front(), open.t.front(), points[1]);
  Spline<K> closed;
  closed.control = {three.control[1], three.control[2]};
  closed.t = {three.t[1], three.t[2]};
  closed.control.insert(closed.control.end(), open.control.begin() + 1, open.control.end() - 1);
  closed.t.insert(closed.t.end(), open.t.begin() + 1, open.t.end() - 1);
  closed.control.push_back(three.control[0]);
  closed.t.push_back(three.t[0]);
  solve_and_widen<K>(closed, points, true, settings, report);
  mend<K>(closed, points, true, settings, report);
  return closed;
}

template <Continuity K>
bool edit_locally(Spline<K>& spline, std::span<const Vec2> edited, bool closed, const Edit& change,
                  const WindowSettings& settings, LocalReport& report) {
  const std::size_t fewest = closed ? 3 : 1;
  if (passed_points(edited, closed).size() < fewest) return false;
  std::visit([&](const auto& what) { edit<K>(spline, edited, closed, what, settings, report); }, change);
  return true;
}

template Spline<Continuity::c1> construct_open<Continuity::c1>(std::span<const Vec2>, const WindowSettings&,
                                                               LocalReport&);
template Spline<Continuity::c1> construct_closed<Continuity::c1>(std::span<const Vec2>, const WindowSettings&,
                                                                 LocalReport&);
template bool edit_locally<Continuity::c1>(Spline<Continuity::c1>&, std::span<const Vec2>, bool, const Edit&,
                                           const WindowSettings&, LocalReport&);
template Spline<Continuity::g1> construct_open<Continuity::g1>(std::span<const Vec2>, const WindowSettings&,
                                                               LocalReport&);
template Spline<Continuity::g1> construct_closed<Continuity::g1>(std::span<const Vec2>, const WindowSettings&,
                                                                 LocalReport&);
template bool edit_locally<Continuity::g1>(Spline<Continuity::g1>&, std::span<const Vec2>, bool, const Edit&,
                                           const WindowSettings&, LocalReport&);
template Spline<Continuity::c2> construct_open<Continuity::c2>(std::span<const Vec2>, const WindowSettings&,
                                                               LocalReport&);
template Spline<Continuity::c2> construct_closed<Continuity::c2>(std::span<const Vec2>, const WindowSettings&,
                                                                 LocalReport&);
template bool edit_locally<Continuity::c2>(Spline<Continuity::c2>&, std::span<const Vec2>, bool, const Edit&,
                                           const WindowSettings&, LocalReport&);
template Spline<Continuity::g2> construct_open<Continuity::g2>(std::span<const Vec2>, const WindowSettings&,
                                                               LocalReport&);
template Spline<Continuity::g2> construct_closed<Continuity::g2>(std::span<const Vec2>, const WindowSettings&,
                                                                 LocalReport&);
template bool edit_locally<Continuity::g2>(Spline<Continuity::g2>&, std::span<const Vec2>, bool, const Edit&,
                                           const WindowSettings&, LocalReport&);

}  // namespace kappabench::pkappa
