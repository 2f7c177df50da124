function result = kappabench(what, varargin)
% KAPPABENCH  Planar curves through points, by the program kappabench. For MATLAB and Octave 7 or newer.
%
%   c = kappabench('fit', P, 'ekappa', 'a', 0.8, 'closed', true)
%       The curve through the rows of P (n x 2) by a scheme with its parameters. P may also be the id of a built-in
%       drawing or the name of a file; then c is a struct array with an element for each of its curves. Besides the
%       scheme's own parameters there are 'closed' (default: false) and 'options', a cell array with a struct or [] for
%       each point: type, a, h, alpha, beta, tangent (degrees), curvature. Look at c.outcome: 'converged', or
%       'not_converged', and then at c.message. What a scheme cannot take is an error.
%
%   X = kappabench('evaluate', c, t)        points, a row for each element of t; t runs over the curve, a unit a segment
%   D = kappabench('evaluate', c, t, nu)    derivatives by t, nu = 1 or 2
%   k = kappabench('curvature', c, t)       signed curvature, 1/length, positive to the left; a column
%   L = kappabench('length', c)             arc length; kappabench('length', c, t) is that from the start to t
%
%   T = kappabench('compare', {'bird', P}, {'kappa', 'ekappa:a=0.8'}, 'closed', true, 'metrics', {'fairness'})
%       The table of the program's `compare`: a struct with a field for each column. Third argument {}: all schemes.
%       'closed' is said of points; without 'metrics' there are all that need no refit.
%   M = kappabench('measure', c, 'points', P, 'metrics', {'fairness'})
%       What metrics say of curves, a struct with a field for each column; judged against the points of the fit or P.
%   h = kappabench('plot', c, 'comb', true)
%       Draws curves over one another, a struct array or a cell array of them; handles of the lines.
%
%   kappabench('schemes'), kappabench('metrics'), kappabench('datasets'), kappabench('experiments')
%       What there is: struct arrays.
%   R = kappabench('results', 'results.h5')
%       The tables of a results file, or of a folder that the program's `report` wrote: R.compare.scheme{1}, ...
%
% The program is the value of the environment variable KAPPABENCH, or `kappabench` on the path. Errors have the
% identifier kappabench:input if what was given is wrong, and kappabench:failed if the program ran and failed.
  if nargin < 1
    help kappabench
    return
  end
  switch what
    case 'fit'
      result = fit(varargin{:});
    case 'evaluate'
      result = evaluate(varargin{:});
    case 'curvature'
      result = curvature(varargin{:});
    case 'length'
      result = curve_length(varargin{:});
    case 'compare'
      result = compare(varargin{:});
    case 'measure'
      result = measure(varargin{:});
    case 'plot'
      result = plot_curves(varargin{:});
    case 'results'
      result = results(varargin{:});
    case {'schemes', 'metrics', 'datasets', 'experiments'}
      result = struct_array(jsondecode(run_program({'list', what, '--json'})));
    otherwise
      refuse('unknown word ''%s''; known are %s', what, ['fit, evaluate, curvature, length, compare, measure, plot, ' ...
             'results, schemes, metrics, datasets, experiments']);
  end
end

% ------------------------------------------------------------------------------------------------------ what is asked

function curves = fit(points, scheme, varargin)
  [given, parameters] = take(varargin, {'closed', 'options'});
  if ~isempty(parameters)
    scheme = [scheme ':' strjoin(cellfun(@parameter_text, parameters(1:2:end), parameters(2:2:end), ...
                                         'UniformOutput', false), ',')];
  end
  [name, is_scratch] = points_name(points, given);
  cleanup = remove_later(name, is_scratch);  %#ok<NASGU> it is there until then
  text = run_program({'fit', name, '--scheme', scheme, '--format', 'json'}, is_scratch);
  curves = curves_of(jsondecode(text));
  if ~ischar(points)
    curves.points = points;
  end
end

