"""Models far from the origin, decals, odd shapes, and a pipe as a file of materials. (obj_reader_test tests the forms
of text, and what the reader repairs, notes and refuses.)"""
import math
import os
import re
from pathlib import Path

import pytest

from pictures import read_picture
from radiosity_runs import mean_light, radiosity, room, solve, square
from running import SOURCE, needs

needs('convert')
pytestmark = pytest.mark.usefixtures('in_work')
MATERIALS = f'mtllib {SOURCE}/tests/support/models/rooms.mtl\n'


def differing_pixels(a, b, percent):
    """The number of pixels that differ by more than this share in a channel."""
    difference = read_picture(a).astype(int) - read_picture(b)
    return (abs(difference).max(axis=2) > 2.55 * percent).sum()


# --- A room with two lamps, and the same in survey and in earth-centred coordinates ---
def lit_room(walls, x=0, y=0, z=0):
    lamp = square('lamp', 0.3, x, y + 1.998, z, 'down')
    return room('floor', walls, walls, (x - 1, y, z - 1), (x + 1, y + 2, z + 1)) + lamp


@pytest.fixture(scope='module')
def moved(in_work):
    """moved[NAME] is a solution."""
    def solved(name, x, y, z):
        lamp = f'--lamp {x + 0.5:.3f},{y + 1:.3f},{z:.3f},0.2,3,3,3'
        return solve(f'{name}.obj', '--rays 64 --element 0.01', lamp, text=MATERIALS + lit_room('wall', x, y, z))
    return {'near': solved('near', 0, 0, 0), 'survey': solved('survey', 460123.5, 210, 5411234.25),
            'earth': solved('earth', 3980581.25, -12345.5, 4966824.75)}


@pytest.mark.parametrize('name', ['survey', 'earth'])
def test_every_element_has_the_same_light_far_away(name, moved):
    near, far = moved['near'].elements, moved[name].elements
    assert len(near) == len(far) > 1000
    for axis in 'xyz':
        offset = far[axis] - near[axis]
        assert abs(offset - offset[0]).max() <= 2e-6
    assert abs(far.ny - near.ny).max() <= 1e-6
    assert abs(far.area / near.area - 1).max() <= 1e-5
    assert abs(far.r - near.r).sum() < 0.001 * near.r.sum()


def test_a_camera_in_survey_coordinates_sees_the_same_and_is_placed(moved):
    moved['near'].render('near.png', '--eye 0,1,.9 --at 0,1,-1 --size 80x60')
    moved['survey'].render('survey.png', '--eye 460123.5,211,5411235.15 --at 460123.5,211,5411233.25 --size 80x60')
    assert differing_pixels('near.png', 'survey.png', 2) < 20
    camera = moved['survey'].render('placed.png', '--size 80x60')
    assert re.search(r'^--eye 4601\d\d\.\d+,2\d+\.\d+,54112\d\d\.\d+ --at 460123\.\d+,', camera, re.M)


def test_exports_have_all_digits_of_survey_coordinates(moved):
    moved['survey'].export('--ply survey.ply')
    moved['survey'].export('--atlas survey')
    assert len(re.findall(r'^460122\.5 21[\d.]+ 54112\d\d\.\d{2,} ', Path('survey.ply').read_text(), re.M)) > 3
    assert re.search(r'^v 460122\.5\d* 21[\d.]* 54112\d\d\.', Path('survey/model.obj').read_text(), re.M)
    assert '"translation":[460123' in Path('survey/model.gltf').read_text()  # a node's


# --- If a decal and a wall are in one plane, the first in the file is in front, in both methods' light and in pictures
def with_decal(name, z):
    """The floor's light by rays and by hemicubes. A picture is in NAME.png."""
    decal = f'v -.9 .1 {z}\nv .9 .1 {z}\nv .9 1.9 {z}\nv -.9 1.9 {z}\nusemtl decal\nf -4 -3 -2 -1\n'
    model = decal + lit_room('dark') if name == 'first' else lit_room('dark') + decal
    lights = []
    for method in '--rays 256', '--hemicube 32 --patch 0.02':
        solution = solve(f'{name}.obj', '--element 0.01', method, text=MATERIALS + model)
        lights.append(mean_light(solution.elements[solution.elements.ny > 0.9])[0])
    solution.render(f'{name}.png', '--eye 0,1,.9 --at 0,1,-1 --size 160x120')
    return lights


