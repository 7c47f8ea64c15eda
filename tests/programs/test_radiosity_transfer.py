"""`radiosity transfer`: a room relit by environments and lamps, against solutions for the same light; a model of many
small polygons, with --check; gloss; and Ctrl-C."""
import re
from pathlib import Path

import pytest

from pictures import numpy, psnr, write_hdr
from radiosity_runs import OPEN_ROOM, RADIOSITY, elements_of, hills, interrupted_at, radiosity, solve, square
from running import Program, needs_built, refuses, run, wait_for

needs_built('compare')
pytestmark = pytest.mark.usefixtures('room')
FINE = '--element 0.02 --rays 64'
SIZE = '--size 160x100'
AT = f'{SIZE} --eye 0,1.5,7 --at 0,1.5,0'


def write_sky(path, degrees):
    """Writes a picture of all directions: an even sky with a bright spot, so far from the middle."""
    down = numpy.pi * (numpy.arange(32)[:, None] + 0.5) / 32
    around = 2 * numpy.pi * ((numpy.arange(64) + 0.5) / 64 - 0.5 - degrees / 360)
    towards_spot = 0.8 * numpy.sin(down) * numpy.cos(around) + 0.6 * numpy.cos(down)
    bright = 0.4 + 3 * numpy.maximum(towards_spot, 0) ** 6
    write_hdr(path, bright[..., None] * (0.8, 0.7, 0.5))


@pytest.fixture(scope='module')
def room(in_work):
    """room.prt, and what transfer prints."""
    write_sky('east.hdr', 90)
    write_sky('ahead.hdr', 0)
    return radiosity('transfer', OPEN_ROOM, '-o', 'room.prt', FINE, '--clusters 40').stdout


def lit(picture, options, room='room.prt'):
    """Renders the room in a light. Returns what was printed."""
    return radiosity('render', room, '-o', picture, AT, options).stdout


def solved(picture, lamps, *options):
    """Renders a solution of the room whose lamps are altered: by a pattern, and what replaces it."""
    Path('solved.mtl').write_text(re.sub(*lamps, OPEN_ROOM.with_suffix('.mtl').read_text()))
    text = OPEN_ROOM.read_text().replace('open_room.mtl', 'solved.mtl')
    solve('solved.obj', FINE, *options, text=text).render(picture, AT)


# --- Against solutions for the same light, with the same number of rays ---
def test_transfer_prints_its_bands_lamps_and_clusters(room):
    assert '\n5 bands, 25 functions; lamps 1 lamp, 2 spot\n' in room
    assert re.search(r'^40 clusters of \d+ axes: [\d.]+ MB instead of', room, re.M)


def test_an_environment_is_like_the_solution_for_it():
    printed = lit('east.png', '--sky east.hdr --lamps none')
    solved('solved.png', (r'\nKe.*', ''), '--sky east.hdr')
    assert psnr('east.png', 'solved.png') > 35
    assert re.search(r'east\.hdr: 5 bands hold 9[\d.]* % of its energy and lose [\d.]* %$', printed, re.M)


def test_one_lamp_of_two_gives_its_light_alone():
    lit('spot.png', '--lamps spot')
    lit('number.png', '--lamps 2=1')
    solved('solved.png', ('Ke 9 8 6', 'Ke 0 0 0'))
    assert psnr('spot.png', 'solved.png') > 45
    run('cmp', 'spot.png', 'number.png')


def test_a_sky_that_is_turned_is_like_the_sky_whose_spot_lies_there():
    lit('turned.png', '--sky ahead.hdr --turn 90 --lamps none')
    lit('east.png', '--sky east.hdr --lamps none')
    lit('ahead.png', '--sky ahead.hdr --lamps none')
    assert psnr('turned.png', 'east.png') > 50
    assert psnr('turned.png', 'ahead.png') <= 40


def test_a_lamp_at_twice_its_strength_gives_twice_its_light():
    def light(lamps):
        radiosity('export', 'room.prt', '--csv light.csv --lamps', lamps)
        elements = elements_of('light.csv')
        return (elements.r * elements.area).sum()
    assert light('lamp=2') / light('lamp') == pytest.approx(2, abs=1e-4)


