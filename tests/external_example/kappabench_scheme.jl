# Your interpolation scheme in Julia, as kappabench asks for it (written to the protocol, not run by the tests). Copy this
# file beside your own, add the package JSON, and write
#
#     include("kappabench_scheme.jl")
#     fit(points, closed, parameters, options) =
#         [bezier(points[i, :], points[i+1, :]) for i in 1:size(points, 1)-1]
#     serve(fit)
#
# with the manifest's command = ["julia", "--startup-file=no", "my_spline.jl"] and a timeout that covers Julia's start.
#
# points      n x 2 matrix, row i is point i
# closed      whether the curve returns to its first point
# parameters  Dict: a value for every [[parameter]] of the manifest
# options     vector of n Dicts: what was said of each point (tangent in degrees, curvature, a, type, ...)
# returns     a vector of segments in order, or a Dict("segments" => ..., "iterations" => ...) to say more
#
# throw(Unsupported("why")) for input that the scheme does not take, any other error when it fails. What is printed goes
# to standard error: standard output is the wire to kappabench.
import JSON

struct Unsupported <: Exception
    why::String
end

place(p) = [Float64(p[1]), Float64(p[2])]

"A Bezier piece of degree 1 to 5 from 2 to 6 control points."
bezier(control_points...) = Dict("type" => "polynomial", "control_points" => [place(p) for p in control_points])

"A rational Bezier piece; weights above 0."
rational(control_points, weights) =
    Dict("type" => "rational", "control_points" => [place(p) for p in control_points], "weights" => Float64.(weights))

"Curvature linear in arc length; the angle at the start in radians."
clothoid(start, angle, curvature, curvature_rate, length) =
    Dict("type" => "clothoid", "start" => place(start), "angle" => angle, "curvature" => curvature,
         "curvature_rate" => curvature_rate, "length" => length)

"What has no formula: positions and derivatives by t at ascending t from 0 to 1, each an m x 2 matrix."
sampled(t, position, first, second) =
    Dict("type" => "sampled", "t" => collect(Float64, t), "x" => position[:, 1], "y" => position[:, 2],
         "dx" => first[:, 1], "dy" => first[:, 2], "ddx" => second[:, 1], "ddy" => second[:, 2])

says(outcome, message) = Dict{String,Any}("outcome" => outcome, "message" => message, "segments" => [])

function answer(fit, question)
    rows = question["points"]
    points = [Float64(rows[i][k]) for i in eachindex(rows), k in 1:2]
    start = time()
    said = try
        found = fit(points, question["closed"], question["parameters"], question["options"])
        found isa AbstractDict ? Dict{String,Any}(found) : Dict{String,Any}("segments" => found)
    catch error
        error isa Unsupported ? says("unsupported_input", error.why) : says("failed", sprint(showerror, error))
    end
    merge!(said, Dict("format" => "kappabench-curve", "version" => 2, "seconds" => time() - start))
end

"Answers kappabench until it has no more questions."
function serve(fit)
    wire = stdout
    redirect_stdout(stderr)
    for line in eachline(stdin)
        text = JSON.json(answer(fit, JSON.parse(line)))  # NaN becomes null, which kappabench refuses with one line
        println(wire, text)
        flush(wire)
    end
end