function table = compare(points, schemes, varargin)
  given = take_all(varargin, {'closed', 'metrics'});
  if ~iscell(points)
    points = {points};
  end
  names = cell(size(points));
  cleanups = cell(size(points));
  for i = 1:numel(points)
    [names{i}, is_scratch] = points_name(points{i}, given);
    cleanups{i} = remove_later(names{i}, is_scratch);
  end
  arguments = [{'compare'}, names(:)', list_argument('--schemes', schemes), metrics_argument(given)];
  table = columns_of(jsondecode(run_program([arguments, {'--format', 'json'}], true)));
end

function table = measure(curves, varargin)
  given = take_all(varargin, {'points', 'metrics'});
  curves = as_list(curves);
  tables = cell(size(curves));
  for i = 1:numel(curves)
    tables{i} = measure_one(curves{i}, given);
  end
  table = tables{1};
  for i = 2:numel(tables)
    for name = fieldnames(table)'
      table.(name{1}) = [table.(name{1}); tables{i}.(name{1})];
    end
  end
end

function table = measure_one(curve, given)
  name = [tempname() '.json'];
  cleanup = remove_later(name, true);  %#ok<NASGU>
  write_text(name, jsonencode(json_of(curve)));
  arguments = {'measure', name};
  points = [];
  if isfield(given, 'points')
    points = given.points;
  elseif isfield(curve, 'points')
    points = curve.points;
  end
  if ~isempty(points)
    [file, is_scratch] = points_name(points, struct('closed', curve.closed));
    cleanup_points = remove_later(file, is_scratch);  %#ok<NASGU>
    arguments = [arguments, {'--points', file}];
  end
  table = columns_of(jsondecode(run_program([arguments, metrics_argument(given), {'--format', 'json'}], true)));
end

function tables = results(name)
  folder = name;
  if ~isfolder(name)
    folder = tempname();
    cleanup = onCleanup(@() remove(folder));  %#ok<NASGU>
    run_program({'report', name, '-o', folder});
  end
  files = [dir(fullfile(folder, 'tables', '*.csv')); dir(fullfile(folder, '*.csv'))];
  if isempty(files)
    refuse('%s: no tables; give a results file or a folder that `kappabench report` wrote', name);
  end
  tables = struct();
  for i = 1:numel(files)
    [unused, id] = fileparts(files(i).name);  %#ok<ASGLU>
    tables.(field_name(id)) = read_csv(fullfile(files(i).folder, files(i).name));
  end
end

% -------------------------------------------------------------------------------------------------------- evaluation

function values = evaluate(curve, t, order)
  if nargin < 3
    order = 0;
  end
  if ~any(order == [0 1 2])
    refuse('nu = %g; give 0, 1 or 2', order);
  end
  [x, y] = jets_of_curve(curve, t);
  values = [x(:, order + 1), y(:, order + 1)];
end

function k = curvature(curve, t)
  [x, y] = jets_of_curve(curve, t);
  k = (x(:, 2) .* y(:, 3) - y(:, 2) .* x(:, 3)) ./ hypot(x(:, 2), y(:, 2)) .^ 3;
end

% By Gauss' rule on 32 panels a segment: about 1e-12 of the length away from cusps.
function lengths = curve_length(curve, t)
  check_one(curve);
  count = numel(curve.segments);
  if nargin < 2
    t = count;
  end
  starts = [0; cumsum(arrayfun(@(k) part_length(curve.segments{k}, 1), (1:count)'))];
  [segment, local, rounds] = places(curve, t);
  lengths = zeros(numel(t), 1);
  for i = 1:numel(t)
    lengths(i) = rounds(i) * starts(end) + starts(segment(i)) + part_length(curve.segments{segment(i)}, local(i));
  end
end

function sum_of_speeds = part_length(segment, to)
  [nodes, weights] = gauss_on(linspace(0, to, 33));
  [x, y] = jets(segment, nodes);
  sum_of_speeds = weights' * hypot(x(:, 2), y(:, 2));
end

% Segment (from 1) and its own parameter; how often a closed curve was gone around before.
function [segment, local, rounds] = places(curve, t)
  check_one(curve);
  t = t(:);
  count = numel(curve.segments);
  rounds = zeros(size(t));
  outside = t < 0 | t > count | isnan(t);
  if any(outside) && (~curve.closed || any(~isfinite(t)))
    refuse('t = %g is outside of the curve; give 0 to %d, a segment each unit', t(find(outside, 1)), count);
  end
  rounds(outside) = floor(t(outside) / count);
  t = t - rounds * count;
  segment = min(floor(t), count - 1) + 1;
  local = t - (segment - 1);
end

% Value, first and second derivative by t, in columns, a row for each element of t.
function [x, y] = jets_of_curve(curve, t)
  [segment, local] = places(curve, t);
  x = zeros(numel(t), 3);
  y = x;
  for k = unique(segment)'
    here = segment == k;
    [x(here, :), y(here, :)] = jets(curve.segments{k}, local(here));
  end
end

% The same of one segment: schemes/api/CURVE_JSON.md has the formulas.
function [x, y] = jets(s, t)
  t = t(:);
  switch s.type
    case 'polynomial'
      [x, y] = polynomial_jets(s.control_points, t);
    case 'rational'
      [w, unused] = polynomial_jets([s.weights(:), s.weights(:)], t);  %#ok<ASGLU>
      [x, y] = polynomial_jets(s.control_points .* s.weights(:), t);
      x = quotient(x, w);
      y = quotient(y, w);
    case 'trigonometric'
      [x, y] = trigonometric_jets(s.control_points, t);
    case 'clothoid'
      arc = s.length * t;
      heading = @(v) s.angle + s.curvature * s.length * v + s.curvature_rate * s.length ^ 2 * v .^ 2 / 2;
      turn = abs(s.curvature * s.length) + abs(s.curvature_rate) * s.length ^ 2;
      [x, y] = intrinsic_jets(s, t, heading, s.curvature + s.curvature_rate * arc, linspace(0, 1, 2 + ceil(turn)));
    case 'intrinsic'
      [x, y] = spline_jets(s, t);
    case 'elliptic_arc'
      rate = s.to - s.from;
      w = s.from + rate * t;
      c = [cos(w), -rate * sin(w), -rate ^ 2 * cos(w)];
      z = [sin(w), rate * cos(w), -rate ^ 2 * sin(w)];
      one = [ones(size(t)), zeros(numel(t), 2)];
      x = s.centre(1) * one + s.axis_a(1) * c + s.axis_b(1) * z;
      y = s.centre(2) * one + s.axis_a(2) * c + s.axis_b(2) * z;
    case 'reparametrized'
      m = s.start_speed;
      q = 1 ./ ((1 - t) + m * t);
      [x, y] = jets(s.of, m * t .* q);
      first = m * q .^ 2;
      second = -2 * (m - 1) * q .* first;
      x = [x(:, 1), first .* x(:, 2), first .^ 2 .* x(:, 3) + second .* x(:, 2)];
      y = [y(:, 1), first .* y(:, 2), first .^ 2 .* y(:, 3) + second .* y(:, 2)];
    case 'blend'
      [x, y] = blend_jets(s, t);
    case 'sampled'
      [x, y] = sampled_jets(s, t);
    otherwise
      refuse('segment of type ''%s'' cannot be evaluated', s.type);
  end
end

function [x, y] = polynomial_jets(p, t)
  x = zeros(numel(t), 3);
  y = x;
  factor = 1;
  for order = 0:2
    n = size(p, 1) - 1;
    if n < 0
      break
    end
    b = zeros(numel(t), n + 1);
    for i = 0:n
      b(:, i + 1) = nchoosek(n, i) * t .^ i .* (1 - t) .^ (n - i);
    end
    x(:, order + 1) = factor * (b * p(:, 1));
    y(:, order + 1) = factor * (b * p(:, 2));
    p = diff(p, 1, 1);
    factor = factor * n;
  end
end

function [x, y] = trigonometric_jets(p, t)
  h = pi / 2;
  S = sin(h * t);
  C = cos(h * t);
  u = [1 - S, -h * C, h ^ 2 * S];
  v = [S + C - 1, h * (C - S), -h ^ 2 * (S + C)];
  w = [1 - C, h * S, h ^ 2 * C];
  basis = {product(u, u), 2 * product(u, v), 4 * product(u, w), 2 * product(v, w), product(w, w)};
  x = zeros(numel(t), 3);
  y = x;
  for i = 1:5
    x = x + p(i, 1) * basis{i};
    y = y + p(i, 2) * basis{i};
  end
end

% A curve by its heading over v = 0 ... 1: the position is an integral, by Gauss' rule between `breaks`.
function [x, y] = intrinsic_jets(s, t, heading, kappa, breaks)
  L = s.length;
  [position_x, position_y] = walk(heading, breaks, t);
  h = heading(t);
  x = [s.start(1) + L * position_x, L * cos(h), -L ^ 2 * kappa .* sin(h)];
  y = [s.start(2) + L * position_y, L * sin(h), L ^ 2 * kappa .* cos(h)];
end

function [x, y] = spline_jets(s, t)
  n = s.degree;
  knots = [0; s.knots(:); 1];
  k = s.control_curvatures(:);
  % The integral of a B-spline is one of the next degree, whose coefficients are running sums.
  sums = [0; cumsum(k .* (knots(n + 2:end) - knots(1:end - n - 1)) / (n + 1))];
  heading = @(v) s.angle + s.length * bspline([0; knots; 1], sums, n + 1, v);
  kappa = bspline(knots, k, n, t);
  inner = unique(knots);
  turn = s.length * max(abs(k));
  breaks = linspace(0, 1, 2 + ceil(turn));
  [x, y] = intrinsic_jets(s, t, heading, kappa, unique([inner(:); breaks(:)]));
end

% De Boor's algorithm, on each knot span for all t there.
function value = bspline(knots, coefficients, degree, t)
  value = zeros(size(t));
  starts = find(diff(knots) > 0)';
  for span = starts(starts > degree & starts < numel(knots) - degree)
    here = t >= knots(span) & (t < knots(span + 1) | knots(span + 1) == knots(end));
    d = repmat(coefficients(span - degree:span)', nnz(here), 1);
    for r = 1:degree
      for j = degree:-1:r
        left = knots(span - degree + j);
        right = knots(span + 1 + j - r);
        share = (t(here) - left) / (right - left);
        d(:, j + 1) = (1 - share) .* d(:, j) + share .* d(:, j + 1);
      end
    end
    value(here) = d(:, degree + 1);
  end
end

% Integrals of cos and sin of the heading from 0 to each element of t, on the parts between all of them and the breaks.
function [x, y] = walk(heading, breaks, t)
  before = breaks(breaks < max([t(:); 0]));
  [ends, unused, place] = unique([0; t(:); before(:)]);  %#ok<ASGLU>
  [nodes, weights] = gauss_on(ends);
  h = heading(nodes);
  parts = numel(ends) - 1;
  steps_x = sum(reshape(weights .* cos(h), [], parts), 1)';
  steps_y = sum(reshape(weights .* sin(h), [], parts), 1)';
  sum_x = [0; cumsum(steps_x)];
  sum_y = [0; cumsum(steps_y)];
  x = sum_x(place(2:numel(t) + 1));
  y = sum_y(place(2:numel(t) + 1));
end

% Nodes and weights of Gauss' rule with 16 nodes between neighbours of `ends`, in columns.
function [nodes, weights] = gauss_on(ends)
  ends = ends(:);
  if numel(ends) < 2
    nodes = zeros(0, 1);
    weights = nodes;
    return
  end
  % Golub and Welsch 1969: eigenvalues of the Jacobi matrix.
  i = (1:15)';
  off = i ./ sqrt(4 * i .^ 2 - 1);
  [vectors, values] = eig(diag(off, 1) + diag(off, -1));
  u = (diag(values)' + 1) / 2;
  w = vectors(1, :) .^ 2;
  width = diff(ends);
  nodes = reshape((ends(1:end - 1) + width * u)', [], 1);
  weights = reshape((width * w)', [], 1);
end

function [x, y] = blend_jets(s, t)
  h = pi / 2;
  w = [sin(h * t) .^ 2, h * sin(pi * t), pi * h * cos(pi * t)];
  v = [cos(h * t) .^ 2, -w(:, 2), -w(:, 3)];
  [fx, fy] = jets(s.from, t);
  [gx, gy] = jets(s.to, t);
  [fex, fey] = jets(s.from, [0; 1]);
  [gex, gey] = jets(s.to, [0; 1]);
  gaps = product(product(v, w), v);
  others = product(product(v, w), w);
  x = product(v, fx) + product(w, gx) + gaps * (fex(1, 1) - gex(1, 1)) + others * (gex(2, 1) - fex(2, 1));
  y = product(v, fy) + product(w, gy) + gaps * (fey(1, 1) - gey(1, 1)) + others * (gey(2, 1) - fey(2, 1));
end

function [x, y] = sampled_jets(s, t)
  x = zeros(numel(t), 3);
  y = x;
  at = s.t(:);
  part = min(sum(t >= at', 2), numel(at) - 1);
  for j = unique(part)'
    here = part == j;
    h = at(j + 1) - at(j);
    p = [s.x(j), s.y(j); s.x(j + 1), s.y(j + 1)];
    d = h * [s.dx(j), s.dy(j); s.dx(j + 1), s.dy(j + 1)];
    e = h ^ 2 * [s.ddx(j), s.ddy(j); s.ddx(j + 1), s.ddy(j + 1)];
    controls = [p(1, :); p(1, :) + d(1, :) / 5; p(1, :) + 2 * d(1, :) / 5 + e(1, :) / 20; ...
                p(2, :) - 2 * d(2, :) / 5 + e(2, :) / 20; p(2, :) - d(2, :) / 5; p(2, :)];
    [x(here, :), y(here, :)] = polynomial_jets(controls, (t(here) - at(j)) / h);
    x(here, :) = x(here, :) ./ [1, h, h ^ 2];
    y(here, :) = y(here, :) ./ [1, h, h ^ 2];
  end
end

% Leibniz' rule up to the second derivative.
function f = product(a, b)
  f = [a(:, 1) .* b(:, 1), a(:, 2) .* b(:, 1) + a(:, 1) .* b(:, 2), ...
       a(:, 3) .* b(:, 1) + 2 * a(:, 2) .* b(:, 2) + a(:, 1) .* b(:, 3)];
end

function f = quotient(a, b)
  value = a(:, 1) ./ b(:, 1);
  first = (a(:, 2) - value .* b(:, 2)) ./ b(:, 1);
  f = [value, first, (a(:, 3) - 2 * first .* b(:, 2) - value .* b(:, 3)) ./ b(:, 1)];
end

% ---------------------------------------------------------------------------------------------------------- pictures

function lines = plot_curves(curves, varargin)
  given = take_all(varargin, {'comb'});
  comb = ~isfield(given, 'comb') || given.comb;
  curves = as_list(curves);
  colours = [0 114 178; 213 94 0; 0 158 115; 204 121 167; 230 159 0; 86 180 233] / 255;  % Okabe and Ito
  [samples, points] = deal(cell(size(curves)));
  for i = 1:numel(curves)
    samples{i} = sampled(curves{i});
    points{i} = evaluate(curves{i}, node_parameters(curves{i}));
    if isfield(curves{i}, 'points')
      points{i} = [points{i}; curves{i}.points];
    end
  end
  kappa = sort(abs(cell2mat(cellfun(@(one) one.curvature, samples(:), 'UniformOutput', false))));
  kappa = kappa(isfinite(kappa));
  all_points = cell2mat(cellfun(@(one) one.position, samples(:), 'UniformOutput', false));
  size_of_all = max(max(all_points) - min(all_points));
  % Curvature beyond 3 times what 95 % stay below is cut off: a peak near a cusp would hide all else.
  limit = min(kappa(end), max(3 * kappa(ceil(0.95 * end)), 20 / size_of_all));
  held = ishold();
  hold('on');
  lines = zeros(numel(curves), 1);
  for i = 1:numel(curves)
    colour = colours(mod(i - 1, size(colours, 1)) + 1, :);
    one = samples{i};
    if comb && limit > 0
      tips = one.position - 0.22 * size_of_all / limit * max(min(one.curvature, limit), -limit) .* one.normal;
      teeth = 1:4:size(tips, 1);
      x = [one.position(teeth, 1)'; tips(teeth, 1)'; nan(1, numel(teeth))];
      y = [one.position(teeth, 2)'; tips(teeth, 2)'; nan(1, numel(teeth))];
      plot(x(:), y(:), '-', 'Color', 0.4 * colour + 0.6, 'LineWidth', 0.5);
      plot(tips(:, 1), tips(:, 2), '-', 'Color', 0.7 * colour + 0.3, 'LineWidth', 0.5);
    end
  end
  for i = 1:numel(curves)
    styles = {'--', '-'};
    lines(i) = plot(samples{i}.position(:, 1), samples{i}.position(:, 2), ...
                    styles{1 + strcmp(curves{i}.outcome, 'converged')}, 'LineWidth', 1.8, ...
                    'Color', colours(mod(i - 1, size(colours, 1)) + 1, :), 'DisplayName', label_of(curves{i}));
    plot(points{i}(:, 1), points{i}(:, 2), 'ks', 'MarkerFaceColor', 'k', 'MarkerSize', 4);
  end
  axis('equal');
  if ~held
    hold('off');
  end
end

function one = sampled(curve)
  count = 64;
  [x, y] = deal(zeros(0, 3));
  for k = 1:numel(curve.segments)
    [more_x, more_y] = jets(curve.segments{k}, linspace(0, 1, count + 1)');
    x = [x; more_x];  %#ok<AGROW>
    y = [y; more_y];  %#ok<AGROW>
  end
  velocity = hypot(x(:, 2), y(:, 2));
  one = struct('position', [x(:, 1), y(:, 1)], 'normal', [-y(:, 2), x(:, 2)] ./ velocity, ...
               'curvature', (x(:, 2) .* y(:, 3) - y(:, 2) .* x(:, 3)) ./ velocity .^ 3);
end

function t = node_parameters(curve)
  t = zeros(numel(curve.nodes), 1);
  for i = 1:numel(t)
    t(i) = curve.nodes(i).segment + curve.nodes(i).t;
  end
end

% The scheme and, if it did not converge, that.
function text = label_of(curve)
  text = curve.scheme;
  if ~strcmp(curve.outcome, 'converged')
    text = sprintf('%s (%s)', text, strrep(curve.outcome, '_', ' '));
  end
end

% ------------------------------------------------------------------------------------------------------- the program

% What the program prints. A fit that did not converge prints its curve all the same. `anonymous`: messages should not
% name a scratch file.
function text = run_program(arguments, anonymous)
  program = getenv('KAPPABENCH');
  if isempty(program)
    program = 'kappabench';
  end
  errors = tempname();
  cleanup = remove_later(errors, true);  %#ok<NASGU>
  words = cellfun(@quoted, [{program}, arguments], 'UniformOutput', false);
  command = [strjoin(words, ' ') ' 2>' quoted(errors)];
  if ~exist('OCTAVE_VERSION', 'builtin') && isunix()
    command = ['env -u LD_LIBRARY_PATH ' command];  % MATLAB's own libraries are not the program's
  end
  [status, text] = system(command);
  message = strtrim(fileread(errors));
  if status == 0 || (status == 3 && ~isempty(strtrim(text)))
    return
  end
  if any(status == [126 127])
    refuse('no program ''%s''; set the environment variable KAPPABENCH to the program kappabench', program);
  end
  message = regexprep(message, '^kappabench: ', '');
  if nargin > 1 && anonymous
    message = about_points(message);
  end
  if status == 2
    refuse('%s', message);
  end
  error('kappabench:failed', '%s', message);
end

% "/tmp/x/points.txt:6: ..." is about the fifth point: the first line says open or closed.
function message = about_points(message)
  line = regexp(message, 'points\.txt:(\d+):', 'tokens', 'once');
  if ~isempty(line)
    message = regexprep(message, '\S*points\.txt:\d+:', sprintf('point %d:', str2double(line{1}) - 1));
  end
  message = regexprep(message, '\S*points\.txt', 'points');
end

function word = quoted(word)
  if ispc()
    word = ['"' word '"'];
  else
    word = ['''' strrep(word, '''', '''\''''') ''''];
  end
end

% What the program is to open: a name as it is, points in a scratch file.
function [name, is_scratch] = points_name(points, given)
  is_scratch = ~ischar(points);
  name = points;
  if ~is_scratch
    return
  end
  if ~isnumeric(points) || ndims(points) ~= 2 || size(points, 2) ~= 2
    refuse('points are %s, %s; a row is a point: give n x 2', class(points), strjoin(arrayfun(@num2str, size(points), ...
           'UniformOutput', false), ' x '));
  end
  lines = cell(size(points, 1) + 1, 1);
  words = {'open', 'closed'};
  lines{1} = words{1 + (isfield(given, 'closed') && logical(given.closed))};
  for i = 1:size(points, 1)
    lines{i + 1} = sprintf('%.17g %.17g', points(i, 1), points(i, 2));
  end
  if isfield(given, 'options')
    if numel(given.options) ~= size(points, 1)
      refuse('%d options for %d points; give one for each, [] for none', numel(given.options), size(points, 1));
    end
    for i = 1:size(points, 1)
      lines{i + 1} = [lines{i + 1}, options_text(given.options{i})];
    end
  end
  folder = tempname();
  mkdir(folder);
  name = fullfile(folder, 'points.txt');
  write_text(name, sprintf('%s\n', lines{:}));
end

function text = options_text(options)
  text = '';
  if isempty(options)
    return
  end
  for name = fieldnames(options)'
    text = [text, ' ', parameter_text(name{1}, options.(name{1}))];  %#ok<AGROW>
  end
end

function text = parameter_text(name, value)
  if ischar(value)
    text = [name '=' value];
  elseif islogical(value)
    words = {'false', 'true'};
    text = [name '=' words{1 + value}];
  else
    text = sprintf('%s=%.17g', name, value);
  end
end

function words = metrics_argument(given)
  words = {};
  if isfield(given, 'metrics')
    words = list_argument('--metrics', given.metrics);
  end
end

function words = list_argument(option, list)
  if ischar(list)
    list = {list};
  end
  words = {};
  if ~isempty(list)
    words = {option, strjoin(list(:)', ',')};
  end
end

% ------------------------------------------------------------------------------------------------------ values, files

% The curves of decoded JSON, an object or an array: a struct array, segments always in a cell array.
function curves = curves_of(decoded)
  curves = struct_array(decoded);
  for i = 1:numel(curves)
    curves(i).segments = as_list(curves(i).segments);
    curves(i).nodes = struct_array(curves(i).nodes);
    curves(i).joints = struct_array(curves(i).joints);
  end
end

% What curve JSON has of a curve. Lists of one element would become an element.
function object = json_of(curve)
  object = struct('format', 'kappabench-curve', 'version', 2, 'scheme', curve.scheme, 'closed', logical(curve.closed), ...
                  'outcome', curve.outcome);
  object.segments = curve.segments(:)';
  object.nodes = arrayfun(@node_of, curve.nodes(:)', 'UniformOutput', false);
  object.joints = num2cell(curve.joints(:)');
end

function node = node_of(node)
  if ischar(node.marks)
    node.marks = {node.marks};
  elseif isempty(node.marks)
    node.marks = {};
  end
end

% jsondecode makes a struct array of objects with the same fields, and a cell array of others.
function list = struct_array(decoded)
  list = decoded;
  if ~iscell(decoded)
    return
  end
  names = unique(all_fields(decoded));
  list = struct([]);
  for i = 1:numel(decoded)
    for j = 1:numel(names)
      value = [];
      if isfield(decoded{i}, names{j})
        value = decoded{i}.(names{j});
      end
      list(i).(names{j}) = value;
    end
  end
end

function names = all_fields(objects)
  names = {};
  for i = 1:numel(objects)
    names = [names; fieldnames(objects{i})];  %#ok<AGROW>
  end
end

function list = as_list(things)
  list = things;
  if isempty(things)
    list = {};
  elseif ~iscell(things)
    list = num2cell(things);
  end
end

% Rows of JSON as columns: numbers in a column, null as NaN, words in a cell array.
function table = columns_of(rows)
  rows = struct_array(rows);
  table = struct();
  for name = fieldnames(rows)'
    cells = {rows.(name{1})}';
    if any(cellfun(@ischar, cells))
      cells(~cellfun(@ischar, cells)) = {''};
      table.(name{1}) = cells;
    else
      cells(cellfun(@isempty, cells)) = {NaN};
      table.(name{1}) = cellfun(@double, cells);
    end
  end
end

% RFC 4180 with a header "name (unit)": a struct with a field for each column. An empty cell
% among numbers is NaN.
function table = read_csv(name)
  text = fileread(name);
  [tokens, ends] = regexp(text, '("(?:[^"]|"")*"|[^,\r\n]*)(,|\r?\n)', 'tokens', 'end');  %#ok<ASGLU>
  fields = cellfun(@(token) unquoted(token{1}), tokens, 'UniformOutput', false);
  is_last = cellfun(@(token) ~strcmp(token{2}, ','), tokens);
  columns = find(is_last, 1);
  cells = reshape(fields, columns, [])';
  table = struct();
  for j = 1:columns
    column = cells(2:end, j);
    numbers = str2double(column);
    if all(~isnan(numbers) | cellfun(@isempty, column)) && ~strcmp(cells{1, j}, 'warnings')
      column = numbers;
    end
    table.(field_name(regexprep(cells{1, j}, ' \([^()]*\)$', ''))) = column;
  end
end

function text = unquoted(text)
  if numel(text) > 1 && text(1) == '"'
    text = strrep(text(2:end - 1), '""', '"');
  end
end

function name = field_name(text)
  name = regexprep(text, '\W', '_');
  if isempty(name) || ~isletter(name(1))
    name = ['x' name];
  end
end

function write_text(name, text)
  [file, message] = fopen(name, 'w');
  if file < 0
    refuse('%s: cannot be written (%s)', name, message);
  end
  fwrite(file, text);
  fclose(file);
end

% Removes a scratch file, points with the folder that was made for them, when what this returns is gone.
function cleanup = remove_later(name, is_scratch)
  cleanup = [];
  if is_scratch
    [folder, file] = fileparts(name);
    if strcmp(file, 'points')
      name = folder;
    end
    cleanup = onCleanup(@() remove(name));
  end
end

function remove(name)
  if isfolder(name)
    if exist('OCTAVE_VERSION', 'builtin')
      confirm_recursive_rmdir(false, 'local');
    end
    rmdir(name, 's');
  elseif exist(name, 'file')
    delete(name);
  end
end

% Pairs of a name and a value: those of `names` as fields, the rest as they are.
function [given, rest] = take(pairs, names)
  if mod(numel(pairs), 2) ~= 0 || ~all(cellfun(@ischar, pairs(1:2:end)))
    refuse('arguments after the first ones are pairs of a name and a value');
  end
  given = struct();
  rest = {};
  for i = 1:2:numel(pairs)
    if any(strcmp(pairs{i}, names))
      given.(pairs{i}) = pairs{i + 1};
    else
      rest = [rest, pairs(i:i + 1)];  %#ok<AGROW>
    end
  end
end

function given = take_all(pairs, names)
  [given, rest] = take(pairs, names);
  if ~isempty(rest)
    refuse('unknown argument ''%s''; known are %s', rest{1}, strjoin(names, ', '));
  end
end

function check_one(curve)
  if ~isstruct(curve) || numel(curve) ~= 1 || ~isfield(curve, 'segments') || isempty(curve.segments)
    refuse('one curve with segments is needed; c(1) is the first one of several');
  end
end

function refuse(format, varargin)
  error('kappabench:input', format, varargin{:});
end
