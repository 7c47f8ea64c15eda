"""The radiosity program as its users run it: models and their materials, solutions, exports, the camera, progress and
Ctrl-C."""
import re
import subprocess
from pathlib import Path

import pytest

from pictures import numpy, read_picture
from radiosity_runs import OPEN_ROOM, RADIOSITY, elements_of, generate, radiosity, solve, square
from running import Program, check_bytes, needs, number, refuses, run, wait_for

needs('script', 'convert')
pytestmark = pytest.mark.usefixtures('in_work')
FEW = '--rays 64 --element 0.25'


@pytest.fixture(scope='module')
def cube(in_work):
    return solve(generate('cube', 'cube.obj'), FEW)


def light(solution):
    return (solution.elements.area * solution.elements.g).sum()


# --- A model, its solution, and exports ---
def test_solve_prints_what_it_does(cube):
    assert re.search(r'elements; \d* sites \(their corners\) with \d* rays', cube.output)
    assert 'sweeps, residual' in cube.output
    assert re.search(r'needs about [1-9]\d* MB', cube.output)
    assert not cube.errors


def test_one_is_singular(in_work):
    Path('one.obj').write_text('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')
    by_rays, by_patches = (solve('one.obj', '--element 9', method).output for method in ('--rays 8', '--patch 9'))
    assert '1 triangle, 1 polygon in one plane each; 1 element; 1 site (their corners) with 8 rays' in by_rays
    assert '1 polygon in one plane each; 1 patch, 1 element\n' in by_patches and ' (1 hemicube),' in by_patches
    assert re.search('1 band, 1 function\n1 cluster of ', radiosity(
        'transfer', 'one.obj', '-o', 'one.prt', '--element 9 --bands 1').stdout)
    refuses(2, 'the room has 1 band\n', RADIOSITY, 'render', 'one.prt', '-o', 'one.png', '--bands', 2)


def test_the_table_has_all_elements(cube):
    assert len(cube.elements) == number(r' (\d+) elements', cube.output)
    assert cube.elements.dtype.names == tuple('polygon,x,y,z,nx,ny,nz,area,r,g,b,material'.split(','))
    assert 599.9 < cube.elements.area.sum() < 600.1
    assert set(cube.elements.material[cube.elements.polygon == 0]) == {'floor'}


def test_a_wall_is_red_near_the_red_one_and_green_near_the_green_one(cube):
    wall = cube.elements[cube.elements.nz == 1]
    left, right = wall[wall.x < -4], wall[wall.x > 4]
    assert left.r.sum() > 1.1 * left.g.sum()
    assert left.r.sum() / left.g.sum() > 1.1 * right.r.sum() / right.g.sum()


def test_materials_may_be_changed_in_the_model_or_by_solve(cube):
    others = '--power lamp=2 --reflectance red=0.5 --reflectance floor=.1,.2,.3'
    bright = solve(generate('cube', 'bright.obj', others), FEW)
    written = re.findall(r'^newmtl (lamp|red|floor)\n(Kd .*)\n(Ke .*)', Path('bright.mtl').read_text(), re.M)
    assert written == [('red', 'Kd 0.325 0.05 0.04', 'Ke 0 0 0'), ('floor', 'Kd 0.1 0.2 0.3', 'Ke 0 0 0'),
                       ('lamp', 'Kd 0.5 0.5 0.5', 'Ke 40 36 30')]
    check_bytes(bright.path.read_bytes(), solve('cube.obj', FEW, others, to='options.rad').path.read_bytes())


def test_a_hundred_times_the_triangles_give_the_same_light(cube):
    printed = radiosity('generate', 'cube', '-o', 'fine.obj', '--area 0.5').stdout
    assert re.search(r'^fine\.obj: \d* triangles', printed)
    assert Path('fine.obj').read_text().count('\nf') >= 1200
    assert 0.99 < light(cube) / light(solve('fine.obj', FEW)) < 1.01


@pytest.mark.parametrize('options', [
    '--final 64 --memory 500 --lamp-samples 64', '--hemicube 32 --patch 2 --residual 1e-6',
    '--direct hemicube --hemicube 25 --patch 4', '--direct hemicube --patch 4 --shots 500',
])
def test_each_method_gives_about_the_same_light(options, cube):
    assert 0.93 < light(solve('cube.obj', '--element 0.25', options, to='other.rad')) / light(cube) < 1.02


def test_without_bounces_the_ceiling_is_dark_except_for_its_lamp(cube):
    elements = solve('cube.obj', '--element 0.25 --bounces 0', to='direct.rad').elements
    ceiling, floor = elements[elements.ny == -1].r, elements[elements.ny == 1].r
    assert (ceiling == 0).sum() > 100
    assert ceiling.any() and ceiling[ceiling != 0].min() >= 15
    assert (floor > 0).sum() > 100


def test_exports_for_viewers_are_whole_and_have_colours(cube):
    cube.export('--ply cube.ply')
    cube.export('--obj lit.obj')
    head, body = Path('cube.ply').read_text().split('end_header\n')
    assert head.count('\nelement face ') == 1
    assert body.count('\n') == sum(map(int, re.findall(r'^element \w+ (\d+)$', head, re.M))) > 1000

    assert re.search(r'^v( [-\d.e]+){6}$', Path('lit.obj').read_text(), re.M)


