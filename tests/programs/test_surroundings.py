"""In odd environments the film draws the same picture, or prints one line: limits; no /proc, /dev or /sys; setuid;
personalities; empty or huge environment variables; folders that are gone, read-only or full; a display that does not
exist.

Fewer than 4 descriptors and stacks below 64 KB are not tried: the loader and the kernel refuse them.
test_commandline.py closes descriptors; test_machine.py tests missing libraries, old processors and little memory.
"""
import os
import re
import shutil
import signal

import pytest

from running import BUILD, FILM, SAFE, check_bytes, needs_built, refuses, run

SCENES = {'plain': ('--dump', '-', '--from', 20, '--to', 20.04, '--size', '64x36'),
          'hall': ('--dump', '-', '--from', 120, '--to', 120.04, '--size', '64x36')}
SMALL = ('--from', 20, '--to', 20.8, '--size', '64x36')
LONG = 120000 * 'x'


@pytest.fixture(scope='module')
def pictures(film):
    return {scene: run(film, *options, text=False).stdout for scene, options in SCENES.items()}


@pytest.fixture
def draws(pictures):
    """draws(SCENE, COMMAND...): the command draws the same picture as the film alone, and prints nothing."""
    def check(scene, *command, **options):
        result = run(*command, *SCENES[scene], text=False, **options)
        assert result.stderr == b''
        check_bytes(result.stdout, pictures[scene])
    return check


@pytest.mark.parametrize('scene, command', [
    ('plain', 'prlimit --nofile=4'),
    ('plain', f'prlimit --stack={64 * 1024}'),
    ('plain', f'prlimit --stack={256 * 1024}'),
    ('plain', 'prlimit --stack=unlimited'),
    ('plain', 'prlimit --core=0'),
    ('plain', 'prlimit --memlock=0'),
    ('hall', f'prlimit --nofile=4 --stack={256 * 1024} --core=0 --memlock=0'),
    ('hall', 'prlimit --stack=unlimited'),
    ('plain', 'env -i'),
    ('hall', 'env -i'),
    ('hall', 'env -u HOME -u XDG_RUNTIME_DIR -u XDG_CACHE_HOME'),
    ('hall', 'setarch -X'),
    *[('plain', f'setarch {personality}') for personality in ('-X', '-Z', '-B', '-L', '-3', '-S', '--uname-2.6')]])
def test_draws_the_same_by(film, draws, scene, command):
    draws(scene, *command.split(), film)


# --- Limits ---

def test_draws_or_prints_one_line_with_any_limit_of_memory(film, pictures):
    drawn = 0
    limits = range(6000, 250000, 11000)  # in KB
    for kb in limits:
        result = run('prlimit', f'--as={kb * 1024}', film, *SCENES['plain'], status=None, text=False)
        drew = (result.returncode, result.stdout, result.stderr) == (0, pictures['plain'], b'')
        refused = (result.returncode, result.stdout, result.stderr.count(b'\n')) == (1, b'', 1)
        assert drew or refused, f'{kb} KB: status {result.returncode}, {result.stderr}'
        drawn += drew
    assert 0 < drawn < len(limits)


@pytest.mark.parametrize('kb', [0, 1, 4])  # a frame has 6,925 bytes
def test_reports_a_limit_on_the_size_of_a_file(film, kb, tmp_path):
    line = refuses(1, '', 'prlimit', f'--fsize={kb * 1024}', film, '--dump', 'd', *SMALL, cwd=tmp_path)
    assert line == f"{FILM}: cannot write d/frame-000500.ppm: the limit on a file's size is reached (ulimit -f)\n"
    assert not os.listdir(tmp_path / 'd')


# All frames would take some 15 s
def test_leaves_whole_frames_if_the_kernel_ends_it_after_two_seconds_of_processor_time(tmp_path):
    run('prlimit', '--cpu=2', SAFE, '--dump', tmp_path, '--from', 20, '--to', 55, '--size', '480x270',
        '--quality', 'draft', '--threads', 2, status=-signal.SIGKILL)
    assert os.listdir(tmp_path)
    assert {frame.stat().st_size for frame in tmp_path.glob('*.ppm')} <= {480 * 270 * 3 + 15}


# --- The environment, folder and signals that it starts with ---

def ignore_signals():
    for name in 'INT', 'TERM', 'HUP', 'CHLD', 'PIPE', 'USR1':
        signal.signal(signal.Signals[f'SIG{name}'], signal.SIG_IGN)


@pytest.mark.parametrize('options', [
    {'env': dict.fromkeys('ABCD', LONG)},
    {'env': {'HOME': '/nowhere', 'LC_ALL': 'tr_TR.UTF-8', 'LANG': b'\xff', 'TERM': '', 'TZ': ':/dev/zero',
             'LANGUAGE': 'xx', 'XDG_RUNTIME_DIR': '/', 'TMPDIR': '/nowhere'}},
    {'preexec_fn': ignore_signals}], ids=['huge', 'odd', 'signals'])
def test_draws_in(film, draws, options):
    draws('plain', film, **options)


def test_draws_without_a_program_name_in_a_folder_that_was_removed(film, draws, tmp_path):
    draws('plain', '', executable=film, cwd=tmp_path, preexec_fn=tmp_path.rmdir)


