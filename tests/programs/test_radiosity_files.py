"""Files of the radiosity program: outputs replace no input, may be pipes and descriptors, and are whole or absent."""
import os
from pathlib import Path

import pytest

from radiosity_runs import RADIOSITY, generate, radiosity, solve
from running import check_bytes, redirected, refuses, run

FEW = '--rays 64 --element 0.25'


@pytest.fixture(scope='module')
def table(in_work):
    """The text of cube.csv, beside cube.obj and cube.rad."""
    solve(generate('cube', 'cube.obj'), FEW).export('--csv cube.csv')
    return Path('cube.csv').read_text()


# --- Wrong use ---
@pytest.mark.parametrize('status, text, words', [
    (1, 'more than the 3 of --memory', 'solve cube.obj -o x.rad --memory 3'),
    (2, '--rays and --patch do not go together', 'solve cube.obj -o x.rad --rays 64 --patch 2'),
    (1, 'damaged', 'export cut.rad --csv x.csv'),
    (2, 'cannot write /dev/fd/9: Bad file descriptor', 'export cube.rad --csv /dev/fd/9'),
    (2, 'q.jpg: .jpg is not written: name a file .png or .exr', 'render cube.rad -o q.jpg'),
    (2, 'q.exr: .exr is not written: name a file .png', 'view cube.rad --screenshot q.exr'),
    (2, 'cube.rad: is a solution: give the model', 'solve cube.rad -o x.rad'),
    (2, 'cube.rad: is a solution: give the model', 'study cube.rad -o x'),
    (2, 'cube.rad: is a solution: give the model', 'transfer cube.rad -o x.prt'),
])
def test_refuses(status, text, words, table):
    Path('cut.rad').write_bytes(Path('cube.rad').read_bytes()[:100000])
    refuses(status, text, RADIOSITY, *words.split())


@pytest.mark.parametrize('command', ['', 'solve', 'render'])
def test_h_is_help(command):
    assert radiosity(*command.split(), '-h').stdout == radiosity(*command.split(), '--help').stdout


# --- No output may replace an input, by whatever name, nor a model, from which the solution may have been made ---
@pytest.fixture
def inputs(table, tmp_path):
    """A folder with all kinds of inputs."""
    texts = {
        'in.mtl': 'newmtl m\nKd .5 .5 .5\nmap_Kd kd.ppm\nmap_bump -bm 1 bump.ppm\n',
        'in.obj': 'mtllib in.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 -1\nusemtl m\nf 1 2 3\n',
        'in.gltf': '{"asset":{"version":"2.0"},"images":[{"uri":"kd.ppm"}],'
                   '"buffers":[{"uri":"in.obj","byteLength":9}]}',
        'kd.ppm': 'P6 2 1 255 abcdef', 'bump.ppm': 'P6 2 1 255 abcdef', 'sky.ppm': 'P6 2 1 255 abcdef',
        'cube.obj': Path('cube.obj').read_text(),
    }
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    (tmp_path / 'in.rad').write_bytes(Path('cube.rad').read_bytes())
    (tmp_path / 'link.png').symlink_to('in.rad')
    (tmp_path / 'soft').symlink_to('in.obj')
    os.link(tmp_path / 'in.obj', tmp_path / 'hard')
    return tmp_path


@pytest.mark.parametrize('words', [
    'solve in.obj -o in.obj', 'solve in.obj -o soft', 'solve soft -o hard', 'solve in.obj -o ./in.mtl',
    'solve in.obj -o kd.ppm', 'transfer in.obj -o bump.ppm', 'transfer in.obj --check --sky sky.ppm -o sky.ppm',
    'solve in.gltf -o kd.ppm', 'solve in.obj --sky sky.ppm -o sky.ppm', 'export in.rad --csv in.rad',
    'export in.rad --obj cube.obj', 'render in.rad -o link.png', 'render link.png -o soft',
])
def test_overwrites_no_input(words, inputs):
    before = {path: path.read_bytes() for path in inputs.iterdir()}
    refuses(2, 'would be overwritten', RADIOSITY, *words.split(), cwd=inputs)
    assert {path: path.read_bytes() for path in inputs.iterdir()} == before


def test_a_later_export_replaces_an_earlier_one(table):
    for _ in range(2):
        radiosity('export', 'cube.rad', '--obj lit.obj')
    assert '\nf' in Path('lit.obj').read_text()


# --- Outputs may be pipes and open descriptors ---
@pytest.mark.parametrize('redirections, name', [('', '/dev/stdout'), ('3>&1 >&2', '/dev/fd/3')])
def test_writes_into_a_pipe(redirections, name, table):
    assert run(*redirected(redirections, RADIOSITY, 'export', 'cube.rad', '--csv', name)).stdout == table


def test_writes_into_a_named_pipe_which_stays_one(table, background):
    os.mkfifo('pipe')
    reader = background('cat', 'pipe')
    radiosity('export', 'cube.rad', '--csv pipe')
    assert reader.ended() == 0 and reader.output() == table
    assert Path('pipe').is_fifo()


def test_appends_where_the_shell_does(table):
    Path('appended').write_text('first\n')
    run(*redirected('>>appended', RADIOSITY, 'export', 'cube.rad', '--csv', '/dev/stdout'))
    assert Path('appended').read_text() == 'first\n' + table


def test_writes_a_picture_into_a_pipe(table):
    def render(name):
        return radiosity('render', 'cube.rad', '-o', name, '--size 160x90', text=False).stdout
    render('cube.png')
    check_bytes(render('/dev/stdout'), Path('cube.png').read_bytes())


def test_writes_a_solution_into_a_pipe_and_keeps_no_state(table):
    piped = radiosity('solve', 'cube.obj', FEW, '--keep-every 0.01', '-o', '/dev/stdout', text=False)
    check_bytes(piped.stdout, Path('cube.rad').read_bytes())
    assert piped.stderr.startswith(b'needs about')
    assert not [*Path('/dev/fd').glob('*.state'), *Path('/dev').glob('*.state')]


def test_a_file_beyond_the_limit_leaves_nothing(table):
    command = ('prlimit', f'--fsize={8 * 1024}', RADIOSITY, 'export', 'cube.rad', '--csv', 'large.csv')
    refuses(1, 'cannot write large.csv: File too large', *command)
    assert not [*Path().glob('large.csv*'), *Path().glob('*part')]


def test_a_pipe_may_close_early():
    assert 'Computes the light' in run(*redirected('| head -n 1', RADIOSITY, '--help')).stdout