@pytest.mark.parametrize('tone', ['log', 'film'])
def test_a_picture_has_its_size(tone, cube):
    cube.render('tone.png', '--eye 0,5,4.9 --at 0,4,-5 --size 160x90 --tone', tone)
    assert read_picture('tone.png').shape == (90, 160, 3)


def test_a_picture_is_brighter_by_two_stops(cube):
    cube.render('dark.png', '--size 160x90 --exposure -2')
    cube.render('bright.png', '--size 160x90')
    assert read_picture('dark.png').mean() < read_picture('bright.png').mean()


def test_an_exr_has_linear_radiance(in_work):
    furnace = solve(generate('furnace', 'furnace.obj'), '--element 0.01')
    furnace.render('two.EXR', '--eye 0.5,0.5,0.5 --at 0,0.5,0.5 --size 64x32 --exposure 3')
    floor = solve('floor.obj', '--element 0.1 --sky two.EXR', text=square('grey', 1))  # it reflects 0.7
    assert floor.elements.r == pytest.approx(1.4, rel=0.001)


def test_the_camera_looks_into_the_open_side_of_a_room(in_work):
    text = OPEN_ROOM.read_text()
    for side in (0, 0, 1), (1, 0, 0), (0, 0, -1), (-1, 0, 0):
        camera = solve('open.obj', '--element 0.1 --rays 8', text=text).render('open.png', '--size 80x60')
        eye, at = (numpy.array(point.split(','), float) for point in re.findall('[-.,e0-9]+,[-.,e0-9]+', camera))
        assert (numpy.sign((eye - at).round(3)) == side).all()
        text = re.sub('^v (.*) (.*) (.*)', lambda v: f'v {v[3]} {v[2]} {-float(v[1])}', text, flags=re.M)  # a quarter


# --- Without --eye and --at the camera shows all of a plate, which fills the picture; also where z is up ---
@pytest.mark.parametrize('model, options', [
    (square('grey', 1), '--lens 120'), (square('grey', 1), '--lens 5'),
    ('v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl grey\nf 4 3 2 1\n', '--up z'),
], ids=['wide', 'long', 'z is up'])
def test_the_camera_shows_all_of_a_plate(model, options):
    Path('plate.mtl').write_text('newmtl grey\nKd 0.5 0.25 0.8\n')
    plate = solve('plate.obj', '--element 0.004', text='mtllib plate.mtl\n' + model)
    camera = plate.render('all.png', '--size 160x90', options)
    assert re.match('--eye .* --at ', camera)
    plate.render('again.png', '--size 160x90', options, camera)
    run('cmp', 'again.png', 'all.png')
    rows, columns = (read_picture('all.png').max(axis=2) > 0.02 * 255).nonzero()
    left, right, top, bottom = columns.min(), columns.max(), rows.min(), rows.max()
    assert left > 0 and right < 159 and top > 0 and bottom < 89, 'it touches an edge'
    assert left < 8 or right > 151 or top < 5 or bottom > 84, 'it is small'


# --- Progress: lines for scripts, a bar on a terminal ---
def test_each_step_of_progress_ends_once_and_never_goes_back(cube):
    lines = solve('cube.obj', '--element 0.25 --final 8 --progress', to='again.rad').errors.splitlines()
    steps = {}
    for line in lines:
        found = re.fullmatch(r'progress: (dividing|form factors|direct light|solving|final rays) (\d+) %'
                             r'(, residual [-+\d.e]+)?(, \d+ s left)?', line)
        assert found, line
        steps.setdefault(found[1], []).append(int(found[2]))
    for percents in steps.values():
        assert percents == sorted(percents) and percents.count(100) == 1
    assert len(steps) == 5 and len(lines) <= 200


def test_a_line_on_a_terminal_clears_the_bar_first(cube):
    shown = run('script', '-qefc', f"'{RADIOSITY}' solve cube.obj -o bar.rad --element 0.25", '/dev/null').stdout
    assert '] 100 %' in shown
    assert not re.search(r' %[^\r\n]*(needs|triangles)', shown.replace('\r\033[K', '\n'))


def test_ctrl_c_on_a_terminal_leaves_the_light_so_far(in_work):
    generate('columns', 'big.obj', '--area 0.5')
    command = ('script', '-qefc', f"exec '{RADIOSITY}' solve big.obj -o big.rad --hemicube 512", '/dev/null')

    def stopped():
        """False if the program ended first: then it is tried again."""
        with Program(in_work, *command, stdin=subprocess.PIPE) as program:
            some_rows = r'form factors +\[.*\] +[1-9]\d? %'
            wait_for(lambda: not program.runs() or re.search(some_rows, program.output()), pause=0.02)
            program.process.communicate(b'\3')
            assert program.ended() == 0
            return re.search('stopped: direct light, and the rows of [1-9]', program.output())

    wait_for(stopped)
    radiosity('export', 'big.rad', '--csv big.csv')
    elements = elements_of('big.csv')
    assert len(elements) > 1000 and elements.area.sum() > 0
