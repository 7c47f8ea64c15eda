"""Where a machine lacks something, the film prints one line on standard error and exits with status 1. --doctor lists
what this machine has and lacks, one line for each."""
import os
import re
import subprocess
from pathlib import Path

import pytest

from running import FILM, PACKED, SAFE, check_bytes, lacking, needs, number, redirected, refuses, run

SCREEN = '640x400'
PLAIN = ('--dump', '-', '--from', 20, '--to', 20.04, '--size', '64x36')
HALL = ('--dump', '-', '--from', 120, '--to', 120.04, '--size', '64x36')


def draws(*command, **options):
    """Asserts that a command writes a picture of 64x36, and returns it."""
    picture = run(*command, text=False, **options).stdout
    assert len(picture) == 64 * 36 * 3 + 13
    return picture


@pytest.mark.parametrize('library, variable, text, options', [
    ('libX11.so.6', '', 'libX11.so.6 is missing', []),
    ('libpthread.so.0', '', 'libpthread.so.0', ['--dump', '-', '--threads', 2]),
    ('libEGL.so.1', 'MESA_GL_VERSION_OVERRIDE=4.5', 'libEGL.so.1 is missing: install', HALL),
    ('none', 'LIBGL_DRIVERS_PATH=/none', 'no headless OpenGL 3.3: install', HALL),  # one line, though Mesa prints more
    ('none', 'MESA_GL_VERSION_OVERRIDE=3.0',
     'no headless OpenGL 3.3: MESA_GL_VERSION_OVERRIDE is 3.0: unset it\n', HALL),
    ('none', 'MESA_EXTENSION_OVERRIDE=-GL_EXT_texture_integer',
     'cannot light the hall: OpenGL 3.3 cannot draw integers', HALL)])
def test_names_what_is_missing(film, tmp_path, library, variable, text, options):
    refuses(1, text, 'env', *variable.split(), film, *options, env=lacking(library, tmp_path))


def test_reports_too_little_memory(film):
    refuses(1, 'not enough memory', 'prlimit', f'--as={300000 * 1024}', film, '--dump', '-', '--size', '7680x4320')
    text = 'not enough memory for OpenGL: raise ulimit -v'
    refuses(1, text, 'prlimit', f'--as={700000 * 1024}', SAFE, *HALL[:-1], '1x1')


@pytest.mark.parametrize('film', [PACKED, SAFE])
def test_takes_less_than_512_mb_for_a_picture_of_the_hall(film, background):
    film = background(film, '--dump', '-', '--from', 100, '--to', 100.04, stdout=subprocess.PIPE)
    with film.process.stdout as pipe:
        magic = pipe.read(2)
        # The picture does not fit into the pipe: the film waits while writing, when its memory has reached its peak
        most = number(r'^VmHWM:\s*(\d+) kB', Path(f'/proc/{film.pid}/status').read_text()) // 1024
        rest = pipe.read()
    assert magic == b'P6' and len(rest) == 1280 * 720 * 3 + 16 - 2
    assert 100 < most < 512


def test_draws_all_but_the_hall_where_written_memory_may_not_be_executed(mdwe):
    draws(SAFE, *PLAIN, preexec_fn=mdwe)
    refuses(1, 'SELinux forbids code that OpenGL generates: allow it', SAFE, *HALL, preexec_fn=mdwe)


def test_draws_without_the_libraries_of_the_window_and_without_address_randomisation(film, tmp_path):
    folders = (lacking(library, tmp_path)['LD_LIBRARY_PATH'] for library in ('libX11.so.6', 'libGL.so.1'))
    picture = draws(film, *PLAIN, env={'LD_LIBRARY_PATH': ':'.join(map(str, folders))})
    check_bytes(draws('setarch', '-R', film, *PLAIN), picture)
    empty = ('--dump', '-', '--from', 100, '--to', 100)  # an interval of the hall, which needs no OpenGL
    assert run(film, *empty, env=lacking('libEGL.so.1', tmp_path)).stdout == ''


def test_reports_a_processor_of_2008_and_runs_on_one_of_2013(film):
    needs('qemu-x86_64')
    refuses(1, 'AVX2', 'qemu-x86_64', '-cpu', 'Nehalem', film, '--version')
    # qemu prints on stderr which features it cannot emulate
    assert run('qemu-x86_64', '-cpu', 'Haswell', film, '--version').stdout.startswith(FILM)


# --- --doctor ---

NAMES = ['processor', 'memory', 'write and run', 'OpenGL', 'OpenGL for --dump', 'sound']


@pytest.fixture
def doctor(screen, tmp_path):
    """doctor(STATUS) returns what --doctor prints of each name. All names must be listed. errors: what stderr holds;
    prefix: words before the command; sound: the type of ALSA's device; lacks: a library that cannot be loaded."""
    needs('/usr/share/alsa/alsa.conf')

    def doctor(status, errors='', prefix=(), sound='null', lacks='none', env=None, **options):
        (tmp_path / 'alsa.conf').write_text(f'pcm.!default {{ type {sound} }}\n')
        env = {'HOME': tmp_path, 'ALSA_CONFIG_PATH': tmp_path / 'alsa.conf', **screen.env, **(env or {})}
        result = run(*prefix, SAFE, '--doctor', status=status, env={**env, **lacking(lacks, tmp_path)}, **options)
        version, *lines = result.stdout.splitlines()
        assert version == run(SAFE, '--version').stdout.strip()
        found = dict(line.split(': ', 1) for line in lines)
        assert [*found] == NAMES
        assert re.fullmatch(errors, result.stderr, re.S)
        return found
    return doctor


def test_doctor_finds_a_machine_with_all_that_it_needs_fine_and_reports_a_full_disk(doctor):
    found = doctor(0, prefix=('taskset', '-c', min(os.sched_getaffinity(0))))
    assert found['sound'] == 'fine'
    assert re.search('llvmpipe|softpipe|Mesa', found['OpenGL'])
    assert re.search('llvmpipe|softpipe', found['OpenGL for --dump'])
    assert found['processor'].startswith('1 x ')
    refuses(1, 'no space left', *redirected('>/dev/full', SAFE, '--doctor'))


@pytest.mark.parametrize('name, text, options', [
    ('OpenGL', 'no X display: set DISPLAY', {'env': {'DISPLAY': None}}),
    ('OpenGL', 'libGL.so.1 is missing: install', {'lacks': 'libGL.so.1'}),
    ('OpenGL', 'no OpenGL 3.3 .*: install', {'env': {'LIBGL_DRIVERS_PATH': '/none'}, 'errors': '.*swrast.*'}),
    ('OpenGL for --dump', 'libEGL.so.1 is missing: install', {'lacks': 'libEGL.so.1'}),
    ('sound', 'no libasound.so.2', {'lacks': 'libasound.so.2'}),
    ('sound', '.*silence$', {'sound': 'hw card 31'}),
    ('memory', 'too little', {'prefix': ('prlimit', f'--as={500000 * 1024}')})])
def test_doctor_names_what_is_missing(doctor, name, text, options):
    assert re.match(text, doctor(1, **options)[name])


def test_doctor_names_what_forbids_to_run_written_memory(doctor, mdwe):
    assert doctor(1, preexec_fn=mdwe)['write and run'].startswith('MemoryDenyWriteExecute')
