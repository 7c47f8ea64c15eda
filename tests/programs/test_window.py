"""The film in a window: it starts, draws, pauses, seeks, resizes, fills screens of many sizes, and ends."""
import ctypes
import re

import pytest

from pictures import numpy
from running import BUILD, FILM, PACKED, SAFE, lacking, needs, needs_built, wait_for

needs('xprop', 'openbox', 'wmctrl')
SMALL = ('--window', '--mute', '--size', '320x180', '--quality', 'draft')


@pytest.fixture
def screen(display):
    return display('1000x700')


def test_fills_the_screen_without_a_window_manager(screen):
    window = screen.play(PACKED, '--from', 100)
    screen.do('key', 'f')
    screen.do('key', 'space')
    window.comes(window.has_sign)  # F came before
    screen.do('key', 'space')
    window.check_full_screen()
    window.escape()


def test_a_bar_grows_while_it_loads_and_escape_ends_it_with_a_line_for_stats(screen):
    window = screen.load(PACKED, '--stats')
    assert window.bar_grows()
    screen.do('key', 'Escape')
    assert window.ended() == 0
    assert window.errors() == f'{FILM}: no picture was shown: left while loading\n'


def test_pauses_and_draws_at_other_sizes(screen):
    window = screen.play(SAFE, '--window', '--size', '640x360', '--from', 50, '--stats')
    assert window.size() == (640, 360)
    screen.do('key', 'space')
    window.comes(window.stands)
    paused = window.picture()
    screen.do('key', 'space')
    window.comes(lambda: window.differs(paused))

    screen.do('windowsize', window.number, 900, 300)
    window.comes(lambda: window.is_black('180x300+0+0') and window.is_black('180x300+720+0'))
    window.comes(window.is_bright)
    screen.do('windowsize', window.number, 3, 2)
    window.comes(lambda: window.size() == (3, 2))
    window.works(0.3)
    screen.do('windowsize', window.number, 700, 500)
    window.comes(lambda: window.is_black('700x52+0+0'))
    window.comes(window.is_bright)

    screen.do('key', 'alt+F4')
    assert window.ended() == 0
    assert re.search(r'^flake +[1-9]', window.output(), re.M)
    assert window.errors() == ''


def test_a_key_acts_once_and_alone(screen):
    window = screen.play(SAFE, *SMALL, '--from', 24)
    screen.do('key', 'ctrl+space', 'key', 'alt+space', 'key', 'super+space', 'key', 'ctrl+Escape', 'key', 'ctrl+Right')
    before = window.picture()
    window.comes(lambda: window.differs(before))
    screen.do('keydown', 'space', 'keydown', 'space', 'keyup', 'space')  # a held key goes down again and again
    window.comes(window.stands)
    screen.do('keydown', 'm', 'keydown', 'space', 'keyup', 'm', 'keydown', 'space', 'keyup', 'space')
    before = window.picture()
    window.comes(lambda: window.differs(before))
    window.escape()


def test_arrows_seek_and_keep_the_pause_which_has_a_sign(screen):
    window = screen.play(SAFE, *SMALL, '--from', 24)
    assert not window.has_sign()
    screen.do('key', 'space')
    window.comes(lambda: window.has_sign() and window.stands())
    seen = []
    for key in 'Right', 'Right', 'Left', 'Left', 'Left', 'Left', 'Left':
        before = window.picture()
        screen.do('key', key)
        window.comes(lambda: window.differs(before) or len(seen) > 3)
        window.comes(lambda: window.has_sign() and window.stands())
        seen.append(window.picture())
    assert numpy.array_equal(seen[0], seen[2])
    assert numpy.array_equal(seen[5], seen[6])  # not before --from
    screen.do('windowsize', window.number, 400, 300)
    window.comes(lambda: window.size() == (400, 300) and window.has_sign())
    screen.do('key', 'space')
    window.comes(lambda: not window.has_sign())
    window.escape()


