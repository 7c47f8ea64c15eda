"""A double-click starts the film in an unpacked archive of tools/release: in Thunar and PCManFM with their default
settings, and in Nemo and Caja where these are installed. ARCHIVE in the environment names an archive, a .tar.gz file.

Tried by hand on 2026-11-23, as a user with a system bus: Nautilus 43.2 starts it; without the x bit it reports that
it could not display the file. Dolphin 22.12.3 asks, with and without the x bit, and starts it on "Execute".
"""
import contextlib
import os
import shutil
import signal
import time
from pathlib import Path

import pytest

from pictures import numpy
from running import BUILD, FILM, PATIENCE, SOURCE, needs, run, wait_for

pytestmark = pytest.mark.long
needs('openbox', 'thunar', 'pcmanfm', 'dbus-run-session')
MANAGERS = ['thunar', 'pcmanfm', *filter(shutil.which, ('nemo', 'caja'))]
QUIET = 20  # seconds after which a film that has not started will not start


@pytest.fixture(scope='module')
def released(work):
    """The film from the archive."""
    archive = os.environ.get('ARCHIVE')
    if not archive:
        needs('zip', 'unzip')
        if run('git', 'rev-parse', 'HEAD', cwd=SOURCE, status=None).returncode != 0:
            pytest.skip('a release needs a git repository')
        run(SOURCE / 'tools/release', '--built', '--unclean', '--no-capture', '--pictures',
            SOURCE / 'tests/support/pictures', '--to', work / 'release', env={'BUILD': BUILD})
        archive, = (work / 'release').glob('*.tar.gz')
    (work / 'unpacked').mkdir()
    run('tar', '-C', work / 'unpacked', '-xf', archive)
    film, = (path for path in work.glob(f'unpacked/**/{FILM}') if path.is_file())
    return film


class Manager:
    """A file manager with default settings, and the film in its folder."""

    asks = False  # whether it has asked what to do with the film

    def __init__(self, screen, name, film, home):
        self.screen, self.film, self.before = screen, film, windows(screen)
        folders = {f'XDG_{kind}_HOME': home / kind.lower() for kind in ('CONFIG', 'DATA', 'CACHE')}
        # Alt-E answers the question, which must be in English
        env = {'HOME': home, 'XDG_RUNTIME_DIR': home, 'GTK_A11Y': 'none', 'NO_AT_BRIDGE': 1, 'LC_ALL': 'C', **folders}
        self.program = screen.start('dbus-run-session', '--', name, film.parent, env=env, start_new_session=True)

    def end(self):
        if self.process():
            os.kill(self.process(), signal.SIGTERM)
        with contextlib.suppress(ProcessLookupError):
            # The process group contains the manager, its bus, and all that they started. They remove their mounts
            os.killpg(self.program.pid, signal.SIGTERM)
            for _ in range(200):
                time.sleep(0.1)
                self.program.runs()  # lets go of it, if it has ended
                os.killpg(self.program.pid, 0)
            os.killpg(self.program.pid, signal.SIGKILL)

    def process(self):
        """The number of the process that runs the film, or None."""
        for exe in Path('/proc').glob('[0-9]*/exe'):
            with contextlib.suppress(OSError):
                if exe.readlink() == self.film:
                    return int(exe.parent.name)
        return None

    def opened(self):
        """Whether there is a new window."""
        return windows(self.screen) - self.before

    def icon(self):
        """The position of the film's icon: the middle of the tallest region that changes when it is selected."""
        pictures = []
        for key in 'Escape', 'ctrl+a':
            self.screen.do('key', key, 'sleep', 1)
            pictures.append(self.screen.picture().astype(int))
        changed = abs(pictures[1] - pictures[0]).mean(axis=2) > 0.03 * 255
        top, bottom = longest_run(changed.any(axis=1))
        left, right = longest_run(changed[top:bottom + 1].any(axis=0))
        return ((left + right) // 2, (top + bottom) // 2) if right - left > 30 and bottom - top >= 18 else None

    def starts_the_film(self, seconds):
        """Double-clicks the icon, and waits so long for the film's window. Answers a question, and repeats a click
        without effect."""
        def click():
            self.screen.do('mousemove', *spot, 'sleep', 0.3, 'click', '--repeat', 2, '--delay', 120, 1)
            return time.monotonic()
        self.program.comes(self.opened)
        spot = wait_for(self.icon)
        self.screen.do('key', 'Escape')
        self.before = windows(self.screen)
        began = last = click()
        while time.monotonic() < began + (PATIENCE if self.process() else seconds):
            if self.screen.find(f'^{FILM}$'):
                return True
            if self.opened() and not self.process():
                time.sleep(1)  # the question may not have the keyboard yet
                if not self.screen.find(f'^{FILM}$'):
                    self.asks, last = True, time.monotonic()
                    self.screen.do('key', 'alt+e')
            elif not self.process() and time.monotonic() > last + QUIET:
                last = click()
            time.sleep(0.1)
        return False


def windows(screen):
    return set(screen.run('xdotool', 'search', '--onlyvisible', '--name', '.', status=None).stdout.split())


def longest_run(flags):
    """The first and the last place of the longest run of true values. Gaps of up to eight others do not end one."""
    places = numpy.flatnonzero(flags)
    runs = numpy.split(places, numpy.flatnonzero(numpy.diff(places) > 9) + 1)
    return max(((run[0], run[-1]) for run in runs if len(run)), key=lambda ends: ends[1] - ends[0], default=(0, 0))


@pytest.fixture
def manager(request, display, released, tmp_path):
    """The file manager of this name."""
    (tmp_path / 'film').mkdir()
    (tmp_path / 'home').mkdir(mode=0o700)
    screen = display('1024x768')
    screen.manage()
    manager = Manager(screen, request.param, Path(shutil.copy(released, tmp_path / 'film')), tmp_path / 'home')
    yield manager
    manager.end()


@pytest.mark.parametrize('manager, asks', [(name, name == 'pcmanfm') for name in MANAGERS], indirect=['manager'])
def test_a_double_click_starts_the_film(manager, asks):
    assert manager.starts_the_film(PATIENCE)
    assert manager.asks == asks
    assert manager.process(), 'another film was started'
    time.sleep(1)

    def escaped():
        manager.screen.do('key', 'Escape')
        return not manager.process()
    wait_for(escaped)


@pytest.mark.parametrize('manager', MANAGERS, indirect=True)
def test_a_double_click_does_not_start_a_film_without_the_x_bit(manager):
    manager.film.chmod(0o644)
    assert not manager.starts_the_film(QUIET)
