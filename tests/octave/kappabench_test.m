% The function kappabench against the program that it calls: octave-cli kappabench_test.m, KAPPABENCH being the program.
1;
addpath(fullfile(fileparts(mfilename('fullpath')), '..', '..', 'experiments', 'matlab'));

function refused(pattern, varargin)
  try
    kappabench(varargin{:});
  catch error
    assert(error.identifier, 'kappabench:input');
    assert(isempty(strfind(error.message, "\n")), 'more than one line');
    assert(~isempty(regexp(error.message, pattern)), '%s', error.message);
    return
  end
  assert(false, 'nothing was refused where "%s" was expected', pattern);
end

% Samples of the program: curve, segment, t, x, y, s, kappa.
function rows = samples_of_program(arguments)
  [status, text] = system([getenv('KAPPABENCH') ' fit ' arguments ' --format csv']);
  assert(status == 0 || status == 3);
  lines = strsplit(strtrim(text), "\n");
  rows = cell2mat(cellfun(@(line) sscanf(line, '%f,', [1 Inf]), lines(2:end)', 'UniformOutput', false));
end

function types = types_in(segment)
  types = {segment.type};
  for part = {'of', 'from', 'to'}
    if isfield(segment, part{1}) && isstruct(segment.(part{1}))
      types = [types, types_in(segment.(part{1}))];
    end
  end
end

P = [0 0; 4 -1; 5 3; 2 5; -1 3];

% ------------------------------------------------------------------- every kind of segment is what the program draws
types = {};
for scheme = {'kappa', 'pkappa', 'ekappa-trig', 'clothoid3', 'yuksel:arc=elliptical', ...
              'yuksel:arc=bezier,parametrization=c2', 'intrinsic'}
  for drawing = {'toy', 's-curve'}
    c = kappabench('fit', drawing{1}, scheme{1});
    rows = samples_of_program([drawing{1} ' --scheme ' scheme{1}]);
    inside = rows(:, 3) < 1;  % the end of a segment is the start of the next one
    rows = rows(inside, :);
    t = rows(:, 2) + rows(:, 3);
    size_of_all = max(max(rows(:, 4:5)) - min(rows(:, 4:5)));
    assert(kappabench('evaluate', c, t), rows(:, 4:5), 1e-12 * size_of_all);
    assert(kappabench('curvature', c, t), rows(:, 7), 1e-8 * (1 + max(abs(rows(:, 7)))));
    assert(kappabench('length', c, t(1:7:end)), rows(1:7:end, 6), 1e-7 * size_of_all);
    for k = 1:numel(c.segments)
      types = union(types, types_in(c.segments{k}));
    end
    % Derivatives are those of what is evaluated.
    t = (0.05:0.37:numel(c.segments))';
    h = 1e-4;
    step = kappabench('evaluate', c, t + h) - kappabench('evaluate', c, t - h);
    smooth = floor(t - h) == floor(t + h);
    d = kappabench('evaluate', c, t, 1);
    assert(step(smooth, :) / (2 * h), d(smooth, :), 1e-5 * max(abs(d(:))));
  end
end
assert(types, {'blend', 'clothoid', 'elliptic_arc', 'intrinsic', 'polynomial', 'reparametrized', 'trigonometric'});

% Those that no scheme of the house writes: a quarter of a circle, and samples of a cubic.
quarter = struct('type', 'rational', 'control_points', [1 0; 1 1; 0 1], 'weights', [1; sqrt(0.5); 1]);
c = struct('segments', {{quarter}}, 'closed', false);
t = linspace(0, 1, 9);
assert(hypot(kappabench('evaluate', c, t)(:, 1), kappabench('evaluate', c, t)(:, 2)), ones(9, 1), 1e-15);
assert(kappabench('curvature', c, t), ones(9, 1), 1e-13);
assert(kappabench('length', c), pi / 2, 1e-13);
at = [0; 0.3; 1];
cubic = struct('type', 'sampled', 't', at, 'x', at, 'y', at .^ 3, 'dx', ones(3, 1), 'dy', 3 * at .^ 2, ...
               'ddx', zeros(3, 1), 'ddy', 6 * at);
c = struct('segments', {{cubic}}, 'closed', false);
assert(kappabench('evaluate', c, t), [t' t'.^3], 1e-14);
assert(kappabench('evaluate', c, t, 2), [zeros(9, 1) 6 * t'], 1e-12);

% --------------------------------------------------------------------------------------- points, parameters, options
c = kappabench('fit', P, 'ekappa', 'a', 0.9, 'iteration', 'published', 'closed', true);
assert(c.outcome, 'converged');
assert(c.parameters.a, 0.9);
assert(c.parameters.iteration, 'published');
assert(c.closed);
t = [c.nodes.segment] + [c.nodes.t];
assert(kappabench('evaluate', c, t), P, 1e-12);
assert(kappabench('evaluate', c, t + 5), P, 1e-12);  % closed curves are periodic
assert(kappabench('length', c, 7), kappabench('length', c) + kappabench('length', c, 2), 1e-10);
options = {[], struct('type', 'cusp'), [], [], []};
cusp = kappabench('fit', P, 'fpc', 'options', options);
t = [cusp.nodes([cusp.nodes.point] == 1).segment] + [cusp.nodes([cusp.nodes.point] == 1).t];
assert(norm(kappabench('evaluate', cusp, t(1), 1)) < 1e-6, 'no cusp where one was asked for');
assert(numel(kappabench('fit', 'bird', 'catmull-rom')), 4);
warning('off', 'all');
stopped = kappabench('fit', 'bird', 'kappa', 'iteration', 'published', 'max_iterations', 1);
assert(stopped(1).outcome, 'not_converged');
assert(~isempty(stopped(1).message) && ~isempty(stopped(1).segments));

% ------------------------------------------------------------------------------------------------------------ errors
refused('a row is a point: give n x 2', 'fit', P', 'kappa');
refused('unknown scheme ''kapa''; did you mean kappa', 'fit', P, 'kapa');
refused('a=2: allowed is', 'fit', P, 'ekappa', 'a', 2);
refused('needs at least 3', 'fit', P(1:2, :), 'kappa', 'closed', true);
refused('point 5: unknown key', 'fit', P, 'fpc', 'options', {[], [], [], [], struct('typ', 'cusp')});
refused('5 options for|1 options for 5 points', 'fit', P, 'fpc', 'options', {[]});
refused('pairs', 'fit', P, 'kappa', 'closed');
refused('no-such-file', 'fit', 'no-such-file.txt', 'kappa');
refused('unknown argument ''comp''', 'plot', c, 'comp', true);
refused('outside of the curve', 'evaluate', kappabench('fit', P, 'kappa'), 99);
refused('nu = 3', 'evaluate', c, 0, 3);
refused('unknown word', 'fitt', P);
program = getenv('KAPPABENCH');
setenv('KAPPABENCH', 'no-such-program');
refused('no program ''no-such-program''; set', 'fit', P, 'kappa');
setenv('KAPPABENCH', program);

% ------------------------------------------------------------------------------- a program of before JSON version 2
scratch = tempname();
mkdir(scratch);
old = fullfile(scratch, 'old');
file = fopen(old, 'w');
fprintf(file, '#!/bin/sh\necho ''%s''\n', ['{"format":"kappabench-curve","version":1,"scheme":"kappa","closed":false,' ...
        '"outcome":"converged","segments":[{"type":"polynomial","control_points":[[0,0],[1,2]]}],"nodes":[],"joints":[]}']);
fclose(file);
system(['chmod +x ' old]);
setenv('KAPPABENCH', old);
assert(kappabench('evaluate', kappabench('fit', P, 'kappa'), [0 0.5 1]), [0 0; 0.5 1; 1 2]);
setenv('KAPPABENCH', program);

% ------------------------------------------------------------------------------------------------------------ tables
T = kappabench('compare', {'toy', P}, {'kappa', 'ekappa:a=0.9'}, 'closed', true);
assert(T.scheme, {'kappa'; 'ekappa a=0.9'; 'kappa'; 'ekappa a=0.9'});
assert(T.dataset, {'toy'; 'toy'; 'points'; 'points'});
assert(T.points(3), 5);
assert(all(strcmp(T.outcome, 'converged')));
[status, text] = system([program ' compare toy --schemes kappa,hobby -o ' scratch ' --format csv']);
assert(status, 0);
R = kappabench('results', fullfile(scratch, 'results.h5'));
again = kappabench('results', scratch);
assert(isequaln(R, again));
C = kappabench('compare', 'toy', {'kappa', 'hobby'});
for name = fieldnames(C)'
  if iscell(C.(name{1}))
    assert(R.compare.(name{1}), C.(name{1}));
  else
    assert(R.compare.(name{1}), C.(name{1}), -4 * eps);  % two readers of 17 digits
  end
end
assert(any(strcmp('ekappa', {kappabench('schemes').id})));
assert(any(strcmp('fairness', {kappabench('metrics').id})));
assert(any(strcmp('bird', {kappabench('datasets').id})));
M = kappabench('measure', c, 'metrics', {'fairness'});
F = kappabench('compare', P, {'ekappa:a=0.9,iteration=published'}, 'closed', true, 'metrics', {'fairness'});
assert(M.bending_energy, F.bending_energy, 1e-12 * F.bending_energy);
assert(M.outcome, {'converged'});
M = kappabench('measure', c, 'points', P + 0.1, 'metrics', {'fairness'});
assert(M.outcome, {'not_converged'});

% ---------------------------------------------------------------------------------------------------------- pictures
figure('visible', 'off');
lines = kappabench('plot', {c, cusp});
assert(numel(lines), 2);
assert(get(lines(1), 'DisplayName'), 'ekappa');
assert(max(get(lines(1), 'XData')) > 5 - 1e-9);
confirm_recursive_rmdir(false);
rmdir(scratch, 's');
disp('octave: all as it should be');
