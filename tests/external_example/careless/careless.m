function segments = careless(points, ~, parameters, options)
% What authors do to the helper: print, raise, return what is no cell of segments, as the parameter kind says.
points
disp('fitting'); printf('%d points\n', rows(points)); fprintf(1, 'said\n');
n = size(points, 1);
segments = arrayfun(@(i) struct('type', 'polynomial', 'control_points', points(i:i+1, :)), 1:n-1, 'UniformOutput', false);
switch parameters.kind
  case 'raises',  undefined_function(1);
  case 'refuses', error('kappabench:unsupported', 'more than %d points', n - 1);
  case 'nan',     segments{1}.control_points(1, 1) = NaN;
  case 'nothing', segments = [];
  case 'more',    segments = struct('segments', {segments}, 'iterations', 3, 'counters', struct('steps', 2), 'message', 'fine');
end
end
