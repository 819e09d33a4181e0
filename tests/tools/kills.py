# SPDX-License-Identifier: MIT
"""Runs of the command that are ended at random times, and resumed."""
import os
import random
import signal
import subprocess
import time

import command

#: What an answer tells of the last run alone.
OF_EACH_RUN = {"resumed_at", "integrator_steps", "integrator_rejected"}


def kills(by_default):
    """How often runs of a test are ended: as often as POLYDEC_KILLS says."""
    return int(os.environ.get("POLYDEC_KILLS", by_default))


def timed(case, *line):
    """The answer of a run, and how many seconds it takes."""
    begin = time.monotonic()
    answer = case.ask(*line)
    return answer, time.monotonic() - begin


def ended_runs(case, line, files, count, seconds, signals=(signal.SIGINT, signal.SIGKILL, signal.SIGKILL)):
    """Answers of runs, each of which begins without these files, is ended by signals after times
    between two, and started again until it comes to its end; so many signals in all."""
    chance = random.Random(1)
    sent = 0
    deadline = command.Deadline("repeated kills and restarts", 600)
    while sent < count:
        for name in files:
            if os.path.exists(case.path(name)):
                os.remove(case.path(name))
        answer, patience = None, 1  # grows, so that a slow machine finishes too
        while answer is None:
            deadline.left()
            which = signals[sent % len(signals)]
            with case.start(*line, "--json", stdout=subprocess.PIPE) as run:
                try:
                    out, _ = run.communicate(timeout=patience * chance.uniform(*seconds))
                except subprocess.TimeoutExpired:
                    run.send_signal(which)
                    out = run.finish().out
                    sent += 1
                    patience *= 1.05
            case.assertIn(run.returncode, (0, -which))
            answer = command.parse(out) if run.returncode == 0 else None
        yield answer


def resumed_series(case, line, count, shares=(0.2, 0.9), **options):
    """Answers of runs with a series that are ended after shares of the time that a whole run takes, and
    resumed: each is the answer of the whole run and leaves its files, and nothing else that was
    finished."""
    def contents(name):
        _, files = case.steps_of(name)
        found = {each for each in os.listdir(case.path(name[:-4])) if not each.startswith(".")}
        case.assertEqual(found, {os.path.basename(file) for file in files})
        return [case.read(file) for file in files]

    whole, took = timed(case, *line, "-o", "whole.pvd")
    wanted = contents("whole.pvd")
    part = (*line, "-o", "part.pvd", "--checkpoint", "part.checkpoint", "--resume")
    answers = []
    for answer in ended_runs(case, part, ("part.pvd", "part.checkpoint"), count,
                             [share * took for share in shares], **options):
        of_each = {key: whole[key] for key in OF_EACH_RUN & set(whole)}
        case.assertEqual({**answer, **of_each}, whole)
        case.assertEqual(contents("part.pvd"), wanted)
        answers.append(answer)
    return answers
