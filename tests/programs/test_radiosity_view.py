"""`radiosity view`: its pictures against the pictures of `radiosity render`; its layers, keys, mouse and wheel; and
models that are solved while they are shown."""
from pathlib import Path

import pytest

from pictures import brightness, numpy, psnr, read_picture
from radiosity_runs import RADIOSITY, generate, hills, radiosity, solve
from radiosity_windows import camera_of, is_like, press, screen
from running import refuses

pytestmark = pytest.mark.usefixtures('models')
SIZE = '--size 300x200'
INSIDE = '--eye 0,5,4.9 --at 0,4,-5'
ASIDE = '--eye 1,5,4.9 --at 0,4,-5 --lens 50'
LAYERS = ['--layer patches', '--layer elements', '--layer wireframe']
SUNNY = '--sun 30,90,3,3,3 --sky 0.2,0.3,0.5 --up z --element 0.02 --rays 32'


@pytest.fixture(scope='module')
def models(in_work):
    """A cube; bumps, where z is up; and a plate with 4 x 4 patches and 8 x 8 elements."""
    solve(generate('cube', 'cube.obj'), '--element 0.1 --rays 64')
    Path('grey.mtl').write_text('newmtl grey\nKd 0.5 0.4 0.3\n')
    text = 'mtllib grey.mtl\nusemtl grey\n'
    assert '\n800 triangles' in solve('bumps.obj', SUNNY, text=text + hills(8, 0.4, up='z')).output
    plate = text + 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n'
    assert '; 16 patches, 64 elements' in solve('plate.obj', '--patch 0.25 --element 0.0625', text=plate).output


# --- Pictures are the tracer's, except on edges, where the samples differ, and within elements, where triangles
# interpolate a little differently. Measured: 48 to 56 dB; 30 in the log tone, whose darkest pixels are edges ---
@pytest.mark.parametrize('least, model, options', [
    (44, 'bumps.rad', f'{SIZE} --up z'),
    (44, 'cube.rad', f'{SIZE} {INSIDE} --lens 100 --exposure -1'),
    (28, 'cube.rad', f'{SIZE} {INSIDE} --tone log'),
])
def test_looks_as_render_shows_it_from_the_camera_that_render_prints(screen, least, model, options):
    printed = screen.draw('view.png', model, options)
    camera = radiosity('render', model, '-o', 'render.png', options).stdout
    assert psnr('view.png', 'render.png') > least
    assert camera == ''.join(line for line in printed.splitlines(True) if '--eye' in line)


@pytest.mark.parametrize('model, options, up', [
    ('bumps.obj', SUNNY, '--up z'), ('cube.obj', '--direct hemicube --bounces 3 --patch 2', '--up y'),
])
def test_a_model_solved_while_it_is_shown_ends_with_the_light_of_the_file(screen, model, options, up):
    solve(model, options, to='model.rad')
    screen.draw('file.png', 'model.rad', SIZE, up)
    screen.draw('live.png', model, SIZE, options)
    assert numpy.array_equal(read_picture('live.png'), read_picture('file.png'))


# --- Layers ---
@pytest.fixture(scope='module')
def plate(screen):
    """plate(OPTION...) is a picture of the plate, which fills most of it."""
    def drawn(*options, camera='--eye 0,0,2 --at 0,0,0 --lens 60'):
        screen.draw('plate.png', 'plate.rad', '--size 200x200', camera, *options)
        return read_picture('plate.png').astype(int)
    return drawn


def test_patches_have_sixteen_colours_before_black(plate):
    def colours(picture):
        """Pixels where patches meet are averages: each of these colours has few pixels."""
        _, counts = numpy.unique(picture.reshape(-1, 3), axis=0, return_counts=True)
        return (counts >= 100).sum()
    assert colours(plate('--layer patches')) == 17
    assert colours(plate()) < 17


def test_eight_elements_have_seven_lines_between_them(plate):
    is_line = brightness(abs(plate('--layer elements') - plate())) > 0.03 * 255
    for pixels in is_line[110, 20:180], is_line[20:180, 110]:
        begins = pixels[1:] & ~pixels[:-1]
        assert begins.sum() == 7 and not pixels[0]


# A plate of width 2 at the distance of 2 takes 173 of 200 pixels
def test_the_wireframe_is_a_rectangles_edges_with_nothing_between(plate):
    wires = plate('--layer wireframe').any(axis=2)
    columns = numpy.flatnonzero(wires.any(axis=0))
    assert 172 <= columns[-1] + 1 - columns[0] <= 176
    assert not wires[20:180, 20:180].any()


def test_the_back_is_not_shown(plate):
    assert not plate('--layer elements', camera='--eye 0,0,-2 --at 0,0,0').any()


# From the middle of the cube's far wall the red wall is on the right, the green one on the left, the lamp above. Its
# hemicube lies in the lower right corner: 4 x 37 pixels wide, 8 from the borders; the top face in its middle
def test_a_hemicube_sees_red_on_its_right_green_on_its_left_and_a_lamp_above(screen):
    screen.draw('hemicube.png', 'cube.rad', '--size 480x300', INSIDE, '--layer hemicube')
    picture = read_picture('hemicube.png')
    red, green, _ = picture[198:238, 448:468].mean(axis=(0, 1))
    assert green < 0.7 * red
    red, green, _ = picture[198:238, 326:346].mean(axis=(0, 1))
    assert red < 0.7 * green
    above, below = (picture[top:top + 37, 361:435, 2].max() for top in (144, 255))
    assert above > 0.98 * 255 >= below


