"""Fixtures of the end-to-end tests. ctest runs them; by hand: pytest tests/programs/test_packing.py -k budget

BUILD in the environment names another folder than build/. -m long and -m windows select the tests of tools/test --long
and --windows.
"""
import contextlib
import ctypes
import itertools
import os
import random
import re
import shutil
import signal
import subprocess

import pytest

pytest.register_assert_rewrite('displays', 'pictures', 'radiosity_runs', 'recordings', 'running')
from running import PACKED, SAFE, Program, run  # noqa: E402

of_git = subprocess.getoutput('git rev-parse --local-env-vars').split()  # set in a hook
for variable in 'CDPATH', 'DISPLAY', 'WAYLAND_DISPLAY', 'PULSE_SERVER', *of_git:
    os.environ.pop(variable, None)
signal.signal(signal.SIGTERM, signal.default_int_handler)  # else SIGTERM would leave programs running


@pytest.fixture(scope='module', params=['safe', pytest.param('packed', marks=pytest.mark.long)])
def film(request):
    """The film: unpacked, since that is the same program and starts seconds sooner, and in a long run packed."""
    return PACKED if request.param == 'packed' else SAFE


@pytest.fixture(scope='module')
def work(tmp_path_factory):
    """A folder that the tests of a file share."""
    return tmp_path_factory.mktemp('work')


@pytest.fixture(scope='module')
def in_work(work):
    """The folder that the tests of a file share, as the current one."""
    with contextlib.chdir(work):
        yield work


@pytest.fixture
def background(tmp_path):
    """background(COMMAND...) starts a program that ends with the test (running.Program)."""
    numbers = itertools.count()
    with contextlib.ExitStack() as programs:
        def start(*command, **options):
            folder = tmp_path / f'background{next(numbers)}'
            folder.mkdir()
            return programs.enter_context(Program(folder, *command, **options))
        yield start


@pytest.fixture
def display():
    """display(SIZE, OPTION...) starts a display in memory that ends with the test (displays.Display)."""
    from displays import Display
    with contextlib.ExitStack() as displays:
        yield lambda *arguments: displays.enter_context(Display(*arguments))


@pytest.fixture(scope='module')
def screen(request):
    """A display of the size SCREEN that the tests of a file share. (On a new one Wine would start its desktop again)"""
    from displays import Display
    with Display(request.module.SCREEN) as display:
        yield display


@pytest.fixture(scope='module')
def wine(work):
    """The program that runs programs for Windows: run(wine, PROGRAM, OPTION...) (wine.started_wine)."""
    from wine import started_wine
    with started_wine(work) as program:
        yield program


@pytest.fixture(scope='session')
def mdwe():
    """For run(..., preexec_fn=mdwe): the program may not execute memory that was written (PR_SET_MDWE, Linux 6.3)."""
    prctl = ctypes.CDLL(None).prctl

    def forbid():
        if prctl(65, 1, 0, 0, 0):
            raise OSError

    try:
        run('true', preexec_fn=forbid)
    except subprocess.SubprocessError:
        pytest.skip('this kernel cannot forbid the execution of written memory')
    return forbid


@pytest.fixture
def chance(request):
    """Random numbers: in an ordinary run always the same, in a long run new ones. pytest prints the seed if the test
    fails; ODRAZ_SEED in the environment repeats it."""
    new = random.randrange(10**6) if request.node.get_closest_marker('long') else 1
    seed = int(os.environ.get('ODRAZ_SEED', new))
    print(f'ODRAZ_SEED={seed}')
    return random.Random(seed)


@pytest.fixture(scope='session', autouse=True)
def leave_nothing(tmp_path_factory):
    """Removes the work folders. A folder that cannot be removed fails no test."""
    yield
    shutil.rmtree(tmp_path_factory.getbasetemp(), ignore_errors=True)


def pytest_sessionfinish(session, exitstatus):
    """Tells ctest by status 77 that tests were skipped for something that is missing, or that all were skipped."""
    stats = session.config.pluginmanager.get_plugin('terminalreporter').stats
    reasons = ' '.join(str(report.longrepr) for report in stats.get('skipped', []))
    missing = re.search('is not (installed|built)', reasons) or reasons and 'passed' not in stats
    if missing and exitstatus in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
        session.exitstatus = 77
