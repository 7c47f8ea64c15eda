"""The light that radiosity finds, against closed forms."""
import re

import pytest
from pytest import approx

from pictures import numpy
from radiosity_runs import generate, mean_light, room, solve, square
from running import SOURCE

pytestmark = pytest.mark.usefixtures('in_work')
PLATE = square('grey', 1)


def lit(model, *options, element=0.004):
    """Solves OBJ text."""
    text = f'mtllib {SOURCE}/tests/support/models/light.mtl\n{model}'
    return solve('out.obj', '--element', element, *options, text=text)


def form_factor(elements, half, height):
    """The form factors of elements to a square above the origin, with half the length of its sides: for each the sum
    over four rectangles with a corner above the element."""
    total = 0
    for x in elements.x, -elements.x:
        for z in elements.z, -elements.z:
            X, Z = (half + x) / height, (half + z) / height
            p, q = numpy.hypot(1, X), numpy.hypot(1, Z)
            total += X / p * numpy.arctan(Z / p) + Z / q * numpy.arctan(X / q)
    return total / (2 * numpy.pi)


@pytest.mark.parametrize('model, material, least, most, options', [
    ('furnace', 'furnace', 1.999, 2.001, ''), ('furnace', 'furnace', 1.110, 1.112, '--reflectance furnace=0.2'),
    *(('squares', 'receives', 0.198, 0.2015, options) for options in ('', '--hemicube 100', '--hemicube 25')),
])
def test_solve_prints_the_mean_light_of_a_material(model, material, least, most, options):
    printed = solve(generate(model, 'known.obj'), *options.split(), '--element 0.004').output
    means = re.search(rf'^{material} .* % +(\S+ \S+ \S+)$', printed, re.M)[1].split()
    assert all(least <= float(mean) <= most for mean in means)


# --- A furnace: all surfaces emit 1 and reflect a half, so their radiance is 2, at any size ---
def test_a_furnace_of_a_millimetre_has_the_same_light_everywhere():
    elements = lit(room('all', 'all', 'all', high=[0.001] * 3), element=4e-9).elements
    assert elements.r == approx(2, rel=0.002)
    assert elements.g.min() >= 1.3307 and elements.g.max() <= 1.336
    assert (elements.b == 1).all()


def test_a_furnace_of_a_kilometre_has_its_mean_by_hemicubes():  # near edges they are less exact
    furnace = room('all', 'all', 'all', high=[1000] * 3)
    r, g, b = mean_light(lit(furnace, '--patch 10000 --hemicube 32', element=4000).elements)
    assert 1.985 < r < 2.015 and 1.32 < g < 1.347 and 0.999 < b < 1.001


# --- Light from outside, and lamps ---
def test_a_sky_lights_a_box_by_its_form_factor():
    solution = lit(room('grey', 'black', '', (-0.5, 0, -0.5), (0.5, 1, 0.5)), '--sky 1,2,3')
    assert 'material black stays black: it reflects nothing' in solution.errors
    floor = solution.elements[solution.elements.ny == 1]
    seen = floor.r / 0.5
    assert 0.197 < seen.mean() < 0.203  # the form factor of two equal squares at the distance of their side is 0.19982
    assert floor.g.mean() / 0.5 == approx(seen.mean(), rel=0.001)
    assert floor.b.mean() / 2.4 == approx(seen.mean(), rel=0.001)
    assert ((seen / form_factor(floor, 0.5, 1) - 1) ** 2).mean() < 0.03 ** 2


def test_a_sun_behind_a_plate_lights_its_back_alone():
    elements = lit(PLATE, '--two-sided', '--sun -30,90,10,10,10').elements
    back = elements.ny < 0
    assert 9.99 < (elements.area * elements.r)[back].sum() < 10.01
    assert not elements.r[~back].any()


def test_a_lamp_lights_a_plate_by_its_distance_and_angle():
    elements = lit(PLATE, '--lamp 0,2,0,0.2,100,100,100').elements
    distance = numpy.sqrt(elements.x ** 2 + elements.z ** 2 + 4)
    assert elements.r == approx(0.5 * 100 * 0.01 / distance ** 2 * 2 / distance, rel=0.01)


def test_an_ambient_colour_above_1_shines_at_any_scale():
    solution = lit(square('old', 1), '--scale 10')
    assert 'Ka is above 1 and is used as Ke' in solution.errors
    assert solution.elements.r == approx(3, rel=0.001)
    assert 399.9 < solution.elements.area.sum() < 400.1


def test_lamps_that_light_no_front_are_noted():
    note = 'no light reaches the fronts of the polygons: try --two-sided'
    inside_out = re.sub(r'^f (.*)', lambda face: 'f ' + ' '.join(face[1].split()[::-1]), room('grey', 'grey', 'grey'),
                        flags=re.M) + square('weak', 0.1, 0.5, 0.9, 0.5, 'down')
    dark, lighted = lit(inside_out), lit(inside_out, '--two-sided')
    assert note in dark.errors and note not in lighted.errors
    assert mean_light(lighted.elements[lighted.elements.material == 'grey']).max() > 0


# Closed lamps shine in all directions in any program
@pytest.mark.parametrize('model, options, noted', [
    (PLATE + square('weak', 0.1, y=1, faces='down'), '', True),
    (PLATE + square('weak', 0.1, y=1, faces='down'), '--two-sided', False),
    (PLATE + room('weak', 'weak', 'weak', (0, 1, 0), (0.1, 1.1, 0.1)), '', False),
])
def test_open_lamps_are_noted_because_other_programs_light_both_sides(model, options, noted):
    assert ('its lamps shine on one side here, in Blender on both' in lit(model, *options.split()).errors) == noted


def test_a_panel_near_a_plate_lights_it_by_its_form_factor():
    elements = lit(PLATE + square('panel', 0.5, y=0.125, faces='down'), element=0.0002).elements
    plate = elements[elements.ny == 1]
    assert len(plate) > 900 and plate.r == approx(0.5 * 1000 * form_factor(plate, 0.5, 0.125), rel=0.01)


def test_a_board_hides_a_lamp_10000_times_brighter_than_one_beneath_it():
    lamps = square('weak', 0.5, y=1, faces='down') + square('bright', 0.2, y=3, faces='down')
    elements = lit(PLATE + lamps + square('black', 1.5, y=2, faces='down'), element=0.0002).elements
    plate = elements[elements.ny == 1]
    assert len(plate) > 900 and plate.b == approx(0.8 * 1000 * form_factor(plate, 0.5, 1), rel=0.01)
    assert not plate.r.any()
