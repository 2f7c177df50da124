function segments = fit_curve(points, closed, parameters, ~)
% @TITLE@: points (n x 2) to a cell of segments, as kappabench_scheme.m explains.
%
% Try it: kappabench fit bird --plugin @NAME@.toml --scheme @NAME@ -o bird.svg
%         kappabench check @NAME@ --plugin @NAME@.toml
n = size(points, 1);
v = tangents(points, closed, parameters.tension);
spans = n - ~closed;
segments = cell(1, spans);
for i = 1:spans
  j = mod(i, n) + 1;
  p = [points(i, :); points(i, :) + v(i, :) / 3; points(j, :) - v(j, :) / 3; points(j, :)];
  segments{i} = struct('type', 'polynomial', 'control_points', p);
end
end

function v = tangents(points, closed, tension)
% TODO: your idea goes here. This one, of Catmull and Rom, takes the chord between the two neighbours.
n = size(points, 1);
v = tension * (points([2:n, 1], :) - points([n, 1:n-1], :));
if ~closed
  v(1, :) = points(2, :) - points(1, :);
  v(n, :) = points(n, :) - points(n - 1, :);
end
end
