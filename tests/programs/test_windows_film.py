"""The film for Windows, run by Wine, against the film for Linux. Frames of every scene, the hall, in-betweens and sound
are equal to the byte; refused options and failed outputs give the same line. It asks for five of the system's libraries
and no others. Most runs use the film that is not packed, which starts sooner. And the packer's example for Windows."""
import os
import re
import shutil

import pytest

from running import BUILD, FILM, SOURCE, Program, flip, redirected, refuses, run
from wine import answers_box, without

pytestmark = pytest.mark.windows
SAFE, SCREEN = f'{FILM}-safe', '640x480'  # OpenGL needs a display under Wine
LINUX, WINDOWS = BUILD / SAFE, BUILD / f'{SAFE}.exe'
# The program's own calls return to its addresses, below 16 MB
CALL = rb'Call KERNEL32\.(?:LoadLibrary|LdrLoadDll)[A-Za-z]*\([0-9a-f]+ L?"([^"]*)".* ret=00[0-9a-f]{6}$'


@pytest.mark.parametrize('film, options', [
    (SAFE, '--version'),
    (SAFE, '--help'),
    *((SAFE, f'--dump - --from {second} --to {second}.04 --size 160x90')
      for second in (5, 14, 24, 38, 58, 78, 91, 105, 121, 139, 159)),
    (SAFE, '--dump - --from 100 --to 100.04 --size 640x360 --quality film'),  # the hall, large
    (SAFE, '--dump - --from 100 --to 100.04 --size 320x180 --threads 3'),
    (SAFE, '--dump - --from 30 --to 30.1 --fps 60 --size 160x90 --quality live'),  # as it is played, with in-betweens
    (SAFE, '--wav - --to 20'),
    (FILM, '--version'),
    (FILM, '--dump - --from 24 --to 24.04 --size 160x90'),
    (FILM, '--dump - --from 121 --to 121.04 --size 160x90'),
    (FILM, '--wav - --to 2'),
])
def test_prints_what_the_film_for_linux_does(wine, screen, film, options, tmp_path):
    for name, command in ('wanted', [BUILD / film]), ('got', [wine, BUILD / f'{film}.exe']):
        (tmp_path / name).write_bytes(run(*command, *options.split(), env=screen.env, text=False).stdout)
    assert (tmp_path / 'wanted').stat().st_size > 0
    run('cmp', tmp_path / 'wanted', tmp_path / 'got')


def test_writes_the_same_files_and_nothing_else_also_over_existing_files(wine, tmp_path):
    for _ in range(2):
        for to, film in (tmp_path / 'linux', [LINUX]), (tmp_path / 'windows', [wine, WINDOWS]):
            to.mkdir(exist_ok=True)
            run(*film, '--dump', to, '--from', 20, '--to', 20.2, '--size', '64x36', '--wav', to / 'a.wav')
        assert len(os.listdir(tmp_path / 'windows')) == 6
        run('diff', '-r', tmp_path / 'linux', tmp_path / 'windows')


def test_writes_to_names_with_blanks_and_those_that_are_not_ascii(wine, tmp_path):
    for film, folder, file in ([LINUX], 'linux', 'short.wav'), ([wine, WINDOWS], 'Příliš žluťoučký kůň', 'a  b .wav'):
        run(*film, '--dump', tmp_path / folder, '--from', 20, '--to', 20.04, '--size', '64x36')
        run(*film, '--wav', tmp_path / file, '--to', 0.1)
    run('cmp', tmp_path / folder / 'frame-000500.ppm', tmp_path / 'linux/frame-000500.ppm')
    run('cmp', tmp_path / file, tmp_path / 'short.wav')


def refuse_alike(wine, film, status, text, *options):
    """Asserts that both films refuse with the same status and line."""
    line = refuses(status, text, BUILD / film, *options)
    assert refuses(status, text, wine, BUILD / f'{film}.exe', *options) == line


@pytest.mark.parametrize('film', [SAFE, FILM])
def test_refuses_an_unknown_option(wine, film):
    refuse_alike(wine, film, 2, "unknown option '--nope'", '--nope')


@pytest.mark.parametrize('value, printed', [('a\nb\33[31m', 'a?b?[31m'), ('"', '"'), ('a\\\\"b c\\', 'a\\\\"b c\\')])
def test_quotes_a_refused_value(wine, value, printed):
    refuse_alike(wine, SAFE, 2, f"not '{printed}'", '--fps', value)


