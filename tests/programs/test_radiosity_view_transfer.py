"""`radiosity view` of a room: its pictures against the pictures of `render`; the sky, which the mouse turns; lamps,
bands and clusters, which keys change."""
import re
import shlex

import pytest

from pictures import numpy, psnr, write_hdr
from radiosity_runs import OPEN_ROOM, RADIOSITY, radiosity
from radiosity_windows import camera_of, is_like, press, screen
from running import number, refuses

pytestmark = pytest.mark.usefixtures('hall')
SKY = 'it\'s a $sky" '  # a shell interprets some of its characters
AT = '--size 240x150 --eye 0,1.5,7 --at 0,1.5,0'
PICTURES = {'plain': (), 'one': ('--lamps 2',), 'bands': ('--bands 1',), 'turned': ('--turn 50',),
            'clusters': ('--rank 8',), 'axes': ('--rank 7',)}


@pytest.fixture(scope='module')
def hall(screen):
    """Solves hall.prt under an orange and blue sky, and draws PICTURES of it."""
    row = 32 * [(1.56, 0.7, 0.31)] + 32 * [(0.12, 0.23, 0.47)]
    write_hdr(SKY, numpy.array(32 * [row]))
    options = '--rays 32 --element 0.04 --glossy red --rank 8 --clusters 40'
    assert 'lamps 1 lamp, 2 spot\n' in radiosity('transfer', OPEN_ROOM, '-o', 'hall.prt', options).stdout
    for name, options in PICTURES.items():
        screen.draw(f'{name}.png', 'hall.prt', '--sky', SKY, AT, *options)


@pytest.mark.parametrize('options', [
    '', '--turn 70 --tilt 40 --bands 2 --lamps 2=3', '--clusters 20 --rank 3 --lamps none',
])
def test_a_picture_is_the_one_that_render_draws(screen, options):
    screen.draw('view.png', 'hall.prt', '--sky', SKY, AT, *options.split())
    radiosity('render', 'hall.prt', '-o', 'render.png', AT, '--sky', SKY, *options.split())
    assert psnr('view.png', 'render.png') > 44


@pytest.mark.parametrize('other', ['one', 'bands', 'turned'])
def test_other_lights_are_other_pictures(other):
    assert psnr(f'{other}.png', 'plain.png') <= 46


@pytest.fixture
def window(screen):
    """A window, which shows plain.png, until ESC ends it."""
    window = screen.view('hall.prt', '--sky', SKY, AT)
    window.comes(lambda: is_like(window, 'plain.png'))
    yield window
    window.escape()


def test_keys_change_lamps_and_bands_and_outline_elements(window):
    assert re.search('1 .. 9 0  *lamps', window.output())
    assert 'turn 0  tilt 0  5 bands  exact rows  lamps 1 2' in window.title()
    press(window, '1', lambda: is_like(window, 'one.png') and 'lamps 2 ' in window.title())
    press(window, '1', lambda: is_like(window, 'plain.png'))
    press(window, 4 * 'bracketleft ', lambda: ' 1 band ' in window.title())
    window.comes(lambda: is_like(window, 'bands.png'))
    press(window, 4 * 'bracketright ', lambda: is_like(window, 'plain.png'))
    press(window, 'F3', lambda: '  elements' in window.title())
    press(window, 'F3', lambda: is_like(window, 'plain.png'))


def test_keys_change_clusters_and_their_axes(window):
    for key, title, picture in [('p', '40 clusters of 8 axes', 'clusters.png'), ('minus', 'of 7 axes', 'axes.png'),
                                ('equal', 'of 8 axes', None), ('period', '80 clusters of 8 axes  lamps', None),
                                ('comma', '40 clusters of 8 axes', None), ('p', 'exact rows', 'plain.png')]:
        press(window, key, lambda: title in window.title())
        if picture:
            window.comes(lambda: is_like(window, picture))


# A shell can read the line that key C prints, with clusters, a tilt, and the sky's name
def test_the_right_button_turns_the_sky_and_a_key_prints_the_light(window, screen):
    there = ('mousemove', '--window', window.number)
    screen.do(*there, 50, 100, 'mousedown', 3, *there, 80, 100, *there, 200, 100, 'mouseup', 3)
    # A third of a degree for a pixel
    window.comes(lambda: 'turn 50 ' in window.title() and is_like(window, 'turned.png'))
    screen.do(*there, 100, 100, 'mousedown', 3, *there, 100, 85, 'mouseup', 3)
    window.comes(lambda: 'tilt 5  ' in window.title())
    press(window, 'p minus', lambda: '40 clusters of 7 axes  lamps' in window.title())
    line = camera_of(window)
    assert line.endswith(' --turn 50 --tilt 5 --bands 5 --clusters 40 --rank 7 --lamps 1,2')
    radiosity('render', 'hall.prt', '-o', 'render.png', *shlex.split(line))
    window.comes(lambda: is_like(window, 'render.png', 44))
    screen.draw('view.png', 'hall.prt', *shlex.split(line))
    assert is_like(window, 'view.png')


@pytest.fixture(scope='module')
def many(hall):
    """A room of more lamps than number keys, some of strengths other than 1."""
    balls = [f'--lamp -1.{9 - k % 10},0.{k % 9 + 1},-1.{k % 9},0.2,{k % 3},2,{k % 2}' for k in range(1, 12)]
    printed = radiosity('transfer', OPEN_ROOM, '-o', 'many.prt', '--rays 16 --element 0.04 --bands 2', *balls).stdout
    assert '13 ball 11\n' in printed
    return 'many.prt'


def test_shift_and_numbers_change_lamps_from_the_eleventh_on(many, screen):
    screen.draw('three.png', many, AT, '--lamps 1,2=3,12=9')
    screen.draw('without.png', many, AT, '--lamps 1,2=3')
    assert psnr('without.png', 'three.png') <= 46
    window = screen.view(many, AT, '--lamps 1,2=3,12=9')
    window.comes(lambda: is_like(window, 'three.png') and 'lamps 1 2 12 ' in window.title())
    press(window, 'shift+2', lambda: is_like(window, 'without.png'))
    press(window, 'shift+2', lambda: is_like(window, 'three.png'))  # with its strength
    press(window, 'shift+3', lambda: 'lamps 1 2 12 13 ' in window.title())  # it was off
    assert camera_of(window).endswith(' --lamps 1,2=3,12=9,13')
    press(window, 'shift+4 shift+9', lambda: 'lamps 1 2 12 13 ' in window.title())  # no lamp has this number
    window.escape()


def test_spin_turns_the_sky_of_a_room_alone(screen):
    printed = radiosity('view', 'hall.prt', '--sky', SKY, AT, '--spin 1', env=screen.env).stdout
    assert number(r'^([\d.]+) pictures a second of 240 x 150', printed) > 0
    refuses(2, '--spin is for a room', RADIOSITY, 'view', OPEN_ROOM, '--spin', 1, env=screen.env)
