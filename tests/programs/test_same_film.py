"""The whole film, with a picture for each second in draft, play and film, and its music, is equal to the bit however it
is drawn and linked. Golden pictures are few, and the hall's have a tolerance. Parts of it are equal on other systems.

SYSTEMS in the environment names others than the oldest and the newest Debian: SYSTEMS=trixie pytest -m long ...
"""
import os
import re

import pytest

from running import BUILD, FILM, SAFE, needs, needs_built, run

pytestmark = pytest.mark.long
ALONE = BUILD / f'{FILM}-parts.elf'


def dump(folder, film, threads):
    """Dumps the film into the folder, with so many threads in it and in OpenGL."""
    pictures = ('--fps', 1, '--size', '320x180')
    parts = [('--dump', folder / quality, *pictures, '--quality', quality) for quality in ('draft', 'play', 'film')]
    for part in *parts, ('--wav', folder / 'music'):
        run(film, '--threads', threads, *part, env={'LP_NUM_THREADS': threads})


@pytest.fixture(scope='module')
def wanted(work):
    """The film as one thread draws it."""
    dump(work, SAFE, 1)
    assert sum(path.is_file() for path in work.rglob('*')) == 487
    return work


def test_seven_threads_draw_what_one_does(wanted, tmp_path):
    dump(tmp_path, SAFE, 7)
    run('diff', '-qr', wanted, tmp_path)


def test_is_the_same_when_each_of_its_files_is_optimised_alone(wanted, tmp_path):
    """Tools and tests are optimised so. The film is optimised as a whole when it is linked."""
    run('cmake', '--build', BUILD, '--target', ALONE.name)
    alone, whole = (run('objdump', '-d', film).stdout.count('\n') for film in (ALONE, BUILD / f'{FILM}.elf'))
    assert alone != whole
    dump(tmp_path, ALONE, 2)
    run('diff', '-qr', wanted, tmp_path)


# --- Other systems, with their glibc and their Mesa ---

# debootstrap installs each system, and unshare enters it, so this needs root and a Debian mirror. On 2026-11-25 all was
# equal with Debian 11 (glibc 2.31, Mesa 20.3) and sid (glibc 2.43, Mesa 26.2)
LEAST = 45  # dB of PSNR that the hall must reach where Mesa differs
PARTS = {
    'frames': '--dump - --from 20 --to 60 --fps 1/4 --size 320x180',
    'hall': '--dump - --from 120 --to 120.04 --size 160x90',
    'music': '--wav -',
}


@pytest.fixture(scope='module', params=os.environ.get('SYSTEMS', 'bullseye sid').split())
def system(request, tmp_path_factory):
    """The folder of an installed system with both films."""
    needs('debootstrap', 'unshare')
    needs_built('compare')
    if os.getuid() != 0:
        pytest.skip('it needs root')
    debian = ('Created-By: Packages', 'Origin: Debian', 'Label: Debian')
    mirrors = run('apt-get', 'indextargets', '--format', '$(SITE)', *debian, status=None).stdout.split()
    if not mirrors:
        pytest.skip('apt lists no mirror of Debian')
    root = tmp_path_factory.mktemp(request.param)
    # A mount namespace of its own: mounts disappear with the process, however it ends. (All packages are in main)
    installed = run('unshare', '--mount', '--propagation', 'private', 'debootstrap', '--variant=minbase',
                    '--include=libegl1,libgl1-mesa-dri', request.param, root, mirrors[0], status=None, timeout=None)
    if installed.returncode != 0:
        pytest.skip(f'not checked: {re.findall("^E: .*", installed.stdout + installed.stderr, re.M)[-1:]}')
    print(run('chroot', root, 'dpkg-query', '-W', '-f', '${Package} ${Version} ', 'libc6', 'libgl1-mesa-dri').stdout)
    for film in FILM, f'{FILM}-safe':
        run('cp', BUILD / film, root)
    yield root
    run('rm', '-rf', '--one-file-system', root, status=None)


@pytest.fixture(scope='module')
def here(tmp_path_factory):
    """The parts of the film as this system draws them: files in a folder."""
    folder = tmp_path_factory.mktemp('here')
    for part, options in PARTS.items():
        draw(folder / part, SAFE, *options.split())
    return folder


def draw(to, *command, **options):
    with open(to, 'wb') as file:
        run(*command, text=False, stdout=file, **options)


@pytest.mark.parametrize('part', PARTS)
@pytest.mark.parametrize('film', [FILM, f'{FILM}-safe'])
def test_draws_the_same(system, here, film, part, tmp_path):
    got = tmp_path / part
    command = ('env', '-i', 'PATH=/usr/sbin:/usr/bin:/sbin:/bin', 'unshare', '--mount-proc', f'--root={system}')
    draw(got, *command, f'/{film}', *PARTS[part].split())
    if part == 'hall':
        run(BUILD / 'compare', here / part, got, '--psnr', LEAST)
    else:
        run('cmp', here / part, got)
