"""radiosity export --atlas: the files in the folder, the numbers in glTF, and errors. (atlas_test compares the pages
with the solution. test_radiosity_gltf.py reads such a model again, and compares its light.)"""
import json
import os
import re
from pathlib import Path

import pytest

from pictures import numpy
from radiosity_runs import RADIOSITY, generate, solve
from running import refuses


@pytest.fixture(scope='module')
def columns(in_work):
    return solve(generate('columns', 'm.obj'), '--element 4 --rays 16')


@pytest.fixture(scope='module')
def printed(columns):
    """What export printed for the folders light and shown."""
    return columns.export('--atlas light'), columns.export('--atlas shown --map radiosity')


def test_prints_its_pages_and_writes_all_files(printed):
    light, shown = printed
    assert re.search('^114 polygons in 1 page, .* 1 stands for ', light, re.M)
    assert re.search(r'^light-0: \d+ x \d+ texels$', light, re.M)
    assert re.search('^radiosity-0: ', shown, re.M)
    names = ['light-0.exr', 'light-0.hdr', 'light-0.png', 'model.bin', 'model.gltf', 'model.mtl', 'model.obj']
    assert sorted(os.listdir('light')) == names


def test_writes_several_pages(columns):
    printed = columns.export('--atlas pages/ --texels 30 --page 1024 --padding 4')
    assert re.search('polygons in [2-9] pages', printed)
    assert Path('pages/light-1.hdr').stat().st_size


def test_reports_polygons_larger_than_a_page(columns):
    assert 'polygons have fewer texels than asked for' in columns.export('--atlas small --texels 30 --page 256')


@pytest.mark.parametrize('folder, extension', [('light', 'MOZ_lightmap'), ('shown', 'KHR_materials_unlit')])
def test_gltf_holds_the_model_with_a_lightmap_or_unlit(folder, extension, printed):
    gltf = json.loads(Path(folder, 'model.gltf').read_text())
    data = Path(folder, 'model.bin').read_bytes()

    def values(accessor):
        width = int(accessor['type'].removeprefix('VEC'))
        offset = gltf['bufferViews'][accessor['bufferView']]['byteOffset']
        return numpy.frombuffer(data, '<f4', accessor['count'] * width, offset).reshape(-1, width)
    assert extension in gltf['extensionsUsed']
    for primitive in gltf['meshes'][0]['primitives']:
        accessor = gltf['accessors'][primitive['attributes']['POSITION']]
        assert values(accessor).min(axis=0) == pytest.approx(accessor['min'], rel=0, abs=1e-5)
        assert values(accessor).max(axis=0) == pytest.approx(accessor['max'], rel=0, abs=1e-5)
        places = values(gltf['accessors'][primitive['attributes']['TEXCOORD_1']])
        assert places.min() > 0 and places.max() < 1
        assert extension in gltf['materials'][primitive['material']]['extensions']


# Materials of one colour, an object of two groups, and objects that touch in one plane
OBJECTS = ('mtllib named.mtl\nv 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 2 0 1\nv 2 0 0\nv 3 0 1\nv 3 0 0\n'
           'v 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 1 0\no left\nusemtl red\nf 1 2 3 4\no right\nusemtl red\nf 4 3 5 6\n'
           'g a b\nusemtl rot\nf 6 5 7 8\no table\nusemtl red\nf 9 10 11 12\n')


@pytest.mark.parametrize('options', ['', '--map radiosity'])
def test_names_of_objects_groups_and_materials_are_kept(options, in_work):
    Path('named.mtl').write_text('newmtl red\nKd .5 .1 .1\nnewmtl rot\nKd .5 .1 .1\n')
    folder = Path(f'named{len(options)}')
    solve('named.obj', '--element 0.1', text=OBJECTS).export(f'--atlas {folder}', *options.split())
    assert re.findall('^((?:o|g|usemtl) .*)', (folder / 'model.obj').read_text(), re.M) == [
        'o left', 'usemtl red_page0', 'o right', 'usemtl red_page0', 'g a b', 'usemtl rot_page0',
        'o table', 'usemtl red_page0']
    assert re.findall('^newmtl (.*)', (folder / 'model.mtl').read_text(), re.M) == ['red_page0', 'rot_page0']
    gltf = json.loads((folder / 'model.gltf').read_text())
    assert [node['name'] for node in gltf['nodes']] == ['left', 'right', 'table']
    assert [len(gltf['meshes'][node['mesh']]['primitives']) for node in gltf['nodes']] == [1, 2, 1]
    second = solve(folder / 'model.gltf', '--element 0.1', to='again.rad')
    second.export(f'--atlas again{len(options)}')
    assert re.findall('^o (.*)', Path(f'again{len(options)}/model.obj').read_text(), re.M) == ['left', 'right', 'table']


def test_lamps_emit_unless_the_pages_have_their_light(printed):
    assert re.search('^Ke 20 18 15', Path('light/model.mtl').read_text(), re.M)
    strength = r'"KHR_materials_emissive_strength":\{"emissiveStrength":20[.}]'
    assert re.search(strength, Path('light/model.gltf').read_text())
    shown = Path('shown/model.mtl').read_text()
    assert shown and not re.search('^Ke [^0]', shown, re.M)


def test_refuses_a_folder_that_is_not_empty(printed):
    error = 'light: already exists: name a new or empty folder'
    refuses(2, error, RADIOSITY, 'export', 'm.rad', '--atlas', 'light')


def test_pages_that_cannot_be_written_leave_nothing(columns):
    command = ('prlimit', f'--fsize={4 * 1024}', RADIOSITY, 'export', 'm.rad', '--atlas', 'x')  # every page is larger
    refuses(1, 'cannot write', *command)
    assert not [*Path().glob('x*')]