def test_plays_again_by_l_and_to_its_end_by_itself(screen):
    window = screen.play(SAFE, *SMALL, '--from', 24, '--to', 25)
    screen.do('key', 'l')
    window.works(2)  # a second of the film takes less
    screen.do('key', 'l')
    assert window.ended() == 0
    played = screen.run(PACKED, '--window', '--size', '320x180', '--from', 161, '--stats')
    assert re.search('^credits', played.stdout, re.M)


def test_holds_off_the_screen_saver_only_while_it_moves(screen):
    window = screen.play(SAFE, *SMALL, '--from', 24)
    screen.is_saved(after=1)
    window.works(2)
    assert not screen.is_saved()
    screen.do('key', 'space')
    window.comes(screen.is_saved)
    screen.do('key', 'space')
    window.comes(lambda: not screen.is_saved())
    window.works(2)
    assert not screen.is_saved()
    window.escape()


@pytest.mark.parametrize('name, options', [('safe', ['--window']), ('debug', ['--mute'])])
def test_without_integers_in_opengl_it_leaves_out_the_halls_scenes_alone(screen, name, options):
    needs_built(f'{FILM}-{name}')
    window = screen.play(BUILD / f'{FILM}-{name}', *options, '--size', '320x180', '--from', 147, title=f'^{FILM}',
                         env={'MESA_EXTENSION_OVERRIDE': '-GL_EXT_texture_integer'})
    window.comes(lambda: 'cannot light the hall' in window.errors())
    screen.do('key', 'Escape')
    assert window.ended() == 0


def report_of(screen, *command, **options):
    """What a film that cannot play prints on stderr. A click into its window must end it with status 1."""
    window = screen.begin(*command, **options)

    def is_clicked_away():
        screen.do('mousemove', 60, 60, 'click', 1)
        return not window.runs()
    wait_for(is_clicked_away)
    assert window.ended() == 1
    return window.errors()


def test_a_missing_library_opens_a_window(screen, tmp_path):
    assert 'libGL.so.1 is missing' in report_of(screen, PACKED, env=lacking('libGL.so.1', tmp_path))


@pytest.mark.parametrize('variable, value, cause', [
    ('LIBGL_DRIVERS_PATH', '/none', ': install libgl1-mesa-dri'),
    ('LIBGL_ALWAYS_INDIRECT', '1', ': LIBGL_ALWAYS_INDIRECT is 1: unset it'),
    ('MESA_GL_VERSION_OVERRIDE', '3.0', ', only 3.0 .*: MESA_GL_VERSION_OVERRIDE is 3.0: unset it'),
    ('MESA_GLSL_VERSION_OVERRIDE', '130', ', only .*: MESA_GLSL_VERSION_OVERRIDE is 130: unset it')])
def test_what_lacks_opengl_opens_a_window_and_mesa_prints_nothing(screen, variable, value, cause):
    line = f'{FILM}: no OpenGL 3.3 on this display{cause}(, or use --dump)?\n'
    assert re.fullmatch(line, report_of(screen, SAFE, env={variable: value}))


def test_a_screen_of_16_bits_opens_a_window_and_a_screen_saver_that_cannot_be_held_off_does_not_matter(display):
    report = report_of(display('640x360x16'), SAFE, '--window', '--mute', '--from', 4)
    assert 'too few colours: set it to 24 bits' in report
    screen = display('640x360', '-extension', 'MIT-SCREEN-SAVER')
    assert screen.run(SAFE, '--window', '--mute', '--from', 4, '--to', 4.5).stderr == ''


def test_ends_when_its_display_goes_away(screen):
    window = screen.play(SAFE, '--window', '--size', '320x180', '--from', 30)
    screen.server.end()
    assert window.ended() == 1
    assert f'{FILM}: the display went away' in window.errors().splitlines()


