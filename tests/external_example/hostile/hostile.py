"""A program that answers kappabench as badly as its parameter `kind` says: one function for every kind of trouble."""
import json
import os
import signal
import subprocess
import sys
import time

def say(text):
    sys.stdout.write(text)
    sys.stdout.flush()


def polygon(question, **more):
    """The honest part: lines from point to point, as an answer with `more`."""
    points = question["points"]
    ends = points[1:] + points[:1] if question["closed"] else points[1:]
    segments = [{"type": "polynomial", "control_points": [p, q]} for p, q in zip(points, ends)]
    return dict({"segments": segments}, **more)


def answer(question, **more):
    say(json.dumps(polygon(question, **more)) + "\n")


def first_time(name):
    """True once in the folder, however often the program is started."""
    try:
        os.close(os.open(name, os.O_CREAT | os.O_EXCL))
        return True
    except FileExistsError:
        return False


# ---- answers that are none

def not_json(question): say("I have no idea\n")
def stray_print(question): say("fitting...\n"), answer(question)
def not_utf8(question): os.write(1, b'{"segments":[\xff\xfe]}\n')
def cut_off(question): say('{"segments":[{"type":"poly\n')
def nested(question): say("[" * 1000000 + "\n")
def nothing_in_it(question): say("{}\n")
def a_number(question): say("42\n")
def other_format(question): answer(question, format="gerber")
def other_version(question): answer(question, version=99)
def two_curves(question): say(json.dumps([polygon(question)] * 2) + "\n")
def no_segments(question): say('{"segments":[]}\n')
def no_such_type(question): say('{"segments":[{"type":"nurbs"}]}\n')
def one_control_point(question): say('{"segments":[{"type":"polynomial","control_points":[[0,0]]}]}\n')
def three_coordinates(question): say('{"segments":[{"type":"polynomial","control_points":[[0,0,0],[1,1,1]]}]}\n')
def not_a_number(question): say('{"segments":[{"type":"polynomial","control_points":[[0,NaN],[1,1]]}]}\n')
def null(question): say('{"segments":[{"type":"polynomial","control_points":[[0,null],[1,1]]}]}\n')
def infinite(question): say('{"segments":[{"type":"polynomial","control_points":[[0,1e999],[1,1]]}]}\n')
def wrong_count(question): say('{"segments":[{"type":"rational","control_points":[[0,0],[1,1]],"weights":[1]}]}\n')
def no_such_node(question): answer(question, nodes=[{"point": 0, "segment": 99, "t": 0.5}])
def no_such_joint(question): answer(question, joints=[{"segment": -1, "claimed": "G1"}])
def no_such_outcome(question): answer(question, outcome="splendid")
def not_its_outcome(question): answer(question, outcome="timed_out")
def bad_counter(question): answer(question, counters={"two words": 1})
def bad_count(question): answer(question, counters={"steps": 0.5})
def many_counters(question): answer(question, counters={"c%d" % i: i for i in range(1000)})
def negative_time(question): answer(question, seconds=-1.0)


# ---- answers that are sound in form

def misses_points(question):
    points = [[x + 1.0, y] for x, y in question["points"]]
    answer(dict(question, points=points))


def open_for_closed(question):
    answer(dict(question, closed=False), closed=False)


def says_failed(question): answer(question, outcome="failed", message="no\nidea\x1b[31m", iterations=7)
def says_unsolved(question): answer(question, outcome="not_converged", message="still 0.5 off", residual=0.5)
def says_more(question): answer(question, counters={"steps": 3}, iterations=5, residual=1e-9, seconds=12.5)
def answers_twice(question): say(json.dumps(polygon(question)) + "\n" + '{"segments":[],"outcome":"failed"}\n')
def in_pieces(question):
    for piece in (json.dumps(polygon(question)), "\n"):
        for start in range(0, len(piece), 100):
            say(piece[start:start + 100])
            time.sleep(0.001)


def who(question): answer(question, counters={"process": os.getpid()})


# ---- none at all

def silence(question): time.sleep(1000)
def silent_once(question): time.sleep(1000) if first_time("silent_once.txt") else answer(question)
def endless_line(question):
    while True:
        say("x" * 100000)


def endless_complaints(question):
    while True:
        sys.stderr.write("warning: warning\n" * 1000)


def many_complaints(question):
    sys.stderr.write("warning: warning\n" * 100000)
    answer(question)


def closes_output(question):
    os.close(1)
    time.sleep(1000)


def exits(question): sys.exit(0)
def fails(question): raise ValueError("no \x07curve\tfits")
def mutters(question): os.write(2, b"\x1b[2J\xff\n\n" + b"y" * 5000 + b"\nlast words\n\n"), os._exit(9)
def aborts(question): os.kill(os.getpid(), signal.SIGABRT)
def aborts_once(question): os.kill(os.getpid(), signal.SIGABRT) if first_time("aborts_once.txt") else answer(question)


def answers_once(question):
    answer(question)
    sys.exit(0)


def kills_guardian(question):
    os.kill(os.getppid(), signal.SIGKILL)
    time.sleep(1000)


def leaves_children(question):
    """A process of its own that keeps standard output open, and its number in a file."""
    child = subprocess.Popen(["sleep", "1000"])
    with open("child.txt", "w") as file:
        file.write("%d %d" % (os.getpid(), child.pid))
    if question["closed"]:
        time.sleep(1000)
    os._exit(3)


# ---- not even the question is read

if sys.argv[1] == "deaf":
    time.sleep(1000)
if sys.argv[1] == "exits_at_once":
    sys.exit(3)
for line in sys.stdin:
    question = json.loads(line)
    globals()[question["parameters"]["kind"]](question)
