"""radiosity solve --resume continues a stopped solution, and writes the same bytes as without the stop. The long tests
stop it in more steps and by more signals."""
import functools
import re
import signal
from pathlib import Path

import pytest

from radiosity_runs import RADIOSITY, elements_of, generate, radiosity
from running import Program, check_bytes, refuses, wait_for

RAYS = '--element 1 --residual 1e-7'
GATHER = '--element 4 --final 128'
STATE = Path('part.rad.state')


@pytest.fixture(scope='module')
def whole(in_work):
    """whole(OPTIONS) is the file of a solution that is not stopped, of columns.obj. Its materials reflect so much that
    solving takes some 170 sweeps."""
    generate('columns', 'columns.obj')
    materials = re.sub('^Kd .*', 'Kd 0.95 0.95 0.95', Path('columns.mtl').read_text(), flags=re.M)
    Path('columns.mtl').write_text(materials)

    @functools.cache
    def solved(options):
        radiosity('solve', 'columns.obj', '-o', 'whole.rad', options)
        assert not Path('whole.rad.state').exists()
        return Path('whole.rad').read_bytes()
    return solved


def stop(how, step, model, options, folder):
    """Solves, and sends the signal when the step has begun and a state was kept. Returns what was printed."""
    command = (RADIOSITY, 'solve', model, *options.split(), '-o', 'part.rad', '--keep-every', 0.01, '--progress')

    def stopped():
        """What was printed; None if the program ended first: then it is tried again."""
        for old in Path().glob('part.rad*'):
            old.unlink()
        with Program(folder, *command) as program:
            has_begun = f'progress: {step}'
            wait_for(lambda: not program.runs() or STATE.exists() and has_begun in program.errors(), pause=0.01)
            program.signal(how)
            program.ended()
            return STATE.exists() and [program.output()]
    return wait_for(stopped)[0]


def resume():
    assert 'sweeps, residual' in radiosity('solve', '--resume', STATE).stdout


@pytest.mark.parametrize('how, step, options', [
    (signal.SIGINT, 'form', RAYS),
    (signal.SIGKILL, 'solving', RAYS),
    (signal.SIGKILL, 'final', GATHER),
    pytest.param(signal.SIGKILL, 'form', RAYS, marks=pytest.mark.long),
    pytest.param(signal.SIGINT, 'solving', RAYS, marks=pytest.mark.long),
    pytest.param(signal.SIGINT, 'final', GATHER, marks=pytest.mark.long),
])
def test_a_stopped_solution_is_resumed_to_the_same_bytes(how, step, options, whole, tmp_path):
    wanted = whole(options)
    printed = stop(how, step, 'columns.obj', options, tmp_path)
    if how == signal.SIGINT:
        assert re.search(f'^to continue: radiosity solve --resume {STATE}', printed, re.M)
    resume()
    check_bytes(Path('part.rad').read_bytes(), wanted)
    assert not STATE.exists()


def test_a_state_belongs_to_a_model_with_its_pictures(whole, tmp_path):
    def paint(red):
        Path('paint.tga').write_bytes(b'\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x18\0@@' + bytes([red]))

    def assert_refused(text, state):
        refuses(2, text, RADIOSITY, 'solve', '--resume', state)
    Path('painted.mtl').write_text(Path('columns.mtl').read_text() + 'map_Kd paint.tga\n')
    Path('painted.obj').write_text(Path('columns.obj').read_text().replace('columns.mtl', 'painted.mtl'))
    paint(128)
    stop(signal.SIGINT, 'form', 'painted.obj', RAYS, tmp_path)
    radiosity('export', 'part.rad', '--csv part.csv')
    assert len(elements_of('part.csv')) > 1000
    Path('cut.state').write_bytes(STATE.read_bytes()[:100000])
    assert_refused('is damaged', 'cut.state')
    paint(192)
    assert_refused('another model', STATE)
    paint(128)
    resume()
