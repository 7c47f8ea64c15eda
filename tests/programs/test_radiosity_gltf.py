"""radiosity reads glTF: a file by Blender, lights whose irradiance has a closed form, and its own lightmaps."""
from pathlib import Path

import pytest

from pictures import numpy, write_picture
from radiosity_runs import mean_light, radiosity, solve
from running import SOURCE, needs

pytestmark = pytest.mark.usefixtures('in_work')
MODELS = SOURCE / 'tests/support/models'


def test_a_room_from_blender_has_its_area_and_faces_its_middle():
    solution = solve(MODELS / 'blender.glb', '--element 4 --rays 16', to='blender.rad')
    note = ': 2 point or spot lights become balls, up to 0.0139 across; 1 spot shines in all directions\n'
    assert note in solution.errors
    e = solution.elements
    assert 323.99 < e.area.sum() < 324.01
    assert ((10 - e.x) * e.nx + (9 - e.y) * e.ny + (-20 - e.z) * e.nz).min() > 0


# --- A small floor reflects half of the light ---
POINT = (MODELS / 'floor.gltf').read_text()
SUN = POINT.replace('"light": 0', '"light": 1')


@pytest.mark.parametrize('model, options, radiance, within', [
    (POINT, '', 0.5 * 100 / numpy.pi, 0.003),  # 100 candela at a height of 1
    (SUN, '--patch 0.001', 0.5, 1e-3),  # pi lux
    (SUN, '--sun 90,0,4,4,4', 2, 1e-4),
], ids=['point', 'sun', 'other sun'])
def test_a_light_gives_its_irradiance(model, options, radiance, within):
    solution = solve('floor.gltf', *options.split(), '--element 0.0001', text=model)
    assert mean_light(solution.elements)[0] == pytest.approx(radiance, rel=within)
    note = "radiosity: --sun replaces the model's own suns"
    assert (note in solution.errors.splitlines()) == ('--sun' in options)


def test_transfer_has_a_sun_as_a_lamp():
    Path('sun.gltf').write_text(SUN)
    printed = radiosity('transfer', 'sun.gltf', '-o', 'sun.prt', '--rays 32 --element 0.0005 --bands 2').stdout
    assert '; lamps 1 sun 1\n' in printed


# --- export --atlas writes the same model with its picture ---
ROOM = """mtllib room.mtl
v -2 0 2\nv 2 0 2\nv 2 0 -2\nv -2 0 -2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl floor\nf 1/1 2/2 3/3 4/4
v -1 2 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nusemtl lamp\nf 5 6 7 8
"""


def sorted_by_place(elements):
    places = numpy.round([elements[name] + 0.00123 for name in ('x', 'y', 'z', 'nx', 'ny', 'nz', 'area')], 2)
    order = numpy.lexsort(places)
    return places[:, order], elements[order]


def test_lightmaps_and_a_picture_make_a_model_with_the_same_light():
    needs('convert')
    row, column = numpy.indices((8, 8))
    write_picture('tiles.ppm', numpy.dstack([40 + 25 * column, 200 + 0 * row, 20 * row]))
    Path('room.mtl').write_text('newmtl floor\nKd .8 .8 1\nmap_Kd tiles.ppm\nnewmtl lamp\nKe 3 2 1\n')
    first = solve('room.obj', '--element 0.1 --rays 64', text=ROOM)
    first.export('--atlas pictured')
    assert Path('pictured/reflectance-0.png').stat().st_size
    second = solve('pictured/model.gltf', '--element 0.1 --rays 64')
    (places, wanted), (places_again, found) = sorted_by_place(first.elements), sorted_by_place(second.elements)
    assert len(wanted) > 19 and numpy.array_equal(places, places_again)
    light = mean_light(wanted).sum()
    assert mean_light(found).sum() == pytest.approx(light, rel=0.005)
    differences = sum(abs(found[colour] - wanted[colour]) for colour in 'rgb')
    assert numpy.average(differences, weights=wanted.area) < 0.03 * light