# --- Keys, mouse and wheel ---
@pytest.fixture(scope='module')
def shown(screen):
    """shown[OPTIONS] is the picture that the window shows with them. (Drawing them later would take its keyboard.)"""
    pictures = {}
    for options in '', *LAYERS, '--tone log', '--exposure 0.5':
        screen.draw('shown.png', 'cube.rad', SIZE, ASIDE, *options.split())
        pictures[options] = read_picture('shown.png')
    return pictures


@pytest.fixture
def window(screen, shown):
    """A window, which shows the cube, until ESC ends it."""
    window = screen.view('cube.rad', SIZE, ASIDE)
    window.comes(lambda: window.shows(shown['']))
    yield window
    window.escape()


@pytest.fixture
def plain(shown):
    return shown['']


def test_the_window_has_the_size_given_and_prints_its_keys(window):
    assert window.size() == (300, 200)
    assert '\n2          elements\n' in window.output()


def test_keys_show_layers_and_name_them_in_the_title(window, plain, shown):
    for key, layer in enumerate(LAYERS, 1):
        press(window, f'{key}', lambda: window.shows(shown[layer]) and layer.replace('--layer', ' ') in window.title())
        press(window, f'{key}', lambda: window.shows(plain))


def test_keys_and_the_wheel_change_tone_and_exposure(window, plain, shown):
    press(window, 'h', lambda: window.differs(plain))  # the keys
    press(window, 'F1', lambda: window.shows(plain))
    press(window, 't', lambda: window.shows(shown['--tone log']))
    press(window, 't', lambda: window.shows(plain))
    window.display.do('mousemove', '--window', window.number, 150, 100, 'click', 4, 'click', 4)
    window.comes(lambda: window.shows(shown['--exposure 0.5']))
    window.display.do('click', 5, 'click', 5)
    window.comes(lambda: window.shows(plain))


def test_a_key_shows_the_hemicube_of_the_patch_under_the_pointer(window, plain):
    window.display.do('mousemove', '--window', window.number, 150, 100)
    press(window, '4', lambda: window.differs(plain))
    middle = window.picture()
    window.display.do('mousemove', '--window', window.number, 30, 100)
    window.comes(lambda: window.differs(middle))
    press(window, '4', lambda: window.shows(plain))


def place(window):
    """Waits until the camera rests, since a released key moves it for one more picture. Returns where it is and where
    it looks, as six numbers."""
    window.comes(lambda: camera_of(window) == camera_of(window))
    _, eye, _, at, *_ = camera_of(window).split()
    return [float(number) for number in f'{eye},{at}'.split(',')]


def test_keys_fly_and_the_mouse_looks_around(window, plain):
    assert camera_of(window) == f'{ASIDE} --up y --exposure 0 --tone film {SIZE}'
    for key, axis, direction in ('w', 2, -1), ('a', 0, -1), ('e', 1, 1):
        before = place(window)[axis]
        window.display.do('keydown', key)
        window.comes(lambda: float(camera_of(window).split()[1].split(',')[axis]) != before)
        window.display.do('keyup', key)
        assert (place(window)[axis] - before) * direction > 0, f'key {key} flies the wrong way'
    press(window, 'r', lambda: window.shows(plain))
    there = ('mousemove', '--window', window.number)
    window.display.do(*there, 130, 100, 'mousedown', 1, *there, 170, 85, 'mouseup', 1)
    window.comes(lambda: window.differs(plain))
    *_, right, up, _ = place(window)
    assert right > 0 and up > 4


def test_another_size_is_filled_and_render_draws_it_from_the_camera_printed(window):
    window.display.do('windowsize', window.number, 400, 150)
    window.comes(lambda: window.size() == (400, 150))

    def is_rendered():
        camera = camera_of(window)
        radiosity('render', 'cube.rad', '-o', 'render.png', camera)
        return camera.endswith('--size 400x150') and is_like(window, 'render.png', 40)
    window.comes(is_rendered)


def test_a_plate_from_behind_is_black_until_a_key_shows_its_back(screen):
    window = screen.view('plate.rad', '--eye 0,0,-2 --at 0,0,0 --size 200x200')
    window.comes(lambda: window.is_black('200x200+0+0'))
    press(window, 'b', lambda: not window.is_black('200x200+0+0'))
    window.escape()


# ESC does not wait for form factors. (light_so_far_test tests the light that is shown meanwhile)
def test_escape_ends_it_while_it_computes_form_factors(screen):
    window = screen.view(generate('columns', 'columns.obj'), '--hemicube 1024 --element 1', SIZE)
    window.comes(lambda: 'form factors' in window.title())
    window.escape()


# --- What is missing ---
def test_refuses_to_show_without_a_display_or_with_an_opengl_that_is_too_old(screen):
    for text, env in [('no X display: set DISPLAY', {}),
                      ('DISPLAY is :99999999, which cannot be opened', {'DISPLAY': ':99999999'}),
                      ('this display, only 2.1 ', {**screen.env, 'MESA_GL_VERSION_OVERRIDE': '2.1'}),
                      ('LIBGL_ALWAYS_INDIRECT is 1: unset it\n', {**screen.env, 'LIBGL_ALWAYS_INDIRECT': '1'})]:
        refuses(1, text, RADIOSITY, 'view', 'cube.rad', env=env)


def test_shows_the_same_without_gl_arb_clip_control(screen):
    screen.draw('plain.png', 'cube.rad', SIZE, ASIDE)
    options = ('cube.rad', SIZE, ASIDE, '--screenshot view.png')
    radiosity('view', *options, env={**screen.env, 'MESA_EXTENSION_OVERRIDE': '-GL_ARB_clip_control'})
    assert psnr('view.png', 'plain.png') > 50