def test_exports_an_atlas():
    radiosity('export', 'room.prt', '--atlas atlas --sky 1,1,1')
    assert Path('atlas/light-0.hdr').read_bytes()


def test_where_z_is_up_the_picture_is_the_same_without_up():
    def turn(point):
        x, y, z = point.groups()
        return f'v {x} {-float(z)} {y}'
    Path('tall.obj').write_text(re.sub('v (.*) (.*) (.*)', turn, OPEN_ROOM.read_text()))
    Path('open_room.mtl').write_text(OPEN_ROOM.with_suffix('.mtl').read_text())
    radiosity('transfer', 'tall.obj', '-o', 'tall.prt', FINE, '--up z')
    sky = '--sky ahead.hdr --turn 90 --lamps none'
    radiosity('render', 'tall.prt', '-o', 'tall.png', SIZE, '--eye 0,-7,1.5 --at 0,0,1.5', sky)
    lit('turned.png', sky)
    assert psnr('tall.png', 'turned.png') > 50


def test_gloss_shows_on_a_polished_wall():
    printed = radiosity('transfer', OPEN_ROOM, '-o', 'glossy.prt', FINE, '--glossy red --gloss 0.5,60').stdout
    assert re.search(r'^gloss in \d* squares', printed, re.M)
    lit('glossy.png', '--lamps lamp', 'glossy.prt')
    lit('dull.png', '--lamps lamp')
    assert psnr('glossy.png', 'dull.png') <= 40


# --- Any model, and --check ---
def test_the_check_of_hills_in_centimetres_finds_small_errors():
    lamp = square('lamp', 40, y=150, faces='down')
    Path('hills.obj').write_text(f'mtllib hills.mtl\nusemtl grey\n{hills(400, 40)}{lamp}')
    Path('hills.mtl').write_text('newmtl grey\nKd 0.5 0.4 0.3\nnewmtl lamp\nKd 0 0 0\nKe 30 28 25\n')
    options = '--rays 64 --check --sky east.hdr --element 400'
    printed = radiosity('transfer', 'hills.obj', '-o', 'hills.prt', options).stdout
    assert re.search(r'east\.hdr: 5 bands hold [\d.]+ %', printed)
    lights = '^    (even|gradient|glow|two lights|random|all lamps) '
    errors = re.findall(rf'{lights} *([\d.]+) +([\d.]+)', printed, re.M)
    assert len(errors) == 6
    for light, rows, clusters in errors:
        assert float(rows) <= 0.01 and float(clusters) <= 1, light
    radiosity('export', 'hills.prt', '--csv hills.csv --sky 1,1,1')
    elements = elements_of('hills.csv')
    assert len(elements) >= 800
    assert elements.r.min() >= 0 and elements.r.max() <= 50, 'it is not what the sky and the lamp give'


def test_an_interrupt_during_the_check_keeps_the_room(tmp_path):
    def interrupted():
        """The status and the last line on stderr; None if the check had already ended: then it is tried again."""
        options = '-o stopped.prt --element 0.004 --rays 128 --check'.split()
        with Program(tmp_path, RADIOSITY, 'transfer', OPEN_ROOM, *options) as transfer:
            status = interrupted_at('processor seconds', transfer, transfer.output)
            return status and (status, transfer.errors().splitlines()[-1])
    line = 'radiosity: interrupted: the check is incomplete; stopped.prt is saved'
    assert wait_for(interrupted) == (1, line)
    radiosity('render', 'stopped.prt', '-o', 'stopped.png', '--size 80x60')


@pytest.mark.parametrize('text, file, options', [
    ("no lamp 'moon'; the room has 1 lamp, 2 spot", 'room.prt', ('--lamps', 'moon')),
    ('is for a room that', 'dark.rad', ('--turn', 3)),
])
def test_refuses_and_leaves_no_picture(text, file, options):
    solve(OPEN_ROOM, '--bounces 0 --rays 16 --element 1', to='dark.rad')
    refuses(2, text, RADIOSITY, 'render', file, '-o', 'x.png', *options)
    assert not Path('x.png').exists()
