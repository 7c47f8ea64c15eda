"""--doctor lists what this machine has and lacks, one line for each."""
import os
import re
from pathlib import Path

import pytest

from displays import Display
from running import BUILD, FILM, lacking, redirected, refuses, run

ODRAZ = BUILD / f'{FILM}-safe'  # starts without unpacking
NAMES = ['processor', 'memory', 'write and run', 'OpenGL', 'OpenGL for --dump', 'sound']


@pytest.fixture(scope='module')
def shown():
    """The environment of a display."""
    if not Path('/usr/share/alsa/alsa.conf').exists():
        pytest.skip('libasound2 is not installed')
    with Display() as display:
        yield display.env


def doctor(folder, status, env, *prefix, sound='null', lacks='none', **options):
    """What --doctor prints of each name, and its stderr. All names must be listed."""
    (folder / 'alsa.conf').write_text(f'pcm.!default {{ type {sound} }}\n')
    env = {'HOME': folder, 'ALSA_CONFIG_PATH': folder / 'alsa.conf', **env, **lacking(lacks, folder)}
    result = run(*prefix, ODRAZ, '--doctor', status=status, env=env, **options)
    version, *lines = result.stdout.splitlines()
    assert version == run(ODRAZ, '--version').stdout.strip()
    found = dict(line.split(': ', 1) for line in lines)
    assert [*found] == NAMES
    return found, result.stderr


def test_a_machine_with_all_that_it_needs_is_fine(shown, tmp_path):
    found, _ = doctor(tmp_path, 0, shown, 'taskset', '-c', min(os.sched_getaffinity(0)))
    assert found['sound'] == 'fine'
    assert re.search('llvmpipe|softpipe|Mesa', found['OpenGL'])
    assert re.search('llvmpipe|softpipe', found['OpenGL for --dump'])
    assert found['processor'].startswith('1 x ')


def test_a_missing_display_is_named_on_stdout_alone(tmp_path):
    found, errors = doctor(tmp_path, 1, {}, sound='hw card 31')
    assert found['OpenGL'].startswith('no X display: set DISPLAY')
    assert errors == ''


@pytest.mark.parametrize('lacks, name, text', [
    ('libasound.so.2', 'sound', 'no libasound.so.2'),
    ('libGL.so.1', 'OpenGL', 'libGL.so.1 is missing: install'),
    ('libEGL.so.1', 'OpenGL for --dump', 'libEGL.so.1 is missing: install')])
def test_a_missing_library_is_named(shown, tmp_path, lacks, name, text):
    assert doctor(tmp_path, 1, shown, lacks=lacks)[0][name].startswith(text)


def test_a_missing_driver_is_named_though_mesa_may_print_more(shown, tmp_path):
    found, errors = doctor(tmp_path, 1, {**shown, 'LIBGL_DRIVERS_PATH': '/none'})
    assert found['OpenGL'].startswith('no OpenGL 3.3 on this display: install')
    assert 'swrast' in errors


def test_a_missing_device_and_too_little_memory_are_reported(shown, tmp_path):
    assert doctor(tmp_path, 1, shown, sound='hw card 31')[0]['sound'].endswith('silence')
    assert doctor(tmp_path, 1, shown, 'prlimit', f'--as={500000 * 1024}')[0]['memory'].startswith('too little')


def test_what_forbids_to_run_written_memory_is_named(shown, tmp_path, mdwe):
    found, _ = doctor(tmp_path, 1, shown, preexec_fn=mdwe)
    assert found['write and run'].startswith('MemoryDenyWriteExecute')


def test_a_full_disk_is_reported():
    refuses(1, 'no space left', *redirected('>/dev/full', ODRAZ, '--doctor'))
