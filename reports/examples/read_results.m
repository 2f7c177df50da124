% Reads a results file of kappabench with nothing but MATLAB's h5 functions and draws the curves of one experiment.
%   read_results('results.h5')                       lists what is there
%   read_results('results.h5', 'ekappa-inflection')  draws that experiment's curves
function read_results(file, experiment)
  if ~strcmp(h5readatt(file, '/', 'format'), 'kappabench-results')
    error('%s: not a results file of kappabench', file);
  end
  root = h5info(file, '/experiments');
  if nargin < 2
    for group = root.Groups'
      fprintf('%s: %s, %d cells\n', h5readatt(file, group.Name, 'id'), h5readatt(file, group.Name, 'title'), ...
              numel(h5info(file, [group.Name '/cells']).Groups));
    end
    return
  end

  cells = h5info(file, ['/experiments/' experiment '/cells']);
  figure; hold on; axis equal off;
  for cell = cells.Groups'
    outcome = h5readatt(file, cell.Name, 'outcome');
    fprintf('%s: %s\n', h5readatt(file, cell.Name, 'label'), outcome);
    for curve = h5info(file, [cell.Name '/curves']).Groups'
      px = h5read(file, [curve.Name '/points/x']);
      py = h5read(file, [curve.Name '/points/y']);
      plot(px, py, 'ks', 'MarkerFaceColor', 'k', 'MarkerSize', 4);
      parts = {curve.Groups.Name};
      if ~any(strcmp(parts, [curve.Name '/samples']))
        continue  % a failure has no curve
      end
      x = h5read(file, [curve.Name '/samples/x']);
      y = h5read(file, [curve.Name '/samples/y']);
      if strcmp(outcome, 'converged')
        plot(x, y, '-');
      else
        plot(x, y, '--');  % never draw it as if it were fine
      end
    end
  end
end