def test_a_window_manager_gives_it_the_full_screen(screen):
    screen.manage()
    window = screen.play(SAFE, '--from', 30)
    window.comes(lambda: 'FULLSCREEN' in screen.run('xprop', '-id', window.number, '_NET_WM_STATE').stdout)
    window.comes(lambda: window.size() == (1000, 700))
    window.comes(window.is_bright)
    assert f'"{FILM}", "{FILM}"' in screen.run('xprop', '-id', window.number, 'WM_CLASS').stdout
    for size in (500, 350), (1000, 700):
        screen.do('key', 'f')
        window.comes(lambda: window.size() == size)
    window.escape()


@pytest.mark.parametrize('film, begin', [(PACKED, 'load'), (SAFE, 'play')])
def test_the_close_button_ends_it(screen, film, begin):
    screen.manage()
    window = getattr(screen, begin)(film, '--window', '--size', '640x360', '--from', 30)
    window.comes(window.managed)
    screen.run('wmctrl', '-i', '-c', window.number)
    assert window.ended() == 0


# --- Screens: the picture is in the middle, as large as possible, and the rest is black ---

class Monitor(ctypes.Structure):
    """XRRMonitorInfo."""
    _fields_ = [('name', ctypes.c_ulong), ('primary', ctypes.c_int), ('automatic', ctypes.c_int),
                ('count', ctypes.c_int), ('place', ctypes.c_int * 6), ('outputs', ctypes.POINTER(ctypes.c_ulong))]


def divide(screen, *places):
    """Divides a screen into monitors, x, y, width and height, of which the last one is the primary one."""
    randr = ctypes.CDLL('libXrandr.so.2')
    randr.XRRGetScreenResources.restype = ctypes.POINTER(ctypes.POINTER(ctypes.c_ulong))
    with screen.opened() as (x11, display, root):
        outputs = randr.XRRGetScreenResources(display, root)[5]
        for i, place in enumerate(places):  # the first one takes the screen's only output
            name = x11.XInternAtom(display, b'monitor%d' % i, 0)
            monitor = Monitor(name, i == len(places) - 1, 0, i == 0, (ctypes.c_int * 6)(*place, 200, 150), outputs)
            randr.XRRSetMonitor(display, root, ctypes.byref(monitor))


def test_fills_the_primary_one_of_two_monitors(display):
    screen = display('1600x600')
    divide(screen, (0, 0, 900, 600), (900, 0, 700, 600))
    window = screen.begin(SAFE, '--mute')
    window.comes(lambda: window.geometry() == '700x600-0+0')


@pytest.mark.parametrize('screen, x, y, width, height, options', [
    ('1366x768', 0, 0, 1365, 768, ()),
    ('1280x1024', 0, 152, 1280, 720, ()),
    ('1000x300', 233, 0, 533, 300, ()),
    ('3000x1800', 0, 56, 3000, 1687, ()),  # more than it traces
    ('1280x720', 0, 0, 1280, 720, ('--size', '320x180')),  # scaled to the screen
    ('1280x720', 280, 0, 720, 720, ('--size', '200x200')),  # with its own aspect
])
def test_fills_the_screen_as_far_as_its_aspect_allows(display, screen, x, y, width, height, options):
    screen = display(screen)
    # From 24 to 31 s the sky is bright in the upper corners; on a busy machine a later picture may be the first
    window = screen.play(SAFE, '--mute', '--from', 24, *options)
    pictures = []

    def has_bright_corners():
        pictures[:] = [screen.picture()]
        return all(pictures[0][y + 2:y + 4, column:column + 2].mean() > 20 for column in (x + 2, x + width - 4))

    window.comes(has_bright_corners)
    picture = pictures[0]
    left, right, above, below = max(x - 1, 0), x + width + 2, max(y - 1, 0), y + height + 2
    for bar in picture[:, :left], picture[:, right:], picture[:above], picture[below:]:
        assert not bar.any()