@pytest.mark.parametrize('name, same, z', [('last', 'far_behind', -9), ('first', 'in_front', -0.999)])
def test_of_polygons_in_one_plane_the_first_is_in_front(name, same, z):
    assert with_decal(name, -1) == pytest.approx(with_decal(same, z), rel=0.01)
    assert differing_pixels(f'{name}.png', f'{same}.png', 4) < 200


# --- Odd shapes and sizes: they are solved, lit, and visible, with at most one note ---
CORNERS = 'v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\n'
SQUARE = CORNERS + 'f 1 2 3 4\n'


@pytest.mark.parametrize('model, element, note', [
    (SQUARE, 0.01, ''),
    (CORNERS.replace('1', '5e8') + 'f 1 2 3 4\n', 1e16, ''),
    (CORNERS + 'v 0.5 0.000002 0.5\nv 1.2 0.5 0.0001\nf 1 4 5\nf 4 6 1\nf 1 2 3 4\n', 0.01, ''),
    (MATERIALS + room('wall', 'wall', 'wall'), 0.01, 'no light reaches the fronts'),
    (SQUARE + 'v 15 0 0\nv 15 0 1\nv 16 0 0\nf 5 6 7\n', 0.01, ''),
], ids=['a square', 'a large square', 'slivers', 'a box inside out', 'one part far away'])
def test_odd_shapes_are_lit_and_visible(model, element, note):
    solution = solve('odd.obj', '--element', element, '--rays 16', text=model)
    assert solution.elements.area.sum() > 0 and mean_light(solution.elements).sum() > 0
    solution.render('odd.png', '--size 80x60')
    assert read_picture('odd.png').max() > 0.15 * 255
    notes = [line for line in solution.errors.splitlines() if 'nothing in the model emits light' not in line]
    assert len(notes) == bool(note) and note in ''.join(notes)


# --- Rooms, turned by an angle in radians about two axes ---
def turned(model, angle):
    cos, sin = math.cos(angle), math.sin(angle)

    def turn(vertex):
        x, y, z = map(float, vertex.groups())
        y, x = sin * x + cos * y, cos * x - sin * y
        return f'v {x:.6f} {cos * y - sin * z:.6f} {sin * y + cos * z:.6f}'
    return re.sub(r'^v (\S+) (\S+) (\S+)$', turn, model, flags=re.M)


@pytest.mark.parametrize('angle', [0, 1])
@pytest.mark.parametrize('x, far', [(0, 1e4), (0, 5e4), (0, 1e6), (-5e4, 0)])
def test_a_small_room_has_its_bounces_beside_a_triangle_far_away(x, far, angle):
    glowing = turned(room('glow', 'glow', 'glow', (x, 0, 0), (x + 0.4, 0.3, 0.5)), angle)
    triangle = f'v {far} 0 0\nv {far + 1} 0 0\nv {far} 1 0\nf -3 -2 -1\n'
    elements = solve('glowing.obj', text=MATERIALS + glowing + triangle).elements
    light = elements.r[elements.polygon < 6]
    assert len(light) > 5 and light == pytest.approx(2, abs=0.001)


@pytest.mark.parametrize('angle', [0, 1])
@pytest.mark.parametrize('low, high', [((1, 0, 0), (2, 1, 1)), ((0, 1, 0), (1, 2, 1))], ids=['beside', 'above'])
def test_a_room_next_to_a_lit_one_is_dark(low, high, angle):
    rooms = room('wall', 'wall', 'lamp') + room('wall', 'wall', 'wall', low, high)
    elements = solve('rooms.obj', text=MATERIALS + turned(rooms, angle)).elements
    is_second = elements.polygon > 5
    assert is_second.sum() > 5000 and elements.r[~is_second].sum() > 5000
    assert not elements.r[is_second].any()


def test_a_pipe_is_not_read_for_materials():
    os.mkfifo('fifo')
    Path('fifo.obj').write_text('mtllib fifo\n' + SQUARE)
    result = radiosity('solve', 'fifo.obj', '-o', 'fifo.rad', '--element 0.01')
    assert re.search('materials cannot be read.*not a regular file', result.stdout + result.stderr)
