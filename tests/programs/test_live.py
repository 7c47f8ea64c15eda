"""Live editing: builds a copy of the repository, starts its odraz-debug, and changes the sources while it plays."""
import re
import time

import pytest

from displays import Window
from pictures import numpy, read_picture
from recordings import FILE_DEVICE, frames_of, is_loud
from running import FILM, copy_sources, needs, number, run, wait_for

pytestmark = pytest.mark.long
needs('git', 'cmake', 'wmctrl')
MATERIALS, TABLE, HALL = 'show/materials.cpp', 'show/scenes/table.cpp', 'show/hall.cpp'
HALL_MODEL, MUSIC = 'show/hall_model.cpp', 'show/music.h'
TABLE_IN_RED = (TABLE, r'0\.8f, kSilver\)', '0.8f, kRed)')
THIN_SHAFT = (HALL_MODEL, r'kShaft, 0\.46f', 'kShaft, 0.4f')


def build(house, target):
    run('cmake', '--build', house / 'build', '--target', target, timeout=None)


@pytest.fixture(scope='module')
def house(work):
    """A copy of the repository, configured."""
    house = work / 'house'
    copy_sources(house)
    (work / 'alsa.conf').write_text(FILE_DEVICE.format(work / 'played'))
    run('git', 'init', '-q', cwd=house)  # every build looks up its version
    run('git', 'add', '.', cwd=house)  # `git restore` brings the first sources back
    run('cmake', '-S', house, '-B', house / 'build', '-G', 'Ninja')
    return house


@pytest.fixture
def start(house, work, display):
    """start(SECOND, OPTION...) builds odraz-debug of the first sources, and starts it at this time of the film."""
    def begin(*options):
        run('git', 'restore', '.', cwd=house)
        build(house, f'{FILM}-debug')
        screen = display('800x500')
        screen.manage()
        return Maker(house, screen.begin(house / f'build/{FILM}-debug', '--size', '320x180', '--from', *options,
                                         title=f'^{FILM}-debug ', env={'ALSA_CONFIG_PATH': work / 'alsa.conf'}))
    return begin


class Maker(Window):
    """The window of odraz-debug, its user, and the sources that it follows."""

    def __init__(self, house, window):
        super().__init__(window.display, window.program, window.number)
        self.house, self.intro, self.comes, self.marked = house, house / 'intro', self.program.comes, 0
        self.focus()

    def mark(self):
        """Only what is printed from now on is `reported`."""
        self.marked = len(self.program.errors())

    def reported(self, pattern):
        return re.search(pattern, self.program.errors()[self.marked:])

    def reports(self, pattern):
        self.comes(lambda: self.reported(pattern))

    def pause(self):
        self.press('space')
        self.titled('paused')
        self.before = self.drawn()

    def key(self, name, title):
        """Presses a key with a result, which covers the picture for four seconds; keeps the picture after them."""
        self.press(name)
        self.titled(title)
        time.sleep(5)
        self.before = self.drawn()

    def fly(self):
        """Flies a little, and sets a key."""
        first, to = self.picture(), ('--window', self.number)

        def flown():
            self.display.do('keydown', *to, 'd', 'sleep', 0.2, 'keyup', *to, 'd')
            self.drawn()
            return self.differs(first)
        self.comes(flown)
        self.key('k', 'key set on row')

    def edit(self, name, pattern, replacement):
        text, times = re.subn(pattern, replacement, (self.intro / name).read_text(), flags=re.M)
        assert times, f'{name} has no {pattern}'
        (self.intro / name).write_text(text)

    def restore(self, name):
        run('git', 'restore', name, cwd=self.intro)

    def changes(self, *change):
        """Edits a source, waits for another picture, and returns it."""
        self.mark()
        self.edit(*change)
        self.reports('shown')
        self.drawn()
        self.comes(lambda: self.differs(self.before))
        return self.drawn()

    def goes_back(self, name):
        self.mark()
        self.restore(name)
        self.reports('shown')
        self.comes(lambda: self.shows(self.before))

    def leave(self):
        # The window may be gone before the key is released
        self.display.run('xdotool', 'key', '--window', self.number, 'Escape', status=None)
        assert self.program.ended() == 0


def test_a_changed_score_is_heard(start, work):
    def loud():
        played = work / 'played'
        return played.exists() and is_loud(frames_of(played.read_bytes()[-40000:]))
    maker = start(20)
    maker.comes(loud)
    maker.edit('show/score.cpp', r'^void playRow\(.*{$', r'\g<0> return;')
    maker.comes(lambda: not loud())
    maker.restore('show/score.cpp')
    maker.comes(loud)
    maker.leave()


