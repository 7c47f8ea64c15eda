"""Materials with pictures (map_Kd): the light of elements against closed forms. (pictured_test compares each element's
part of its picture, picture_file_test reads and refuses files.)"""
import os
import unicodedata
from pathlib import Path

import pytest

from pictures import numpy, read_picture, write_picture
from radiosity_runs import mean_light, solve
from running import needs

needs('convert')
pytestmark = pytest.mark.usefixtures('in_work')
CUBE = """mtllib cube.mtl
v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl all
f 1/1 5/2 6/3 2/4\nf 3/1 4/2 8/3 7/4\nf 1/1 3/2 7/3 5/4\nf 2/1 6/2 8/3 4/4\nf 1/1 2/2 4/3 3/4\nf 5/1 7/2 8/3 6/4
"""
FLOOR = """mtllib sub\\floor.mtl
v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/4 2/1 3/2\nf 1/4 3/2 4/3
"""
BOARD = 'usemtl none\nv -1 0.4 -1\nv 0 0.4 -1\nv 0 0.4 1\nv -1 0.4 1\nf 5 6 7 8\n'


def test_a_furnace_with_a_checkerboard_reflects_its_mean():
    checks = numpy.indices((512, 512)).sum(axis=0) % 2 * 188  # black, and sRGB 188, which is 0.5029: in the mean 0.2514
    write_picture('checks.png', numpy.dstack([checks] * 3))
    Path('cube.mtl').write_text('newmtl all\nKd 0.5 1 0.25\nKe 1 1 1\nmap_Kd checks.png\n')
    solution = solve('cube.obj', '--hemicube 32 --patch 0.01 --element 0.01', text=CUBE)
    assert not solution.errors
    r, g, b = mean_light(solution.elements)  # all surfaces emit 1, so all have 1 / (1 - Kd 0.2514)
    assert 1.135 < r < 1.153 and 1.325 < g < 1.347 and 1.059 < b < 1.076


# --- A floor under an even sky of 1 has its reflectance as radiance ---
@pytest.fixture(scope='module')
def floor(in_work):
    """floor(MATERIAL-LINES) solves a floor. Its picture is red on the left, blue on the right, black above."""
    os.makedirs('sub/my pictures')
    picture = numpy.zeros((16, 32, 3))
    picture[8:, :16, 0] = picture[8:, 16:, 2] = 255
    write_picture('sub/my pictures/Floor.png', picture)

    def solved(lines):
        Path('sub/floor.mtl').write_text(f'newmtl m\nKd 1 1 1\n{lines}\n')
        return solve('floor.obj', '--element 0.0016 --rays 16 --sky 1,1,1', text=FLOOR)
    return solved


def assert_shows(elements, is_red, is_blue):
    """What is red and what is blue, by x and y (-1 .. 1, y up). Skips 0.04 around borders."""
    x, y = elements.x, -elements.z
    away = [abs(axis - border) > 0.04 for axis in (x, y) for border in (-0.5, 0, 0.5)]
    inside = numpy.all(away, axis=0)
    assert inside.sum() > 1000
    for found, wanted in (elements.r, is_red(x, y)), (elements.g, 0), (elements.b, is_blue(x, y)):
        assert abs(found - wanted)[inside].max() <= 0.005


def test_a_picture_that_is_scaled_repeats(floor):
    def is_lower(y):
        return (y < -0.5) | (y > 0) & (y < 0.5)
    assert_shows(floor('map_Kd -s 2 2 my pictures/Floor.png').elements,
                 lambda x, y: is_lower(x) & is_lower(y), lambda x, y: is_lower(-x) & is_lower(y))


def test_a_picture_that_is_clamped_is_continued_by_its_border(floor):
    elements = floor('map_Kd -clamp on -s 2 2 -o 0.5 0 my pictures/Floor.png').elements
    assert_shows(elements, lambda x, y: 0, lambda x, y: y < -0.5)


def test_a_picture_named_with_backslashes_and_capitals_is_found(floor):
    solution = floor('map_Kd my pictures\\\\floor.PNG')
    assert_shows(solution.elements, lambda x, y: (x < 0) & (y < 0), lambda x, y: (x > 0) & (y < 0))
    solution.render('floor.png', '--eye 0,2.5,0.01 --at 0,0,0 --size 200x200 --exposure -1')
    seen = read_picture('floor.png')[[140, 140, 60], [60, 140, 60]] > 0.1 * 255
    assert seen[:, [0, 2]].tolist() == [[True, False], [False, True], [False, False]]
    solution.export('--atlas light')
    assert read_picture('light/reflectance-0.png').max(axis=(0, 1)).tolist() == [255, 0, 255]


def test_final_rays_see_the_picture_beneath_a_board(floor):
    floor('map_Kd my pictures/Floor.png')

    def beneath(*options):
        elements = solve('board.obj', '--sky 1,1,1 --element 0.01', *options, text=FLOOR + BOARD).elements
        return mean_light(elements[elements.ny < -0.5])
    r, g, b = beneath()
    assert r - g > 3 * (b - g) > 0
    assert beneath('--final 256')[[0, 2]] == pytest.approx([r, b], rel=0.04)


# macOS stores names in the form NFD, most programs write NFC
LETTERS = [chr(code) for block in ((0xc0, 0x180), (0x370, 0x500), (0x1ea0, 0x1efa), (0x3040, 0x3100), (0xac00, 0xac40))
           for code in range(*block) if len(unicodedata.normalize('NFD', chr(code))) > 1]


@pytest.mark.parametrize('written, stored', [('NFC', 'NFD'), ('NFD', 'NFC')])
def test_names_are_found_in_either_form_of_unicode(written, stored, tmp_path):
    names = [f'Möbel {"".join(LETTERS[at:at + 20])}' for at in range(0, len(LETTERS), 20)]
    lines = faces = ''
    for number, name in enumerate(names):
        file = tmp_path / unicodedata.normalize(stored, f'Möbel/{name}.PPM')
        file.parent.mkdir(exist_ok=True)
        file.write_text('P3 1 1 255\n255 255 255\n')
        lines += f'newmtl m{number}\nKd 1 1 1\nmap_Kd Möbel\\{name}.ppm\n'
        faces += f'usemtl m{number}\nf 1/1 2/2 3/3 4/4\n'
    (tmp_path / unicodedata.normalize(stored, 'über.mtl')).write_text(unicodedata.normalize(written, lines))
    text = unicodedata.normalize(written, 'mtllib Über.mtl\n') + FLOOR[FLOOR.index('v'):FLOOR.index('usemtl')] + faces
    errors = solve(tmp_path / 'names.obj', '--element 0.01 --rays 16', text=text).errors
    assert len(names) > 20 and 'cannot' not in errors and 'material file' not in errors


@pytest.mark.parametrize('missing', ['none', 'fifo'])
def test_an_unreadable_picture_leaves_the_colour(missing, floor):
    if missing == 'fifo':
        os.mkfifo('sub/fifo.png')
    solution = floor(f'Kd 0.25 0.25 0.25\nmap_Kd {missing}.png')
    assert "the material's colour is used" in solution.errors
    assert solution.elements.r == pytest.approx(0.25, abs=1e-4)
