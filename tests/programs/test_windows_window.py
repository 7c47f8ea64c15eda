"""The film for Windows in a window, by Wine: it starts, draws, fills a screen of another aspect, is resized to tiny and
odd sizes, is moved and minimised, and ends."""
import re

import pytest

from running import BUILD, FILM, refuses, wait_for
from wine import answers_box, without

pytestmark = pytest.mark.windows
PACKED, SAFE = BUILD / f'{FILM}.exe', BUILD / f'{FILM}-safe.exe'
SCREEN, SMALL = '1000x700', ('--window', '--size', '640x360')


def play(screen, *command):
    """Plays the film until a picture is shown, and returns its window."""
    window = screen.begin(*command)
    window.program.comes(window.is_bright)
    return window


def ends(window, keys='Escape'):
    """Presses keys as a user does, which must end the film with status 0."""
    window.display.do('windowfocus', '--sync', window.number, 'key', keys)
    assert window.program.ended() == 0


def resize(window, width, height):
    window.display.do('windowsize', window.number, width, height)


def draws_between(window, *bars):
    """Waits until these bars are black, but not the whole picture."""
    for bar in bars:
        window.program.comes(lambda: window.is_black(bar))
    window.program.comes(window.is_bright)


def test_fills_the_screen_and_escape_ends_it(wine, screen):
    window = play(screen, wine, PACKED, '--from', 30)
    window.check_full_screen()
    ends(window)


def test_a_bar_grows_while_it_loads_and_escape_ends_it(wine, screen):
    window = screen.begin(wine, PACKED)
    assert window.bar_grows(stopped=False)
    ends(window)


def test_draws_between_bars_at_another_size_and_alt_f4_ends_it(wine, screen):
    window = play(screen, wine, PACKED, *SMALL, '--from', 60, '--stats')
    assert window.size() == (640, 360)
    resize(window, 900, 300)
    draws_between(window, '180x300+0+0', '180x300+720+0')
    ends(window, 'alt+F4')
    assert re.search('^patches +[1-9]', window.program.output(), re.M)


def test_keys_act_once_and_alone_and_the_pause_has_a_sign(wine, screen):
    window = play(screen, wine, SAFE, '--mute', *SMALL, '--from', 24, '--quality', 'draft')
    focus = ('windowfocus', '--sync', window.number)
    screen.do(*focus, 'key', 'ctrl+space', 'keydown', 'space', 'keydown', 'space', 'keyup', 'space')
    window.program.comes(window.has_sign)
    before = window.picture()
    screen.do(*focus, 'key', 'Right')
    window.program.comes(lambda: window.differs(before) and window.has_sign())
    screen.do(*focus, 'key', 'f')
    window.program.comes(lambda: window.geometry() == '1000x700+0+0' and window.has_sign())
    ends(window)


def test_has_odd_and_tiny_sizes_and_plays_on(wine, screen):
    window = play(screen, wine, PACKED, '--mute', '--window', '--size', '641x359', '--from', 30)
    assert window.size() == (641, 359)
    resize(window, 3, 2)
    window.program.comes(lambda: window.size() == (3, 2))
    window.program.works(0.3)
    ends(window)


def test_is_resized_often_and_quickly_and_is_moved(wine, screen):
    window = play(screen, wine, PACKED, '--mute', *SMALL, '--from', 30)
    for i in range(1, 61):
        resize(window, 20 + i * 13 % 700, 20 + i * 29 % 500)
    resize(window, 700, 500)
    window.program.comes(lambda: window.size() == (700, 500))
    draws_between(window, '700x52+0+0', '700x52+0+448')
    window.display.do('windowmove', window.number, 50, 30)
    window.program.comes(lambda: window.geometry() == '700x500+50+30')
    window.program.comes(window.is_bright)
    ends(window)


@pytest.mark.parametrize('film, options, env', [(PACKED, ['--mute'], {}), (SAFE, [], without('winmm'))])
def test_plays_to_its_end_also_without_sound(wine, screen, film, options, env):
    options = ('--window', '--size', '320x180', '--from', 161, '--stats', *options)
    assert re.search('^credits', screen.run(wine, film, *options, env=env).stdout, re.M)


def test_a_window_manager_minimises_restores_resizes_and_closes_it(wine, display):
    def hidden():
        return 'Map State: IsUn' in screen.run('xwininfo', '-id', window.number).stdout
    screen = display('1000x700')
    screen.manage()
    window = play(screen, wine, PACKED, '--mute', *SMALL, '--from', 30)
    wait_for(window.managed)
    screen.do('windowminimize', window.number)
    window.program.comes(hidden)
    window.program.works(0.3)
    screen.run('wmctrl', '-i', '-a', window.number)
    window.program.comes(lambda: not hidden())
    window.program.comes(lambda: window.size() == (640, 360))
    resize(window, 640, 500)
    draws_between(window, '640x69+0+0', '640x69+0+431')
    screen.run('wmctrl', '-i', '-c', window.number)
    assert window.program.ended() == 0


@pytest.mark.parametrize('env', [{'MESA_GL_VERSION_OVERRIDE': 2.1}, without('opengl32')])
def test_refuses_an_old_or_missing_opengl(wine, screen, env):
    refuses(1, 'no OpenGL 3.3 on this display: install', wine, SAFE, env={**screen.env, **env})


def test_opens_a_box_where_there_is_no_standard_error(wine, screen):
    assert answers_box(screen, SAFE.name, wine, SAFE, env={'MESA_GL_VERSION_OVERRIDE': 2.1}) == 1


def test_refuses_to_play_without_a_display(wine):
    refuses(1, 'no display: log in to one', wine, SAFE, '--window')