def test_changed_sources_and_compiler_errors_are_shown(start):
    maker = start(17)  # the shot that is changed ends at 24 s
    maker.pause()
    red = maker.changes(*TABLE_IN_RED)
    maker.mark()
    with open(maker.intro / TABLE, 'a') as source:
        source.write('this is no C++\n')
    maker.reports(f'intro/{TABLE}:[0-9:]* error: ')
    wrong = maker.drawn()
    assert numpy.array_equal(red[:60], wrong[:60]), 'the picture does not stay'
    assert not numpy.array_equal(red, wrong), 'the error is not over the picture'
    maker.goes_back(TABLE)
    for edit, error in ((r'    .kCredits. = "d+",\n', ''), 'every scene with parts has chords in kChords'), (
            (r'(    .kPoint. = "D+A",\n)(    .kTable. = .*\n)', r'\2\1'), 'sorry, unimplemented: '):
        maker.mark()
        maker.edit(MUSIC, *edit)
        maker.reports(error)
        maker.goes_back(MUSIC)
    maker.changes(MATERIALS, r'diffuse = 0\.375f', 'diffuse = 0.9f')
    maker.goes_back(MATERIALS)
    maker.changes('show/events.h', '{kBallsSetOff, *kTable, *16,', '{kBallsSetOff, kTable, 4,')
    maker.goes_back('show/events.h')
    first = maker.before
    maker.fly()
    assert maker.differs(first)
    maker.changes(*TABLE_IN_RED)  # from this view
    maker.goes_back(TABLE)
    maker.press('Escape')
    maker.titled('not saved')
    maker.leave()
    assert all(re.search(' shown | error: |sorry, ', line) for line in maker.program.errors().splitlines())


def test_edits_are_saved_into_the_sources(start, tmp_path):
    maker = start(20, '--mute')
    maker.pause()
    maker.key('k', 'key set on row')  # moves the film to a row
    maker.key('ctrl+z', 'undone')
    maker.fly()
    edited, row = maker.before, int(number(r' row (\d+)\.0 ', maker.title()))
    # S without Ctrl flies backwards, and Ctrl may be released first
    to = ('--window', maker.number)
    maker.mark()
    maker.display.do('keydown', *to, 'ctrl', 'keydown', *to, 's', 'keyup', *to, 'ctrl')
    maker.drawn()
    maker.display.do('keyup', *to, 's')
    maker.reports(r'saved film\.keys')
    maker.reports('shown')
    maker.comes(lambda: maker.shows(edited))
    lines = run('git', 'diff', '--numstat', cwd=maker.intro).stdout
    assert lines == '1\t0\tintro/show/film.keys\n'  # one key is new
    build(maker.house, f'{FILM}-safe')
    run(maker.house / f'build/{FILM}-safe', '--dump', tmp_path, '--fps', 8, '--from', row / 8, '--to', row / 8 + 0.1,
        '--size', '320x180', '--quality', 'play')
    assert numpy.array_equal(read_picture(tmp_path / f'frame-{row:06}.ppm'), edited)
    # (keys_test tests files that other programs change meanwhile)
    maker.fly()
    maker.display.run('wmctrl', '-i', '-c', maker.number)
    maker.titled('not saved')
    maker.leave()


def test_a_changed_hall_is_solved_again(start):
    solves = 'solving the hall again'
    maker = start(95, '--mute')
    maker.pause()
    maker.mark()
    maker.edit(*THIN_SHAFT)
    maker.reports(solves)
    assert not numpy.array_equal(maker.drawn(), maker.before), 'no bar over the picture'
    maker.reports('shown')
    maker.changes(MATERIALS, r'(kPlaster = {.texture = plaster\(linear\()194, 187, 174', r'\g<1>194, 57, 44')
    assert maker.reported(solves)
    maker.mark()
    maker.restore(MATERIALS)
    maker.reports(solves)
    maker.goes_back(HALL_MODEL)  # while it solves
    assert maker.reported(solves)
    maker.changes(HALL, r'kDust = 0\.0', 'kDust = 0.')  # changes the picture alone
    assert not maker.reported('solving the hall')
    maker.goes_back(HALL)
    maker.mark()
    maker.edit(*THIN_SHAFT)
    maker.reports(solves)
    maker.leave()


def test_quits_while_it_compiles_and_so_do_its_compilers(start):
    maker = start(95, '--mute')
    maker.edit(*THIN_SHAFT)
    maker.titled('building')
    maker.leave()
    compilers = ('pgrep', '-f', f'^[^ ]*(ninja|cc1plus|cmake) .*{maker.house}')
    wait_for(lambda: run(*compilers, status=None).returncode == 1)