def test_refuses_names_that_cannot_be_files_and_leaves_nothing_behind(wine, tmp_path):
    folder, name = tmp_path / 'folder', tmp_path / 'a"b'  # Windows allows no such name
    folder.mkdir()
    refuse_alike(wine, SAFE, 1, 'it is a directory', '--wav', folder, '--to', 0.1)
    refuses(1, f'cannot write {name}: the system refused', wine, WINDOWS, '--wav', name, '--to', 0.1)
    assert os.listdir(tmp_path) == ['folder'] and not os.listdir(folder)


def test_refuses_a_full_disk(wine):
    frames = ('--dump', '-', '--from', 20, '--to', 20.2, '--size', '64x36', '--quality', 'draft')
    command = redirected('>/dev/full', wine, WINDOWS, *frames)
    refuses(1, 'cannot write standard output: no space left on the device', *command)


def test_refuses_a_closed_pipe(wine, tmp_path):
    reading, writing = os.pipe()
    frames = ('--dump', '-', '--from', 20, '--to', 30, '--size', '320x180', '--quality', 'draft')
    with Program(tmp_path, wine, WINDOWS, *frames, stdout=writing) as film:
        os.close(writing)
        assert os.read(reading, 99)
        os.close(reading)
        assert film.ended() == 1
        assert film.errors() == f'{FILM}: cannot write standard output: the pipe was closed\n'


@pytest.mark.parametrize('changes', [{'DISPLAY': None}, without('opengl32'), {'MESA_GL_VERSION_OVERRIDE': 2.1}])
def test_refuses_to_draw_the_hall_without_opengl(wine, screen, changes):
    frame = ('--dump', '-', '--from', 100, '--to', 100.04, '--size', '64x36')
    refuses(1, 'no OpenGL 3.3: install', wine, WINDOWS, *frame, env={**screen.env, **changes})


@pytest.mark.parametrize('options, libraries', [
    ('--dump - --from 20 --to 20.04 --size 64x36 --quality draft', 'kernel32'),
    ('--wav - --to 0.1', 'kernel32'),
    ('--help', 'kernel32'),
    ('--dump - --from 100 --to 100.04 --size 64x36 --quality draft', 'gdi32 kernel32 opengl32 user32'),  # the hall
    ('--window --size 64x36 --from 163.9', 'gdi32 kernel32 opengl32 user32 winmm'),
])
def test_asks_for_the_libraries_it_needs_alone(wine, screen, tmp_path, options, libraries):
    with open(tmp_path / 'trace', 'wb') as trace:
        screen.run(wine, WINDOWS, *options.split(), env={'WINEDEBUG': '-all,+relay'}, text=False, stderr=trace)
    names = re.findall(CALL, (tmp_path / 'trace').read_bytes(), re.M)
    assert {name.removesuffix(b'.dll').lower().decode() for name in names} == set(libraries.split())


# --- The packer's example ---

PACK = BUILD / 'pack'
CHECKED = 512 + 264 + 300  # after headers, imports, and the code that checks and reports


@pytest.fixture(scope='module')
def example(work):
    run('bash', SOURCE / 'packer/example/build.sh', PACK, work, '--pe')
    return work / 'hello.exe'


@pytest.fixture
def broken(example, tmp_path):
    return shutil.copy(example, tmp_path / 'broken.exe')


def greets(*command, **options):
    result = run(*command, status=7, **options)
    assert (result.stdout.rstrip(), result.stderr) == ('hello, 42', '')


def test_runs_by_any_path(wine, example):
    greets(wine, example)
    greets(wine, './hello.exe', cwd=example.parent)


def test_is_unpacked_into_what_plain_makes(wine, example, tmp_path):
    plain, again = tmp_path / 'plain.exe', tmp_path / 'again.exe'
    run(PACK, '-d', example, '-o', plain)
    greets(wine, plain)
    run(PACK, example.parent / 'hello_windows.elf', '-o', again, '--pe', '--plain')
    run('cmp', plain, again)


# The film has the same checking code
def test_refuses_a_flipped_bit_anywhere(wine, example, broken, tmp_path):
    size = example.stat().st_size
    assert size > 3000
    for at in [*range(CHECKED, size - 1, 97), size - 1]:
        shutil.copy(example, broken)
        flip(broken, at, 1 << at % 8)
        refuses(1, 'damaged: copy it again', wine, broken)
        refuses(2, f'{broken}: ', PACK, '--test', broken)
        refuses(2, f'{broken}: ', PACK, '-d', broken, '-o', tmp_path / 'x')


def test_runs_with_bytes_after_its_end(wine, broken):
    broken.write_bytes(broken.read_bytes() + b'more bytes\n')
    greets(wine, broken)


def test_reports_damage_in_a_box_without_standard_error(wine, broken, display):
    flip(broken, broken.stat().st_size - 1, 1)
    assert answers_box(display('640x480'), 'damaged: copy it again', wine, broken) == 1
