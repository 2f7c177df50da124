function segments = catmull_rom_octave(points, closed, parameters, ~)
% The cubic Catmull-Rom spline (Catmull and Rom 1974; Barry and Goldman 1988).
n = size(points, 1);
if closed, before = [n, 1:n-1]; after = [2:n, 1]; else, before = [1, 1:n-1]; after = [2:n, n]; end
spans = n - ~closed;
h = sqrt(sum((points(after, :) - points) .^ 2, 2)) .^ parameters.alpha;  % of the span after each point
slope = (points(after, :) - points) ./ h;
velocity = (h .* slope(before, :) + h(before) .* slope) ./ (h(before) + h);
if ~closed, velocity(1, :) = slope(1, :); velocity(n, :) = slope(n - 1, :); end
segments = cell(1, spans);
for i = 1:spans
  j = after(i);
  p = [points(i, :); points(i, :) + h(i) / 3 * velocity(i, :); points(j, :) - h(i) / 3 * velocity(j, :); points(j, :)];
  segments{i} = struct('type', 'polynomial', 'control_points', p);
end
end