@pytest.fixture(params=['safe', 'debug'])
def opens(request):
    """A program that opens a window: the film, or odraz-debug. (test_radiosity_view.py has a third)"""
    needs_built(f'{FILM}-{request.param}')
    return BUILD / f'{FILM}-{request.param}', '--mute'


# No display of another test has such a number
@pytest.mark.parametrize('name', [':99999999', 'unix/:99999999', 'nowhere.invalid:0', '/', pytest.param(LONG, id='x')])
def test_refuses_a_display_that_does_not_exist(opens, name):
    refuses(1, f'DISPLAY is {name[:400]}', *opens, env={'DISPLAY': name})


def test_refuses_a_display_that_is_not_named_lacks_the_screen_or_does_not_admit_the_user(opens, display, tmp_path):
    refuses(1, 'no X display: set DISPLAY', *opens, env={'DISPLAY': ''})
    (tmp_path / 'cookie').write_bytes(b'\xff\xff' + bytes(5) + b'\x12MIT-MAGIC-COOKIE-1\0\x10' + 16 * b'x')
    strict = display('64x64', '-auth', tmp_path / 'cookie').env['DISPLAY']
    for name in display().env['DISPLAY'] + '.99', strict:
        line = f'DISPLAY is {name}, which cannot be opened'
        refuses(1, line, *opens, env={'DISPLAY': name, 'XAUTHORITY': '/dev/null'})


# --- Environments that only root can make ---

@pytest.fixture
def inside(background):
    """The words that run a command with mounts of its own, which last as long as the test."""
    if os.geteuid() != 0 or run('unshare', '--mount', 'true', status=None).returncode != 0:
        pytest.skip('only root can mount')
    keeper = background('unshare', '--mount', 'sleep', 'infinity')
    namespace = f'/proc/{keeper.pid}/ns/mnt'
    keeper.comes(lambda: os.readlink(namespace) != os.readlink('/proc/self/ns/mnt'))
    return 'nsenter', f'--mount={namespace}'


@pytest.fixture
def disk(inside, tmp_path):
    """A folder with a disk of 64 KB, inside."""
    run(*inside, 'mount', '-t', 'tmpfs', '-o', 'size=64k', 'none', tmp_path)
    return tmp_path


@pytest.mark.parametrize('scene, folders', [
    *[('plain', [folder]) for folder in ('/dev', '/sys', '/run', '/var', '/proc')],
    ('hall', ['/dev', '/sys', '/run', '/var', '/proc'])])
def test_draws_where_folders_are_empty(film, draws, inside, scene, folders):
    for folder in folders:
        run(*inside, 'mount', '-t', 'tmpfs', 'none', folder)
    draws(scene, *inside, film)


def test_reports_a_full_disk_and_leaves_no_half_written_frame_and_a_read_only_disk(film, inside, disk):
    command = (*inside, film, '--dump', disk / 'd', *SMALL)
    line = refuses(1, '', *command)
    assert re.fullmatch(rf'{FILM}: cannot write {disk}/d/frame-0005\d\d\.ppm: no space left on the device\n', line)
    frames = run(*inside, 'ls', disk / 'd').stdout.split()
    assert len(frames) >= 3 and all(frame.endswith('.ppm') for frame in frames)
    run(*inside, 'rm', '-r', disk / 'd')
    run(*inside, 'mount', '-o', 'remount,ro', disk)
    assert refuses(1, '', *command) == f'{FILM}: cannot write {disk}/d: the file system is read-only\n'


def test_draws_from_a_read_only_disk(film, draws, inside, disk):
    run(*inside, 'mount', '-o', 'remount,size=9m', disk)
    run(*inside, 'cp', film, disk / 'film')
    run(*inside, 'mount', '-o', 'remount,ro', disk)
    draws('plain', *inside, disk / 'film')


@pytest.fixture
def nobody(film, tmp_path):
    """Options that run a copy of the film, ./film, as user nobody, who has a folder of unsuitable libraries."""
    if os.geteuid() != 0:
        pytest.skip('only root can become nobody')
    tmp_path.chmod(0o711)
    shutil.copy(film, tmp_path / 'film')
    (tmp_path / 'evil').mkdir()
    for library in 'libpthread.so.0', 'libdl.so.2', 'libEGL.so.1', 'libc.so.6':
        (tmp_path / 'evil' / library).write_text('not a library\n')
    return {'cwd': tmp_path, 'user': 65534, 'group': 65534, 'extra_groups': []}


def test_setuid_does_not_load_libraries_that_the_user_names(draws, nobody):
    (nobody['cwd'] / 'film').chmod(0o4755)
    draws('plain', './film', env={'HOME': '/'}, **nobody)
    draws('plain', './film', env={'LD_LIBRARY_PATH': 'evil', 'LD_PRELOAD': 'evil/libc.so.6'}, **nobody)
    (nobody['cwd'] / 'film').chmod(0o755)  # they would be found
    refuses(127, 'evil/', './film', *SCENES['plain'], env={'LD_LIBRARY_PATH': 'evil'}, **nobody)


def test_reports_a_folder_that_the_user_may_not_write_to_and_a_thread_that_it_may_not_start(draws, nobody):
    refuses(1, 'cannot write mine: permission denied', './film', '--dump', 'mine', *SMALL, **nobody)
    command = ('prlimit', '--nproc=1', './film', '--threads')
    text = 'without room for another thread: try --threads 1'
    refuses(1, text, *command, 8, *SCENES['plain'], **nobody)
    draws('plain', *command, 1, **nobody)
