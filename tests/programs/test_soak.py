"""The film in a window for some minutes: whole, then from a random moment, and so on in turns; the last run is cut
short. Every scene is shown. Each run ends by itself and prints nothing on stderr. After its first third it takes no
more memory, descriptors or threads, and never more than the whole film. It plays to a PulseAudio server, if there is
one. MINUTES in the environment is for how long."""
import contextlib
import os
import random
import re
import shutil
import time
from pathlib import Path

import pytest

from pictures import numpy
from recordings import Server, can_serve
from running import BUILD, FILM, PATIENCE, number

pytestmark = pytest.mark.long
MINUTES = float(os.environ.get('MINUTES', 3))
LENGTH, LEAST = 164, 6  # seconds of the film, and of the shortest run
ROOM = numpy.array([8, 4, 4])  # by how much MB, descriptors and threads may differ between runs


def taken(pid):
    """A process's memory (MB), descriptors and threads; None if it is ending, and has no memory."""
    with contextlib.suppress(OSError):
        status = Path(f'/proc/{pid}/status').read_text()
        found = re.search(r'^VmRSS:\s+(\d+).*^Threads:\s+(\d+)', status, re.M | re.S)
        descriptors = len(os.listdir(f'/proc/{pid}/fd'))
        if found and descriptors:
            return [int(found[1]) / 1024, descriptors, int(found[2])]
    return None


def watch(program, seconds):
    """Looks at the process each second until it ends; kills it when it hangs. Returns what it took after its start,
    which lasts a second and 1.5 times the time of the first picture."""
    began, looks = time.monotonic(), []
    while program.runs():
        at = time.monotonic() - began
        if at >= seconds + PATIENCE:
            program.process.kill()
        looks.append((at, taken(program.pid)))
        time.sleep(1)
    assert program.ended() == 0
    assert program.errors() == ''
    first = re.search(r'^first picture after (.*) s$', program.output(), re.M)
    return numpy.array([look for at, look in looks if first and look and at >= 1.5 * float(first[1]) + 1])


def test_plays_for_minutes_without_taking_more(display, tmp_path):
    film = shutil.copy(BUILD / FILM, tmp_path)  # the original may be rebuilt meanwhile
    screen = display('1280x720')
    options = ['--window', '--size', '1280x720', '--stats']
    if can_serve():
        Server(screen)
    else:
        options.append('--mute')
    dice, whole, begin = random.Random(1), None, 0
    end = time.monotonic() + 60 * MINUTES
    while (left := int(end - time.monotonic())) >= LEAST:
        to = min(begin + left, LENGTH)
        program = screen.start(film, *options, '--from', begin, '--to', to)
        looks = watch(program, to - begin)
        if len(looks) >= 3:  # else the machine is too busy to judge growth
            third = (len(looks) + 2) // 3
            most = looks.max(axis=0)
            print(f'{begin} to {to} s, {len(looks)} looks: {most} MB, descriptors, threads at most')
            assert most[0] < 512
            assert most[0] - looks[:third, 0].max() <= ROOM[0]  # for scenes that it has not shown before
            assert (looks[-third:, 1:].min(axis=0) <= looks[:third, 1:].max(axis=0)).all()
            if whole is not None:
                assert (most <= whole + ROOM).all()
            elif (begin, to) == (0, LENGTH):
                whole = most
                for scene in 'point', 'table', 'flake', 'patches', 'hall', 'odraz', 'credits':
                    assert number(rf'^{scene} +\S+ +\S+ +(\S+)', program.output()) > 0
        begin = 0 if begin else dice.randrange(1, LENGTH - LEAST)
