"""The panel of odraz-debug, used in a window by keys and mouse; and the keys that pages name. (panel_test and
panel_parts_test test the parts.)"""
import re

import pytest

from pictures import brightness
from running import BUILD, FILM, SOURCE, needs_built

needs_built(f'{FILM}-debug')
WIDTH, HEIGHT = 640, 360
SCREEN = f'{WIDTH + 20}x{HEIGHT + 40}'
STRIP = (slice(HEIGHT - 25, HEIGHT), slice(WIDTH))  # the time line
REST = (slice(110, 310), slice(190, 590))
LENGTH = int(re.search(r' kEndRow = (\d+);', (SOURCE / 'intro/show/length.h').read_text())[1]) / 8  # seconds


@pytest.fixture(scope='module')
def window(screen):
    """odraz-debug, paused at 25 s. The tests but the last leave it paused, without the time line."""
    window = screen.begin(BUILD / f'{FILM}-debug', '--from', 25, '--size', f'{WIDTH}x{HEIGHT}', '--mute',
                          title=f'^{FILM}-debug')
    window.focus()
    window.titled('row')
    window.press('space')
    window.titled('paused')
    return window


@pytest.fixture
def line(window):
    """Shows the time line during a test."""
    window.press('Tab')
    yield
    window.press('Tab')


def change(before, after, area):
    """The share of an area's pixels whose brightness changed by more than 2 %."""
    return (brightness(abs(after[area].astype(int) - before[area])) > 0.02 * 255).mean()


def comes_to(window, seconds, tolerance=0.3):
    """Waits until the title shows this time of the film."""
    def is_near():
        minutes, rest = re.search(r'  (\d+):([\d.]+)  row ', window.title()).groups()
        return abs(60 * int(minutes) + float(rest) - seconds) < tolerance
    window.comes(is_near)


def seconds_at(column):
    return column / WIDTH * LENGTH


def point(window, column, *actions):
    """Moves the pointer to a column of the time line, and acts there."""
    window.display.do('mousemove', '--window', window.number, column, HEIGHT - 10, *actions)


def test_tab_shows_and_hides_the_time_line(window):
    hidden = window.drawn()
    window.press('Tab')
    shown = window.drawn()
    assert change(hidden, shown, STRIP) > 0.5
    assert change(hidden, shown, REST) < 0.001
    window.press('Tab')
    assert change(shown, window.drawn(), STRIP) > 0.5


def test_the_mouse_seeks_and_it_stays_paused(window, line):
    point(window, 320, 'mousedown', 1)
    comes_to(window, seconds_at(320))
    window.display.do('mousemove_relative', 40, 0)
    comes_to(window, seconds_at(360))
    before = window.drawn()
    window.display.do('mousemove_relative', '--', 0, -200)  # off the strip
    assert change(before, window.drawn(), REST) < 0.001  # the camera is not turned
    comes_to(window, seconds_at(360))
    window.display.do('mouseup', 1)
    point(window, 120, 'click', 1)
    comes_to(window, seconds_at(120), 0.001)
    window.press('Next')  # (the unit tests of the panel test all steps)
    comes_to(window, 32, 0.001)
    assert 'paused' in window.title()


def test_p_shows_the_samples_and_the_right_button_marks_a_loop_which_l_ends(window, line):
    plain = window.drawn()
    window.press('p')
    assert change(plain, window.drawn(), REST) > 0.8
    window.press('p')
    point(window, 120, 'mousedown', 3, 'mousemove_relative', 3, 0, 'mouseup', 3)  # (panel_test plays a loop)
    looped = window.drawn()
    window.press('l')
    assert change(looped, window.drawn(), (STRIP[0], slice(119, 124))) > 0.02


def test_begins_again_after_its_end_and_escape_ends_it(window):
    window.press('Tab')
    point(window, 639, 'click', 1)
    window.press('space')
    comes_to(window, 1.5, 1.5)
    window.press('space')
    window.titled('paused')
    window.escape()


def unknown_keys(text):
    """The single letters in code, which are keys of odraz-debug, that its table does not list."""
    table = re.findall(r'^    {Action.*?"(.*?)"', (SOURCE / 'intro/maker/panel/keys.h').read_text(), re.M)
    named = set(re.findall(r'`([A-Z])`', text))
    assert named
    return named - set(re.findall(r'\b[A-Z]\b', ' '.join(table)))


def test_every_key_that_a_page_names_is_one():
    pages = (SOURCE / folder / 'show/README.md' for folder in ('intro', 'tools/film_template'))
    assert not unknown_keys(''.join(page.read_text() for page in pages if page.exists()))
    assert unknown_keys('`G` shows the path from outside, `K` sets a key') == {'G'}
