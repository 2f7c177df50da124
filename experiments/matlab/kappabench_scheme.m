function kappabench_scheme(fit)
%KAPPABENCH_SCHEME  Your interpolation scheme in MATLAB or Octave, as kappabench asks for it.
%   Copy this file beside your function  segments = fit_curve(points, closed, parameters, options)  and let the
%   manifest start  kappabench_scheme(@fit_curve)  (see schemes/plugin/README.md).
%
%   points      n x 2, row i is point i
%   closed      whether the curve returns to its first point
%   parameters  struct: a value for every [[parameter]] of the manifest
%   options     1 x n cell of structs: what was said of each point (tangent in degrees, curvature, a, type, ...)
%   segments    a cell of structs in order, each a segment of the curve JSON (schemes/api/CURVE_JSON.md), such as
%                 struct('type', 'polynomial', 'control_points', P)    a Bezier piece, P (2 to 6) x 2
%                 struct('type', 'rational', 'control_points', P, 'weights', w)
%                 struct('type', 'clothoid', 'start', p, 'angle', a, 'curvature', k, 'curvature_rate', r, 'length', L)
%                 struct('type', 'sampled', 't', t, 'x', x, 'y', y, 'dx', dx, 'dy', dy, 'ddx', ddx, 'ddy', ddy)
%               or, to say more, one struct with the fields segments = {{...}}, iterations, residual, message, ...
%
%   error('kappabench:unsupported', 'why') is for input that the scheme does not take, any other error for a failure.
%   What is printed goes to standard error: standard output is the wire to kappabench.
read_line = line_reader();
while true
  line = read_line();
  if ~ischar(line), break, end
  if isempty(strtrim(line)), continue, end
  start = tic;
  try
    answer = answer_to(fit, jsondecode(line), start);
    text = encode(answer);
  catch problem
    outcome = 'failed';
    if strcmp(problem.identifier, 'kappabench:unsupported'), outcome = 'unsupported_input'; end
    text = encode(struct('outcome', outcome, 'message', [problem.message place(problem)], 'segments', {{}}));
  end
  fprintf(1, '%s\n', text);
  if is_octave(), fflush(stdout); end
end
end

function answer = answer_to(fit, question, start) %#ok<INUSL> used inside evalc
points = reshape(question.points, [], 2); %#ok<NASGU>
options = reshape(question.options, 1, []);
if ~iscell(options), options = num2cell(options); end %#ok<NASGU>
result = {};
printed = evalc('result = fit(points, question.closed, question.parameters, options);');
seconds = toc(start);
if ~isempty(printed), fprintf(2, '%s', printed); end
if iscell(result), result = struct('segments', {result}); end
answer = result;
answer.format = 'kappabench-curve';
answer.version = 2;
answer.seconds = seconds;
end

function read = line_reader()
if is_octave()
  read = @line_of_octave;
else
  reader = java.io.BufferedReader(java.io.InputStreamReader(java.lang.System.in));
  read = @() text_or_end(reader.readLine());
end
end

function line = line_of_octave()
try
  line = input('', 's');  % fgetl would wait for the first character of the line after it
catch
  line = -1;  % no more questions
end
end

function line = text_or_end(line)
if isempty(line) && ~ischar(line), line = -1; else, line = char(line); end
end

function yes = is_octave()
yes = exist('OCTAVE_VERSION', 'builtin') ~= 0;
end

function text = place(problem)
text = '';
if ~isempty(problem.stack), text = sprintf(' (%s:%d)', problem.stack(1).name, problem.stack(1).line); end
end

function text = encode(value)
% JSON with every digit, where a matrix with rows of points keeps them: jsonencode of Octave rounds to 15 digits.
if ischar(value) || isstring(value)
  text = jsonencode(char(value));
elseif iscell(value)
  text = ['[' strjoin(cellfun(@encode, value(:)', 'UniformOutput', false), ',') ']'];
elseif isstruct(value) && isscalar(value)
  names = fieldnames(value)';
  fields = cellfun(@(name) ['"' name '":' encode(value.(name))], names, 'UniformOutput', false);
  text = ['{' strjoin(fields, ',') '}'];
elseif isstruct(value)
  text = encode(num2cell(value));
elseif islogical(value) && isscalar(value)
  words = {'false', 'true'};
  text = words{value + 1};
elseif isscalar(value)
  if isfinite(value), text = sprintf('%.17g', value); else, text = 'null'; end
elseif isvector(value) || isempty(value)
  text = encode(num2cell(value));
else
  text = encode(num2cell(value, 2));
end
end
