"""A dump that is killed at any moment leaves whole frames, and the frame that it was writing as FRAME.PID.part, since a
killed process cannot clean up. A later dump ignores such a file."""
import hashlib
import os
import re
import shutil
import signal

import pytest

from running import SAFE, Program, run, wait_for

LARGE = ('--from', 20, '--to', 20.4, '--size', '1280x720', '--quality', 'draft')  # to be killed while they are written
SMALL = ('--from', 20, '--to', 24, '--size', '16x9', '--quality', 'draft')


def frames_in(folder):
    """The digests of the pictures, by their names."""
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in folder.glob('*.ppm')}


@pytest.fixture(scope='module')
def reference(work):
    """The ten large frames, and the seconds of processor time that a dump of them takes."""
    before = sum(os.times()[2:4])
    run(SAFE, '--dump', work / 'reference', *LARGE)
    frames = frames_in(work / 'reference')
    assert len(frames) == 10
    return frames, sum(os.times()[2:4]) - before


@pytest.mark.parametrize('kills', [6, pytest.param(50, marks=pytest.mark.long)])
def test_a_killed_dump_leaves_whole_frames(reference, kills, chance, tmp_path):
    frames, seconds = reference
    dump = tmp_path / 'dump'
    killed = whole = tries = 0
    while killed < kills or not whole:
        tries += 1
        shutil.rmtree(dump, ignore_errors=True)
        with Program(tmp_path, SAFE, '--dump', dump, *LARGE) as program:
            # Kill it at a random moment; every second time, as soon as a random frame has a file
            if tries % 2:
                moment = chance.uniform(0, seconds)
                wait_for(lambda: not program.runs() or program.seconds_worked() >= moment, pause=0.002)
            else:
                frame = f'frame-{500 + chance.randrange(10):06}.ppm*'
                wait_for(lambda: not program.runs() or any(dump.glob(frame)), pause=0.0001)
            program.process.kill()
            killed += program.ended() == -signal.SIGKILL  # a dump that ended before does not count
        if dump.exists():
            written = frames_in(dump)
            assert written.items() <= frames.items(), f'after kill {tries}'
            parts = set(os.listdir(dump)) - set(written)
            assert len(parts) <= 1 and all(re.fullmatch(r'frame-\d{6}\.ppm\.\d+\.part', name) for name in parts)
            whole += len(written)


def test_a_later_dump_completes_it_and_leaves_its_unfinished_frame(reference, tmp_path):
    part = tmp_path / 'frame-000500.ppm.99999.part'
    part.write_text('half a frame\n')
    run(SAFE, '--dump', tmp_path, *LARGE)
    assert frames_in(tmp_path) == reference[0]
    assert part.read_text() == 'half a frame\n'


def test_dumps_at_once_into_one_folder_make_the_same_frames(background, tmp_path):
    run(SAFE, '--dump', tmp_path / 'small', *SMALL)
    wanted = frames_in(tmp_path / 'small')
    for number, dumps in enumerate((2, 2, 4, 4)):  # they often write the same frame at the same time
        folder = tmp_path / f'dump{number}'
        programs = [background(SAFE, '--dump', folder, *SMALL) for _ in range(dumps)]
        assert [(program.ended(), program.errors()) for program in programs] == [(0, '')] * dumps
        assert frames_in(folder) == wanted
        assert sorted(os.listdir(folder)) == sorted(wanted)
